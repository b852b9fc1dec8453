//! Every scheme on every law: order, invariants, reversibility. A new scheme is a new row of `for_each_scheme`.

use dmech::prelude::*;

use dmech_tests::for_each_law;
use dmech_tests::laws::*;
use dmech_tests::motion::*;

/// Runs a macro for every scheme.
macro_rules! for_each_scheme {
    ($run:ident, $($rest:tt)*) => {
        $run! { Explicit, $($rest)* }
        $run! { Leapfrog, $($rest)* }
        $run! { CompensatedLeapfrog, $($rest)* }
        $run! { Boris, $($rest)* }
        $run! { Implicit, $($rest)* }
        $run! { DiscreteGradient, $($rest)* }
        $run! { Kanatani, $($rest)* }
        $run! { NYSTROM_4, $($rest)* }
        $run! { NYSTROM_6, $($rest)* }
        $run! { RELAXED_6, $($rest)* }
        $run! { FORCE_GRADIENT_4, $($rest)* }
    };
}

#[test]
fn orders_are_as_declared() {
    let mut measured = 0;
    macro_rules! one {
        // Above order 2 the error at t = 1 is rounding; `splittings` measures it on motions where it is not.
        (NYSTROM_4, $($rest:tt)*) => {};
        (NYSTROM_6, $($rest:tt)*) => {};
        (RELAXED_6, $($rest:tt)*) => {};
        (FORCE_GRADIENT_4, $($rest:tt)*) => {};
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            has_its_order::<_, _, $d>($law::new(), $scheme, State::new($q, $v), 0.05, stringify!($law));
            measured += 1;
        }};
    }
    macro_rules! every {
        // The floor's force is continuous but has a kink: a step that straddles it has a local error of its own.
        (Floor, $($rest:tt)*) => {};
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
    assert_eq!(measured, 7 * 11);
}

#[test]
fn what_is_kept_exactly_is_kept_to_round_off_and_what_is_bounded_does_not_drift() {
    let mut tally = Tally::default();
    macro_rules! one {
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let law = $law::new();
            let run = long_run::<_, _, $d>(law, $scheme, State::new($q, $v));
            tally.check($scheme, &run, energy_scale(&law, &run.states()[..1]), smooth::<_, $d>(&law), stringify!($law));
            let name = concat!(stringify!($scheme), " on ", stringify!($law));
            assert!(run.drift(Invariant::Energy).is_some() && run.drift(Invariant::WorkEnergy).is_some(), "{name}");
            let central = <$law as Potential<$d>>::CENTRAL;
            assert_eq!(run.drift(Invariant::AngularMomentum).is_some(), central, "{name}");
        }};
    }
    macro_rules! every {
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
    assert!(tally.exact >= 12 * 10 && tally.bounded >= 12 * 5, "{tally:?}");
}

#[test]
fn symmetric_schemes_return_when_the_velocity_is_reversed() {
    let mut returned = 0;
    macro_rules! one {
        // Kanatani's start is itself only of second order: it is a two-step scheme, reversed in its own variables.
        (Kanatani, $($rest:tt)*) => {};
        (Explicit, $($rest:tt)*) => {};
        (RELAXED_6, $($rest:tt)*) => {};
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let miss = miss::<_, _, $d>($law::new(), $law::new(), $scheme, State::new($q, $v));
            assert!(miss < 2e-12, "{} on {}: {miss:e}", stringify!($scheme), stringify!($law));
            returned += 1;
        }};
    }
    macro_rules! every {
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
    assert_eq!(returned, 8 * 12);
}

#[test]
fn single_precision_follows_double_precision() {
    macro_rules! one {
        ($scheme:ident, $law:ident, $d:literal, $q:expr, $v:expr) => {{
            let law = $law::new();
            let double = Simulation::new(law, State::<$d>::new($q, $v)).scheme($scheme).dt(0.01).run(100).unwrap();
            let narrow = State::<$d, f32>::of($q.map(|x: f64| x as f32), $v.map(|x: f64| x as f32));
            let single = Simulation::new(law, narrow).scheme($scheme).dt(0.01).run(100).unwrap();
            let miss = distance(single.last().q.map(f64::from), double.last().q);
            // An energy that is put back to an ulp puts the velocity at a turning point back to an ulp over h.
            let most = if stringify!($scheme) == "RELAXED_6" { 1e-4 } else { 1e-5 };
            assert!(miss < most && miss > 0.0, "{} on {}: {miss:e}", stringify!($scheme), stringify!($law));
        }};
    }
    macro_rules! every {
        ($law:ident, $($rest:tt)*) => { for_each_scheme!(one, $law, $($rest)*); };
    }
    for_each_law!(every);
}
