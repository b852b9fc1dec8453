//! The impl blocks of a law of one body.

use dmech_symbolic::expression::Expr;
use dmech_symbolic::kernel::Kernels;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::document::pointwise_texts;
use super::generics::{generic_name, hidden_lifetime, module, parameters_of, scalar_name};
use super::marker::{marker, told};
use super::names::{Names, ident, receiver, runtime, underscored};
use super::pointwise::{FORCE, POTENTIAL};
use super::printer::{Printer, Reached};
use crate::Derivation;
use crate::lower::{Lowered, Parameter, Source};

/// The traits of mechanics for the user's type, with everything derived from its potential and force.
///
/// What acts at one moment, for one mass, is a hidden struct of the numbers that the law reads of itself, so that they may be those of
/// eight laws side by side. What can be had without mass and time is implemented for the type itself too, by that struct.
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
    let receiver = receiver();
    let self_ty = &model.self_ty;
    let where_clause = &model.generics.where_clause;
    let printer = |law: Reached| Printer {
        graph,
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
    let momentary = printer(Reached::Numbers);
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
    let own: Vec<_> = parameters_of(model).collect();
    let own_generics = quote!(<#(#own),*>);
    let generics = quote!(<#(#own,)* #scalar: #runtime::Real>);
    let items = super::author::items(model, &quote!(#d), None);
    let velocity_independent = !forced.as_ref().is_some_and(|forced| forced.depends_on_velocity);
    let linear_in_velocity = forced.as_ref().is_none_or(|forced| forced.linear_in_velocity);
    let markers = [
        velocity_independent.then_some("VelocityIndependent"),
        linear_in_velocity.then_some("LinearInVelocity"),
        (!names(&phi, is_mass) && !names(forces, is_mass)).then_some("MassIndependent"),
    ];
    let markers = markers.into_iter().flatten().map(|name| marker(model, &runtime, name));
    let moment = generic_name(model, ["Moment", "Instant", "__Moment", "__Instant"], "__DmechMoment");
    let law_at =
        |time: TokenStream| quote!(<Self as #runtime::Law<#d, #scalar>>::field(#receiver, #scalar::ONE, #time));
    let of_itself = (model.potential.is_some() && potential_is_bare).then(|| {
        let functions = momentary.of_moment(kernels, &law_at(quote!(#scalar::ZERO)));
        quote! {
            #[automatically_derived]
            impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
                #constants
                #functions
            }
        }
    });
    let force_of_itself = forced.as_ref().filter(|_| !names(forces, is_mass)).map(|_| {
        let t = ident("t");
        let functions = momentary.force_of_moment(&law_at(quote!(#t)), &t);
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
    let kept = printer(Reached::Law(quote!(#receiver))).invariants(&model.invariants, invariants);
    let autonomous = !names(&phi, is_time) && !names(forces, is_time);
    let read: Vec<_> = numbers_of_law(parameters).collect();
    let fields = names_of_numbers(parameters);
    let count = Literal::usize_unsuffixed(read.len());
    let (held, law, mass, t) = (hidden_lifetime(model), ident("law"), ident("mass"), ident("t"));
    // A law that is only run counts as used.
    let declared = model.fields.is_none().then(|| model.formulas().map(|f| &f.ident).collect::<Vec<_>>());
    let declared = declared.iter().flatten();
    let told = told(model, &runtime, &super::document::derivation(derivation));
    quote! {
        #[allow(clippy::approx_constant)]
        const _: () = {
            use #module as #runtime;

            #told
            #(#markers)*

            #[automatically_derived]
            impl #own_generics #runtime::written::Author<#d> for #self_ty #where_clause {
                #items
            }

            /// The law at one moment, for one mass.
            #[allow(dead_code)]
            #[derive(Clone, Copy)]
            pub struct #moment<#scalar> {
                /// What is read of the law.
                law: [#scalar; #count],
                mass: #scalar,
                t: #scalar,
            }

            #[automatically_derived]
            impl #generics #runtime::Law<#d, #scalar> for #self_ty #where_clause {
                type Field<#held> = #moment<#scalar> where Self: #held;
                const AUTONOMOUS: bool = #autonomous;
                #[inline(always)]
                fn field(&#receiver, #mass: #scalar, #t: #scalar) -> #moment<#scalar> {
                    #(let _ = <#self_ty>::#declared;)*
                    #moment { law: [#(#scalar::from_f64(#read)),*], #mass, #t }
                }
                #kept
                fn written(&#receiver) -> ::core::option::Option<&dyn #runtime::written::Written<#d>> {
                    ::core::option::Option::Some(#receiver)
                }
            }

            #[automatically_derived]
            impl #own_generics #runtime::Fields<#d> for #self_ty #where_clause {
                type Numbers = [::core::primitive::f64; #count];
                type Moment<#scalar: #runtime::Real> = #moment<#scalar>;
                fn numbers(&#receiver) -> [::core::primitive::f64; #count] {
                    [#(#read),*]
                }
                #fields
                #[inline(always)]
                fn moment<#scalar: #runtime::Real>(
                    #law: [#scalar; #count],
                    #mass: #scalar,
                    #t: #scalar,
                ) -> #moment<#scalar> {
                    #moment { #law, #mass, #t }
                }
            }

            #of_itself
            #force_of_itself

            #[automatically_derived]
            impl<#scalar: #runtime::Real> #runtime::Potential<#d, #scalar> for #moment<#scalar> {
                #constants
                #potential_functions
            }

            #[automatically_derived]
            impl<#scalar: #runtime::Real> #runtime::Field<#d, #scalar> for #moment<#scalar> {
                #field_functions
            }
        };
    }
}

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

impl Printer<'_> {
    /// The functions of `Potential` for the law itself, by its moment.
    fn of_moment(&self, kernels: &Kernels, moment: &TokenStream) -> TokenStream {
        let (runtime, point, ends) = (&self.runtime, [ident("q")], ["a", "b"].map(ident));
        let functions = POTENTIAL.iter().zip(pointwise_texts(self.graph, kernels)).map(|(function, text)| {
            let (name, arguments) = (ident(function.name), function.of(&point, &ends));
            let value = quote!(#runtime::Potential::#name(&#moment, #(#arguments),*));
            let function = function.with_body((&self.scalar, &self.dimension), arguments, &value);
            quote!(#(#[doc = #text])* #function)
        });
        functions.collect()
    }

    /// The functions of `Force` for the law itself.
    fn force_of_moment(&self, moment: &TokenStream, t: &Ident) -> TokenStream {
        let (scalar, d, runtime, receiver) = (&self.scalar, &self.dimension, &self.runtime, receiver());
        let [q, v] = ["q", "v"].map(ident);
        let functions = FORCE.map(|(name, rank)| {
            let (name, result) = (ident(name), rank.array(scalar, d));
            quote! {
                #[inline(always)]
                fn #name(&#receiver, #q: [#scalar; #d], #v: [#scalar; #d], #t: #scalar) -> #result {
                    #runtime::Field::#name(&#moment, #q, #v, #t)
                }
            }
        });
        functions.into_iter().collect()
    }
}

/// The degree of a potential that is a polynomial; nothing is said of others.
pub(super) fn degree(degree: Option<u32>) -> Option<TokenStream> {
    let degree = Literal::u32_unsuffixed(degree?);
    Some(quote! {
        const DEGREE: ::core::option::Option<::core::primitive::u32> = ::core::option::Option::Some(#degree);
    })
}
