//! The impl blocks of a law between two bodies.

use dmech_symbolic::expression::Symbol;
use dmech_symbolic::kernel::{PairForce, PairFormulas, PairPotential};
use dmech_symbolic::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::block::block;
use super::body::{Printed, body};
use super::generics::{PairGenerics, generic_name, hidden_lifetime, module};
use super::marker::{marker, told};
use super::names::{Names, ident, receiver, runtime, underscored};
use super::numbers::{names_of_numbers, numbers_of_law};
use super::pair_document::{self, force_texts, potential_texts};
use super::pointwise::{POTENTIAL, blind};
use super::printer::{Printer, Reached};
use super::rank::Rank;
use crate::PairDerivation;
use crate::lower::{LoweredPair, Read, Source, data};
use crate::model::Model;

/// The traits of a law between two bodies for the user's type.
///
/// What acts between two bodies at one moment is a hidden struct of the numbers that the law reads of itself and of both.
pub(crate) fn pair_implementation(derivation: &PairDerivation) -> TokenStream {
    let PairDerivation { model, lowered, pair, kernels } = derivation;
    let LoweredPair { variables: of_two, layout, .. } = pair;
    let names = PairGenerics::of(model);
    let PairGenerics { scalar, foreign, with_data, author, data: data_type, dimension, .. } = &names;
    let (runtime, self_ty) = (runtime(), &model.self_ty);
    let where_clause = &model.generics.where_clause;
    let receiver = receiver();
    let printer = Printer {
        graph: &lowered.graph,
        names: Names::new(&lowered.graph, &lowered.variables, Some(of_two), &lowered.parameters),
        variables: &lowered.variables,
        parameters: &lowered.parameters,
        scalar: scalar.clone(),
        runtime: quote!(#runtime),
        dimension: dimension.clone(),
        between: true,
        layout,
        law: Reached::Numbers,
    };
    let told = told(model, &runtime, &pair_document::derivation(derivation));
    let (constants, functions) = potential(&printer, derivation);
    let force = kernels.force.as_ref().map(|force| printer.pair_force(force, derivation));
    let acts = kernels.potential.is_none().then(|| {
        quote! { const POTENTIAL: bool = false; }
    });
    let velocity_independent = !kernels.force.as_ref().is_some_and(|force| force.depends_on_velocity);
    let markers = [
        kernels.symmetric.then_some("Symmetric"),
        velocity_independent.then_some("VelocityIndependent"),
        velocity_independent.then_some("LinearInVelocity"),
    ];
    let markers = markers.into_iter().flatten().map(|name| marker(model, &runtime, name));
    let autonomous = !lowered.parameters.iter().any(|p| matches!(p.source, Source::Time));
    let items = super::author::items(model, dimension, Some(data_type));
    let reads = reads(&printer, &names, model, layout);
    let read: Vec<_> = numbers_of_law(&lowered.parameters).collect();
    let fields = names_of_numbers(&lowered.parameters);
    let pair = generic_name(model, ["Pair", "Acting", "__Pair", "__Acting"], "__DmechPair");
    let (held, law) = (hidden_lifetime(model), ident("law"));
    let (a, b, t) = (ident("a"), ident("b"), ident("t"));
    let [of_body, of_law] = [layout.len(), read.len()].map(Literal::usize_unsuffixed);
    let numbers = quote!([#scalar; #of_body]);
    // A law that is only run counts as used.
    let declared = model.formulas().map(|formula| &formula.ident);
    let items = quote! {
        #told
        #(#markers)*
        #reads

        #[automatically_derived]
        impl #author #runtime::written::PairAuthor<#dimension, #data_type> for #self_ty #where_clause {
            #items
        }

        /// The law between two bodies at one moment.
        #[allow(dead_code)]
        #[derive(Clone, Copy)]
        pub struct #pair<#scalar> {
            /// What is read of the law.
            law: [#scalar; #of_law],
            a: #numbers,
            b: #numbers,
            t: #scalar,
        }

        #[automatically_derived]
        impl #with_data #runtime::PairLaw<#dimension, #data_type, #scalar> for #self_ty #where_clause {
            type Between<#held> = #pair<#scalar> where Self: #held;
            const AUTONOMOUS: bool = #autonomous;
            #[inline(always)]
            fn between(&#receiver, #a: #numbers, #b: #numbers, #t: #scalar) -> #pair<#scalar> {
                #(let _ = <#self_ty>::#declared;)*
                #pair { law: [#(#scalar::from_f64(#runtime::written::Number::number(#read))),*], #a, #b, #t }
            }
            fn written(&#receiver) -> ::core::option::Option<&dyn #runtime::written::WrittenPair<#dimension, #data_type>> {
                ::core::option::Option::Some(#receiver)
            }
        }

        #[automatically_derived]
        impl #author #runtime::PairFields<#dimension, #data_type> for #self_ty #where_clause {
            type Fields = [::core::primitive::f64; #of_law];
            type Moment<#scalar: #runtime::Real> = #pair<#scalar>;
            fn fields(&#receiver) -> [::core::primitive::f64; #of_law] {
                [#(#runtime::written::Number::number(#read)),*]
            }
            #fields
            #[inline(always)]
            fn moment<#scalar: #runtime::Real>(
                #law: [#scalar; #of_law],
                #a: #numbers,
                #b: #numbers,
                #t: #scalar,
            ) -> #pair<#scalar> {
                #pair { #law, #a, #b, #t }
            }
        }

        #[automatically_derived]
        impl #foreign #runtime::Potential<#dimension, #scalar> for #pair<#scalar> {
            #constants
            #functions
        }

        #[automatically_derived]
        impl #foreign #runtime::Between<#dimension, #scalar> for #pair<#scalar> {
            #acts
            #force
        }
    };
    block(&module(model), items)
}

/// What the law reads of a body.
fn reads(printer: &Printer<'_>, names: &PairGenerics, model: &Model, layout: &[Read]) -> TokenStream {
    let (runtime, self_ty, where_clause) = (&printer.runtime, &model.self_ty, &model.generics.where_clause);
    let PairGenerics { data: data_type, reads, .. } = names;
    let count = Literal::usize_unsuffixed(layout.len());
    let (mass, data) = (ident("mass"), data());
    let reads_mass = layout.iter().any(|read| matches!(read, Read::Mass));
    let reads_data = layout.iter().any(|read| matches!(read, Read::Data(_)));
    let mass_argument = underscored(&mass, reads_mass);
    let data_argument = if reads_data { data.clone() } else { ident("_data") };
    let numbers = layout.iter().map(|read| match read {
        Read::Mass => quote!(#mass),
        Read::Data(tokens) => tokens.clone(),
    });
    quote! {
        #[automatically_derived]
        impl #reads #runtime::Reads<#data_type> for #self_ty #where_clause {
            type Numbers = [::core::primitive::f64; #count];
            #[inline(always)]
            fn numbers(#mass_argument: ::core::primitive::f64, #data_argument: &#data_type) -> Self::Numbers {
                [#(#numbers),*]
            }
        }
    }
}

/// The constants and functions of `Potential`.
fn potential(printer: &Printer<'_>, derivation: &PairDerivation) -> (TokenStream, TokenStream) {
    let (potential, force) = (derivation.kernels.potential.as_ref(), derivation.kernels.force.as_ref());
    let is_radial = |p: &PairPotential| matches!(p.formulas, PairFormulas::Radial(_));
    let central = potential.is_none_or(is_radial);
    // With a force beside it nothing of a step follows from the potential alone.
    let alone = force.is_none();
    let linear = alone && potential.is_none_or(|p| p.linear);
    let piecewise = potential.is_some_and(|p| p.piecewise) || force.is_some_and(|force| force.piecewise);
    let degree = potential.filter(|_| alone).and_then(|potential| potential.degree);
    let constants = super::constants::of_potential(central, linear, piecewise, degree);
    let Some(potential) = potential else {
        let (scalar, d) = (&printer.scalar, &printer.dimension);
        return (constants, blind("_d", (scalar, d), |rank| rank.zero(scalar, d)));
    };
    let documents = potential_texts(derivation, potential);
    let functions = if is_radial(potential) {
        printer.radial(potential, derivation, &documents)
    } else {
        printer.pointwise_functions("d", potential.pointwise.each(), &documents)
    };
    (constants, functions)
}

impl Printer<'_> {
    /// A potential of the distance.
    fn radial(&self, radial: &PairPotential, derivation: &PairDerivation, documents: &[Vec<String>; 5]) -> TokenStream {
        let pair = &derivation.pair.variables;
        let (at, ends) = ([("d", pair.s)], [("a", pair.s_a), ("b", pair.s_b)]);
        let list = POTENTIAL.iter().zip(radial.pointwise.each()).zip(documents);
        let functions = list.map(|((function, program), text)| {
            let function = self.radial_function(function.name, function.of(&at, &ends), function.rank, program);
            quote!(#(#[doc = #text])* #function)
        });
        functions.collect()
    }

    /// One function of separations, of which the program sees the squares.
    fn radial_function(&self, name: &str, arguments: &[(&str, Symbol)], rank: Rank, program: &Program) -> TokenStream {
        let (scalar, d, runtime) = (&self.scalar, &self.dimension, &self.runtime);
        let used = program.symbols();
        let arrays: Vec<_> = arguments.iter().map(|(array, _)| ident(array)).collect();
        let is_energy = matches!(rank, Rank::Scalar);
        let needed = |s: &Symbol| !is_energy || used.contains(s);
        let signature = arguments.iter().map(|(array, s)| {
            let array = underscored(&ident(array), needed(s));
            quote!(#array: [#scalar; #d])
        });
        let squares = arguments.iter().filter(|(_, s)| used.contains(s)).map(|(array, s)| {
            let (array, s) = (ident(array), self.names.symbol(*s));
            quote!(let #s = #runtime::radial::square(#array);)
        });
        let parameters = self.bind_parameters(&used, false);
        let Printed { statements, outputs } = body(program, &self.names, scalar);
        let (name, receiver, result) = (ident(name), receiver(), rank.array(scalar, d));
        let value = match is_energy {
            true => outputs[0].clone(),
            false => quote!(#runtime::radial::#name(#(#outputs,)* #(#arrays),*)),
        };
        quote! {
            #[inline(always)]
            fn #name(&#receiver, #(#signature),*) -> #result {
                #(#squares)*
                #parameters
                #statements
                #value
            }
        }
    }

    /// What `Between` says of a law with a force.
    fn pair_force(&self, force: &PairForce, derivation: &PairDerivation) -> TokenStream {
        let pair = &derivation.pair.variables;
        let arrays = [("d", &self.variables.q[..]), ("va", &pair.va[..]), ("vb", &pair.vb[..])];
        let [force_doc, jacobians_doc] = force_texts(derivation, force);
        let reciprocal = force.reciprocal;
        let jacobians = self.function("force_jacobians", &arrays, &[], Rank::Matrices, &force.jacobians);
        let force = self.function("force", &arrays, &[], Rank::Vector, &force.force);
        quote! {
            const FORCED: bool = true;
            const RECIPROCAL: bool = #reciprocal;
            #(#[doc = #force_doc])* #force
            #(#[doc = #jacobians_doc])* #jacobians
        }
    }
}
