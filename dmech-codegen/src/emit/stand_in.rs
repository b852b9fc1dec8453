//! What stands in for the traits of a law that has errors, so that one mistake shows as one error: without it every use of
//! the law would be told that it is none.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse_quote;

use super::generics::{PairGenerics, dimension, generic_name, hidden_lifetime, module, parameters_of, scalar_name};
use super::marker::{marker, told};
use super::names::{ident, receiver};
use super::pointwise::{FORCE, blind};
use crate::model::{Model, Refusal};

/// The traits of mechanics without content.
///
/// Where only the formulas are wrong, it is known what the law acts on. Where the signature is, it may have been meant for
/// one body or for two, in any number of coordinates.
pub(crate) fn stand_in(model: &Model, refusal: Refusal) -> TokenStream {
    let runtime = module(model);
    let of_two = model.pair.is_some() || refusal == Refusal::Signature;
    let of_one = model.pair.is_none() || refusal == Refusal::Signature;
    let one = of_one.then(|| of_one_body(model));
    let two = of_two.then(|| of_two_bodies(model));
    let told = told(model, &runtime, &unreachable());
    // Of a conservative law it is known.
    let of_velocity = if of_one { &[][..] } else { &["VelocityIndependent", "LinearInVelocity"] };
    let markers = of_velocity.iter().map(|name| marker(model, &runtime, name));
    quote! {
        #told
        #one
        #two
        #(#markers)*
    }
}

fn unreachable() -> TokenStream {
    quote!(::core::unreachable!())
}

/// Potential and force.
fn of_one_body(model: &Model) -> TokenStream {
    let (scalar, runtime, unreachable, receiver) = (scalar_name(model), module(model), unreachable(), receiver());
    let (d, any_dimension) = dimension(model);
    let (self_ty, where_clause, parameters) = (&model.self_ty, &model.generics.where_clause, parameters_of(model));
    let conservative = marker(model, &runtime, "Conservative");
    let potential = blind("_q", (&scalar, &d), |_| unreachable.clone());
    let names = FORCE.map(|(name, _)| ident(name));
    let results = FORCE.map(|(_, rank)| rank.array(&scalar, &d));
    let generics = quote!(<#(#parameters,)* #any_dimension #scalar: #runtime::Real>);
    quote! {
        #conservative
        #[automatically_derived]
        impl #generics #runtime::Force<#d, #scalar> for #self_ty #where_clause {
            #(fn #names(&#receiver, _q: [#scalar; #d], _v: [#scalar; #d], _t: #scalar) -> #results { #unreachable })*
        }
        #[automatically_derived]
        impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
            #potential
        }
    }
}

/// What acts between two bodies.
fn of_two_bodies(model: &Model) -> TokenStream {
    let PairGenerics { scalar, foreign, with_data, reads, data, dimension: d, .. } = PairGenerics::of(model);
    let (runtime, self_ty, where_clause) = (module(model), &model.self_ty, &model.generics.where_clause);
    let pair = generic_name(model, ["Pair", "Acting", "__Pair", "__Acting"], "__DmechPair");
    let (held, numbers, unreachable) = (hidden_lifetime(model), ident("_numbers"), unreachable());
    // Where it is not known that the law was meant for two bodies, its generics need not be `Sync`.
    let mut generics = model.generics.clone();
    if generics.type_params().next().is_some() {
        generics.make_where_clause().predicates.push(parse_quote!(#self_ty: ::core::marker::Sync));
    }
    let (shared, symmetric) = (&generics.where_clause, marker(model, &runtime, "Symmetric"));
    let potential = blind("_d", (&scalar, &d), |_| unreachable.clone());
    quote! {
        const _: () = {
            #symmetric
            #[automatically_derived]
            impl #reads #runtime::Reads<#data> for #self_ty #where_clause {
                type Numbers = [::core::primitive::f64; 0];
                fn numbers(_: ::core::primitive::f64, _: &#data) -> Self::Numbers { #unreachable }
            }
            pub struct #pair;
            #[automatically_derived]
            impl #with_data #runtime::PairLaw<#d, #data, #scalar> for #self_ty #shared {
                type Between<#held> = #pair where Self: #held;
                fn between(&self, _: [#scalar; 0], #numbers: [#scalar; 0], _: #scalar) -> #pair { #unreachable }
            }
            #[automatically_derived]
            impl #foreign #runtime::Potential<#d, #scalar> for #pair {
                #potential
            }
            #[automatically_derived]
            impl #foreign #runtime::Between<#d, #scalar> for #pair {}
        };
    }
}
