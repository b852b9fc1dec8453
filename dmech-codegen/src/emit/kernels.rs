//! The functions of the implementation, one for each kernel.

use dmech_symbolic::expression::Symbol;
use dmech_symbolic::kernel::{ForcedKernels, ForcedStep, Kernels, KickByMean};
use dmech_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::document::{force_texts, pointwise_texts};
use super::names::{ident, underscored};
use super::pointwise::{FORCE, POTENTIAL};
use super::printer::Printer;
use super::rank::Rank;
use crate::lower::Source;

impl Printer<'_> {
    /// The functions of `Field` for a law without a force.
    pub(super) fn steps(&self, kernels: &Kernels) -> TokenStream {
        let Kernels { kick, gradient_kick, implicit, discrete, .. } = kernels;
        let with_gradient = format!(" v − c ∇Φ(q) + e H ∇Φ(q), H the Hessian. Cost: {}.", gradient_kick.cost());
        let functions = [
            self.kick(" v − c ∇Φ(q).", kick),
            self.gradient_kick(&with_gradient, gradient_kick),
            self.step("implicit_increment", "the trapezoidal step: Δ + g ∇Φ(q + Δ) = c", implicit),
            self.step("discrete_increment", "the energy-exact steps: Δ + g ∇̄Φ(a, q + Δ) = c", discrete),
        ];
        functions.into_iter().collect()
    }

    /// v − c times what acts.
    fn kick(&self, doc: &str, program: &Program) -> TokenStream {
        let function = self.function("kick", &self.motion(), &[self.variables.c], Rank::Vector, program);
        quote!(#[doc = #doc] #function)
    }

    /// v′ = v − c (∇Φ − F) with the force at the mean velocity; nothing where the force is not linear in the velocity.
    fn kick_by_mean(&self, forced: &ForcedKernels) -> Option<TokenStream> {
        match &forced.kick_by_mean {
            Some(KickByMean::Solved(program)) => {
                let doc = format!(" v′ = v − c (∇Φ − F(q, (v + v′)/2)). Cost: {}.", program.cost());
                let coefficients = [self.variables.c];
                let function = self.function("kick_by_mean", &self.motion(), &coefficients, Rank::Vector, program);
                return Some(quote!(#[doc = #doc] #function));
            }
            Some(KickByMean::Rotation(program)) => return Some(self.rotation(program)),
            None => {}
        }
        let (scalar, d, [c, q, v]) = (&self.scalar, &self.dimension, ["c", "q", "v"].map(ident));
        forced.linear_in_velocity.then(|| {
            quote! {
                #[inline(always)]
                fn kick_by_mean(&self, #c: #scalar, #q: [#scalar; #d], #v: [#scalar; #d]) -> [#scalar; #d] {
                    self.kick(#c, #q, #v)
                }
            }
        })
    }

    /// v − c times what acts, and e times its change along itself.
    fn gradient_kick(&self, doc: &str, program: &Program) -> TokenStream {
        let coefficients = [self.variables.c, self.variables.e];
        let function = self.function("gradient_kick", &self.motion(), &coefficients, Rank::Vector, program);
        quote!(#[doc = #doc] #function)
    }

    /// Position and velocity.
    fn motion(&self) -> [(&'static str, &[Symbol]); 2] {
        [("q", &self.variables.q), ("v", &self.variables.v)]
    }

    /// The functions of `Potential` that are taken at a point, or between two.
    pub(super) fn pointwise(&self, kernels: &Kernels) -> TokenStream {
        self.pointwise_functions("q", kernels.pointwise.each(), &pointwise_texts(self.graph, kernels))
    }

    /// The same of the programs, with the name of the point.
    pub(super) fn pointwise_functions(
        &self,
        point: &str,
        programs: [&Program; 5],
        documents: &[Vec<String>; 5],
    ) -> TokenStream {
        let at = [(point, &self.variables.q[..])];
        let ends = [("a", &self.variables.a[..]), ("b", &self.variables.b[..])];
        let list = POTENTIAL.iter().zip(programs).zip(documents);
        let functions = list.map(|((function, program), text)| {
            let function = self.function(function.name, function.of(&at, &ends), &[], function.rank, program);
            quote!(#(#[doc = #text])* #function)
        });
        functions.collect()
    }

    /// The functions of `Force`: they take the time as an argument.
    pub(super) fn force_functions(&self, forced: &ForcedKernels) -> TokenStream {
        let time = self.parameters.iter().find(|p| matches!(p.source, Source::Time)).map(|p| p.symbol);
        let list = FORCE.iter().zip([&forced.force, &forced.force_dq, &forced.force_dv]);
        let functions = list.zip(force_texts(self.graph, forced)).map(|((&(name, rank), program), text)| {
            let used = time.is_some_and(|t| program.symbols().contains(&t));
            let t = underscored(&time.map_or_else(|| ident("t"), |t| self.names.symbol(t)), used);
            let function = self.function_of_time(name, &self.motion(), &[], Some(&t), rank, program);
            quote!(#(#[doc = #text])* #function)
        });
        functions.collect()
    }

    /// The functions of `Field` that a law with a force needs.
    pub(super) fn field_functions(&self, kernels: &Kernels, forced: &ForcedKernels) -> TokenStream {
        let slope = self.function("slope", &self.motion(), &[], Rank::Vector, &forced.slope);
        let half = self.function("half_force", &self.motion(), &[], Rank::Vector, &forced.half_force);
        let what = "the potential alone: Δ + g ∇̄Φ(a, q + Δ) = c";
        let potential = self.step("potential_increment", what, &kernels.discrete);
        let (half_doc, workless) = match &forced.discrete {
            ForcedStep::Mean(_) => (" F/2, the share of the start of a step in the mean force.", None),
            ForcedStep::Middle { slope, change } => (
                " Nothing: a force that does no work is taken in the middle of the step.",
                Some(self.middle_step(slope, change)),
            ),
        };
        let slope_doc = format!(" ∇Φ − F: minus all that acts. Cost: {}.", forced.slope.cost());
        quote! {
            #[doc = #slope_doc] #slope
            #[doc = #half_doc] #half
            #potential
            #workless
        }
    }

    /// The steps of a law with a force.
    pub(super) fn forced_steps(&self, forced: &ForcedKernels) -> TokenStream {
        let exact = match &forced.discrete {
            ForcedStep::Mean(step) => {
                let what = "the energy-exact step: Δ + g (∇̄Φ(a, q + Δ) − F′/2) = c, F′ at (q + Δ, v′)";
                self.step("discrete_increment", what, step)
            }
            ForcedStep::Middle { .. } => self.rounded_middle_step(),
        };
        let what = "the trapezoidal step: Δ + g (∇Φ − F)(q + Δ, v′) = c, v′ = v + (2/h)(Δ − h v)";
        let implicit = self.step("implicit_increment", what, &forced.implicit);
        let kick = self.kick(&format!(" v − c (∇Φ − F). Cost: {}.", forced.kick.cost()), &forced.kick);
        let kick_by_mean = self.kick_by_mean(forced);
        let gradient_kick = forced.gradient_kick.as_ref().map(|program| {
            let doc = format!(" v − c s + e (∂s/∂q) s, with s = ∇Φ − F. Cost: {}.", program.cost());
            self.gradient_kick(&doc, program)
        });
        quote! {
            #kick
            #kick_by_mean
            #gradient_kick
            #implicit
            #exact
        }
    }
}
