//! What stands in for the traits of a law that has errors, so that one mistake shows as one error: without it every use of
//! the law would be told that it is none.

use proc_macro2::TokenStream;
use quote::quote;

use super::implementation::{module, parameters_of, stub};
use super::pair::pair_stub;
use crate::model::{Model, Refusal};

/// The traits of mechanics without content.
///
/// Where only the formulas are wrong, it is known what the law acts on. Where the signature is, it may have been meant for
/// one body or for two, in any number of coordinates.
pub(crate) fn stand_in(model: &Model, refusal: Refusal) -> TokenStream {
    let (runtime, self_ty, where_clause) = (module(model), &model.self_ty, &model.generics.where_clause);
    let parameters: Vec<_> = parameters_of(model).collect();
    let of_two = model.pair.is_some() || refusal == Refusal::Signature;
    let of_one = model.pair.is_none() || refusal == Refusal::Signature;
    let one = of_one.then(|| stub(model));
    let two = of_two.then(|| pair_stub(model));
    // Of a conservative law it is known.
    let velocity_independent = (!of_one).then(|| {
        quote! {
            #[automatically_derived]
            impl <#(#parameters),*> #runtime::VelocityIndependent for #self_ty #where_clause {}
            #[automatically_derived]
            impl <#(#parameters),*> #runtime::LinearInVelocity for #self_ty #where_clause {}
        }
    });
    quote! {
        #[automatically_derived]
        impl <#(#parameters),*> #runtime::Derivation for #self_ty #where_clause {
            fn derivation(&self) -> &'static ::core::primitive::str { ::core::unreachable!() }
        }
        #one
        #two
        #velocity_independent
    }
}
