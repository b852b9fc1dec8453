//! From the body of a potential to an expression: an abstract interpreter of the part of Rust that mechanics needs.
//!
//! | file | what it reads |
//! |---|---|
//! | [`law`] | the bodies of a law |
//! | [`expression`] | any expression: finds the right rule |
//! | [`statement`] | blocks, `let`, loops |
//! | [`pattern`] | what `let` and arguments bind; type annotations |
//! | [`assign`] | `=`, `+=` and their places |
//! | [`branch`] | `if`, comparisons, `&&`, `\|\|`, `!` |
//! | [`merge`] | joins what two branches leave behind |
//! | [`arithmetic`] | `+ - * / %` on numbers, integers, vectors |
//! | [`function`] | the functions of `f64` |
//! | [`vector`] | nalgebra's vectors |
//! | [`sequence`] | arrays, ranges and their iterators |
//! | [`call`] | helpers of the block, `f64::sqrt(x)`, closures |
//! | [`name`] | variables, constants |
//! | [`abandon`] | nothing: what refused code leaves behind |
//! | [`pair`] | the arguments of a law between two bodies |
//! | [`field`] | `self.k`, `self.k[2]`, `Self::G` |
//! | [`operator`], [`code`] | what is written, before it has a value |
//!
//! The rules are methods of one [`interpreter`], spread over these files: an expression has statements in it and a statement
//! expressions, so that they call each other in a circle. No file needs another for its types or its functions in a circle.
//!
//! Loops are unrolled, helpers inlined, branches merged with a selection. Every error is noted and its value replaced
//! by [`Value::Unknown`](value::Value), which silences whatever follows from it, so that one run finds all of them.

mod abandon;
mod arithmetic;
mod assign;
mod branch;
mod budget;
mod call;
mod code;
mod expression;
mod field;
mod function;
mod interpreter;
mod law;
mod lowered;
mod merge;
mod name;
mod operator;
mod pair;
mod pattern;
mod scope;
mod sequence;
mod statement;
mod value;
mod vector;

#[cfg(test)]
mod tests;

use crate::diagnostics::Mistakes;
use crate::model::Model;

pub use lowered::{Lowered, LoweredPair, Parameter, Read, Source};
pub(crate) use pair::data;

/// The law as expressions, or everything in its body that cannot be differentiated or understood.
pub(crate) fn lower(model: &Model) -> Result<Lowered, Mistakes> {
    interpreter::Interpreter::new(model).run()
}

/// What is wrong with the body of a law that is refused for its signature.
pub(crate) fn mistakes(model: &Model) -> Mistakes {
    interpreter::Interpreter::new(model).mistakes()
}
