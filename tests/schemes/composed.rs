//! Compositions: every set of stages on every scheme that can be composed.

use std::hint::black_box;

use dmech::Kept;
use dmech::prelude::coefficients::*;
use dmech::prelude::*;

use dmech_tests::laws::{HenonHeiles, Kepler};
use dmech_tests::measured::*;
use dmech_tests::memory::allocations;
use dmech_tests::motion::*;

/// Runs a macro for every set of stages.
macro_rules! for_each_set {
    ($run:ident, $($rest:tt)*) => {
        $run! { TripleJump4, $($rest)* }
        $run! { Suzuki4, $($rest)* }
        $run! { Suzuki4S7, $($rest)* }
        $run! { McLachlan4, $($rest)* }
        $run! { Yoshida6, $($rest)* }
        $run! { McLachlan6, $($rest)* }
        $run! { KahanLi6, $($rest)* }
        $run! { SofroniouSpaletta6S11, $($rest)* }
        $run! { SofroniouSpaletta6, $($rest)* }
        $run! { Yoshida8, $($rest)* }
        $run! { SuzukiUmeno8, $($rest)* }
        $run! { McLachlan8, $($rest)* }
        $run! { KahanLi8, $($rest)* }
        $run! { Morales8, $($rest)* }
        $run! { SofroniouSpaletta8, $($rest)* }
    };
}

/// Runs a macro for every set of stages on every scheme that can be composed.
macro_rules! for_each_composition {
    ($run:ident, $($rest:tt)*) => {
        for_each_set!($run, Leapfrog, $($rest)*);
        for_each_set!($run, DiscreteGradient, $($rest)*);
        for_each_set!($run, Implicit, $($rest)*);
    };
}

#[test]
fn every_composition_has_its_order() {
    let (mut measured, mut wrong) = (0, Vec::new());
    macro_rules! one {
        ($set:ident, $base:ident, $law:expr, $start:expr, $exact:expr) => {{
            let order = measured_order($law, Composed::new($base, $set), $start, &$exact);
            println!("{:<16} {:<22} {:<20} {order:.3}", stringify!($base), stringify!($set), stringify!($law));
            let declared = f64::from(<Composed<$base, $set, _> as Method>::ORDER);
            if (order - declared).abs() >= 0.1 {
                wrong.push(format!("{} of {} on {}: {order}", stringify!($set), stringify!($base), stringify!($law)));
            }
            measured += 1;
        }};
    }
    macro_rules! law {
        ($law:expr, $start:expr) => {{
            let exact = path($law, Composed::order8(DiscreteGradient), $start, 200).expect("small steps");
            for_each_composition!(one, $law, $start, exact);
        }};
    }
    law!(HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]));
    law!(BOWL, State::new([1.1, 0.3], [-0.2, 0.5]));
    // Leap-frog refuses the wind, and is shaken.
    let start = State::<1>::new([0.9], [0.4]);
    let exact = path(SHAKEN, Composed::order8(DiscreteGradient), start, 200).expect("small steps");
    for_each_set!(one, Leapfrog, SHAKEN, start, exact);
    for_each_set!(one, DiscreteGradient, SHAKEN, start, exact);
    let start = State::new([0.7, -0.4], [0.3, 0.8]);
    let exact = path(WIND, Composed::order8(DiscreteGradient), start, 200).expect("small steps");
    for_each_set!(one, DiscreteGradient, WIND, start, exact);
    for_each_set!(one, Implicit, WIND, start, exact);
    assert_eq!(measured, 15 * (3 + 3 + 2 + 2));
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn energy_and_angular_momentum_stay_exact_at_every_order() {
    let (law, start) = (Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
    macro_rules! one {
        ($set:ident, $base:ident, $energy:expr) => {{
            let scheme = Composed::new($base, $set);
            let run = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(0.1).run(20_000).expect("small steps");
            let [energy, turning] =
                [Invariant::Energy, Invariant::AngularMomentum].map(|i| run.drift(i).expect("a central law"));
            println!(
                "{:<44} energy {:.1e}, angular momentum {:.1e}",
                run.report().scheme(),
                energy.max_relative(),
                turning.max_relative()
            );
            assert!(energy.max_relative() < $energy, "{}: {energy:?}", run.report().scheme());
            if run.kept(Invariant::Energy) == Kept::Bounded {
                does_not_drift(&run, Invariant::Energy, run.report().scheme());
            }
            assert!(turning.max_relative() < 1e-13, "{}: {turning:?}", run.report().scheme());
            work_balances(&run, [MASS; 2], "Kepler");
        }};
    }
    for_each_set!(one, DiscreteGradient, 1e-13);
    // Bounded, not exact; Yoshida's long stages err by more than the rest.
    macro_rules! bounded {
        (Yoshida8, $($rest:tt)*) => {};
        (TripleJump4, $($rest:tt)*) => {};
        ($($rest:tt)*) => { one! { $($rest)* } };
    }
    for_each_set!(bounded, Leapfrog, 1e-2);
}

#[test]
fn work_balances_where_the_energy_is_not_kept() {
    let start = State::new([0.7, -0.4], [0.3, 0.8]);
    macro_rules! one {
        ($set:ident, $base:ident, $law:expr, $start:expr, $d:literal) => {{
            let simulation = Simulation::new($law, $start).mass(MASS).scheme(Composed::new($base, $set)).dt(0.02);
            let run = simulation.run(5000).expect("small steps");
            work_balances(&run, [MASS; $d], stringify!($law));
        }};
    }
    for_each_composition!(one, SHAKEN, State::<1>::new([0.9], [0.4]), 1);
    for_each_set!(one, DiscreteGradient, WIND, start, 2);
    for_each_set!(one, Implicit, WIND, start, 2);
}

#[test]
fn compositions_return_when_the_velocity_is_reversed() {
    macro_rules! one {
        ($set:ident, $base:ident, $law:expr, $start:expr) => {{
            let miss = miss($law, $law, Composed::new($base, $set), $start);
            assert!(miss < 1e-12, "{} of {}: {miss:e}", stringify!($set), stringify!($base));
        }};
    }
    for_each_composition!(one, HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]));
    for_each_composition!(one, Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
}

#[test]
fn no_stage_allocates_and_no_force_is_taken_twice() {
    macro_rules! one {
        ($set:ident, $base:ident, $law:expr, $start:expr) => {{
            let scheme = Composed::new($base, $set);
            let mut stepper = Simulation::new($law, $start).mass(MASS).scheme(scheme).dt(0.01).stepper().unwrap();
            let counted = allocations(|| {
                for _ in 0..50 {
                    stepper.step().unwrap();
                    black_box(stepper.state());
                }
                stepper.advance(50).unwrap();
            });
            let stages = $set::GAMMA.len() as u64;
            assert_eq!(counted, 0, "{} of {}", stringify!($set), stringify!($base));
            assert!(stepper.evaluations() >= 100 * stages);
            if stepper.iterations() == 0 {
                assert_eq!(stepper.evaluations(), 100 * stages, "{} of {}", stringify!($set), stringify!($base));
            }
        }};
    }
    for_each_composition!(one, Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
    for_each_composition!(one, SHAKEN, State::<1>::new([0.9], [0.4]));
}

/// The predictor follows the force through stages that go to and fro: a stage needs one or two evaluations.
#[test]
fn stages_need_one_or_two_evaluations() {
    let (law, start) = (Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]));
    macro_rules! one {
        (Yoshida8, $($rest:tt)*) => {};
        (TripleJump4, $($rest:tt)*) => {};
        ($set:ident, $base:ident, $stage:expr, $bound:expr) => {{
            let stages = $set::GAMMA.len() as u64;
            let steps = 50_000 / stages;
            let simulation = Simulation::new(law, start).mass(MASS).scheme(Composed::new($base, $set));
            let mut stepper = simulation.dt($stage * stages as f64).stepper().unwrap();
            stepper.advance(steps).unwrap();
            let per_stage = stepper.evaluations() as f64 / (steps * stages) as f64;
            println!("{:<16} {:<22} {} {per_stage:.3}", stringify!($base), stringify!($set), $stage);
            assert!(per_stage < $bound, "{} of {}: {per_stage}", stringify!($set), stringify!($base));
        }};
    }
    for_each_set!(one, DiscreteGradient, 0.02, 2.1);
    for_each_set!(one, DiscreteGradient, 0.005, 1.25);
    for_each_set!(one, Implicit, 0.02, 2.1);
    for_each_set!(one, Implicit, 0.005, 1.25);
}

#[test]
fn reports_name_the_scheme_the_set_and_the_order() {
    let simulation = Simulation::new(Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1])).dt(0.01);
    let run = simulation.scheme(Composed::order6(DiscreteGradient)).run(10).unwrap();
    assert_eq!((run.report().scheme(), run.report().order()), ("Composed(DiscreteGradient, SofroniouSpaletta6)", 6));
    assert!(run.to_string().contains("Composed(DiscreteGradient, SofroniouSpaletta6), order 6, dt = 0.01"), "{run}");
}
