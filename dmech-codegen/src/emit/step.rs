//! The functions that solve a step.

use dmech_symbolic::expression::Symbol;
use dmech_symbolic::kernel::{Given, Step, Way};
use dmech_symbolic::linear::Asked;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::body::{Printed, body};
use super::document::increment;
use super::names::{ident, receiver, underscored};
use super::printer::Printer;

impl Printer<'_> {
    /// The function that solves a step, with what it is called.
    pub(super) fn step(&self, name: &str, what: &str, step: &Step) -> TokenStream {
        let Self { scalar, runtime, variables, .. } = self;
        let equation = ident("equation");
        let Step { way, given, program, .. } = step;
        let between = *given == Given::InParts;
        let used = program.symbols();
        let parameters = self.bind_parameters(&used, false);
        let Printed { statements, outputs } = body(program, &self.names, scalar);
        let solution = if let Way::Central = way {
            let solver = ident(if between { "discrete" } else { "implicit" });
            let arguments = if between { vec![variables.s_a, variables.s_b] } else { vec![variables.s] };
            let arguments = arguments.into_iter().map(|s| underscored(&self.names.symbol(s), used.contains(&s)));
            quote! {
                #runtime::newton::central::#solver(#equation, |#(#arguments: #scalar),*| {
                    #statements
                    [#(#outputs),*]
                })
            }
        } else {
            let solver = ident(match (way, between) {
                (Way::Linear, false) => "once",
                (Way::Linear, true) => "twice",
                _ => "drive",
            });
            let (arguments, unpack) = self.unpacked(&[("delta", &variables.delta), ("b", &variables.b)], &used);
            let known = self.pattern(&variables.rhs, &used).map(|pattern| quote!(let #pattern = #equation.known();));
            let vectors = [("a", &variables.a), ("v", &variables.v), ("drift", &variables.drift)];
            let read = self.read_of(&equation, &vectors, &[variables.g, variables.rate, variables.t_end], &used);
            let closure_equation = underscored(&equation, known.is_some() || !read.is_empty());
            let constructor = ident(if between { "in_parts" } else { "rounded" });
            let (vectors, positive) = outputs.split_at(Given::VECTORS * variables.q.len());
            let vectors = vectors.chunks(variables.q.len());
            let correction = quote!(#runtime::newton::Correction::#constructor(#([#(#vectors),*]),*));
            let asked = asked(step.asked);
            let result = match way {
                Way::Linear => quote!((#correction, [#(#positive),*])),
                _ => quote!(#correction.#asked([#(#positive),*])),
            };
            quote! {
                #runtime::newton::#solver(#equation, |#closure_equation, #(#arguments),*| {
                    #unpack
                    #known
                    #(#read)*
                    #statements
                    #result
                })
            }
        };
        let (doc, function) = (increment(what, step), self.increment(name, quote!(#parameters #solution)));
        quote!(#[doc = #doc] #function)
    }

    /// A function that solves the equation of a step.
    pub(super) fn increment(&self, name: &str, body: TokenStream) -> TokenStream {
        let Self { scalar, runtime, dimension: d, .. } = self;
        let (name, receiver, equation) = (ident(name), receiver(), ident("equation"));
        // Without `always` the equation and its solution go through memory.
        quote! {
            #[inline(always)]
            fn #name(
                &#receiver,
                #equation: &#runtime::newton::Equation<#d, #scalar>,
            ) -> ::core::result::Result<#runtime::newton::Increment<#d, #scalar>, #runtime::newton::NotConverged> {
                #body
            }
        }
    }

    /// What of the equation is used: `let [vx, vy] = equation.v;` and `let g = equation.g;`.
    pub(super) fn read_of(
        &self,
        equation: &Ident,
        vectors: &[(&str, &Vec<Symbol>)],
        scalars: &[Symbol],
        used: &[Symbol],
    ) -> Vec<TokenStream> {
        let vectors = vectors.iter().filter_map(|(field, symbols)| {
            let field = ident(field);
            self.pattern(symbols, used).map(|pattern| quote!(let #pattern = #equation.#field;))
        });
        let scalars = scalars.iter().filter(|symbol| used.contains(symbol)).map(|&symbol| {
            let name = self.names.symbol(symbol);
            quote!(let #name = #equation.#name;)
        });
        vectors.chain(scalars).collect()
    }
}

/// The function of a correction that asks it.
pub(super) fn asked(what: Asked) -> Ident {
    ident(match what {
        Asked::Positive => "if_positive",
        Asked::Oriented => "if_oriented",
    })
}
