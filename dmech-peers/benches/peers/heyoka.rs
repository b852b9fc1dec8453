//! heyoka: Taylor series of an order that it chooses by the tolerance, compiled for the equations.
//!
//! It is used as its manual has it, and with its option `fast_math`, which is faster everywhere; measured and left out are
//! `slp_vectorize` (as fast or slower) and `compact_mode` (2 to 4 times as slow). High accuracy is off, as it is unless asked
//! for. It evaluates no force, and none is counted.

use std::cell::RefCell;

use dmech_peers::{Crate, Entrant, Finish, Motion, Problem, distance};

use super::process::Heyoka;

/// Tolerances of 10⁻³ to 10⁻¹⁵ and the least that makes sense.
fn knobs(by: f64) -> Vec<f64> {
    let mut knobs: Vec<_> = (0..).map(|k| -3.0 - by * f64::from(k)).take_while(|&x| x > -15.6).collect();
    knobs.push(f64::EPSILON.log10());
    knobs.into_iter().map(|x| 10_f64.powf(x)).collect()
}

/// Those of a motion that the program knows by its name; none where there is no heyoka.
pub(crate) fn entrants<'a, M: Motion<D>, const D: usize>(
    heyoka: Option<&'a RefCell<Heyoka>>,
    problem: &'a Problem<M, D>,
) -> Vec<Entrant<'a>> {
    let Some(heyoka) = heyoka else { return Vec::new() };
    let entrant = |name, label, options: &'static str| {
        // Code for a hundred equations takes ten seconds to compile.
        let knobs = knobs(if D < 10 { 0.5 } else { 1.5 });
        let run = move |tolerance| {
            let mut heyoka = heyoka.borrow_mut();
            let (end, time) = heyoka.propagate(problem.name, tolerance, options, &problem.start, problem.end)?;
            let error = distance(&end.q, &problem.truth);
            if error.is_finite() { Ok(Finish { error, evaluations: 0, time }) } else { Err("not finite".to_owned()) }
        };
        Entrant::new(Crate::Heyoka, name, label, knobs, run)
    };
    vec![entrant("Taylor", "heyoka", "-"), entrant("Taylor, fast_math", "heyoka fast", "fast_math")]
}
