//! Impl blocks without functions, and with one.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::generics::parameters_of;
use super::names::{ident, receiver};
use crate::model::Model;

/// A trait that says something of the law and has no functions.
pub(super) fn marker(model: &Model, runtime: &impl ToTokens, name: &str) -> TokenStream {
    with_functions(model, runtime, name, &TokenStream::new())
}

/// The derivation, told in words by an expression.
pub(super) fn told(model: &Model, runtime: &impl ToTokens, text: &impl ToTokens) -> TokenStream {
    let receiver = receiver();
    let function = quote!(fn derivation(&#receiver) -> &'static ::core::primitive::str { #text });
    with_functions(model, runtime, "Derivation", &function)
}

fn with_functions(model: &Model, runtime: &impl ToTokens, name: &str, functions: &TokenStream) -> TokenStream {
    let (self_ty, where_clause, own) = (&model.self_ty, &model.generics.where_clause, parameters_of(model));
    let name = ident(name);
    quote! {
        #[automatically_derived]
        impl <#(#own),*> #runtime::#name for #self_ty #where_clause { #functions }
    }
}
