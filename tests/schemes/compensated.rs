//! Compensated leap-frog is leap-frog, and loses less to rounding.

use dmech::models::Kepler;
use dmech::prelude::*;
use dmech::scheme::Scheme;

const PLANET: Kepler = Kepler { gm: 1.1 };

fn start() -> State<2> {
    State::new([1.3, 0.2], [-0.15, 0.7])
}

/// The largest difference of two positions.
fn apart(a: &State<2>, b: &State<2>) -> f64 {
    a.q.iter().zip(b.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The same formulas: over a few steps only rounding differs.
#[test]
fn it_is_leap_frog() {
    let simulation = Simulation::new(PLANET, start()).mass(1.7).dt(0.01);
    let plain = simulation.clone().scheme(Leapfrog).run(100).unwrap();
    let compensated = simulation.scheme(CompensatedLeapfrog).run(100).unwrap();
    let worst = plain.states().iter().zip(compensated.states()).map(|(a, b)| apart(a, b)).fold(0.0, f64::max);
    println!("{worst:.1e} apart in 100 steps");
    assert!(worst > 0.0 && worst < 1e-14, "{worst:e}");
}

/// There and back: what does not come back is rounding, and of compensated sums it is less by a factor of the order of h.
#[test]
fn less_is_lost_on_the_way_there_and_back() {
    fn miss<S: Scheme<Particle<Kepler, 2>>>(scheme: S, dt: f64, steps: u64) -> f64 {
        let end = |start| {
            *Simulation::new(PLANET, start).scheme(scheme).dt(dt).record_every(steps).run(steps).unwrap().last()
        };
        let back = end(end(start()).reversed());
        apart(&back, &start())
    }
    for (dt, steps) in [(1e-3, 200_000), (1e-4, 2_000_000)] {
        let (plain, compensated) = (miss(Leapfrog, dt, steps), miss(CompensatedLeapfrog, dt, steps));
        println!("h = {dt:e}, {steps} steps and back: plain {plain:.1e}, compensated {compensated:.1e}");
        assert!(plain > 0.0 && compensated < 0.1 * plain, "h = {dt:e}: {plain:e} and {compensated:e}");
    }
}
