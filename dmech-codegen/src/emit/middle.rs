//! The energy-exact step of a force that does no work.

use dmech_symbolic::kernel::{Step, Way};
use dmech_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Printed, body};
use super::names::{ident, receiver};
use super::printer::Printer;
use super::step::asked;

impl Printer<'_> {
    /// One correction in two parts, with the residual between them formed of the force as computed:
    ///
    /// ```text
    /// let slope = { … [G] };
    /// let [rhs0, rhs1] = equation.residual(delta, slope);
    /// let (change, turned, positive) = { … ([δ], [J δ], […]) };
    /// Correction::in_parts(change, slope, turned).if_positive(positive)
    /// ```
    pub(super) fn middle_step(&self, slope: &Program, change: &Step) -> TokenStream {
        let Self { scalar, runtime, variables, .. } = self;
        let (linear, asked, change) = (change.way == Way::Linear, asked(change.asked), &change.program);
        let [equation, delta] = ["equation", "delta"].map(ident);
        let [first, turned, moved, grown] = ["slope", "turned", "change", "positive"].map(ident);
        let used: Vec<_> = slope.symbols().into_iter().chain(change.symbols()).collect();
        let parameters = self.bind_parameters(&used, false);
        let unpack = self.pattern(&variables.delta, &used).map(|pattern| quote!(let #pattern = #delta;));
        let (arguments, unpack_end) = self.unpacked(&[("b", &variables.b)], &used);
        let read = self.read_of(&equation, &[("a", &variables.a)], &[variables.g, variables.rate], &used);
        let residual = self.pattern(&variables.rhs, &used);
        let residual = residual.map(|p| quote!(let #p = #equation.residual(#delta, #first);));
        let Printed { statements, outputs } = body(slope, &self.names, scalar);
        let Printed { statements: solve, outputs: solution } = body(change, &self.names, scalar);
        let (changes, rest) = solution.split_at(variables.q.len());
        let (turns, positive) = rest.split_at(variables.q.len());
        let correction = quote!(#runtime::newton::Correction::in_parts(#moved, #first, #turned));
        let result = if linear { quote!((#correction, #grown)) } else { quote!(#correction.#asked(#grown)) };
        let solver = ident(if linear { "twice_middle" } else { "drive_middle" });
        let way = if linear { "Linear: two corrections, the second on the residual." } else { "Newton." };
        let doc = format!(
            " The increment Δ of the energy-exact step, with the parts of G: Δ + g G = c with G = ∇̄Φ(a, q + Δ) − F \
             at the mean position and the mean velocity Δ/h, at right angles to Δ. {way}",
        );
        let increment = self.increment(
            "workless_increment",
            quote! {
                #parameters
                #runtime::newton::#solver(#equation, |#equation, #delta, #(#arguments),*| {
                    #unpack
                    #unpack_end
                    #(#read)*
                    let #first = { #statements [#(#outputs),*] };
                    #residual
                    let (#moved, #turned, #grown) = { #solve ([#(#changes),*], [#(#turns),*], [#(#positive),*]) };
                    #result
                })
            },
        );
        quote!(#[doc = #doc] #increment)
    }

    /// The same as the increment of the energy-exact step.
    pub(super) fn rounded_middle_step(&self) -> TokenStream {
        let (runtime, receiver, equation) = (&self.runtime, receiver(), ident("equation"));
        let body = quote!(#runtime::Field::workless_increment(#receiver, #equation));
        let increment = self.increment("discrete_increment", body);
        quote! {
            /// That of `workless_increment`.
            #increment
        }
    }
}
