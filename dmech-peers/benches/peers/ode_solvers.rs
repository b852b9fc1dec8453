//! `ode_solvers`: the Dop853 of Hairer, Nørsett and Wanner, on vectors of fixed size, without dense output.
//!
//! The crate stores the state of every step. Its test for stiffness is turned off, which would cost time and could only
//! end a run.

use dmech_peers::{Crate, Entrant, Finish, Motion, Problem, tolerances};
use ode_solvers::{Dop853, OutputType, SVector, System};

struct Rates<M, const D: usize>(M);

impl<M: Motion<D>, const D: usize, const N: usize> System<f64, SVector<f64, N>> for Rates<M, D> {
    fn system(&self, _: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        super::rates(&self.0, y.as_slice(), dy.as_mut_slice());
    }
}

/// N = 2 D.
pub(crate) fn entrants<M: Motion<D>, const D: usize, const N: usize>(problem: &Problem<M, D>) -> Vec<Entrant<'_>> {
    let run = |tolerance: f64| {
        Finish::of(&problem.truth, || {
            let start = SVector::from(super::joined::<D, N>(&problem.start));
            let (rates, sparse, most) = (Rates(problem.motion), OutputType::Sparse, u32::MAX);
            // Safety factor, β, least and greatest change of the step: the defaults.
            let mut solver = Dop853::from_param(
                rates,
                0.0,
                problem.end,
                0.0,
                start,
                tolerance,
                tolerance,
                0.9,
                0.0,
                0.333,
                6.0,
                problem.end,
                0.0,
                most,
                most,
                sparse,
            );
            let stats = solver.integrate().map_err(|error| error.to_string())?;
            let end = solver.y_out().last().ok_or("no state")?;
            Ok((super::position(end.as_slice()), u64::from(stats.num_eval)))
        })
    };
    vec![Entrant::new(Crate::OdeSolvers, "Dop853", "ode_solvers Dop853", tolerances(), run)]
}
