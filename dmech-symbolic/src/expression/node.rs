//! What expressions are made of.

use super::{Binary, Condition, Expr, Number, Symbol, Unary};

/// One node in normal form.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number.
    Number(Number),
    /// A variable.
    Symbol(Symbol),
    /// constant + Σ cᵢ tᵢ, terms sorted; no term is a number or a sum; cᵢ ≠ 0.
    Sum {
        /// The constant term.
        constant: Number,
        /// The other terms with their coefficients.
        terms: Box<[(Number, Expr)]>,
    },
    /// c Π fᵢ^nᵢ, factors sorted; no factor is a product; nᵢ ≠ 0; c ≠ 0.
    Product {
        /// The numerical coefficient.
        coefficient: Number,
        /// The factors with their integer exponents.
        factors: Box<[(Expr, i32)]>,
    },
    /// A function of one argument.
    Unary(Unary, Expr),
    /// A function of two arguments.
    Binary(Binary, Expr, Expr),
    /// The first expression where the condition holds, the second elsewhere.
    Select(Condition, Expr, Expr),
}
