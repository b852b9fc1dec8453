//! What the kernels read of the law.

use proc_macro2::TokenStream;
use quote::quote;

use super::names::{ident, underscored};
use crate::lower::{Parameter, Source};

/// The function that tells the names of what the kernels read of the law, in order.
pub(super) fn names_of_numbers(parameters: &[Parameter]) -> TokenStream {
    let of_law = parameters.iter().filter(|parameter| matches!(parameter.source, Source::Law(_)));
    let names: Vec<_> = of_law.map(|parameter| &parameter.name).collect();
    let see = underscored(&ident("see"), !names.is_empty());
    quote! {
        fn names(#see: &mut dyn ::core::ops::FnMut(&'static ::core::primitive::str)) {
            #(#see(#names);)*
        }
    }
}

/// What the kernels read of the law, in order.
pub(super) fn numbers_of_law(parameters: &[Parameter]) -> impl Iterator<Item = &TokenStream> {
    parameters.iter().filter_map(|parameter| match &parameter.source {
        Source::Law(tokens) => Some(tokens),
        _ => None,
    })
}
