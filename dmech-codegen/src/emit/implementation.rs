//! The impl block, and what stands in for it where the law has errors.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::kernels::Printer;
use super::names::{Names, ident};
use crate::lower::{Lowered, Source};
use crate::model::Model;
use crate::Derivation;

/// `impl Potential<D, R> for Law`, with everything derived from Φ.
pub(crate) fn implementation(derivation: &Derivation) -> TokenStream {
    let Derivation { model, lowered, kernels } = derivation;
    let Lowered { graph, variables, parameters, .. } = lowered;
    let scalar = scalar_name(model);
    let module = module(model);
    let runtime = ident("dmech_v1");
    let d = Literal::usize_unsuffixed(model.dimension);
    let sources = || parameters.iter().map(|p| &p.source);
    let frozen = sources().any(|s| matches!(s, Source::Mass | Source::Time));
    let autonomous = !sources().any(|s| matches!(s, Source::Time));
    let receiver = Ident::new("self", Span::call_site());
    let self_ty = &model.self_ty;
    let method = &model.potential.ident;
    let printer = Printer {
        declared: model.fields.is_none().then(|| quote!(<#self_ty>::#method)),
        graph,
        names: Names::new(graph, variables, parameters),
        variables,
        parameters,
        scalar: scalar.clone(),
        runtime: quote!(#runtime),
        dimension: d.clone(),
        law: if frozen { quote!(#receiver.law) } else { quote!(#receiver) },
    };
    let functions = printer.functions(kernels);
    let central = kernels.structure.central.is_some();
    let linear = kernels.structure.constant_hessian;
    let constants = quote! {
        const CENTRAL: bool = #central;
        const LINEAR: bool = #linear;
    };
    let where_clause = &model.generics.where_clause;
    let parameters = model.generics.params.iter();
    let generics = quote!(<#(#parameters,)* #scalar: #runtime::Real>);
    let parameters = model.generics.params.iter();
    let own_generics = quote!(<#(#parameters),*>);
    if !frozen {
        return quote! {
            const _: () = {
                use #module as #runtime;

                #[automatically_derived]
                impl #own_generics #runtime::Conservative for #self_ty #where_clause {}

                #[automatically_derived]
                impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
                    #constants
                    #functions
                }
            };
        };
    }
    // A law that names m or t is a potential only at one moment, for one mass.
    let moment = ident("Moment");
    let law_parameter = ident("Law");
    quote! {
        const _: () = {
            use #module as #runtime;

            pub struct #moment<'law, #law_parameter, #scalar> {
                law: &'law #law_parameter,
                mass: #scalar,
                t: #scalar,
            }
            #[automatically_derived]
            #[allow(unused_variables)]
            impl #generics #runtime::Law<#d, #scalar> for #self_ty #where_clause {
                type Field<'law> = #moment<'law, Self, #scalar> where Self: 'law;
                const AUTONOMOUS: bool = #autonomous;
                #[inline]
                fn field(&self, mass: #scalar, t: #scalar) -> Self::Field<'_> {
                    #moment { law: self, mass, t }
                }
            }
            #[automatically_derived]
            impl #own_generics #runtime::VelocityIndependent for #self_ty #where_clause {}
            #[automatically_derived]
            impl #generics #runtime::Field<#d, #scalar> for #moment<'_, #self_ty, #scalar> #where_clause {}
            #[automatically_derived]
            impl #generics #runtime::Potential<#d, #scalar> for #moment<'_, #self_ty, #scalar> #where_clause {
                #constants
                #functions
            }
        };
    }
}

/// An implementation without content, so that one mistake in the law shows as one error.
pub(crate) fn stub(model: &Model) -> TokenStream {
    let (scalar, runtime) = (scalar_name(model), module(model));
    let d = Literal::usize_unsuffixed(model.dimension);
    let (self_ty, where_clause) = (&model.self_ty, &model.generics.where_clause);
    let parameters = model.generics.params.iter();
    let own_parameters = model.generics.params.iter();
    let function = |name: &str, arguments: &[&str], result: TokenStream| {
        let name = ident(name);
        let arguments = arguments.iter().map(|a| ident(a));
        quote!(fn #name(&self, #(#arguments: [#scalar; #d]),*) -> #result { ::core::unreachable!() })
    };
    let (vector, matrix) = (quote!([#scalar; #d]), quote!([[#scalar; #d]; #d]));
    let functions = [
        function("potential", &["_q"], quote!(#scalar)),
        function("gradient", &["_q"], vector.clone()),
        function("hessian", &["_q"], matrix.clone()),
        function("discrete_gradient", &["_a", "_b"], vector),
        function("discrete_gradient_jacobian", &["_a", "_b"], matrix),
    ];
    quote! {
        #[automatically_derived]
        impl<#(#own_parameters),*> #runtime::Conservative for #self_ty #where_clause {}
        #[automatically_derived]
        impl<#(#parameters,)* #scalar: #runtime::Real> #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
            #(#functions)*
        }
    }
}

/// The hidden module of the facade that generated code refers to.
fn module(model: &Model) -> TokenStream {
    let krate = &model.krate;
    quote!(#krate::__private::v1)
}

/// R, unless the user's own type or generics have that name.
fn scalar_name(model: &Model) -> Ident {
    let (self_ty, generics) = (&model.self_ty, &model.generics);
    let tokens = quote!(#self_ty #generics).to_string();
    let words: Vec<&str> = tokens.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let free = ["R", "Scalar", "__R", "__Scalar"].into_iter().find(|name| !words.contains(name));
    ident(free.unwrap_or("__DmechScalar"))
}
