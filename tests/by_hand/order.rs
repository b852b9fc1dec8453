//! The order of each scheme, measured.

use crate::common::{Kepler, SUN, SUN_BY_COMPONENTS, greenspan_orbit, kepler_position};
use approx::{abs_diff_eq, assert_abs_diff_eq, relative_eq};
use dmech_core::prelude::*;

fn error_at_one<L: Law<2>, S: Scheme<Particle<L, 2>>>(law: L, scheme: S, n: u32) -> f64 {
    let run = Simulation::new(law, greenspan_orbit()).scheme(scheme).dt(1.0 / f64::from(n)).run_until(1.0).unwrap();
    let exact = kepler_position(1.0);
    assert_eq!((run.steps(), run.last().t), (u64::from(n), 1.0));
    (run.last().q[0] - exact[0]).hypot(run.last().q[1] - exact[1])
}

/// The slope of log error against log dt over the ladder, and the constant error/dt^ORDER at its end.
fn measure<L: Law<2> + Copy, S: Scheme<Particle<L, 2>>>(law: L, scheme: S) -> (f64, f64) {
    let ladder = [800, 1600, 3200, 6400];
    let points: Vec<(f64, f64)> =
        ladder.iter().map(|&n| (-f64::from(n).ln(), error_at_one(law, scheme, n).ln())).collect();
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
    let slope = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum::<f64>()
        / points.iter().map(|p| (p.0 - mx) * (p.0 - mx)).sum::<f64>();
    let (x, y) = points[points.len() - 1];
    (slope, (y - f64::from(S::ORDER) * x).exp())
}

/// Positions at t = 1 on Greenspan's orbit (not at t = 4: near a period errors cancel), against Kepler's equation. The
/// constants are those of the reference, printed to three digits there.
#[test]
fn each_scheme_has_its_order_and_its_error_constant() {
    fn check<L: Law<2> + VelocityIndependent + Copy>(law: L) {
        let table = [
            ("Explicit", measure(law, Explicit), Explicit::ORDER, 2.02),
            ("Leapfrog", measure(law, Leapfrog), Leapfrog::ORDER, 2.28),
            ("Implicit", measure(law, Implicit), Implicit::ORDER, 2.05),
            ("DiscreteGradient", measure(law, DiscreteGradient), DiscreteGradient::ORDER, 1.56),
            ("Kanatani", measure(law, Kanatani), Kanatani::ORDER, 12.4),
        ];
        for (name, (slope, constant), order, expected) in table {
            println!("{name}: order {slope:.4}, constant {constant:.4}");
            assert!(abs_diff_eq!(slope, f64::from(order), epsilon = 0.02), "{name} has order {slope}");
            assert!(
                relative_eq!(constant, expected, max_relative = 0.005),
                "{name} has constant {constant}, not {expected}"
            );
        }
    }
    check(SUN);
    check(SUN_BY_COMPONENTS);
}

/// The velocity of a state is of second order too, where it is put together from half steps.
#[test]
fn velocities_at_whole_steps_are_of_second_order() {
    fn error<S: Scheme<Particle<Kepler<true>, 2>>>(scheme: S, n: u32) -> f64 {
        let run = Simulation::new(SUN, greenspan_orbit()).scheme(scheme).dt(1.0 / f64::from(n)).run_until(1.0).unwrap();
        let (before, after) = (kepler_position(1.0 - 1e-5), kepler_position(1.0 + 1e-5));
        let exact = [(after[0] - before[0]) / 2e-5, (after[1] - before[1]) / 2e-5];
        (run.last().v[0] - exact[0]).hypot(run.last().v[1] - exact[1])
    }
    for (name, coarse, fine) in [
        ("Leapfrog", error(Leapfrog, 400), error(Leapfrog, 800)),
        ("Implicit", error(Implicit, 400), error(Implicit, 800)),
        ("DiscreteGradient", error(DiscreteGradient, 400), error(DiscreteGradient, 800)),
        ("Kanatani", error(Kanatani, 400), error(Kanatani, 800)),
    ] {
        let order = (coarse / fine).log2();
        assert!(abs_diff_eq!(order, 2.0, epsilon = 0.05), "{name}: {order}");
    }
}

/// A backward step of another scheme starts Kanatani's recursion as well as its formula does, at another constant.
#[test]
fn kanatani_keeps_its_order_from_either_start() {
    let (order, constant) = measure(SUN, Kanatani.start(Start::BackwardStep));
    assert_abs_diff_eq!(order, 2.0, epsilon = 0.02);
    assert!(constant < 12.4, "{constant}");
}
