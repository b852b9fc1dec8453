//! Orders, with numbers of 31 digits.

use dmech::extend::Real;
use dmech::models::{DampedPendulum, Kepler, MagneticField};
use dmech::prelude::*;
use dmech_tests::measured::{BOWL, SHAKEN, WIND};
use dmech_tests::motion::MASS;

use crate::laws::{Geodesic, for_each_order};

type Wide = DoubleDouble;

pub(crate) fn wide<const D: usize>(state: State<D>) -> State<D, Wide> {
    State::of(state.q.map(Wide::from), state.v.map(Wide::from)).at_time(state.t)
}

/// By halving the step as long as differences are far above rounding: each power that is clear of the next term of the error.
fn order<L, S, const D: usize>(law: L, scheme: S, start: State<D>, what: &str) -> f64
where
    L: Law<D, Wide> + Copy,
    S: Scheme<Particle<L, D, Wide>>,
{
    let end = |k: i32| {
        let simulation = Simulation::new(law, wide(start)).mass(MASS).scheme(scheme).dt(0.5_f64.powi(k));
        let run =
            simulation.record_every(10_000).run(1 << (k + 1)).unwrap_or_else(|interrupted| panic!("{interrupted}"));
        (*run.last(), run.report().rough() > 0)
    };
    let apart = |a: &State<D, Wide>, b: &State<D, Wide>| {
        (0..D).map(|i| ((a.q[i] - b.q[i]).abs() + (a.v[i] - b.v[i]).abs()).to_f64()).fold(0.0, f64::max)
    };
    // What was made in halves was too long a step.
    let first = (0..4).find(|&k| !end(k).1).expect("short enough");
    let (mut last, mut before, mut powers) = (end(first).0, f64::INFINITY, Vec::new());
    for k in first + 1..10 {
        let (next, rough) = end(k);
        assert!(!rough, "{what}: too long a step");
        let change = apart(&last, &next);
        if change < 1e-29 {
            break;
        }
        powers.push((before / change).log2());
        (last, before) = (next, change);
    }
    println!("{:<17} {what:<16} {powers:.3?}", S::NAME);
    assert!(powers.len() > 2, "{} on {what}: {powers:?}", S::NAME);
    powers[powers.len() - 1]
}

macro_rules! has_its_order {
    ($scheme:expr, $measured:ident, $law:expr, $start:expr) => {{
        let order = order($law, $scheme, $start, stringify!($law));
        let declared = f64::from(dmech_tests::motion::order_of_method($scheme));
        assert!((order - declared).abs() < 0.03 * declared, "{order} for {declared} on {}", stringify!($law));
        $measured += 1;
    }};
}

/// Central and not, polynomials and others, forces that depend on the time and, nonlinear or not, on the velocity.
#[test]
fn orders_are_as_declared() {
    let mut measured = 0;
    let planet = State::new([0.8, 0.1], [0.2, 1.1]);
    for_each_order!(has_its_order! { measured, Kepler { gm: 1.3 }, planet });
    for_each_order!(has_its_order! { measured, BOWL, State::new([1.1, 0.3], [-0.2, 0.5]) });
    for_each_order!(has_its_order! { measured, SHAKEN, State::new([1.3], [0.9]).at_time(0.25) });
    for_each_order!(has_its_order! { measured, WIND, State::new([0.7, -0.4], [0.3, 0.8]) });
    assert_eq!(measured, 20);
}

/// The explicit one too, where no force depends on the velocity.
#[test]
fn seventeen_explicit_stages_have_order_12() {
    let mut measured = 0;
    let scheme = RungeKuttaNystrom::order12();
    has_its_order!(scheme, measured, Kepler { gm: 1.3 }, State::new([0.8, 0.1], [0.2, 1.1]));
    has_its_order!(scheme, measured, BOWL, State::new([1.1, 0.3], [-0.2, 0.5]));
    has_its_order!(scheme, measured, SHAKEN, State::new([1.3], [0.9]).at_time(0.25));
    assert_eq!(measured, 3);
}

/// Forces linear in v, and general relativity's.
#[test]
fn forces_of_the_velocity_have_order_16() {
    let mut measured = 0;
    has_its_order!(Gauss::order16(), measured, Geodesic { gm: 1.3, c: 4.7 }, State::new([1.6, 0.1], [0.1, 0.8]));
    has_its_order!(LineIntegral::order6(), measured, Geodesic { gm: 1.3, c: 4.7 }, State::new([1.6, 0.1], [0.1, 0.8]));
    has_its_order!(Gauss::order16(), measured, DampedPendulum { k: 1.7, alpha: 0.4 }, State::new([1.9], [0.3]));
    let field = MagneticField { charge: 3.3, field: [0.4, -0.7, 2.9] };
    has_its_order!(Gauss::order16(), measured, field, State::new([0.3, 0.2, -0.1], [0.5, 0.8, -0.3]));
    has_its_order!(LineIntegral::order8(), measured, field, State::new([0.3, 0.2, -0.1], [0.5, 0.8, -0.3]));
    assert_eq!(measured, 5);
}

/// A circle about a black hole, v² = gm/(r − 3 gm/c²), closes; an ellipse keeps v²/2 − gm/r − gm L²/(c² r³) and L.
#[test]
fn geodesics_keep_what_they_must() {
    let law = Geodesic { gm: 1.3, c: 4.7 };
    let [gm, c] = [law.gm, law.c].map(Wide::from);
    let two = Wide::from(2.0);
    let r = Wide::from(1.9);
    let speed = (gm / (r - Wide::from(3.0) * gm / (c * c))).sqrt();
    let period = two * Wide::ZERO.atan2(-Wide::ONE) * r / speed;
    let n = 40_u32;
    let dt = period.to_f64() / f64::from(n);
    let late = Wide::from(f64::from(n)) * Wide::from(dt) - period;
    let start = State::of([r, Wide::ZERO], [Wide::ZERO, speed]);
    let last = *Simulation::new(law, start).scheme(Gauss::order16()).dt(dt).run(n.into()).unwrap().last();
    let miss = (last.q[0] - late * last.v[0] - r).abs().max((last.q[1] - late * last.v[1]).abs()).to_f64();
    assert!(miss < 1e-27, "{miss:e}");

    let kept = |s: &State<2, Wide>| {
        let ([x, y], [u, w]) = (s.q, s.v);
        let (r2, turning) = (x * x + y * y, x * w - y * u);
        let r = r2.sqrt();
        [(u * u + w * w) / two - gm / r - gm * turning * turning / (c * c * r2 * r), turning]
    };
    let start = wide(State::new([1.6, 0.1], [0.1, 0.8]));
    let run = Simulation::new(law, start).scheme(Gauss::order16()).dt(0.0625).run(400).unwrap();
    let worst =
        |i: usize| run.states().iter().map(|s| (kept(s)[i] - kept(&start)[i]).abs().to_f64()).fold(0.0, f64::max);
    println!("energy {:e}, angular momentum {:e}, circle {miss:e}", worst(0), worst(1));
    assert!(worst(0) < 1e-20 && worst(0) > 0.0, "{:e}", worst(0));
    // Along q there is no moment, whatever the force.
    assert!(worst(1) < 1e-29, "{:e}", worst(1));
}
