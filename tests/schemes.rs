//! Every scheme on every law: order, invariants, reversibility. A new scheme is a new row of `for_each_scheme`.

use dmech::prelude::*;
use dmech::{Kept, scheme::Method};

mod laws;
use laws::*;

/// Runs a macro for every scheme.
macro_rules! for_each_scheme {
    ($run:ident, $($rest:tt)*) => {
        $run! { Explicit, $($rest)* }
        $run! { Leapfrog, $($rest)* }
        $run! { Implicit, $($rest)* }
        $run! { DiscreteGradient, $($rest)* }
        $run! { Kanatani, $($rest)* }
    };
}

fn end<L, S, const D: usize>(law: L, scheme: S, start: State<D>, steps: u64) -> State<D>
where
    L: Law<D> + Copy,
    S: Scheme<L, D>,
{
    let run = Simulation::new(law, start).mass(1.3).scheme(scheme).dt(1.0 / steps as f64).run(steps);
    *run.unwrap_or_else(|interrupted| panic!("{interrupted}")).last()
}

fn distance<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The exponent of h in the error of the position at t = 1, by halving the step twice (no exact solution needed:
/// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p).
fn measured_order<L, S, const D: usize>(law: L, scheme: S, start: State<D>) -> f64
where
    L: Law<D> + Copy,
    S: Scheme<L, D>,
{
    let [one, two, four] = [400, 800, 1600].map(|steps| end(law, scheme, start, steps).q);
    let (coarse, fine) = (distance(one, two), distance(two, four));
    assert!(fine > 1e-11, "{fine:e}: at the level of rounding there is no order to measure");
    (coarse / fine).log2()
}

#[test]
fn orders_are_as_declared() {
    let mut measured = 0;
    macro_rules! one {
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let order = measured_order::<_, _, $d>($law::new(), $scheme, State::new($q, $v));
            let declared = f64::from(<$scheme as Method>::ORDER);
            println!("{:<14} {:<17} {order:.3}", stringify!($law), stringify!($scheme));
            assert!((order - declared).abs() < 0.05, "{} on {}: {order}", stringify!($scheme), stringify!($law));
            measured += 1;
        }};
    }
    macro_rules! every {
        // The floor's force is continuous but has a kink: a step that straddles it has a local error of its own.
        (Floor, $($rest:tt)*) => {};
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
    assert_eq!(measured, 5 * 11);
}

/// The scale that a change of energy is compared with: kinetic and potential energy may cancel.
fn energy_scale<L: Potential<D>, const D: usize>(law: &L, start: &State<D>) -> f64 {
    law.potential(start.q).abs() + 0.65 * start.v.iter().map(|v| v * v).sum::<f64>()
}

#[test]
fn what_is_kept_exactly_is_kept_to_round_off_and_what_is_bounded_does_not_drift() {
    const STEPS: u64 = 20_000;
    let (mut exact, mut bounded) = (0, 0);
    macro_rules! one {
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let (law, start) = ($law::new(), State::<$d>::new($q, $v));
            // The explicit orbits spiral outward, some to infinity.
            let steps = if <$scheme as Method>::ORDER == 1 { 200 } else { STEPS };
            let run = Simulation::new(law, start).mass(1.3).scheme($scheme).dt(0.01).run(steps);
            let run = run.unwrap_or_else(|interrupted| panic!("{interrupted}"));
            let scale = energy_scale(&law, &start);
            let name = concat!(stringify!($scheme), " on ", stringify!($law));
            let invariants =
                [Invariant::Energy, Invariant::DiscreteEnergy, Invariant::WorkEnergy, Invariant::AngularMomentum];
            for invariant in invariants {
                let Some(drift) = run.drift(invariant) else {
                    continue;
                };
                let worst = drift.max_abs() / if invariant == Invariant::AngularMomentum { 1.0 } else { scale };
                match <$scheme as Method>::keeps(invariant) {
                    Kept::Exact => {
                        assert!(worst < 2e-13 * (STEPS as f64 / 1e3).sqrt(), "{name}: {invariant:?} {worst:e}");
                        exact += 1;
                    }
                    Kept::Bounded => {
                        assert!(worst < 0.02, "{name}: {invariant:?} {worst:e}");
                        bounded += 1;
                    }
                    Kept::No => {}
                }
            }
            assert!(run.drift(Invariant::Energy).is_some() && run.drift(Invariant::WorkEnergy).is_some(), "{name}");
            let central = <$law as Potential<$d>>::CENTRAL;
            assert_eq!(run.drift(Invariant::AngularMomentum).is_some(), central, "{name}");
        }};
    }
    macro_rules! every {
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
    assert!(exact >= 12 * 7 && bounded >= 12 * 2, "{exact} exact, {bounded} bounded");
}

#[test]
fn symmetric_schemes_return_when_the_velocity_is_reversed() {
    let mut returned = 0;
    macro_rules! one {
        // Kanatani's start is itself only of second order: it is a two-step scheme, reversed in its own variables.
        (Kanatani, $($rest:tt)*) => {};
        (Explicit, $($rest:tt)*) => {};
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let (law, start) = ($law::new(), State::<$d>::new($q, $v));
            let there = end(law, $scheme, start, 500);
            let turned = State::new(there.q, there.v.map(|v| -v));
            let back = end(law, $scheme, turned, 500);
            let miss = distance(back.q, start.q) + distance(back.v.map(|v| -v), start.v);
            assert!(distance(there.q, start.q) > 0.05, "{}: it did not move", stringify!($law));
            assert!(miss < 2e-12, "{} on {}: {miss:e}", stringify!($scheme), stringify!($law));
            returned += 1;
        }};
    }
    macro_rules! every {
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
    assert_eq!(returned, 3 * 12);
}

#[test]
fn single_precision_follows_double_precision() {
    macro_rules! one {
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let law = $law::new();
            let double = Simulation::new(law, State::<$d>::new($q, $v)).scheme($scheme).dt(0.01).run(100).unwrap();
            let narrow = State::<$d, f32>::new($q.map(|x: f64| x as f32), $v.map(|x: f64| x as f32));
            let single = Simulation::new(law, narrow).scheme($scheme).dt(0.01).run(100).unwrap();
            let miss = distance(single.last().q.map(f64::from), double.last().q);
            assert!(miss < 1e-5 && miss > 0.0, "{} on {}: {miss:e}", stringify!($scheme), stringify!($law));
        }};
    }
    macro_rules! every {
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
}
