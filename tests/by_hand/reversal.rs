//! Motion runs back as it came.

use crate::common::{Pendulum, SUN, greenspan_orbit};
use dmech_core::prelude::*;
use dmech_core::scheme::KanataniMemory;
use dmech_core::system::Stride;

/// N steps, the velocity turned round, N steps: where it started. The explicit scheme does not return.
#[test]
fn symmetric_schemes_return_to_where_they_started() {
    fn miss<const D: usize, L: Law<D> + Copy, S: Scheme<Particle<L, D>>>(law: L, scheme: S, start: State<D>) -> f64 {
        let there = Simulation::new(law, start).scheme(scheme).dt(0.02).run(1000).unwrap();
        let back = Simulation::new(law, there.last().reversed()).scheme(scheme).dt(0.02).run(1000).unwrap();
        let (q, v) = (back.last().q, back.last().v);
        let away = (0..D).map(|i| (there.last().q[i] - start.q[i]).abs()).fold(0.0, f64::max);
        assert!(away > 0.1, "it did not move");
        (0..D).map(|i| (q[i] - start.q[i]).abs().max((v[i] + start.v[i]).abs())).fold(0.0, f64::max)
    }
    let swing = State::new([2.5], [0.2]);
    let law = Pendulum { k: 1.4 };
    for (name, planet, pendulum, symmetric) in [
        ("Explicit", miss(SUN, Explicit, greenspan_orbit()), miss(law, Explicit, swing), Explicit::SYMMETRIC),
        ("Leapfrog", miss(SUN, Leapfrog, greenspan_orbit()), miss(law, Leapfrog, swing), Leapfrog::SYMMETRIC),
        ("Implicit", miss(SUN, Implicit, greenspan_orbit()), miss(law, Implicit, swing), Implicit::SYMMETRIC),
        (
            "DiscreteGradient",
            miss(SUN, DiscreteGradient, greenspan_orbit()),
            miss(law, DiscreteGradient, swing),
            DiscreteGradient::SYMMETRIC,
        ),
    ] {
        println!("{name}: {planet:.1e} {pendulum:.1e}");
        assert_eq!(planet < 1e-10, symmetric, "{name} on an orbit: {planet:e}");
        assert_eq!(pendulum < 1e-10, symmetric, "{name} on a pendulum: {pendulum:e}");
    }
}

/// Kanatani's recursion binds three positions symmetrically: the last two, exchanged, lead back through all of them.
#[test]
fn kanatani_goes_back_through_the_same_positions() {
    let stride = Stride::new(0.02, 1.0);
    let mut stepper = Simulation::new(SUN, greenspan_orbit()).scheme(Kanatani).dt(0.02).stepper().unwrap();
    let mut path = vec![stepper.memory().q_before(), stepper.q()];
    for _ in 0..1000 {
        stepper.step().unwrap();
        path.push(stepper.q());
    }
    let (before, now) = (path[path.len() - 1], path[path.len() - 2]);
    let sun = Particle::new(SUN, 1.0);
    let mut memory = KanataniMemory::<Particle<_, 2>>::from_positions(&stride, before, now, &SUN.gradient(now));
    for expected in path.iter().rev().skip(2) {
        Kanatani.step(&sun, &stride, 0.0, &mut memory, &mut ()).unwrap();
        let q = memory.q();
        assert!((q[0] - expected[0]).hypot(q[1] - expected[1]) < 1e-10, "{q:?} {expected:?}");
    }
}
