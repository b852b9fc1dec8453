//! A periodic box, and pairs that are cut off at a distance.

use dmech::SceneError;
use dmech::models::pairs::{Gravity, LennardJones, Spring};
use dmech::prelude::*;
use dmech::scene::{Acts, SceneSystem, Term};
use dmech_tests::memory::bytes;

/// k ((r/a)² − 1)³ within a: the law, its force and the derivative of that vanish at a.
#[derive(Clone, Copy, Debug)]
struct Smooth {
    k: f64,
    a: f64,
}

#[dmech::law]
impl Smooth {
    #[pair]
    fn energy(&self, d: [f64; 2]) -> f64 {
        let [x, y] = d;
        let u = 1.0 - (x * x + y * y) / (self.a * self.a);
        self.k * u * u * u
    }
}

/// Depends on the direction.
#[derive(Clone, Copy, Debug)]
struct Oval;

#[dmech::law]
impl Oval {
    #[pair]
    fn energy(&self, d: [f64; 2]) -> f64 {
        let [x, y] = d;
        x * x + 2.0 * y * y
    }
}

const ATOMS: LennardJones = LennardJones { epsilon: 0.9, sigma: 1.1 };

/// Numbers between 0 and 1.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn vector<const D: usize>(&mut self, size: f64) -> [f64; D] {
        core::array::from_fn(|_| size * (2.0 * self.roll() - 1.0))
    }
}

fn image<const D: usize>(mut d: [f64; D], lengths: Option<[f64; D]>) -> [f64; D] {
    for (k, l) in lengths.into_iter().flatten().enumerate() {
        if d[k].abs() > 0.5 * l {
            d[k] -= l * (d[k] / l).round();
        }
    }
    d
}

/// Accelerations of bodies of mass 1 and the energy, by the definition.
fn by_hand<const D: usize>(
    q: &[[f64; D]],
    lengths: Option<[f64; D]>,
    cutoff: f64,
    energy: impl Fn(f64) -> f64,
    slope: impl Fn(f64) -> f64,
) -> (Vec<[f64; D]>, f64) {
    let (mut forces, mut sum) = (vec![[0.0; D]; q.len()], 0.0);
    for a in 0..q.len() {
        for b in a + 1..q.len() {
            let d = image(core::array::from_fn(|k| q[a][k] - q[b][k]), lengths);
            let r = d.iter().map(|x| x * x).sum::<f64>().sqrt();
            if r < cutoff {
                sum += energy(r) - energy(cutoff);
                for k in 0..D {
                    forces[a][k] -= slope(r) * d[k] / r;
                    forces[b][k] += slope(r) * d[k] / r;
                }
            }
        }
    }
    (forces, sum)
}

fn lennard_jones(r: f64) -> f64 {
    ATOMS.energy(r)
}

fn lennard_jones_slope(r: f64) -> f64 {
    let s6 = (ATOMS.sigma / r).powi(6);
    4.0 * ATOMS.epsilon * (6.0 * s6 - 12.0 * s6 * s6) / r
}

fn at_rest<const D: usize>(q: &[[f64; D]]) -> Scene<D> {
    q.iter().fold(Scene::new(), |scene, &q| scene.body(1.0, q, [0.0; D]))
}

/// Accelerations and energy of a scene at rest: a step of `Explicit` with h = 1 changes the velocities by them.
fn by_scene<const D: usize, A: Acts<D>, X>(simulation: Simulation<(), X>) -> (Vec<[f64; D]>, f64)
where
    X: dmech_core::Setup<(), System = SceneSystem<D, A>, State = SceneState<D>>,
{
    let mut stepper = simulation.scheme(Explicit).dt(1.0).stepper().unwrap();
    let energy = dmech_core::System::potential(stepper.system(), 0.0, &stepper.q());
    stepper.step().unwrap();
    (stepper.state().v, energy)
}

fn agree<const D: usize>(name: &str, found: &(Vec<[f64; D]>, f64), expected: &(Vec<[f64; D]>, f64)) {
    let all = found.0.iter().flatten().zip(expected.0.iter().flatten());
    let size = expected.0.iter().flatten().fold(1e-300, |size: f64, x| size.max(x.abs()));
    let worst = all.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / size;
    let energy = (found.1 - expected.1).abs() / expected.1.abs().max(1e-3);
    assert!(worst < 1e-13 && energy < 1e-12, "{name}: forces {worst:e}, energy {energy:e}");
}

/// Bodies at random, not too near to each other, some of them many boxes away.
fn scattered(n: usize, length: f64, away: f64, dice: &mut Dice) -> Vec<[f64; 3]> {
    let mut q: Vec<[f64; 3]> = Vec::new();
    while q.len() < n {
        let place = dice.vector::<3>(0.5 * length);
        let near = |other: &[f64; 3]| {
            let d = image(core::array::from_fn(|k| place[k] - other[k]), Some([length; 3]));
            d.iter().map(|x| x * x).sum::<f64>() < 0.6
        };
        if !q.iter().any(near) {
            q.push(place);
        }
    }
    for place in &mut q {
        for x in place {
            *x += away * length * (8.0 * dice.roll()).floor();
        }
    }
    q
}

/// In boxes of one, two and more cells a side, in open space, near the middle and many boxes away.
#[test]
fn lists_find_what_the_direct_sum_finds() {
    let mut dice = Dice(7);
    for (n, length, cutoff) in [(2, 5.1, 2.5), (20, 5.0, 2.5), (60, 7.0, 1.5), (90, 9.0, 2.9), (200, 16.0, 2.75)] {
        for away in [0.0, 1.0, -40.0] {
            let q = scattered(n, length, away, &mut dice);
            let name = format!("{n} bodies, box {length}, cut-off {cutoff}, away {away}");
            let law = |lengths| by_hand(&q, lengths, cutoff, lennard_jones, lennard_jones_slope);
            let closed = at_rest(&q).pairs(ATOMS).cutoff(cutoff).periodic([length; 3]);
            agree(&name, &by_scene(Simulation::scene(closed)), &law(Some([length; 3])));
            let open = at_rest(&q).pairs(ATOMS).cutoff(cutoff);
            agree(&format!("{name}, open"), &by_scene(Simulation::scene(open)), &law(None));
            // The order of the builder does not matter, and without a cut-off the nearest images act.
            let uncut = at_rest(&q).periodic([length; 3]).pairs(ATOMS);
            let sum = by_hand(&q, Some([length; 3]), 1e30, lennard_jones, lennard_jones_slope);
            agree(&format!("{name}, not cut"), &by_scene(Simulation::scene(uncut)), &sum);
        }
    }
}

/// On the edge of the box, at the cut-off, half a box apart, in one cell, alone.
#[test]
fn edges() {
    let check = |name: &str, q: &[[f64; 3]], length: f64, cutoff: f64| {
        let scene = at_rest(q).pairs(ATOMS).cutoff(cutoff).periodic([length; 3]);
        let expected = by_hand(q, Some([length; 3]), cutoff, lennard_jones, lennard_jones_slope);
        agree(name, &by_scene(Simulation::scene(scene)), &expected);
        expected.1
    };
    check("alone", &[[0.3, 0.0, 8.0]], 8.0, 2.0);
    check("on the edges", &[[0.0; 3], [0.0, 0.0, 8.0 - 1.2], [8.0 - 1.3, 8.0, 0.0], [0.0, -6.5, 16.0]], 8.0, 2.0);
    assert_eq!(check("at the cut-off", &[[0.0; 3], [2.0, 0.0, 0.0]], 8.0, 2.0), 0.0);
    assert!(check("just within", &[[0.0; 3], [2.0_f64.next_down(), 0.0, 0.0]], 8.0, 2.0) <= 0.0);
    assert_eq!(check("half a box apart", &[[0.0; 3], [4.0, 0.0, 0.0]], 8.0, 4.0), 0.0);
    assert!(check("half a box apart in one direction", &[[0.0; 3], [2.0, 1.5, 0.0]], 4.0, 2.0) == 0.0);
    check("in one cell", &[[0.1; 3], [1.1, 0.1, 0.1], [0.1, 1.2, 0.3], [-0.9, 0.2, 0.1]], 100.0, 2.0);
    check("far apart", &[[0.0; 3], [1e3, 0.0, 0.0], [1e3, 1.2, 0.0], [-1e6, 0.0, 0.0]], 1e9, 2.0);
}

fn refusal<const D: usize, P, L: Term<D, P, B>, B: dmech::scene::Space<D>>(scene: Scene<D, P, L, B>) -> Error {
    Simulation::scene(scene).scheme(Explicit).dt(0.1).stepper().err().expect("a refusal")
}

#[test]
fn what_fits_no_box_is_refused_in_numbers() {
    let two = || at_rest(&[[0.0; 2], [1.0, 0.5]]);
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        let error = refusal(two().pairs(ATOMS).periodic([3.0, length]));
        assert!(matches!(error, Error::Scene(SceneError::Length { component: 1, .. })), "{error}");
    }
    for cutoff in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-200] {
        let error = refusal(two().pairs(ATOMS).cutoff(cutoff));
        assert!(matches!(error, Error::Scene(SceneError::Cutoff { .. })), "{error}");
    }
    let error = refusal(two().pairs(ATOMS).cutoff(2.5).periodic([6.0, 4.9]));
    assert_eq!(error, SceneError::CutoffInBox { cutoff: 2.5, component: 1, length: 4.9 }.into());
    assert_eq!(
        error.to_string(),
        "the cut-off 2.5 is longer than half the box, whose length along coordinate 1 is 4.9: a body would be within reach of two images of another"
    );
    assert_eq!(refusal(two().pairs(Oval).cutoff(2.5)), SceneError::CutoffNotCentral.into());
    assert_eq!(refusal(Scene::<2>::new().pairs(ATOMS).cutoff(2.5)), SceneError::Empty.into());
}

/// A crystal of n³ atoms a little shaken, with momentum 0, in a box where they are as dense as a liquid.
fn crystal(n: u32, heat: f64, dice: &mut Dice) -> (Scene<3>, f64) {
    let spacing = 1.12;
    let mut v: Vec<[f64; 3]> = (0..n.pow(3)).map(|_| dice.vector(heat)).collect();
    for k in 0..3 {
        let mean = v.iter().map(|v| v[k]).sum::<f64>() / v.len() as f64;
        v.iter_mut().for_each(|v| v[k] -= mean);
    }
    let place = |i: u32| [i % n, i / n % n, i / n / n].map(|x| spacing * f64::from(x));
    let scene = (0..n.pow(3)).fold(Scene::new(), |scene, i| scene.body(1.0, place(i), v[i as usize]));
    (scene, spacing * f64::from(n))
}

const UNIT: LennardJones = LennardJones { epsilon: 1.0, sigma: 1.0 };

#[test]
fn leapfrog_bounds_the_energy_and_keeps_the_momentum() {
    let (scene, length) = crystal(6, 1.5, &mut Dice(3));
    let scene = scene.pairs(UNIT).cutoff(2.5).periodic([length; 3]);
    let run = Simulation::scene(scene).scheme(Leapfrog).dt(0.002).record_every(50).run(4000).unwrap();
    let energy = run.drift(Invariant::Energy).unwrap();
    println!("energy {:e}", energy.max_relative());
    assert!(energy.max_relative() < 2e-3);
    assert!(run.drift(Invariant::LinearMomentum).unwrap().max_abs() < 1e-12);
    assert!(run.drift(Invariant::AngularMomentum).is_none());
    // Positions go on: some atom has left the box.
    assert!(run.last().q.iter().flatten().any(|&x| x < 0.0 || x > length));
}

/// Turned round, the motion comes back.
#[test]
fn leapfrog_goes_back() {
    let (scene, length) = crystal(5, 1.5, &mut Dice(4));
    let scene = scene.pairs(UNIT).cutoff(2.4).periodic([length; 3]);
    let there = |scene| Simulation::scene(scene).scheme(Leapfrog).dt(0.002).record_every(300).run(300).unwrap();
    let out = there(scene.clone());
    let back = there(scene.clone().starting_from(&out.last().clone().reversed()));
    let start = Simulation::scene(scene).start();
    let error = back.last().q.iter().flatten().zip(start.q.iter().flatten()).map(|(x, y)| (x - y).abs());
    let error = error.fold(0.0, f64::max);
    assert!(error < 1e-9, "{error:e}");
}

/// The lists change how long a step takes and nothing else: a run in two parts is the same to the bit.
#[test]
fn nothing_depends_on_when_lists_were_made() {
    let (scene, length) = crystal(6, 2.0, &mut Dice(5));
    let scene = scene.pairs(UNIT).cutoff(2.5).periodic([length; 3]);
    let mut whole = Simulation::scene(scene).scheme(Nystrom::order4()).dt(0.004).stepper().unwrap();
    whole.advance(37).unwrap();
    // A clone has no lists.
    let mut other = whole.clone();
    whole.advance(40).unwrap();
    for _ in 0..40 {
        other = other.clone();
        other.advance(1).unwrap();
    }
    assert_eq!(whole.q().flat(), other.q().flat());
}

/// Bodies pass the cut-off and the edges of the box all the time; the law and its force vanish at the cut-off.
/// Saved and read back, by explicit and implicit steps and by steps that follow the motion; another box, another cut-off or none
/// is another scene.
#[test]
fn a_box_is_saved_and_resumed() {
    let (scene, length) = crystal(5, 2.0, &mut Dice(6));
    let boxed = |cutoff: f64, lengths: [f64; 3]| scene.clone().pairs(UNIT).cutoff(cutoff).periodic(lengths);
    macro_rules! resumed {
        ($($simulation:expr),*) => {$({
            let simulation = $simulation;
            let mut whole = simulation(boxed(2.5, [length; 3])).stepper().unwrap();
            whole.advance(13).unwrap();
            let saved = serde_json::to_string(&whole.checkpoint()).unwrap();
            let saved: dmech::Checkpoint = serde_json::from_str(&saved).unwrap();
            let mut other = simulation(boxed(2.5, [length; 3])).resume(&saved).unwrap();
            assert_eq!(whole.state(), other.state());
            whole.advance(20).unwrap();
            other.advance(20).unwrap();
            assert_eq!(whole.state(), other.state());
            for (cutoff, lengths) in [(2.4, [length; 3]), (2.5, [length, length, 1.01 * length])] {
                let error = simulation(boxed(cutoff, lengths)).resume(&saved).unwrap_err();
                assert!(matches!(error, Error::Checkpoint(_)), "{error}");
            }
        })*};
    }
    resumed!(
        |scene| Simulation::scene(scene).scheme(Leapfrog).dt(0.004),
        |scene| Simulation::scene(scene).scheme(DiscreteGradient).dt(0.01),
        |scene| Simulation::scene(scene).scheme(Nystrom::order4()).dt(0.01).adaptive(1e-3)
    );
    let mut stepper = Simulation::scene(boxed(2.5, [length; 3])).scheme(Leapfrog).dt(0.004).stepper().unwrap();
    stepper.advance(3).unwrap();
    let open = scene.clone().pairs(UNIT).cutoff(2.5);
    let error = Simulation::scene(open).scheme(Leapfrog).dt(0.004).resume(&stepper.checkpoint()).unwrap_err();
    assert!(matches!(error, Error::Checkpoint(_)), "{error}");
}

#[test]
fn order_two_where_the_law_ends_smoothly() {
    let mut dice = Dice(11);
    let scene = (0..30).fold(Scene::<2>::new(), |scene, i| {
        scene.body(1.0 + 0.1 * f64::from(i % 3), dice.vector(2.0), dice.vector(1.0))
    });
    let scene = scene.pairs(Smooth { k: 0.8, a: 1.3 }).cutoff(1.3).periodic([4.0, 4.5]);
    fn errors<
        S: Scheme<SceneSystem<2, A>> + Copy,
        A: Acts<2>,
        L: Term<2, (), dmech::scene::Periodic<2>, Ready = A> + Clone,
    >(
        scene: &Scene<2, (), L, dmech::scene::Periodic<2>>,
        scheme: S,
    ) -> [f64; 2] {
        let end = |steps: u64| {
            let simulation = Simulation::scene(scene.clone()).scheme(scheme).dt(1.0 / steps as f64);
            let mut stepper = simulation.stepper().unwrap();
            stepper.advance(2 * steps).unwrap();
            stepper.q().to_list()
        };
        let exact = end(12_800);
        [100, 200].map(|steps| {
            let apart = end(steps).into_iter().flatten().zip(exact.iter().flatten()).map(|(x, y)| (x - y).abs());
            apart.fold(0.0, f64::max)
        })
    }
    for errors in [errors(&scene, Leapfrog), errors(&scene, DiscreteGradient)] {
        let order = (errors[0] / errors[1]).log2();
        assert!((order - 2.0).abs() < 0.15, "{order} of {errors:?}");
    }
}

/// Across the cut-off and the edges the secant is exact, in large steps too.
#[test]
fn discrete_gradient_keeps_the_energy() {
    for (heat, dt) in [(1.5, 0.004), (3.0, 0.01)] {
        let (scene, length) = crystal(5, heat, &mut Dice(9));
        let scene = scene.pairs(UNIT).cutoff(2.0).periodic([length; 3]);
        let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(dt).record_every(10).run(200).unwrap();
        let energy = run.drift(Invariant::Energy).unwrap().max_relative();
        println!("energy {energy:e} {run}");
        assert!(energy < 1e-12, "{energy:e}");
        assert!(run.drift(Invariant::LinearMomentum).unwrap().max_abs() < 1e-11);
    }
}

/// Not cut off, the force jumps where another image becomes the nearest; springs between all, longer than half the box.
#[test]
fn discrete_gradient_keeps_the_energy_where_images_change() {
    let mut dice = Dice(21);
    let scene = (0..12).fold(Scene::<2>::new(), |scene, _| scene.body(1.3, dice.vector(2.0), dice.vector(1.0)));
    let scene = scene.pairs(Spring { k: 0.3, length: 0.7 }).periodic([4.0, 3.0]);
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.02).run(300).unwrap();
    let energy = run.drift(Invariant::Energy).unwrap().max_relative();
    assert!(energy < 1e-12, "{energy:e}");
    let momentum = run.drift(Invariant::LinearMomentum).unwrap().max_abs();
    assert!(momentum < 1e-12, "{momentum:e}");
}

/// Bodies that go several cut-offs far in a step, through half the box and more, and meet others at both ends.
#[test]
fn discrete_gradient_keeps_the_energy_in_giant_steps() {
    for speed in [5.0, 15.0, 60.0] {
        let mut dice = Dice(61);
        let scene = (0..120).fold(Scene::<2>::new(), |scene, _| scene.body(1.0, dice.vector(3.0), dice.vector(speed)));
        let scene = scene.pairs(Smooth { k: 3.0, a: 1.1 }).cutoff(0.8).periodic([6.0; 2]);
        let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.1).run(40).unwrap();
        let energy = run.drift(Invariant::Energy).unwrap().max_relative();
        assert!(energy < 1e-12, "speed {speed}: {energy:e}");
    }
}

/// Without a box the secant across the cut-off is along a + b: angular momentum too.
#[test]
fn a_cut_off_keeps_the_angular_momentum() {
    let mut dice = Dice(31);
    let scene = (0..25).fold(Scene::<3>::new(), |scene, _| scene.body(0.7, dice.vector(2.0), dice.vector(0.5)));
    let scene = scene.pairs(Spring { k: 0.3, length: 0.7 }).cutoff(1.5);
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.02).run(300).unwrap();
    for invariant in [Invariant::Energy, Invariant::LinearMomentum, Invariant::AngularMomentum] {
        let drift = run.drift(invariant).unwrap();
        assert!(
            drift.max_abs() < 1e-12 * run.drift(Invariant::Energy).unwrap().start().abs().max(1.0),
            "{invariant:?} {drift:?}"
        );
    }
}

/// What is cut off takes part in every kind of step.
#[test]
fn every_scheme_takes_it() {
    let (scene, length) = crystal(4, 1.0, &mut Dice(13));
    let scene = scene.pairs(UNIT).cutoff(2.2).periodic([length; 3]);
    let exact = Simulation::scene(scene.clone()).scheme(Leapfrog).dt(1e-5).run(5000).unwrap();
    let close = |name: &str, state: &SceneState<3>, limit: f64| {
        let apart = state.q.iter().flatten().zip(exact.last().q.iter().flatten()).map(|(x, y)| (x - y).abs());
        let apart = apart.fold(0.0, f64::max);
        assert!(apart < limit, "{name}: {apart:e}");
    };
    macro_rules! every {
        ($($scheme:expr),*) => {$({
            let run = Simulation::scene(scene.clone()).scheme($scheme).dt(0.001).run(50).unwrap();
            close(stringify!($scheme), run.last(), 3e-5);
        })*};
    }
    every!(Leapfrog, CompensatedLeapfrog, Nystrom::order4(), ForceGradient::order4(), Composed::order4(Leapfrog));
    every!(Implicit, DiscreteGradient, Kanatani, Composed::order4(DiscreteGradient));
    let adaptive = Simulation::scene(scene.clone()).scheme(Nystrom::order6()).adaptive(1e-4).run_until(0.05).unwrap();
    close("adaptive", adaptive.last(), 3e-5);
}

/// A step that throws a body out of all numbers ends in an error, as without a box.
#[test]
fn what_is_not_finite_is_told() {
    let scene = at_rest(&[[0.0; 3], [1e-30, 0.0, 0.0]]).pairs(UNIT).cutoff(2.0).periodic([9.0; 3]);
    let error = Simulation::scene(scene).scheme(Leapfrog).dt(0.1).run(10).expect_err("too near").cause().to_string();
    assert!(error.contains("bodies 0 and 1"), "{error}");
    let scene = Scene::<3>::new().body(1.0, [0.0; 3], [1e308; 3]).body(1.0, [1.0, 0.0, 0.0], [-1e308; 3]);
    let scene = scene.pairs(UNIT).cutoff(2.0).periodic([9.0; 3]);
    assert!(Simulation::scene(scene).scheme(Leapfrog).dt(10.0).run(10).is_err());
}

/// Chains and bonds are wrapped too: a ring around the box is as long as the box.
#[test]
fn chains_and_bonds_go_around_the_box() {
    let ring =
        (0..8).fold(Scene::<2>::new(), |scene, i| scene.body(1.0, [f64::from(i), 0.0], [0.0, 0.1 * f64::from(i % 3)]));
    let spring = Spring { k: 2.0, length: 1.0 };
    let ring = ring.chain(spring).bonds(spring, [(7, 0)]).periodic([8.0, 5.0]);
    for energies in [
        Simulation::scene(ring.clone())
            .scheme(DiscreteGradient)
            .dt(0.05)
            .run(100)
            .unwrap()
            .drift(Invariant::Energy)
            .unwrap(),
        Simulation::scene(ring)
            .scheme(Composed::order8(Leapfrog))
            .dt(0.01)
            .run(500)
            .unwrap()
            .drift(Invariant::Energy)
            .unwrap(),
    ] {
        assert!(energies.max_relative() < 1e-12, "{energies:?}");
    }
}

/// A mass that is read of the bodies is found for those in the lists too.
#[test]
fn laws_that_read_the_bodies() {
    let mut dice = Dice(41);
    let (mut scene, mut q, mut m) = (Scene::<3>::new(), Vec::new(), Vec::new());
    for i in 0..40 {
        q.push(dice.vector::<3>(2.0));
        m.push(1.0 + 0.1 * f64::from(i));
        scene = scene.body(m[i as usize], q[i as usize], [0.0; 3]);
    }
    let (found, _) = by_scene(Simulation::scene(scene.pairs(Gravity { g: 0.5 }).cutoff(1.9).periodic([4.0; 3])));
    for a in 0..40 {
        let mut fall = [0.0; 3];
        for b in (0..40).filter(|&b| b != a) {
            let d = image(core::array::from_fn(|k| q[a][k] - q[b][k]), Some([4.0; 3]));
            let r = d.iter().map(|x| x * x).sum::<f64>().sqrt();
            for k in 0..3 {
                fall[k] -= if r < 1.9 { 0.5 * m[b] * d[k] / r.powi(3) } else { 0.0 };
            }
        }
        let error = (0..3).map(|k| (fall[k] - found[a][k]).abs()).fold(0.0, f64::max);
        assert!(error < 1e-11, "{error:e}");
    }
}

/// O(N), and steps take no memory once the lists are made, or hardly any as they grow.
#[test]
fn a_cut_off_takes_memory_in_proportion_to_the_bodies() {
    let taken = |n: u32| {
        let (scene, length) = crystal(n, 1.5, &mut Dice(17));
        let before = bytes();
        let simulation =
            Simulation::scene(scene.pairs(UNIT).cutoff(2.5).periodic([length; 3])).scheme(Leapfrog).dt(0.002);
        let mut stepper = simulation.stepper().unwrap();
        stepper.advance(20).unwrap();
        let first = bytes() - before;
        stepper.advance(200).unwrap();
        (first, bytes() - before)
    };
    let [(small, _), (large, later)] = [taken(10), taken(20)];
    println!("{small} and {large} bytes, {later} later");
    assert!(large < 10 * small && large < 2000 * 8000 && later < large + large / 8);
}

/// On one thread and on several the same bits.
#[test]
fn any_number_of_threads() {
    let end = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let (scene, length) = crystal(22, 1.5, &mut Dice(19));
            let scene = scene.pairs(UNIT).cutoff(1.8).periodic([length; 3]);
            let mut stepper = Simulation::scene(scene).scheme(Leapfrog).dt(0.004).stepper().unwrap();
            stepper.advance(12).unwrap();
            stepper.q().flat().to_vec()
        })
    };
    assert_eq!(end(1), end(3));
}
