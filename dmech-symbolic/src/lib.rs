//! The symbolic engine of dmech: from a potential, written as an expression, to straight-line programs.
//!
//! | module | what it does |
//! |---|---|
//! | [`expression`] | hash-consed expressions in normal form; every rewriting rule states its domain |
//! | [`calculus`] | derivatives, divided differences, discrete gradients |
//! | [`degree`](mod@degree) | the degree of an expression as a polynomial |
//! | [`structure`] | what a potential is beside being smooth: linear, diagonal, central |
//! | [`linear`] | symbolic solution of small linear systems, zeros exploited |
//! | [`kernel`] | the programs that a scheme needs of a law |
//! | [`program`] | scheduling: shared subexpressions, power sharing, order by latency, fused multiply-add |
//!
//! The engine knows nothing of Rust syntax. An interpreter for expressions and one for programs are the oracle for
//! generated code.
//!
//! ```
//! use dmech_symbolic::{calculus, expression::Graph};
//!
//! let mut g = Graph::new();
//! let (x, k) = (g.coordinate("x"), g.parameter("k"));
//! let (qx, kx) = (g.symbol(x), g.symbol(k));
//! let half = g.number(0.5);
//! let phi = g.mul(&[half, kx, qx, qx]);
//! let gradient = calculus::gradient(&mut g, phi, &[x]);
//! assert_eq!(g.display(gradient[0]).to_string(), "k·x");
//! ```
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]

pub mod calculus;
pub mod degree;
pub mod expression;
mod hash;
pub mod kernel;
pub mod linear;
pub mod program;
pub mod structure;
