//! `diffsol`, which is made for stiff systems: its explicit method of order 5 by Tsitouras, the implicit ESDIRK34, and the
//! backward differentiation formulas, on vectors of nalgebra, the only ones that it has without faer.
//!
//! Implicit methods get the exact derivative along a direction. Steps are made one by one, and nothing is stored.

use std::cell::Cell;

use diffsol::{NalgebraLU, NalgebraMat, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector};
use dmech_peers::{Crate, Entrant, Finish, Motion, Problem, tolerances};

type Matrix = NalgebraMat<f64>;

/// Steps to the end.
fn finish<'a, E, S, const D: usize>(mut solver: S, end: f64) -> Result<[f64; D], String>
where
    E: OdeEquations<T = f64, V = <Matrix as diffsol::MatrixCommon>::V> + 'a,
    S: OdeSolverMethod<'a, E>,
{
    solver.set_stop_time(end).map_err(|error| error.to_string())?;
    while solver.step().map_err(|error| error.to_string())? != OdeSolverStopReason::TstopReached {}
    let state = solver.state();
    Ok(core::array::from_fn(|i| state.y.get_index(i)))
}

/// N = 2 D.
pub(crate) fn entrants<M: Motion<D>, const D: usize, const N: usize>(problem: &Problem<M, D>) -> Vec<Entrant<'_>> {
    let mut entrants = Vec::new();
    macro_rules! add {
        ($name:literal, $label:literal, |$problem:ident| $solver:expr) => {
            let run = |tolerance: f64| {
                Finish::of(&problem.truth, || {
                    let forces = Cell::new(0);
                    let motion = problem.motion;
                    let builder = OdeBuilder::<Matrix>::new().rtol(tolerance).atol([tolerance]);
                    let builder = builder.rhs_implicit(
                        |y: &[f64], _: &[f64], _, dy: &mut [f64]| {
                            forces.set(forces.get() + 1);
                            super::rates(&motion, y, dy);
                        },
                        |y: &[f64], _: &[f64], _, along: &[f64], change: &mut [f64]| {
                            super::rates_along(&motion, y, along, change);
                        },
                    );
                    let start = super::joined::<D, N>(&problem.start);
                    let builder = builder.init(move |_, _, y: &mut [f64]| y.copy_from_slice(&start), N);
                    let $problem = builder.build().map_err(|error| error.to_string())?;
                    let q = finish(($solver).map_err(|error| error.to_string())?, problem.end)?;
                    Ok((q, forces.get()))
                })
            };
            entrants.push(Entrant::new(Crate::Diffsol, $name, $label, tolerances(), run));
        };
    }
    add!("Tsit45", "diffsol Tsit45", |problem| problem.tsit45());
    add!("ESDIRK34", "ESDIRK34", |problem| problem.esdirk34::<NalgebraLU<f64>>());
    add!("BDF", "BDF", |problem| problem.bdf::<NalgebraLU<f64>>());
    entrants
}
