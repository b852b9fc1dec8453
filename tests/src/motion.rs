//! What the suites measure of a motion: order, invariants, the way back.

use dmech::prelude::*;
use dmech::{Kept, Potential};

/// The splittings as rows of tables.
pub const NYSTROM_4: Nystrom<coefficients::BlanesMoan4S6, 6> = Nystrom::order4();
pub const NYSTROM_6: Nystrom<coefficients::BlanesMoan6S14, 14> = Nystrom::order6();
pub const RELAXED_6: Relaxed<coefficients::BlanesMoan6S14, 14> = Relaxed::order6();
pub const FORCE_GRADIENT_4: ForceGradient<coefficients::Omelyan4S5, 5> = ForceGradient::order4();

/// The mass that the suites use: not 1.
pub const MASS: f64 = 1.3;

pub fn distance<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The state at t = 1 after a number of steps.
pub fn end<L, S, const D: usize>(law: L, scheme: S, start: State<D>, steps: u64) -> State<D>
where
    L: Law<D>,
    S: Scheme<Particle<L, D>>,
{
    let run = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(1.0 / steps as f64).run(steps);
    *run.unwrap_or_else(|interrupted| panic!("{interrupted}")).last()
}

/// The exponent of h in the error of the position at t = 1, by halving the step twice (no exact solution needed:
/// |u_h − u_{h/2}| / |u_{h/2} − u_{h/4}| → 2^p), held against the order that the scheme declares.
pub fn has_its_order<L, S, const D: usize>(law: L, scheme: S, start: State<D>, tolerance: f64, law_name: &str)
where
    L: Law<D> + Copy,
    S: Scheme<Particle<L, D>>,
{
    let [one, two, four] = [400, 800, 1600].map(|steps| end(law, scheme, start, steps).q);
    let (coarse, fine) = (distance(one, two), distance(two, four));
    assert!(fine > 1e-11, "{fine:e}: at the level of rounding there is no order to measure");
    let order = (coarse / fine).log2();
    println!("{law_name:<16} {:<17} {order:.4}", S::NAME);
    assert!((order - f64::from(S::ORDER)).abs() < tolerance, "{} on {law_name}: {order}", S::NAME);
}

/// Σ mᵢ vᵢ²/2.
pub fn kinetic<const D: usize>(masses: [f64; D], v: [f64; D]) -> f64 {
    (0..D).map(|i| 0.5 * masses[i] * v[i] * v[i]).sum()
}

/// Kinetic and potential energy without regard to sign, as they may cancel: the largest of these states.
pub fn energy_scale<L: Law<D>, const D: usize>(law: &L, states: &[State<D>]) -> f64 {
    let of = |s: &State<D>| law.field(MASS, s.t).potential(s.q).abs() + kinetic([MASS; D], s.v);
    states.iter().map(of).fold(0.0, f64::max)
}

/// Steps of a run that measures round-off.
const STEPS: u64 = 20_000;

/// A run over which invariants are looked at.
pub fn long_run<L, S, const D: usize>(law: L, scheme: S, start: State<D>) -> Run<State<D>>
where
    L: Law<D>,
    S: Scheme<Particle<L, D>>,
{
    // The explicit orbits spiral outward, some to infinity.
    let steps = if S::ORDER == 1 { 200 } else { STEPS };
    let run = Simulation::new(law, start).mass(MASS).scheme(scheme).dt(0.01).run(steps);
    run.unwrap_or_else(|interrupted| panic!("{interrupted}"))
}

/// A quantity that goes to and fro has no trend: the least-squares line through it rises over the run by a small part of
/// the largest deviation. Of one that accumulates the line is the deviation, however small that still is. Rounding walks.
pub fn does_not_drift<const D: usize>(run: &Run<State<D>>, invariant: Invariant, what: &str) {
    let drift = run.drift(invariant).unwrap_or_else(|| panic!("{what}: no {invariant}"));
    let rise = drift.slope().abs() * (run.last().t - run.states()[0].t);
    println!("{what:<50} {invariant}: rises by {:.4} of {:.1e}", rise / drift.max_abs(), drift.max_abs());
    let rounding = 16.0 * f64::EPSILON * (drift.samples() as f64).sqrt() * drift.start().abs().max(1.0);
    assert!(
        rise < 0.1 * drift.max_abs() + rounding,
        "{what}: {invariant} rises by {rise:e}, deviates by {:e}",
        drift.max_abs()
    );
}

/// Whether a law has no seams.
pub fn smooth<L: Law<D>, const D: usize>(_: &L) -> bool {
    !<L::Field<'_> as Potential<D>>::PIECEWISE
}

/// How many invariants were found kept, and the worst of those that are exact.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    pub exact: usize,
    pub bounded: usize,
    pub worst_exact: f64,
}

impl Tally {
    /// Exact to round-off and bounded without drift, as the scheme promises; energies relative to `scale`.
    ///
    /// Where a force has a kink no nearby energy is kept that would hold the error: what is left at each crossing adds up as
    /// a walk, and a run has a trend by chance.
    pub fn check<S: Method, const D: usize>(
        &mut self,
        _: S,
        run: &Run<State<D>>,
        scale: f64,
        smooth: bool,
        law_name: &str,
    ) {
        for invariant in Invariant::ALL {
            let Some(drift) = run.drift(invariant) else { continue };
            let worst = drift.max_abs() / if invariant == Invariant::AngularMomentum { 1.0 } else { scale };
            let what = format!("{} on {law_name}: {invariant:?} {worst:e}", S::NAME);
            match S::keeps(invariant) {
                Kept::Exact => {
                    assert!(worst < 2e-13 * (STEPS as f64 / 1e3).sqrt(), "{what}");
                    self.worst_exact = self.worst_exact.max(worst);
                    self.exact += 1;
                }
                Kept::Bounded | Kept::BetweenSeams => {
                    assert!(worst < 0.02, "{what}");
                    if smooth {
                        does_not_drift(run, invariant, &what);
                    }
                    self.bounded += 1;
                }
                Kept::No => {}
            }
        }
    }
}

/// Kinetic energy less work is constant to 10⁻¹² of the largest kinetic energy, for a particle or bodies of these masses.
pub fn work_balances<const D: usize>(run: &Run<State<D>>, masses: [f64; D], law_name: &str) {
    let drift = run.drift(Invariant::WorkEnergy).expect("every law has work");
    let largest = run.states().iter().map(|s| kinetic(masses, s.v)).fold(0.0, f64::max);
    let relative = drift.max_abs() / largest;
    let what = format!("{:<18} {law_name:<12} {relative:.1e}", run.report().scheme());
    println!("{what}");
    assert!(relative < 1e-12, "{what}");
    assert!(drift.max_abs() > 0.0, "{what}: nothing moved");
}

/// How far from home a motion ends that goes there and back; `home` is the law under the reversal of time.
pub fn miss<L, S, const D: usize>(law: L, home: L, scheme: S, start: State<D>) -> f64
where
    L: Law<D>,
    S: Scheme<Particle<L, D>>,
{
    assert!(S::SYMMETRIC);
    let there = end(law, scheme, start, 500);
    assert!(distance(there.q, start.q) > 0.05, "it did not move");
    let back = end(home, scheme, State::new(there.q, there.v).reversed(), 500).reversed();
    distance(back.q, start.q) + distance(back.v, start.v)
}

/// The order that a method declares.
pub fn order_of_method<S: Method>(_: S) -> u32 {
    S::ORDER
}
