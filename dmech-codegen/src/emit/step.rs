//! The functions that solve a step.

use dmech_symbolic::kernel::{Given, Step, Way};
use dmech_symbolic::linear::Asked;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::body::{Printed, body};
use super::names::{ident, receiver, underscored};
use super::printer::Printer;

impl Printer<'_> {
    pub(super) fn step(&self, name: &str, step: &Step) -> TokenStream {
        let Self { scalar, runtime, variables, dimension: d, .. } = self;
        let (name, receiver) = (ident(name), receiver());
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
                (Way::Linear, true) => "once_discrete",
                (_, false) => "drive",
                (_, true) => "drive_discrete",
            });
            let arrays = [("a", &variables.a[..]), ("delta", &variables.delta[..]), ("b", &variables.b[..])];
            let (arguments, unpack) = self.unpacked(&arrays[usize::from(!between)..], &used);
            let known = self.pattern(&variables.rhs, &used).map(|pattern| quote!(let #pattern = #equation.known();));
            let velocities = [("v", &variables.v), ("drift", &variables.drift)].map(|(field, symbols)| {
                let field = ident(field);
                self.pattern(symbols, &used).map(|pattern| quote!(let #pattern = #equation.#field;))
            });
            let scalars = [variables.g, variables.rate, variables.t_end].map(|symbol| {
                let name = self.names.symbol(symbol);
                used.contains(&symbol).then(|| quote!(let #name = #equation.#name;))
            });
            let needs_equation = known.is_some() || velocities.iter().chain(&scalars).any(Option::is_some);
            let closure_equation = underscored(&equation, needs_equation);
            let constructor = ident(if between { "in_parts" } else { "rounded" });
            let (vectors, positive) = outputs.split_at(given.vectors() * variables.q.len());
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
                    #(#velocities)*
                    #(#scalars)*
                    #statements
                    #result
                })
            }
        };
        // Without `always` the equation and its solution go through memory.
        quote! {
            #[inline(always)]
            fn #name(
                &#receiver,
                #equation: &#runtime::newton::Equation<#d, #scalar>,
            ) -> ::core::result::Result<#runtime::newton::Increment<#d, #scalar>, #runtime::newton::NotConverged> {
                #parameters
                #solution
            }
        }
    }
}

/// The function of a correction that asks it.
pub(super) fn asked(what: Asked) -> Ident {
    ident(match what {
        Asked::Positive => "if_positive",
        Asked::Oriented => "if_oriented",
    })
}
