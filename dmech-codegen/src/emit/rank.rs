//! What a generated function gives: a number, a vector, a matrix.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// What the results of a program are gathered into.
#[derive(Clone, Copy)]
pub(super) enum Rank {
    Scalar,
    Vector,
    Matrix,
    /// Three matrices.
    Matrices,
}

impl Rank {
    /// The type of the whole.
    pub(super) fn array(self, scalar: &Ident, d: &TokenStream) -> TokenStream {
        match self {
            Self::Scalar => quote!(#scalar),
            Self::Vector => quote!([#scalar; #d]),
            Self::Matrix => quote!([[#scalar; #d]; #d]),
            Self::Matrices => quote!([[[#scalar; #d]; #d]; 3]),
        }
    }

    /// The whole with nothing but zeros.
    pub(super) fn zero(self, scalar: &Ident, d: &TokenStream) -> TokenStream {
        match self {
            Self::Scalar => quote!(#scalar::ZERO),
            Self::Vector => quote!([#scalar::ZERO; #d]),
            Self::Matrix => quote!([[#scalar::ZERO; #d]; #d]),
            Self::Matrices => quote!([[[#scalar::ZERO; #d]; #d]; 3]),
        }
    }

    pub(super) fn gather(self, outputs: &[TokenStream], dimension: usize) -> TokenStream {
        let part = match self {
            Self::Scalar => return outputs[0].clone(),
            Self::Vector => return quote!([#(#outputs),*]),
            Self::Matrix => Self::Vector,
            Self::Matrices => Self::Matrix,
        };
        let parts = outputs.chunks(outputs.len() / if let Self::Matrix = self { dimension } else { 3 });
        let parts = parts.map(|outputs| part.gather(outputs, dimension));
        quote!([#(#parts),*])
    }
}
