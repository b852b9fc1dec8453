//! Gauss's method is symplectic, and what comes with that.

use dmech::extend::Real;
use dmech::models::{HenonHeiles, Kepler};
use dmech::prelude::*;
use dmech_tests::measured::{SHAKEN, WIND};
use dmech_tests::motion::{MASS, miss, work_balances};

use crate::laws::{Quartic, Soft, for_each_order};
use crate::orders::wide;

type Wide = DoubleDouble;

/// MᵀJM − J of a step, by central differences with numbers of 31 digits: its largest element.
fn not_symplectic<L, S>(law: L, scheme: S, start: State<2>, dt: f64) -> f64
where
    L: Law<2, Wide> + Copy,
    S: Scheme<Particle<L, 2, Wide>>,
{
    let delta = Wide::from(1e-10);
    let end = |i: usize, shift: Wide| {
        let mut from = wide(start);
        if i < 2 {
            from.q[i] += shift
        } else {
            from.v[i - 2] += shift
        }
        let last = *Simulation::new(law, from).mass(MASS).scheme(scheme).dt(dt).run(1).unwrap().last();
        [last.q[0], last.q[1], last.v[0], last.v[1]]
    };
    let columns: [[Wide; 4]; 4] = core::array::from_fn(|i| {
        let (more, less) = (end(i, delta), end(i, -delta));
        core::array::from_fn(|k| (more[k] - less[k]) / (delta + delta))
    });
    // The mass is the same for both coordinates: that of (q, v) is that of (q, p).
    let form = |a: [Wide; 4], b: [Wide; 4]| a[0] * b[2] + a[1] * b[3] - a[2] * b[0] - a[3] * b[1];
    let mut worst = 0.0_f64;
    for i in 0..4 {
        for j in 0..4 {
            let unit = if j == i + 2 {
                1.0
            } else if i == j + 2 {
                -1.0
            } else {
                0.0
            };
            worst = worst.max((form(columns[i], columns[j]) - Wide::from(unit)).to_f64().abs());
        }
    }
    worst
}

#[test]
fn the_area_is_kept_in_long_steps() {
    let start = State::new([0.31, -0.22], [0.37, 0.29]);
    for dt in [0.1, 0.7, 2.1] {
        let [gauss, planet] = [
            not_symplectic(HenonHeiles { lambda: 0.9 }, Gauss::order16(), start, dt),
            not_symplectic(Kepler { gm: 1.3 }, Gauss::order16(), State::new([1.2, 0.3], [-0.2, 1.1]), 0.7 * dt),
        ];
        println!("dt = {dt}: {gauss:e} {planet:e}");
        assert!(gauss < 1e-17 && planet < 1e-17, "dt = {dt}: {gauss:e} {planet:e}");
    }
    // A line integral is not, which shows that it can be seen.
    let line = not_symplectic(HenonHeiles { lambda: 0.9 }, LineIntegral::order4(), start, 0.7);
    assert!(line > 1e-6, "{line:e}");
}

#[test]
fn there_and_back() {
    let mut worst = 0.0_f64;
    macro_rules! returns {
        ($scheme:expr, $law:expr, $start:expr) => {
            worst = worst.max(miss($law, $law, $scheme, $start))
        };
    }
    for_each_order!(returns! { Kepler { gm: 1.3 }, State::new([0.9, 0.2], [-0.1, 1.1]) });
    for_each_order!(returns! { Quartic { k: 0.8 }, State::new([0.9, 0.2], [-0.1, 1.1]) });
    assert!(worst < 1e-13, "{worst:e}");
}

/// Angular momentum about the centre of a force, and both momenta of bodies that attract each other.
#[test]
fn momenta_are_kept_to_rounding() {
    let planet = State::new([0.8, 0.1], [0.2, 1.1]);
    let run =
        Simulation::new(Kepler { gm: 1.3 }, planet).mass(MASS).scheme(Gauss::order16()).dt(0.15).run(50_000).unwrap();
    let angular = run.drift(Invariant::AngularMomentum).unwrap();
    println!("{:e}", angular.max_relative());
    assert!(angular.max_relative() < f64::EPSILON * 50_000_f64.sqrt() && angular.max_abs() > 0.0, "{angular:?}");

    let bodies = Scene::new()
        .body(1.3, [0.9, 0.1, 0.2], [0.1, 0.4, 0.0])
        .body(0.7, [-0.8, 0.3, 0.1], [0.2, -0.3, 0.3])
        .body(2.1, [0.2, -1.1, -0.3], [-0.3, 0.1, -0.1]);
    macro_rules! linear {
        ($scheme:expr, $angular:literal) => {{
            let scene = Simulation::scene(bodies.clone().pairs(Soft { g: 0.3, eps: 0.7 })).scheme($scheme).dt(0.05);
            let run = scene.run(5000).unwrap();
            let [linear, angular] =
                [Invariant::LinearMomentum, Invariant::AngularMomentum].map(|i| run.drift(i).unwrap().max_abs());
            println!("{}: {linear:e} {angular:e}", run.report().scheme());
            assert!(linear < 1e-13 && (angular < 1e-13 || !$angular), "{linear:e} {angular:e}");
        }};
    }
    for_each_order!(linear! { false });
    linear!(Gauss::order16(), true);
}

/// Kinetic energy less the work of forces that turn, brake and name the time.
#[test]
fn work_is_what_it_changes() {
    macro_rules! balances {
        ($scheme:expr, $law:expr, $start:expr, $masses:expr) => {{
            let run = Simulation::new($law, $start).mass(MASS).scheme($scheme).dt(0.1).run(2000).unwrap();
            work_balances(&run, $masses, stringify!($law));
        }};
    }
    for_each_order!(balances! { WIND, State::new([0.7, -0.4], [0.3, 0.8]), [MASS; 2] });
    for_each_order!(balances! { SHAKEN, State::new([1.3], [0.9]), [MASS] });
    let run = Simulation::new(Quartic { k: 0.8 }, State::new([0.7, -0.4], [0.3, 0.8])).masses([1.7, 0.4]);
    work_balances(&run.scheme(Gauss::order16()).dt(0.1).run(2000).unwrap(), [1.7, 0.4], "masses");
}

/// Brouwer's law: the error of the energy, which is rounding alone, is a walk. Over a dozen planets its mean square
/// grows like the number of steps.
#[test]
fn the_energy_walks() {
    let law = Kepler { gm: 1.0 };
    let looks: [u64; 4] = [1_500, 6_000, 24_000, 96_000];
    let mut squares = [0.0; 4];
    let planets = 12;
    for i in 0..planets {
        let turn = 0.31 + 0.52 * f64::from(i);
        let State { q: [q, _], v: [_, v], .. } = law.pericentre(1.0 + 0.01 * f64::from(i), 0.3);
        let start = State::new([q * turn.cos(), q * turn.sin()], [-v * turn.sin(), v * turn.cos()]);
        let simulation = Simulation::new(law, start).scheme(Gauss::order16()).dt(law.period(1.0) / 40.0);
        let mut stepper = simulation.stepper().unwrap();
        let energy = stepper.energy().unwrap();
        for (square, look) in squares.iter_mut().zip(looks) {
            stepper.advance(look - stepper.steps()).unwrap();
            // Seen with more digits than the sum has itself.
            *square += ((stepper.energy().unwrap() - energy) / energy).powi(2) / f64::from(planets);
        }
    }
    let roots = squares.map(f64::sqrt);
    let exponent = (roots[3] / roots[0]).ln() / (looks[3] as f64 / looks[0] as f64).ln();
    println!("{roots:?}: exponent {exponent:.3}");
    assert!(exponent < 0.7 && roots[3] < 2e-14, "{roots:?}: {exponent}");
    assert!(roots[3] > 1e-17, "nothing was rounded");
}
