//! Hash-consed expressions in normal form.
//!
//! Equal expressions are the same [`Expr`]; children are always older than their parents, so that walking the
//! indices downwards is a reverse topological order. The constructors of [`Graph`] bring every expression into normal
//! form: sums and products are n-ary, flat and sorted, like terms and powers of one base are merged.
//!
//! Numbers are folded only where the result is exact in binary64, so that an expression means the same for every
//! scalar type; nothing is ever expanded, because a·(b + c) and a·b + a·c round differently and structure would be lost.

mod application;
mod choice;
mod condition;
mod display;
mod evaluate;
mod function;
mod graph;
mod index;
mod node;
mod number;
mod order;
mod power;
mod product;
mod substitute;
mod sum;

pub use choice::Choice;
pub use condition::{Condition, Relation};
pub use display::Display;
pub use evaluate::{evaluate, evaluate_all};
pub use function::{Binary, Unary};
pub use graph::Graph;
pub use index::{Expr, Symbol, Variable};
pub use node::Node;
pub use number::Number;
pub(crate) use power::{EvenOfRoot, Root, Square};
pub use substitute::Substitution;
