//! The impl blocks of a law of one body.

use dmech_symbolic::expression::Expr;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::block::block;
use super::document::pointwise_texts;
use super::generics::{generic_name, hidden_lifetime, module, parameters_of, scalar_name};
use super::marker::{marker, told};
use super::names::{Names, ident, receiver, runtime};
use super::numbers::{names_of_numbers, numbers_of_law};
use super::pointwise::{FORCE, POTENTIAL};
use super::printer::{Printer, Reached};
use crate::Derivation;
use crate::lower::{Lowered, Source};
use crate::model::Model;

/// The traits of mechanics for the user's type, with everything derived from its potential and force.
///
/// What acts at one moment, for one mass, is a hidden struct of the numbers that the law reads of itself, so that they may be those of
/// eight laws side by side. What can be had without mass and time is implemented for the type itself too, by that struct.
pub(crate) fn implementation(derivation: &Derivation) -> TokenStream {
    let frame = Frame::of(derivation);
    let Frame { model, runtime, d, own, .. } = &frame;
    let (self_ty, where_clause) = (&model.self_ty, &model.generics.where_clause);
    let told = told(model, runtime, &super::document::derivation(derivation));
    let markers = frame.markers().map(|name| marker(model, runtime, name));
    let items = super::author::items(model, d, None);
    let (law, fields) = (frame.law(), frame.fields());
    let (of_itself, force_of_itself, moment) = (frame.potential_of_itself(), frame.force_of_itself(), frame.moment());
    let items = quote! {
        #told
        #(#markers)*

        #[automatically_derived]
        impl #own #runtime::written::Author<#d> for #self_ty #where_clause {
            #items
        }

        #law
        #fields
        #of_itself
        #force_of_itself
        #moment
    };
    block(&module(model), items)
}

/// What the blocks of an implementation share.
struct Frame<'a> {
    derivation: &'a Derivation,
    model: &'a Model,
    scalar: Ident,
    runtime: Ident,
    /// D.
    d: TokenStream,
    /// The generic parameters of the law, and these with the scalar.
    own: TokenStream,
    generics: TokenStream,
    /// The hidden struct.
    moment: Ident,
    /// What is read of the law.
    read: Vec<&'a TokenStream>,
}

impl<'a> Frame<'a> {
    fn of(derivation: &'a Derivation) -> Self {
        let model = &derivation.model;
        let (scalar, runtime) = (scalar_name(model), runtime());
        let own: Vec<_> = parameters_of(model).collect();
        Self {
            derivation,
            model,
            d: Literal::usize_unsuffixed(model.dimension).into_token_stream(),
            own: quote!(<#(#own),*>),
            generics: quote!(<#(#own,)* #scalar: #runtime::Real>),
            moment: generic_name(model, ["Moment", "Instant", "__Moment", "__Instant"], "__DmechMoment"),
            read: numbers_of_law(&derivation.lowered.parameters).collect(),
            scalar,
            runtime,
        }
    }

    /// Whether the potential, or the force, depends on the mass, or on the time.
    fn names(&self, source: fn(&Source) -> bool) -> [bool; 2] {
        let Lowered { graph, potential, force, parameters, .. } = &self.derivation.lowered;
        let named = |roots: &[Expr]| {
            parameters.iter().any(|p| source(&p.source) && roots.iter().any(|&e| graph.depends_on(e, &[p.symbol])))
        };
        [named(&[*potential]), named(force.as_deref().unwrap_or_default())]
    }

    fn names_mass(&self) -> [bool; 2] {
        self.names(|source| matches!(source, Source::Mass))
    }

    fn names_time(&self) -> [bool; 2] {
        self.names(|source| matches!(source, Source::Time))
    }

    fn printer(&self, law: Reached) -> Printer<'a> {
        let Lowered { graph, variables, parameters, .. } = &self.derivation.lowered;
        let runtime = &self.runtime;
        Printer {
            graph,
            names: Names::new(graph, variables, None, parameters),
            variables,
            parameters,
            scalar: self.scalar.clone(),
            runtime: quote!(#runtime),
            dimension: self.d.clone(),
            between: false,
            layout: &[],
            law,
        }
    }

    /// What the law is, in traits without functions.
    fn markers(&self) -> impl Iterator<Item = &'static str> {
        let forced = self.derivation.forced.as_ref();
        let velocity_independent = !forced.is_some_and(|forced| forced.depends_on_velocity);
        let linear_in_velocity = forced.is_none_or(|forced| forced.linear_in_velocity);
        let markers = [
            velocity_independent.then_some("VelocityIndependent"),
            linear_in_velocity.then_some("LinearInVelocity"),
            (self.names_mass() == [false; 2]).then_some("MassIndependent"),
        ];
        markers.into_iter().flatten()
    }

    /// What it says of its potential in constants.
    fn constants(&self) -> TokenStream {
        let (structure, forced) = (&self.derivation.kernels.structure, self.derivation.forced.as_ref());
        let central = structure.central.is_some() && forced.is_none();
        let linear = structure.constant_hessian && forced.is_none();
        let piecewise = forced.map_or(structure.piecewise, |forced| forced.piecewise);
        super::constants::of_potential(central, linear, piecewise, structure.degree.filter(|_| forced.is_none()))
    }

    /// The law, and what acts at one moment.
    fn law(&self) -> TokenStream {
        let Self { derivation, model, scalar, runtime, d, generics, moment, read, .. } = self;
        let (receiver, self_ty, where_clause) = (receiver(), &model.self_ty, &model.generics.where_clause);
        let count = Literal::usize_unsuffixed(read.len());
        let (held, mass, t) = (hidden_lifetime(model), ident("mass"), ident("t"));
        let autonomous = self.names_time() == [false; 2];
        let kept = self.printer(Reached::Law(quote!(#receiver))).invariants(&model.invariants, &derivation.invariants);
        // A law that is only run counts as used.
        let declared = model.fields.is_none().then(|| model.formulas().map(|f| &f.ident).collect::<Vec<_>>());
        let declared = declared.iter().flatten();
        quote! {
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
                    #moment { law: [#(#scalar::from_f64(#runtime::written::Number::number(#read))),*], #mass, #t }
                }
                #kept
                fn written(&#receiver) -> ::core::option::Option<&dyn #runtime::written::Written<#d>> {
                    ::core::option::Option::Some(#receiver)
                }
            }
        }
    }

    /// The numbers of the law, each over any scalar.
    fn fields(&self) -> TokenStream {
        let Self { model, scalar, runtime, d, own, moment, read, .. } = self;
        let (receiver, self_ty, where_clause) = (receiver(), &model.self_ty, &model.generics.where_clause);
        let count = Literal::usize_unsuffixed(read.len());
        let [law, mass, t] = ["law", "mass", "t"].map(ident);
        let names = names_of_numbers(&self.derivation.lowered.parameters);
        quote! {
            #[automatically_derived]
            impl #own #runtime::Fields<#d> for #self_ty #where_clause {
                type Numbers = [::core::primitive::f64; #count];
                type Moment<#scalar: #runtime::Real> = #moment<#scalar>;
                fn numbers(&#receiver) -> [::core::primitive::f64; #count] {
                    [#(#runtime::written::Number::number(#read)),*]
                }
                #names
                #[inline(always)]
                fn moment<#scalar: #runtime::Real>(
                    #law: [#scalar; #count],
                    #mass: #scalar,
                    #t: #scalar,
                ) -> #moment<#scalar> {
                    #moment { #law, #mass, #t }
                }
            }
        }
    }

    /// The potential and the field of the moment.
    fn moment(&self) -> TokenStream {
        let Self { derivation: Derivation { kernels, forced, .. }, scalar, runtime, d, moment, .. } = self;
        let printer = self.printer(Reached::Numbers);
        let (constants, potential) = (self.constants(), printer.pointwise(kernels));
        let field = match forced {
            None => printer.steps(kernels),
            Some(forced) => {
                let (workless, steps) = (forced.workless, printer.forced_steps(forced));
                let (field, force) = (printer.field_functions(kernels, forced), printer.force_functions(forced));
                quote! {
                    const FORCED: bool = true;
                    const CONSERVES_ENERGY: bool = #workless;
                    #steps
                    #field
                    #force
                }
            }
        };
        quote! {
            #[automatically_derived]
            impl<#scalar: #runtime::Real> #runtime::Potential<#d, #scalar> for #moment<#scalar> {
                #constants
                #potential
            }

            #[automatically_derived]
            impl<#scalar: #runtime::Real> #runtime::Field<#d, #scalar> for #moment<#scalar> {
                #field
            }
        }
    }

    /// The moment of the law itself, of mass 1.
    fn moment_at(&self, time: &TokenStream) -> TokenStream {
        let (Self { scalar, runtime, d, .. }, receiver) = (self, receiver());
        quote!(<Self as #runtime::Law<#d, #scalar>>::field(#receiver, #scalar::ONE, #time))
    }

    /// The potential of the law itself, where it is one without mass and time.
    fn potential_of_itself(&self) -> Option<TokenStream> {
        let Self { derivation, model, scalar, runtime, d, generics, .. } = self;
        if model.potential.is_none() || self.names_mass()[0] || self.names_time()[0] {
            return None;
        }
        let (constants, moment) = (self.constants(), self.moment_at(&quote!(#scalar::ZERO)));
        let (point, ends) = ([ident("q")], ["a", "b"].map(ident));
        let texts = pointwise_texts(&derivation.lowered.graph, &derivation.kernels);
        let functions = POTENTIAL.iter().zip(texts).map(|(function, text)| {
            let (name, arguments) = (ident(function.name), function.of(&point, &ends));
            let value = quote!(#runtime::Potential::#name(&#moment, #(#arguments),*));
            let function = function.with_body((scalar, d), arguments, &value);
            quote!(#(#[doc = #text])* #function)
        });
        let (self_ty, where_clause) = (&model.self_ty, &model.generics.where_clause);
        Some(quote! {
            #[automatically_derived]
            impl #generics #runtime::Potential<#d, #scalar> for #self_ty #where_clause {
                #constants
                #(#functions)*
            }
        })
    }

    /// Its force, where that is one without mass.
    fn force_of_itself(&self) -> Option<TokenStream> {
        let Self { derivation, model, scalar, runtime, d, generics, .. } = self;
        if derivation.forced.is_none() || self.names_mass()[1] {
            return None;
        }
        let ([q, v, t], receiver) = (["q", "v", "t"].map(ident), receiver());
        let moment = self.moment_at(&quote!(#t));
        let functions = FORCE.map(|(name, rank)| {
            let (name, result) = (ident(name), rank.array(scalar, d));
            quote! {
                #[inline(always)]
                fn #name(&#receiver, #q: [#scalar; #d], #v: [#scalar; #d], #t: #scalar) -> #result {
                    #runtime::Field::#name(&#moment, #q, #v, #t)
                }
            }
        });
        let (self_ty, where_clause) = (&model.self_ty, &model.generics.where_clause);
        Some(quote! {
            #[automatically_derived]
            impl #generics #runtime::Force<#d, #scalar> for #self_ty #where_clause {
                #(#functions)*
            }
        })
    }
}
