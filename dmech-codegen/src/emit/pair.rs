//! The impl blocks of a law between two bodies.

use dmech_symbolic::expression::Symbol;
use dmech_symbolic::kernel::{PairForce, PairFormulas, PairPotential};
use dmech_symbolic::program::Program;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::parse_quote;

use super::body::{Printed, body};
use super::implementation::{
    degree, dimension, generic_name, hidden_lifetime, module, names_of_numbers, numbers_of_law, parameters_of,
    scalar_name,
};
use super::names::{Names, ident, receiver, runtime, underscored};
use super::pair_document::{self, force_texts, potential_texts};
use super::printer::{Printer, Reached};
use super::rank::{POINTWISE, Rank};
use crate::PairDerivation;
use crate::lower::{LoweredPair, Read, Source, data};
use crate::model::Model;

/// The traits of a law between two bodies for the user's type.
///
/// What acts between two bodies at one moment is a hidden struct of the numbers that the law reads of itself and of both.
pub(crate) fn pair_implementation(derivation: &PairDerivation) -> TokenStream {
    let PairDerivation { model, lowered, pair, kernels } = derivation;
    let LoweredPair { variables: of_two, layout, .. } = pair;
    let names = Generics::of(model);
    let Generics { scalar, own, foreign, with_data, author, data: data_type, dimension, .. } = &names;
    let (module, runtime, self_ty) = (module(model), runtime(), &model.self_ty);
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
    let text = pair_document::derivation(derivation);
    let (constants, functions) = potential(&printer, derivation);
    let force = kernels.force.as_ref().map(|force| printer.pair_force(force, derivation));
    let acts = kernels.potential.is_none().then(|| {
        quote! { const POTENTIAL: bool = false; }
    });
    let symmetric = kernels.symmetric.then(|| {
        quote! {
            #[automatically_derived]
            impl #own #runtime::Symmetric for #self_ty #where_clause {}
        }
    });
    let velocity_independent = !kernels.force.as_ref().is_some_and(|force| force.depends_on_velocity);
    let velocity_independent = velocity_independent.then(|| {
        quote! {
            #[automatically_derived]
            impl #own #runtime::VelocityIndependent for #self_ty #where_clause {}
            #[automatically_derived]
            impl #own #runtime::LinearInVelocity for #self_ty #where_clause {}
        }
    });
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
    quote! {
        #[allow(clippy::approx_constant)]
        const _: () = {
            use #module as #runtime;

            #[automatically_derived]
            impl #own #runtime::Derivation for #self_ty #where_clause {
                fn derivation(&#receiver) -> &'static ::core::primitive::str {
                    #text
                }
            }
            #symmetric
            #velocity_independent
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
                    #pair { law: [#(#scalar::from_f64(#read)),*], #a, #b, #t }
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
                    [#(#read),*]
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
    }
}

/// The generic parameters of the impl blocks.
struct Generics {
    scalar: Ident,
    /// The law's own.
    own: TokenStream,
    /// The dimension, where it is any, and the scalar, without the law's own.
    foreign: TokenStream,
    /// With the law's own and the data of the bodies, where they are any.
    with_data: TokenStream,
    /// The same without the scalar.
    author: TokenStream,
    /// The same without the dimension.
    reads: TokenStream,
    data: TokenStream,
    dimension: TokenStream,
}

impl Generics {
    fn of(model: &Model) -> Self {
        let runtime = module(model);
        let scalar = scalar_name(model);
        let (dimension, any_dimension) = dimension(model);
        let data = match model.pair.as_ref().and_then(|pair| pair.data.as_ref()) {
            Some(data) => quote!(#data),
            None => {
                let name = generic_name(model, ["P", "Data", "__P", "__Data"], "__DmechData");
                quote!(#name)
            }
        };
        let any_data = model.pair.as_ref().is_none_or(|pair| pair.data.is_none());
        let parameters: Vec<_> = parameters_of(model).collect();
        let last_data = any_data.then(|| quote!(#data));
        let any_data = any_data.then(|| quote!(#data,));
        Self {
            own: quote!(<#(#parameters),*>),
            foreign: quote!(<#any_dimension #scalar: #runtime::Real>),
            with_data: quote!(<#(#parameters,)* #any_dimension #any_data #scalar: #runtime::Real>),
            author: quote!(<#(#parameters,)* #any_dimension #any_data>),
            reads: quote!(<#(#parameters,)* #last_data>),
            scalar,
            data,
            dimension,
        }
    }
}

/// What the law reads of a body.
fn reads(printer: &Printer<'_>, names: &Generics, model: &Model, layout: &[Read]) -> TokenStream {
    let (runtime, self_ty, where_clause) = (&printer.runtime, &model.self_ty, &model.generics.where_clause);
    let Generics { data: data_type, reads, .. } = names;
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
    let piecewise = piecewise.then(|| {
        quote! { const PIECEWISE: bool = true; }
    });
    let degree = degree(potential.filter(|_| alone).and_then(|potential| potential.degree));
    let constants = quote! {
        const CENTRAL: bool = #central;
        const LINEAR: bool = #linear;
        #piecewise
        #degree
    };
    let Some(potential) = potential else { return (constants, printer.no_potential()) };
    let documents = potential_texts(derivation, potential);
    let functions = if is_radial(potential) {
        printer.radial(potential, derivation, &documents)
    } else {
        printer.pointwise_functions("d", potential.pointwise(), &documents)
    };
    (constants, functions)
}

impl Printer<'_> {
    /// A force alone.
    fn no_potential(&self) -> TokenStream {
        let (scalar, d, receiver) = (&self.scalar, &self.dimension, receiver());
        let functions = POINTWISE.map(|(name, rank)| {
            let result = rank.array(scalar, d);
            let zero = match rank {
                Rank::Scalar => quote!(#scalar::ZERO),
                Rank::Vector => quote!([#scalar::ZERO; #d]),
                Rank::Matrix | Rank::Matrices => quote!([[#scalar::ZERO; #d]; #d]),
            };
            let arguments = if name.starts_with("discrete") { &["_a", "_b"][..] } else { &["_d"] };
            let (name, arguments) = (ident(name), arguments.iter().map(|argument| ident(argument)));
            quote! {
                #[inline(always)]
                fn #name(&#receiver, #(#arguments: [#scalar; #d]),*) -> #result {
                    #zero
                }
            }
        });
        quote!(#(#functions)*)
    }

    /// A potential of the distance.
    fn radial(&self, radial: &PairPotential, derivation: &PairDerivation, documents: &[Vec<String>; 5]) -> TokenStream {
        let pair = &derivation.pair.variables;
        let ends = [("a", pair.s_a), ("b", pair.s_b)];
        let list = POINTWISE.iter().zip(radial.pointwise()).zip(documents);
        let functions = list.map(|((&(name, rank), program), text)| {
            let arguments = if name.starts_with("discrete") { &ends[..] } else { &[("d", pair.s)] };
            let function = self.radial_function(name, arguments, rank, program);
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

/// What acts between two bodies without content, for a law that has errors.
pub(super) fn pair_stub(model: &Model) -> TokenStream {
    let Generics { scalar, own, foreign, with_data, reads, data, dimension: d, .. } = Generics::of(model);
    let (runtime, self_ty, where_clause) = (module(model), &model.self_ty, &model.generics.where_clause);
    let pair = generic_name(model, ["Pair", "Acting", "__Pair", "__Acting"], "__DmechPair");
    let (held, numbers, q) = (hidden_lifetime(model), ident("_numbers"), ident("_d"));
    let (vector, matrix) = (quote!([#scalar; #d]), quote!([[#scalar; #d]; #d]));
    let unreachable = quote!({ ::core::unreachable!() });
    // Where it is not known that the law was meant for two bodies, its generics need not be `Sync`.
    let mut generics = model.generics.clone();
    if generics.type_params().next().is_some() {
        generics.make_where_clause().predicates.push(parse_quote!(#self_ty: ::core::marker::Sync));
    }
    let shared = &generics.where_clause;
    quote! {
        const _: () = {
            #[automatically_derived]
            impl #own #runtime::Symmetric for #self_ty #where_clause {}
            #[automatically_derived]
            impl #reads #runtime::Reads<#data> for #self_ty #where_clause {
                type Numbers = [::core::primitive::f64; 0];
                fn numbers(_: ::core::primitive::f64, _: &#data) -> Self::Numbers #unreachable
            }
            pub struct #pair;
            #[automatically_derived]
            impl #with_data #runtime::PairLaw<#d, #data, #scalar> for #self_ty #shared {
                type Between<#held> = #pair where Self: #held;
                fn between(&self, _: [#scalar; 0], #numbers: [#scalar; 0], _: #scalar) -> #pair #unreachable
            }
            #[automatically_derived]
            impl #foreign #runtime::Potential<#d, #scalar> for #pair {
                fn potential(&self, #q: #vector) -> #scalar #unreachable
                fn gradient(&self, #q: #vector) -> #vector #unreachable
                fn hessian(&self, #q: #vector) -> #matrix #unreachable
                fn discrete_gradient(&self, #q: #vector, _: #vector) -> #vector #unreachable
                fn discrete_gradient_jacobian(&self, #q: #vector, _: #vector) -> #matrix #unreachable
            }
            #[automatically_derived]
            impl #foreign #runtime::Between<#d, #scalar> for #pair {}
        };
    }
}
