//! The generated Kepler law against the exact orbit: orders, error constants, what is kept over long times.

use approx::{abs_diff_eq, relative_eq};
use dmech::models::Kepler;
use dmech::prelude::*;

const SUN: Kepler = Kepler { gm: 1.0 };

/// Greenspan's planet (5.6).
fn planet() -> State<2> {
    State::new([0.5, 0.0], [0.0, 1.63])
}

/// Where that planet is at time t, by Kepler's equation.
fn exact_position(t: f64) -> [f64; 2] {
    let (r, v) = (0.5, 1.63);
    let a = 1.0 / (2.0 / r - v * v);
    let e = 1.0 - r / a;
    let mean = t / a.powf(1.5);
    let mut anomaly = mean;
    for _ in 0..50 {
        anomaly -= (anomaly - e * anomaly.sin() - mean) / (1.0 - e * anomaly.cos());
    }
    [a * (anomaly.cos() - e), a * (1.0 - e * e).sqrt() * anomaly.sin()]
}

fn error_at_1<S: Scheme<Particle<Kepler, 2>>>(scheme: S, steps: u64) -> f64 {
    let run = Simulation::new(SUN, planet()).scheme(scheme).dt(1.0 / steps as f64).record_every(steps).run(steps);
    let end = run.unwrap_or_else(|interrupted| panic!("{interrupted}")).last().q;
    let exact = exact_position(1.0);
    (end[0] - exact[0]).hypot(end[1] - exact[1])
}

/// Order within 0.02, and the constant C of the error C h^p of an independent computation within 1 % (its last digit).
fn check_order<S: Scheme<Particle<Kepler, 2>>>(scheme: S, constant: f64) {
    let (coarse, fine) = (error_at_1(scheme, 800), error_at_1(scheme, 1600));
    let order = (coarse / fine).log2();
    let declared = f64::from(S::ORDER);
    let measured = fine * 1600_f64.powf(declared);
    println!("{:<17} order {order:.4}, error {measured:.3} h^{declared}", S::NAME);
    assert!(abs_diff_eq!(order, declared, epsilon = 0.02), "{} has order {order}", S::NAME);
    assert!(relative_eq!(measured, constant, max_relative = 0.01), "{}: {measured} h^p, not {constant}", S::NAME);
}

#[test]
fn orders_and_error_constants_at_t_1() {
    check_order(Explicit, 2.02);
    check_order(Leapfrog, 2.28);
    check_order(Implicit, 2.05);
    check_order(DiscreteGradient, 1.56);
    check_order(Kanatani, 12.4);
}

/// 10⁵ steps of 1/200 period from the apocentre of an orbit with semi-major axis 1.
fn check_kept<S: Scheme<Particle<Kepler, 2>>>(scheme: S, eccentricity: f64, energy: Invariant, bound: f64) {
    let r = 1.0 + eccentricity;
    let v = ((1.0 - eccentricity) / r).sqrt();
    let dt = std::f64::consts::TAU / 200.0;
    let run = Simulation::new(SUN, State::new([r, 0.0], [0.0, v])).scheme(scheme).dt(dt).run(100_000);
    let run = run.unwrap_or_else(|interrupted| panic!("{interrupted}"));
    let (energy, turning) = (run.drift(energy).unwrap(), run.drift(Invariant::AngularMomentum).unwrap());
    println!(
        "{:<17} e = {eccentricity}: energy {:.1e}, angular momentum {:.1e}",
        S::NAME,
        energy.max_relative(),
        turning.max_relative()
    );
    // At the pericentre K and Φ are many times the energy, and so is their rounding; the angular momentum is the same all round.
    assert!(energy.max_relative() < bound && turning.max_relative() < 1e-14, "{} at e = {eccentricity}", S::NAME);
    // The rounding is there, or nothing was looked at.
    assert!(energy.max_relative() > 0.0 && turning.max_relative() > 0.0);
}

#[test]
fn energy_and_angular_momentum_are_kept_over_500_orbits() {
    check_kept(DiscreteGradient, 0.3, Invariant::Energy, 1e-14);
    check_kept(DiscreteGradient, 0.9, Invariant::Energy, 2e-13);
    check_kept(Kanatani, 0.3, Invariant::DiscreteEnergy, 1e-14);
    check_kept(Kanatani, 0.9, Invariant::DiscreteEnergy, 1e-13);
}

/// x″ = −k x.
#[derive(Clone, Copy, Debug, dmech::Law)]
#[potential(|q: f64| 0.5 * self.k * q * q)]
struct Spring {
    k: f64,
}

/// The same step in plain sums, in the textbook form v′ = 2 Δq/h − v.
fn plain_oscillator(h: f64, steps: u64) -> f64 {
    let (mut x, mut v) = (1.0_f64, 0.0_f64);
    let energy = |x: f64, v: f64| 0.5 * (x * x + v * v);
    let (start, mut worst) = (energy(x, v), 0.0_f64);
    for _ in 0..steps {
        let next = (x * (1.0 - 0.25 * h * h) + h * v) / (1.0 + 0.25 * h * h);
        v = 2.0 * (next - x) / h - v;
        x = next;
        worst = worst.max((energy(x, v) - start).abs());
    }
    worst / start
}

#[test]
fn the_oscillator_keeps_its_energy_over_a_million_steps_and_needs_no_iteration() {
    fn check<S: Scheme<Particle<Spring, 1>>>(scheme: S, energy: Invariant) {
        let spring = Simulation::new(Spring { k: 1.0 }, State::new([1.0], [0.0])).scheme(scheme).dt(0.01);
        let run = spring.record_every(10).run(1_000_000).unwrap();
        let worst = run.drift(energy).unwrap().max_relative();
        println!("{:<17} {worst:.1e}", S::NAME);
        assert!(worst < 1e-13 && worst > 0.0, "{}: {worst:e}", S::NAME);
        assert_eq!(run.report().iterations(), 0);
    }
    check(DiscreteGradient, Invariant::Energy);
    check(Kanatani, Invariant::DiscreteEnergy);
    // Plain sums fail the same test.
    let plain = plain_oscillator(0.01, 1_000_000);
    println!("plain sums        {plain:.1e}");
    assert!(plain > 1e-12, "{plain:e}");
}

/// Kanatani's explicit form of the linear step (3.20)–(3.21), with m = 1.3.
#[test]
fn a_quadratic_potential_gives_kanatanis_closed_form() {
    let (k, m, h) = (2.3, 1.3, 0.17);
    let run = Simulation::new(Spring { k }, State::new([0.8], [-0.4])).mass(m).scheme(Kanatani).dt(h).run(200).unwrap();
    let x: Vec<f64> = run.states().iter().map(|s| s.q[0]).collect();
    let divisor = 1.0 + k * h * h / (2.0 * m);
    // z₁ = (x₁ − x₀)/h from the run; everything after it by the paper's recursion.
    let (mut before, mut now, mut z) = (x[0], x[1], (x[1] - x[0]) / h);
    for (i, &computed) in x.iter().enumerate().skip(2) {
        let next = (now - k * before * h * h / (2.0 * m) + z * h) / divisor;
        z = (z - k * (now + before) * h / (2.0 * m)) / divisor;
        (before, now) = (now, next);
        assert!(abs_diff_eq!(computed, next, epsilon = 1e-13), "step {i}: {computed} {next}");
    }
}
