//! `differential-equations`: DOP853, Verner's pairs of order 6, 7 and 9, and its symplectic method of order 4, on arrays.
//!
//! Nothing is stored but the last state. Its pair of order 8 is left out: measured on the orbit it takes 16 times as many
//! forces for 1e-6 as for 1e-3, which is not order 8.

use differential_equations::methods::SymplecticIntegrator;
use differential_equations::ode::{OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::*;
use dmech_peers::{Crate, Entrant, Finish, Motion, Problem, tolerances};

struct Rates<M, const D: usize>(M);

impl<M: Motion<D>, const D: usize, const N: usize> ODE<f64, [f64; N]> for Rates<M, D> {
    fn diff(&self, _: f64, y: &[f64; N], dy: &mut [f64; N]) {
        super::rates(&self.0, y, dy);
    }
}

struct Last<const N: usize> {
    end: f64,
    y: Option<[f64; N]>,
}

impl<const N: usize> Solout<f64, [f64; N]> for Last<N> {
    fn solout<I: Interpolation<f64, [f64; N]> + ?Sized>(
        &mut self,
        t: f64,
        _: f64,
        y: &[f64; N],
        _: &[f64; N],
        _: &mut I,
        _: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]> {
        // The crate may end a few roundings before the end, where it takes no further step.
        if t > self.end - 1e-6 {
            self.y = Some(*y);
        }
        ControlFlag::Continue
    }
}

fn solve<M: Motion<D>, S, const D: usize, const N: usize>(
    problem: &Problem<M, D>,
    method: impl FnOnce() -> S,
) -> Result<Finish, String>
where
    S: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    Finish::of(&problem.truth, || {
        let start = super::joined::<D, N>(&problem.start);
        let mut last = Last { end: problem.end, y: None };
        let rates = Rates(problem.motion);
        let solution = solve_ode(&mut method(), &rates, 0.0, problem.end, &start, &mut last);
        // Not the state that it shows too.
        let word = |error| format!("{error:?}").chars().take_while(|c| c.is_alphanumeric()).collect::<String>();
        let solution = solution.map_err(word)?;
        Ok((super::position(&last.y.ok_or("no state at the end")?), solution.evals.function as u64))
    })
}

/// N = 2 D.
pub(crate) fn entrants<M: Motion<D>, const D: usize, const N: usize>(problem: &Problem<M, D>) -> Vec<Entrant<'_>> {
    let mut entrants = Vec::new();
    macro_rules! add {
        ($method:ident, $name:literal, $label:literal) => {
            let run = |tolerance: f64| {
                let method = || ExplicitRungeKutta::$method().rtol(tolerance).atol(tolerance).max_steps(usize::MAX);
                solve::<M, _, D, N>(problem, method)
            };
            entrants.push(Entrant::new(Crate::DifferentialEquations, $name, $label, tolerances(), run));
        };
    }
    add!(dop853, "DOP853", "diff.-eq. DOP853");
    add!(rkv656e, "Verner 6(5)", "Verner 6(5)");
    add!(rkv767e, "Verner 7(6)", "Verner 7(6)");
    add!(rkv988e, "Verner 9(8)", "Verner 9(8)");
    let symplectic = |steps: f64| {
        let method = || SymplecticIntegrator::ruth_forest(problem.end / steps).max_steps(usize::MAX);
        solve::<M, _, D, N>(problem, method)
    };
    let steps = (0..40).map(|k| ((problem.end / problem.coarse).ceil() * 2_f64.powf(0.5 * f64::from(k))).round());
    entrants.push(Entrant::new(
        Crate::DifferentialEquations,
        "Ruth–Forest, symplectic, order 4",
        "Ruth–Forest 4",
        steps.collect(),
        symplectic,
    ));
    entrants
}
