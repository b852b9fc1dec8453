//! The schemes of dmech that take part, with equal steps and with steps that follow the motion of each planet.
//!
//! All ride in lanes.

use std::time::Instant;

use dmech::extend::{Adaptive, Rides};
use dmech::models::Kepler;
use dmech::prelude::*;
use dmech_peers::{Crate, ORBITS, ORBITS_END, orbit_law, orbit_start};

use crate::entrant::{Ends, Entrant};

/// The longest step that is tried, a sixth of a revolution.
const COARSE: f64 = 1.0;

/// The longest step that follows a motion.
const LONGEST: f64 = 2.0;

/// Looks at the invariants after so many steps: never.
const NEVER: u64 = 1 << 40;

/// In steps of equal length.
macro_rules! even {
    ($($scheme:expr),* $(,)?) => {[$({
        let run = |dt: f64| all($scheme, dt);
        Entrant { by: Crate::Dmech, name: name(&$scheme).to_owned(), knob: "step", knobs: steps(), run: Box::new(run) }
    }),*]};
}

/// In steps that follow the motion.
macro_rules! adaptive {
    ($($scheme:expr),* $(,)?) => {[$({
        let run = |tolerance: f64| all(Adaptive::new($scheme, tolerance), LONGEST);
        let name = format!("{}, adaptive", name(&$scheme));
        Entrant { by: Crate::Dmech, name, knob: "tolerance", knobs: tolerances(), run: Box::new(run) }
    }),*]};
}

pub(crate) fn entrants() -> Vec<Entrant<'static>> {
    let mut entrants = Vec::new();
    entrants.extend(even![
        Leapfrog,
        CompensatedLeapfrog,
        Composed::order4(Leapfrog),
        Composed::order6(Leapfrog),
        Composed::order8(Leapfrog),
        Nystrom::order4(),
        Nystrom::new(coefficients::BlanesMoan6S11),
        Nystrom::order6(),
        Nystrom::order8(),
        ForceGradient::order4(),
        ForceGradient::order6(),
        ForceGradient::order8(),
        RungeKuttaNystrom::order12(),
        Gauss::order16(),
    ]);
    entrants.extend(adaptive![
        Nystrom::order4(),
        Nystrom::new(coefficients::BlanesMoan6S11),
        Nystrom::order6(),
        Nystrom::order8(),
        ForceGradient::order4(),
        ForceGradient::order6(),
        ForceGradient::order8(),
        Composed::order8(Leapfrog),
        RungeKuttaNystrom::order12(),
        Gauss::order16(),
    ]);
    entrants
}

/// Steps that fill the time, 2^(1/6) apart.
fn steps() -> Vec<f64> {
    (0..80).map(|k| ORBITS_END / (ORBITS_END / COARSE * 2_f64.powf(f64::from(k) / 6.0)).round()).collect()
}

/// 10^(−1/4) apart.
fn tolerances() -> Vec<f64> {
    (0..64).map(|k| 10_f64.powf(-0.25 * f64::from(k))).collect()
}

fn all<S: Rides<Kepler, 2> + Sync>(scheme: S, dt: f64) -> Result<Ends, String> {
    let clock = Instant::now();
    let members = Ensemble::of(ORBITS).law(orbit_law).start(orbit_start).scheme(scheme).dt(dt);
    let run = members.look_every(NEVER).threads(1).run_until(ORBITS_END).map_err(|error| error.to_string())?;
    let time = clock.elapsed();
    let (mut places, mut forces) = (Vec::with_capacity(ORBITS), 0);
    for member in run.members() {
        let run = member.map_err(|interrupted| interrupted.to_string())?;
        places.push(run.last().q);
        forces += run.report().evaluations();
    }
    Ok(Ends { places, forces, time })
}

fn name<S: Method>(_: &S) -> &'static str {
    S::NAME
}
