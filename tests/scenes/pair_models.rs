//! Motions of few bodies under the library's pair laws, against the closed forms that stand with the laws.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use dmech::models::pairs::*;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

/// The last state of a run in so many steps.
fn end<const D: usize, P, L: Term<D, P>, S: Scheme<SceneSystem<D, L::Ready>>>(
    scene: Scene<D, P, L>,
    scheme: S,
    span: f64,
    steps: u64,
) -> SceneState<D> {
    Simulation::scene(scene).scheme(scheme).dt(span / steps as f64).run(steps).unwrap().last().clone()
}

fn apart<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Two bodies under gravity, and two charges whose attraction is as large, come back after a period: eccentricity 0.6.
#[test]
fn two_bodies_come_back() {
    let (g, masses, half_axis, e) = (1.3, [2.5, 0.7], 1.4, 0.6_f64);
    let total: f64 = masses.iter().sum();
    let distance = half_axis * (1.0 - e);
    let speed = (g * total / half_axis * (1.0 + e) / (1.0 - e)).sqrt();
    let parts = [-masses[1] / total, masses[0] / total];
    let (q, v) = (parts.map(|part| [part * distance, 0.0]), parts.map(|part| [0.0, part * speed]));

    let law = Gravity { g };
    let stars = Scene::new().body(masses[0], q[0], v[0]).body(masses[1], q[1], v[1]).pairs(law);
    let back = end(stars, Nystrom::order8(), law.period(half_axis, total), 1000);
    assert!(apart(&back.q, &q) < 1e-10 && apart(&back.v, &v) < 1e-10, "{back:?}");

    let (law, charges) = (Coulomb { k: 2.0 }, [Charge { q: g * masses[0] / 2.0 }, Charge { q: -masses[1] }]);
    let ions = Scene::new().body_with(masses[0], q[0], v[0], charges[0]).body_with(masses[1], q[1], v[1], charges[1]);
    let period = law.period(half_axis, masses[0] * masses[1] / total, charges);
    let back = end(ions.pairs(law), Nystrom::order8(), period, 1000);
    assert!(apart(&back.q, &q) < 1e-10 && apart(&back.v, &v) < 1e-10, "{back:?}");
}

/// Charges of one sign turn back where all energy is in their distance.
#[test]
fn charges_come_as_close_as_they_can() {
    let (law, charges) = (Coulomb { k: 1.3 }, [Charge { q: 2.0 }, Charge { q: 0.7 }]);
    // At rest: they part, and by then have the energy that they had.
    let ions = Scene::new().body_with(1.0, [0.0], [0.0], charges[0]).body_with(3.0, [0.9], [0.0], charges[1]);
    let last = end(ions.pairs(law), Nystrom::order6(), 5.0, 5000);
    let (r, u) = (last.q[1][0] - last.q[0][0], last.v[1][0] - last.v[0][0]);
    let relative = 0.5 * 0.75 * u * u + law.energy(r, &charges[0], &charges[1]);
    assert_abs_diff_eq!(law.closest(relative, charges), 0.9, epsilon = 1e-10);
}

/// Two masses on a bond come back after a period of their reduced mass: exactly for springs and Morse, for small vibrations
/// of Lennard-Jones' atoms.
#[test]
fn bonds_vibrate_in_their_time() {
    let reduced = 1.3 * 0.8 / 2.1;
    let pair = |r: f64| Scene::new().body(1.3, [0.2], [0.0]).body(0.8, [0.2 + r], [0.0]);
    let stretched = |state: &SceneState<1>| state.q[1][0] - state.q[0][0];

    let spring = Spring { k: 1.7, length: 1.1 };
    let last = end(pair(1.6).pairs(spring), Nystrom::order8(), spring.period(reduced), 200);
    assert_abs_diff_eq!(stretched(&last), 1.6, epsilon = 1e-12);

    let morse = Morse { depth: 1.5, width: 1.2, length: 0.8 };
    let last = end(pair(1.7).pairs(morse), Nystrom::order8(), morse.period(morse.energy(1.7), reduced), 1000);
    assert_abs_diff_eq!(stretched(&last), 1.7, epsilon = 1e-11);

    let atoms = LennardJones { epsilon: 0.7, sigma: 1.1 };
    // The period is longer by the square of the amplitude, and at rest the place does not change with the time.
    for amplitude in [1e-3, 1e-4] {
        let start = atoms.rest() + amplitude;
        let last = end(pair(start).pairs(atoms), Nystrom::order8(), atoms.small_period(reduced), 1000);
        assert!((stretched(&last) - start).abs() < 1e4 * amplitude.powi(5) + 1e-12, "{}", stretched(&last) - start);
    }
}

/// Every mode of a weakly excited chain swings with its own frequency.
#[test]
fn a_weak_chain_swings_in_its_modes() {
    let (law, mass, springs) = (FermiPastaUlamTsingou { k: 1.3, alpha: 0.25, beta: 0.4 }, 0.7, 8);
    for mode in 1..springs {
        let shape = |j: usize| (core::f64::consts::PI * (mode * j) as f64 / springs as f64).sin();
        let amplitude = 1e-6;
        let place = |j: usize| if j.is_multiple_of(springs) { 0.0 } else { amplitude * shape(j) };
        let chain = (0..=springs).fold(Scene::new(), |scene, j| scene.body(mass, [place(j)], [0.0]));
        let period = core::f64::consts::TAU / law.small_frequency(mode, springs, mass);
        let last = end(chain.chain(law).pin(0).pin(springs), Nystrom::order8(), period, 100);
        let miss = (0..=springs).map(|j| (last.q[j][0] - place(j)).abs()).fold(0.0, f64::max);
        assert!(miss < 1e-5 * amplitude, "mode {mode}: {miss:e}");
    }
}

/// A soliton of Toda's chain keeps its shape and its speed, by a scheme of order eight to ten digits.
#[test]
fn a_soliton_runs_as_it_should() {
    let (law, kappa, mass, span) = (Toda { a: 0.8, b: 1.4 }, 0.9, 1.3, 12.0);
    let at = |j: i32, t: f64| law.soliton(kappa, mass, f64::from(j) - 30.0, t);
    let scene = || {
        let chain = (0..80).fold(Scene::new(), |scene, j| scene.body(mass, at(j, 0.0).q, at(j, 0.0).v));
        chain.chain(law)
    };
    let miss = |last: &SceneState<1>| {
        let of = |j: i32| {
            (last.q[j as usize][0] - at(j, span).q[0]).abs().max((last.v[j as usize][0] - at(j, span).v[0]).abs())
        };
        (0..80).map(of).fold(0.0, f64::max)
    };
    let exact = miss(&end(scene(), Nystrom::order8(), span, 200));
    assert!(exact < 1e-10, "{exact:e}");
    // What an exact energy does not promise: the error is that of order two.
    let [coarse, fine] = [200, 400].map(|steps| miss(&end(scene(), DiscreteGradient, span, steps)));
    assert!(abs_diff_eq!((coarse / fine).log2(), 2.0, epsilon = 0.05), "{coarse:e} {fine:e}");
}

/// Two balls that meet head-on touch as long as they should and part with the speeds of an elastic impact.
#[test]
fn balls_part_after_an_elastic_impact() {
    let (law, small, large) = (HertzSpheres { modulus: 40.0 }, Sphere { radius: 0.7 }, Sphere { radius: 1.2 });
    let (masses, u) = ([0.5, 2.0], 1.3);
    let touching = law.on_a_line(small, large).contact_time(u, 0.4);
    // Along a slanted line, so that they just touch.
    let [cos, sin] = [0.6, 0.8];
    let balls = Scene::new().body_with(masses[0], [0.0, 0.0], [u * cos, u * sin], small).body_with(
        masses[1],
        [1.9 * cos, 1.9 * sin],
        [0.0, 0.0],
        large,
    );
    let last = end(balls.pairs(law), DiscreteGradient, touching, 10_000);
    let along = |x: [f64; 2]| x[0] * cos + x[1] * sin;
    let gap = along(last.q[1]) - along(last.q[0]) - 1.9;
    assert!(gap.abs() < 1e-6, "{gap:e}");
    let speeds = [(0.5 - 2.0) / 2.5 * u, 2.0 * 0.5 / 2.5 * u];
    for (v, speed) in last.v.iter().zip(speeds) {
        assert!((along(*v) - speed).abs() < 1e-6 && (v[0] * sin - v[1] * cos).abs() < 1e-12, "{v:?}");
    }
}
