//! The functions of `Potential` and of `Force`, as they are called and what they take and give.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::names::{ident, receiver};
use super::rank::Rank;

/// A function of a point, or of two.
pub(super) struct Pointwise {
    pub(super) name: &'static str,
    pub(super) rank: Rank,
    between: bool,
}

const fn at(name: &'static str, rank: Rank) -> Pointwise {
    Pointwise { name, rank, between: false }
}

const fn between(name: &'static str, rank: Rank) -> Pointwise {
    Pointwise { name, rank, between: true }
}

/// The functions of `Potential`.
pub(super) const POTENTIAL: [Pointwise; 5] = [
    at("potential", Rank::Scalar),
    at("gradient", Rank::Vector),
    at("hessian", Rank::Matrix),
    between("discrete_gradient", Rank::Vector),
    between("discrete_gradient_jacobian", Rank::Matrix),
];

/// The functions of `Force`, of position, velocity and time.
pub(super) const FORCE: [(&str, Rank); 3] =
    [("force", Rank::Vector), ("force_dq", Rank::Matrix), ("force_dv", Rank::Matrix)];

impl Pointwise {
    /// What it is a function of.
    pub(super) fn of<'a, T>(&self, point: &'a [T], ends: &'a [T]) -> &'a [T] {
        if self.between { ends } else { point }
    }

    /// The function with a body.
    pub(super) fn with_body(
        &self,
        (scalar, d): (&Ident, &TokenStream),
        arguments: &[Ident],
        body: &TokenStream,
    ) -> TokenStream {
        let (name, receiver, result) = (ident(self.name), receiver(), self.rank.array(scalar, d));
        quote! {
            #[inline(always)]
            fn #name(&#receiver, #(#arguments: [#scalar; #d]),*) -> #result {
                #body
            }
        }
    }
}

/// All functions of `Potential` with bodies that do not look at what they are given.
pub(super) fn blind(point: &str, of: (&Ident, &TokenStream), body: impl Fn(Rank) -> TokenStream) -> TokenStream {
    let (point, ends) = ([ident(point)], ["_a", "_b"].map(ident));
    POTENTIAL.iter().map(|function| function.with_body(of, function.of(&point, &ends), &body(function.rank))).collect()
}
