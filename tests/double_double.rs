//! Laws, schemes and studies with numbers of 31 digits.

use dmech::models::{Anharmonic, DampedPendulum, HenonHeiles, Kepler, MagneticField, Morse, Pendulum};
use dmech::prelude::*;

type Wide = DoubleDouble;

fn wide<const D: usize>(x: [f64; D]) -> [Wide; D] {
    x.map(Wide::from)
}

fn probe<L: Law<D, Wide> + Potential<D, Wide> + Copy, const D: usize>(name: &str, law: L, start: State<D>, dt: f64) {
    let start = State { t: start.t, q: wide(start.q), v: wide(start.v) };
    let energy = |s: &State<D, Wide>| {
        (0..D).fold(law.potential(s.q), |sum, i| sum + Wide::from(0.5) * s.v[i] * s.v[i])
    };
    let run = Simulation::new(law, start).scheme(DiscreteGradient).dt(dt).run(2000).unwrap();
    let e0 = energy(&start);
    let worst = run.states().iter().map(|s| ((energy(s) - e0) / e0).to_f64().abs()).fold(0.0, f64::max);
    println!("{name} {worst:e} {:e}, iterations {}", run.drift(Invariant::Energy).unwrap().max_relative(), run.report().iterations());
}

#[test]
fn probes() {
    probe("kepler", Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]), 0.02);
    probe("hh", HenonHeiles { lambda: 1.0 }, State::new([0.0, 0.1], [0.39, 0.08]), 0.05);
    probe("morse", Morse::default(), State::new([1.2], [0.4]), 0.02);
    probe("pendulum", Pendulum { k: 1.3 }, State::new([2.1], [0.4]), 0.05);
    probe("anharmonic", Anharmonic::default(), State::new([0.8, -0.5, 0.3], [0.2, 0.4, -0.6]), 0.03);
}

#[test]
fn compositions() {
    let law = Kepler { gm: 1.0 };
    let start = State::new(wide([0.5, 0.0]), wide([0.0, 1.63]));
    for k in [4, 5, 6, 7, 8, 9] {
        let n = 1u64 << k;
        let dt = 2.0 / n as f64;
        let a = Simulation::new(law, start).scheme(Composed::order8(DiscreteGradient)).dt(dt).run(n).unwrap();
        let b = Simulation::new(law, start).scheme(Composed::order8(Leapfrog)).dt(dt).run(n).unwrap();
        println!("{n}: {:e} {:?}", a.last().q[0] - b.last().q[0], a.report().iterations() as f64 / n as f64 / 21.0);
    }
}

#[test]
fn studies() {
    let report = Study::new(HenonHeiles { lambda: 1.0 }, State::new([0.0, 0.1], [0.39, 0.08]), 100.0)
        .scheme(Composed::order8(DiscreteGradient)).scheme(Nystrom::order6()).precise().repetitions(1).run().unwrap();
    println!("{report}");
    let law = Kepler { gm: 1.0 };
    let report = Study::new(law, State::new([0.5, 0.0], [0.0, 1.63]), 350.0)
        .scheme(Composed::order8(DiscreteGradient)).precise().repetitions(1).run().unwrap();
    println!("{report}");
    let report = Study::new(DampedPendulum::default(), State::new([0.5], [0.3]), 30.0)
        .scheme(Composed::order8(DiscreteGradient)).precise().repetitions(1).run().unwrap();
    println!("{report}");
}
