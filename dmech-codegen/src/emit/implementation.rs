//! The impl block, and what stands in for it where the law has errors.

use dmech_symbolic::expression::Expr;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;
use syn::{GenericParam, Lifetime};

use super::kernels::Printer;
use super::names::{Names, ident, runtime};
use crate::Derivation;
use crate::lower::{Lowered, Source};
use crate::model::Model;

/// The traits of mechanics for the user's type, with everything derived from its potential and force.
///
/// A conservative law is a `Potential`, and its own field at all times. One that names `m` or `t`, or has a force, is a law whose field at a
/// moment is a hidden struct; what can be had without mass and time is implemented for the type itself too.
pub(crate) fn implementation(derivation: &Derivation) -> TokenStream {
    let Derivation { model, lowered, kernels, forced, invariants } = derivation;
    let Lowered { graph, variables, potential, force, parameters, .. } = lowered;
    let scalar = scalar_name(model);
    let module = module(model);
    let runtime = runtime();
    let d = Literal::usize_unsuffixed(model.dimension);
    let names = |roots: &[Expr], source: fn(&Source) -> bool| {
        parameters.iter().any(|p| source(&p.source) && roots.iter().any(|&e| graph.depends_on(e, &[p.symbol])))
    };
    let (is_mass, is_time) = (|s: &Source| matches!(s, Source::Mass), |s: &Source| matches!(s, Source::Time));
    let phi = [*potential];
    let forces = force.as_deref().unwrap_or_default();
    let potential_is_bare = !names(&phi, is_mass) && !names(&phi, is_time);
    let conservative = forced.is_none() && potential_is_bare;
    let receiver = Ident::new("self", Span::call_site());
    let self_ty = &model.self_ty;
    let declared = model.fields.is_none().then(|| model.formulas().map(|f| &f.ident).collect::<Vec<_>>());
    let mention: Vec<_> = declared.iter().flatten().map(|method| quote!(<#self_ty>::#method)).collect();
    let printer = |law: TokenStream| Printer {
        graph,
        declared: mention.clone(),
        names: Names::new(graph, variables, None, parameters),
        variables,
        parameters,
        scalar: scalar.clone(),
        runtime: quote!(#runtime),
        dimension: quote!(#d),
        between: false,
        layout: &[],
        law,
    };
    let (bare, momentary) = (printer(quote!(#receiver)), printer(quote!(#receiver.law)));
    // The field is a reference to the law: with its `self` read as that, a wrong name in the law is told once.
    let itself = printer(quote!((*#receiver)));
    let central = kernels.structure.central.is_some() && forced.is_none();
    let linear = kernels.structure.constant_hessian && forced.is_none();
    let piecewise = forced.as_ref().map_or(kernels.structure.piecewise, |forced| forced.piecewise);
    let piecewise = piecewise.then(|| {
        quote!(
            const PIECEWISE: bool = true;
        )
    });
    let degree = degree(kernels.structure.degree.filter(|_| forced.is_none()));
    let constants = quote! {
        const CENTRAL: bool = #central;
        const LINEAR: bool = #linear;
        #piecewise
        #degree
    };
    let where_clause = &model.generics.where_clause;
    let text = super::document::derivation(derivation);
    let derivation = |own_generics: &TokenStream| {
        let receiver = Ident::new("self", Span::call_site());
        quote! {
            #[automatically_derived]
            impl #own_generics #runtime::Derivation for #self_ty #where_clause {
                fn derivation(&#receiver) -> &'static ::core::primitive::str {
                    #text
                }
            }
        }
    };
    let own = parameters_of(model);
    let own_generics = quote!(<#(#own),*>);
    let items = super::author::items(model, graph, parameters, &quote!(#d), None);
    let author = quote! {
        #[automatically_derived]
        impl #own_generics #runtime::written::Author<#d> for #self_ty #where_clause {
            #items
        }
    };
    let written = quote! {
        fn written(&self) -> ::core::option::Option<&dyn #runtime::written::Written<#d>> {
            ::core::option::Option::Some(self)
        }
    };
    let kept = bare.invariants(&model.invariants, invariants);
    let own = parameters_of(model);
    let generics = quote!(<#(#own,)* #scalar: #runtime::Real>);
    let derivation = derivation(&own_generics);
    let velocity_independent = !forced.as_ref().is_some_and(|forced| forced.depends_on_velocity);
    let velocity_independent = velocity_independent.then(|| {
        quote! {
            #[automatically_derived]
            impl #own_generics #runtime::VelocityIndependent for #self_ty #where_clause {}
        }
    });
    let linear_in_velocity = forced.as_ref().is_none_or(|forced| forced.linear_in_velocity).then(|| {
        quote! {
            #[automatically_derived]
            impl #own_generics #runtime::LinearInVelocity for #self_ty #where_clause {}
        }
    });
    let mass_independent = (!names(&phi, is_mass) && !names(forces, is_mass)).then(|| {
        quote! {
            #[automatically_derived]
            impl #own_generics #runtime::MassIndependent for #self_ty #where_clause {}
        }
    });
    if conservative {
        let (functions, steps) = (bare.pointwise(kernels), itself.steps(kernels));
        let (held, mass, t) = (hidden_lifetime(model), ident("_mass"), ident("_t"));
        return quote! {
            #[allow(clippy::approx_constant)]
            const _: () = {
                use #module as #runtime;

                #derivation

                #velocity_independent
                #linear_in_velocity
                #mass_independent
                #author

                #[automatically_derived]
                impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
                    #constants
                    #functions
                }

                #[automatically_derived]
                impl #generics #runtime::Field<#d, #scalar> for &#self_ty #where_clause {
                    #steps
                }

                #[automatically_derived]
                impl #generics #runtime::Law<#d, #scalar> for #self_ty #where_clause {
                    type Field<#held> = &#held Self where Self: #held;
                    #[inline(always)]
                    fn field(&self, #mass: #scalar, #t: #scalar) -> &Self {
                        self
                    }
                    #kept
                    #written
                }
            };
        };
    }
    let of_itself = (model.potential.is_some() && potential_is_bare).then(|| {
        let functions = bare.pointwise(kernels);
        quote! {
            #[automatically_derived]
            impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
                #constants
                #functions
            }
        }
    });
    let force_of_itself = forced.as_ref().filter(|_| !names(forces, is_mass)).map(|forced| {
        let functions = bare.force_functions(forced);
        quote! {
            #[automatically_derived]
            impl #generics #runtime::Force<#d, #scalar> for #self_ty #where_clause {
                #functions
            }
        }
    });
    let field_functions = match forced {
        Some(forced) => {
            let steps = momentary.forced_steps(forced);
            let (field, force) = (momentary.field_functions(kernels, forced), momentary.force_functions(forced));
            let workless = forced.workless;
            let capabilities = quote! {
                const FORCED: bool = true;
                const CONSERVES_ENERGY: bool = #workless;
            };
            quote!(#capabilities #steps #field #force)
        }
        None => momentary.steps(kernels),
    };
    let potential_functions = momentary.pointwise(kernels);
    let autonomous = !names(&phi, is_time) && !names(forces, is_time);
    let moment = generic_name(model, ["Moment", "Instant", "__Moment", "__Instant"], "__DmechMoment");
    let (held, law, mass, t) = (hidden_lifetime(model), ident("Law"), ident("mass"), ident("t"));
    quote! {
        #[allow(clippy::approx_constant)]
            const _: () = {
            use #module as #runtime;

            #derivation
            #of_itself
            #force_of_itself
            #velocity_independent
            #linear_in_velocity
            #mass_independent
            #author

            /// The law at one moment, for one mass.
            #[allow(dead_code)]
            pub struct #moment<#held, #law, #scalar> {
                law: &#held #law,
                mass: #scalar,
                t: #scalar,
            }

            #[automatically_derived]
            impl #generics #runtime::Law<#d, #scalar> for #self_ty #where_clause {
                type Field<#held> = #moment<#held, Self, #scalar> where Self: #held;
                const AUTONOMOUS: bool = #autonomous;
                #[inline(always)]
                fn field(&self, #mass: #scalar, #t: #scalar) -> Self::Field<'_> {
                    #moment { law: self, mass: #mass, t: #t }
                }
                #kept
                #written
            }

            #[automatically_derived]
            impl #generics #runtime::Potential<#d, #scalar> for #moment<'_, #self_ty, #scalar> #where_clause {
                #constants
                #potential_functions
            }

            #[automatically_derived]
            impl #generics #runtime::Field<#d, #scalar> for #moment<'_, #self_ty, #scalar> #where_clause {
                #field_functions
            }
        };
    }
}

/// The degree of a potential that is a polynomial; nothing is said of others.
pub(super) fn degree(degree: Option<u32>) -> Option<TokenStream> {
    let degree = Literal::u32_unsuffixed(degree?);
    Some(quote! {
        const DEGREE: ::core::option::Option<::core::primitive::u32> = ::core::option::Option::Some(#degree);
    })
}

/// Potential and force without content, for a law of one body that has errors.
pub(super) fn stub(model: &Model) -> TokenStream {
    let (scalar, runtime) = (scalar_name(model), module(model));
    let (d, any_dimension) = dimension(model);
    let (self_ty, where_clause) = (&model.self_ty, &model.generics.where_clause);
    let parameters: Vec<_> = parameters_of(model).collect();
    let function = |name: &str, arguments: &[&str], result: &TokenStream| {
        let name = ident(name);
        let arguments = arguments.iter().map(|a| ident(a));
        quote!(fn #name(&self, #(#arguments: [#scalar; #d]),*) -> #result { ::core::unreachable!() })
    };
    let (vector, matrix) = (quote!([#scalar; #d]), quote!([[#scalar; #d]; #d]));
    let functions = [
        function("potential", &["_q"], &quote!(#scalar)),
        function("gradient", &["_q"], &vector),
        function("hessian", &["_q"], &matrix),
        function("discrete_gradient", &["_a", "_b"], &vector),
        function("discrete_gradient_jacobian", &["_a", "_b"], &matrix),
    ];
    let names = ["force", "force_dq", "force_dv"].map(ident);
    let results = [&vector, &matrix, &matrix];
    let generics = quote!(<#(#parameters,)* #any_dimension #scalar: #runtime::Real>);
    quote! {
        #[automatically_derived]
        impl <#(#parameters),*> #runtime::Conservative for #self_ty #where_clause {}
        #[automatically_derived]
        impl #generics #runtime::Force<#d, #scalar> for #self_ty #where_clause {
            #(fn #names(&self, _q: #vector, _v: #vector, _t: #scalar) -> #results { ::core::unreachable!() })*
        }
        #[automatically_derived]
        impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
            #(#functions)*
        }
    }
}

/// The number of coordinates as it is printed, and the parameter that it is where it may be any.
pub(super) fn dimension(model: &Model) -> (TokenStream, Option<TokenStream>) {
    if model.dimension > 0 {
        let d = Literal::usize_unsuffixed(model.dimension);
        return (quote!(#d), None);
    }
    let name = generic_name(model, ["D", "Dim", "__D", "__Dim"], "__DmechDimension");
    (quote!(#name), Some(quote!(const #name: usize,)))
}

/// The hidden module of the facade that generated code refers to.
pub(super) fn module(model: &Model) -> TokenStream {
    let krate = &model.krate;
    quote!(#krate::__private::v1)
}

/// The generic parameters of the law as an impl block declares them: a struct's may have defaults, a block's not.
pub(super) fn parameters_of(model: &Model) -> impl Iterator<Item = GenericParam> + '_ {
    model.generics.params.iter().cloned().map(|mut parameter| {
        match &mut parameter {
            GenericParam::Type(ty) => ty.default = None,
            GenericParam::Const(constant) => constant.default = None,
            GenericParam::Lifetime(_) => {}
        }
        parameter
    })
}

/// R, unless the user's own type or generics have that name.
pub(super) fn scalar_name(model: &Model) -> Ident {
    generic_name(model, ["R", "Scalar", "__R", "__Scalar"], "__DmechScalar")
}

/// The lifetime of the law in a hidden struct: 'law, unless the user's generics have it.
pub(super) fn hidden_lifetime(model: &Model) -> Lifetime {
    let name = generic_name(model, ["law", "held", "__law", "__held"], "__dmech_law");
    Lifetime::new(&format!("'{name}"), Span::mixed_site())
}

/// The first name that stands nowhere where the user's own text is printed beside it: not in the type of the law, its
/// generics and their bounds, the data of the bodies, or the path of the facade.
pub(super) fn generic_name(model: &Model, candidates: [&str; 4], last_resort: &str) -> Ident {
    let Model { self_ty, generics, krate, .. } = model;
    let (bounds, data) = (&generics.where_clause, model.pair.as_ref().map(|pair| &pair.data));
    let data = data.into_iter().flatten();
    let tokens = quote!(#self_ty #generics #bounds #(#data)* #krate).to_string();
    let words: Vec<&str> = tokens.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let free = candidates.into_iter().find(|name| !words.contains(name));
    ident(free.unwrap_or(last_resort))
}
