//! The energy-exact step of a force that does no work.

use dmech_symbolic::kernel::{Step, Way};
use dmech_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Printed, body};
use super::names::{ident, receiver, underscored};
use super::printer::Printer;
use super::step::asked;

impl Printer<'_> {
    /// One correction in two parts, with the residual between them formed of the force as computed:
    ///
    /// ```text
    /// let slope = { … [G] };
    /// let [rhs0, rhs1] = equation.residual(delta, slope);
    /// let (change, turned, positive) = { … ([δ], [J δ], […]) };
    /// Correction::sum(change, slope, turned).if_positive(positive)
    /// ```
    pub(super) fn middle_step(&self, slope: &Program, change: &Step) -> TokenStream {
        let Self { scalar, runtime, variables, dimension: d, .. } = self;
        let (linear, asked, change) = (change.way == Way::Linear, asked(change.asked), &change.program);
        let [equation, a, delta, b] = ["equation", "a", "delta", "b"].map(ident);
        let [first, turned, moved, grown] = ["slope", "turned", "change", "positive"].map(ident);
        let receiver = receiver();
        let used: Vec<_> = slope.symbols().into_iter().chain(change.symbols()).collect();
        let parameters = self.bind_parameters(&used, false);
        let ends = [(&a, &variables.a), (&delta, &variables.delta), (&b, &variables.b)];
        let unpack = ends.map(|(array, symbols)| {
            let pattern = self.pattern(symbols, &used)?;
            Some(quote!(let #pattern = #array;))
        });
        let unpack = unpack.iter().flatten();
        let scalars = [variables.g, variables.rate].map(|symbol| {
            let name = self.names.symbol(symbol);
            used.contains(&symbol).then(|| quote!(let #name = #equation.#name;))
        });
        let scalars = scalars.iter().flatten();
        let closure_a = underscored(&a, self.pattern(&variables.a, &used).is_some());
        let closure_b = underscored(&b, self.pattern(&variables.b, &used).is_some());
        let residual = self.pattern(&variables.rhs, &used);
        let residual = residual.map(|p| quote!(let #p = #equation.residual(#delta, #first);));
        let Printed { statements, outputs } = body(slope, &self.names, scalar);
        let Printed { statements: solve, outputs: solution } = body(change, &self.names, scalar);
        let (changes, rest) = solution.split_at(variables.q.len());
        let (turns, positive) = rest.split_at(variables.q.len());
        let correction = quote!(#runtime::newton::Correction::sum(#moved, #first, #turned));
        let result = if linear { quote!((#correction, #grown)) } else { quote!(#correction.#asked(#grown)) };
        let solver = ident(if linear { "once_middle" } else { "drive_middle" });
        let way = if linear { "Linear: two corrections, the second on the residual." } else { "Newton." };
        let doc = format!(
            " The increment Δ of the energy-exact step, and what the rounding of G leaves out: Δ + g G = c with G = ∇̄Φ(a, q + Δ) − F \
             at the mean position and the mean velocity Δ/h, at right angles to Δ. {way}",
        );
        quote! {
            #[doc = #doc]
            #[inline(always)]
            fn workless_increment(
                &#receiver,
                #equation: &#runtime::newton::Equation<#d, #scalar>,
            ) -> ::core::result::Result<#runtime::newton::Increment<#d, #scalar>, #runtime::newton::NotConverged> {
                #parameters
                #runtime::newton::#solver(#equation, |#equation, #closure_a, #delta, #closure_b| {
                    #(#unpack)*
                    #(#scalars)*
                    let #first = { #statements [#(#outputs),*] };
                    #residual
                    let (#moved, #turned, #grown) = { #solve ([#(#changes),*], [#(#turns),*], [#(#positive),*]) };
                    #result
                })
            }
        }
    }

    /// The same as the increment of the energy-exact step.
    pub(super) fn rounded_middle_step(&self) -> TokenStream {
        let Self { scalar, runtime, dimension: d, .. } = self;
        let (receiver, equation) = (receiver(), ident("equation"));
        quote! {
            /// That of `workless_increment`.
            #[inline(always)]
            fn discrete_increment(
                &#receiver,
                #equation: &#runtime::newton::Equation<#d, #scalar>,
            ) -> ::core::result::Result<#runtime::newton::Increment<#d, #scalar>, #runtime::newton::NotConverged> {
                #runtime::Field::workless_increment(#receiver, #equation)
            }
        }
    }
}
