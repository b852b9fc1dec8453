//! Greenspan §4, the pendulum, by the code of `examples/pendulum.rs`, against the same computation made independently.

#[path = "../../examples/shared/section_4.rs"]
mod section_4;

use approx::relative_eq;
use section_4::{ALPHAS, Extrema, STABILITY, TIME_STEPS, explicit_limit, implicit, leapfrog, measured_growth};

/// α, Δt, and x and v after 10⁴ steps: an independent reproduction in binary64, whose own check against 80-bit
/// arithmetic leaves 1e-9 as the meaningful tolerance.
#[rustfmt::skip]
const IMPLICIT: [(f64, f64, f64, f64); 6] = [
    (0.003, 1.0, 2.927812991009e-06, 3.625362585414e-06),
    (0.003, 0.1, 0.13142004863663306, -0.11274025080566367),
    (0.003, 0.01, -0.5170909621197257, -0.4171800392941224),
    (0.0, 1.0, -0.3560270186369273, 0.6740403307635066),
    (0.0, 0.1, 0.6904350663596945, 0.3573762349437363),
    (0.0, 0.01, -0.26279669858188565, -0.7191104013375382),
];

/// Δt, x and the mean of the two half-step velocities.
const LEAPFROG: [(f64, f64, f64); 3] = [
    (1.0, -0.5460156741441091, -0.48556672713748306),
    (0.1, 0.6484634468232082, -0.4236278414822404),
    (0.01, -0.2636263341296416, -0.718802653690258),
];

#[test]
fn ends_where_the_reproduction_ends() {
    for (alpha, dt, x, v) in IMPLICIT {
        let end = *implicit(alpha, dt).unwrap().last();
        let error = (end.q[0] - x).abs().max((end.v[0] - v).abs());
        println!("implicit α = {alpha:<5} Δt = {dt:<4} {error:.1e}");
        assert!(error < 1e-9, "α = {alpha}, Δt = {dt}: {end:?}");
    }
    for (dt, x, v) in LEAPFROG {
        let end = *leapfrog(dt).unwrap().last();
        let error = (end.q[0] - x).abs().max((end.v[0] - v).abs());
        println!("leap-frog          Δt = {dt:<4} {error:.1e}");
        assert!(error < 1e-9, "Δt = {dt}: {end:?}");
    }
}

#[test]
fn every_case_is_stable_and_loses_the_energy_that_its_damping_takes() {
    for alpha in ALPHAS {
        for dt in TIME_STEPS {
            let run = implicit(alpha, dt).unwrap();
            let energy = |x: f64, v: f64| 0.5 * v * v + 2.0 * (0.5 * x).sin().powi(2);
            let (first, last) = (run.states()[0], run.last());
            let kept = energy(last.q[0], last.v[0]) / energy(first.q[0], first.v[0]);
            // The step maps an eigenvalue μ = −α/2 ± i of the small swing to (1 + μh/2)/(1 − μh/2), which damps it by
            // e^(−αh/2(1 + h²/4)). The rest is due to the size of the swing, and at Δt = 1 to where in it the run ends.
            let expected = (-alpha * last.t / (1.0 + 0.25 * dt * dt)).exp();
            println!("α = {alpha:<5} Δt = {dt:<4} {kept:.3e} {:.4}", kept / expected);
            assert!(relative_eq!(kept, expected, max_relative = 0.1), "α = {alpha}, Δt = {dt}: {kept} of {expected}");
        }
    }
}

#[test]
fn undamped_extrema() {
    // Found where the paper claims 1e-5 for all: 7.7e-2 at Δt = 1 and 8.8e-4 at 0.1.
    let raw = [(1.0, 7.7e-2), (0.1, 8.8e-4)];
    for dt in TIME_STEPS {
        for (name, run) in [("implicit", implicit(0.0, dt)), ("leap-frog", leapfrog(dt))] {
            let extrema = Extrema::of(run.unwrap().states());
            println!("{name:<9} Δt = {dt:<4} {extrema:?}");
            assert!(extrema.overshoot <= 0.0, "{name}, Δt = {dt}: beyond π/4 by {:e}", extrema.overshoot);
            assert!(extrema.count > 25, "a pendulum that does not swing has no extrema to check");
            assert_eq!(extrema.raw < 1e-5, dt == 0.01, "{name}, Δt = {dt}: {:e}", extrema.raw);
            assert!(extrema.parabola < extrema.raw);
            if let ("implicit", Some((_, found))) = (name, raw.iter().find(|(at, _)| *at == dt)) {
                assert!(relative_eq!(extrema.raw, found, max_relative = 0.02), "Δt = {dt}: {:e}", extrema.raw);
            }
        }
    }
}

#[test]
fn explicit_is_stable_below_the_smaller_limit_and_nowhere_above() {
    for (alpha, n) in STABILITY {
        let limit = explicit_limit(alpha);
        for (part, stable) in [(0.98, true), (1.02, false), (1.5, false)] {
            let dt = part * limit;
            let growth = measured_growth(alpha, dt, if part > 1.1 { n / 10 } else { n }).unwrap();
            let predicted = section_4::predicted_growth(alpha, dt);
            println!("α = {alpha:<5} Δt = {dt:<8.5} {growth:.9} {predicted:.9}");
            assert_eq!(growth < 1.0, stable, "α = {alpha}, Δt = {dt}: {growth}");
            // The phase in which the amplitude is read moves it by no more than a few per cent over n steps.
            assert!((growth - predicted).abs() < 0.2 * (predicted - 1.0).abs(), "α = {alpha}: {growth} {predicted}");
        }
        // The printed limit, max(2α, 2/α), would allow this step.
        assert!(1.5 * limit < (2.0 * alpha).max(2.0 / alpha));
    }
}
