//! Steps that are put back onto the energy surface: the energy of the start to rounding, the order of the splitting.

use dmech::extend::{Method, System};
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};
use dmech::{Kept, Potential};

use dmech_tests::laws::*;
use dmech_tests::measured::*;
use dmech_tests::motion::*;

use super::bodies::{BOND, SPRING, line, stars};

/// Runs a macro for every set.
macro_rules! for_each_set {
    ($run:ident, $($rest:tt)*) => {
        $run! { Relaxed::order6(), Nystrom::order6(), $($rest)* }
        $run! { Relaxed::order8(), Nystrom::order8(), $($rest)* }
    };
}

/// At the pericentre of an orbit of eccentricity 0.3, and its period.
fn ellipse() -> (State<2>, f64) {
    let (gm, e): (f64, f64) = (Kepler::new().gm / MASS, 0.3);
    let speed = (gm * (1.0 + e) / (1.0 - e)).sqrt();
    (State::new([1.0 - e, 0.0], [0.0, speed]), core::f64::consts::TAU / gm.sqrt())
}

#[test]
fn orders_are_those_of_the_splitting() {
    macro_rules! one {
        ($scheme:expr, $plain:expr, $law:expr, $start:expr, $exact:expr) => {{
            let order = measured_order($law, $scheme, $start, &$exact);
            println!("{} on {}: {order:.3}", stringify!($scheme), stringify!($law));
            // The steps are not symmetric: the next power of the step comes after the first, not the one after it.
            let declared = f64::from($scheme.order());
            assert!((order - declared).abs() < 0.07 * declared, "{} on {}", stringify!($scheme), stringify!($law));
        }};
    }
    macro_rules! law {
        ($law:expr, $start:expr) => {{
            let exact = path($law, Composed::order8(DiscreteGradient), $start, 200).expect("small steps");
            for_each_set!(one, $law, $start, exact);
        }};
    }
    law!(HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]));
    law!(BOWL, State::new([1.1, 0.3], [-0.2, 0.5]));
    law!(SHAKEN, State::new([2.3], [1.3]));
}

trait Order {
    fn order(&self) -> u32;
}

impl<S: Method> Order for S {
    fn order(&self) -> u32 {
        S::ORDER
    }
}

/// The error at t = 2 over a ladder of steps: the slope between the first and the last that are clear of rounding.
fn order_of_scene<L, S, const D: usize>(scene: &Scene<D, (), L>, scheme: S, ladder: [u64; 2]) -> f64
where
    L: Term<D, ()> + Clone,
    S: Scheme<SceneSystem<D, L::Ready>>,
{
    let places = |run: Run<SceneState<D>>| run.last().q.concat();
    let motion = || Simulation::scene(scene.clone());
    let exact = places(motion().scheme(Composed::order8(DiscreteGradient)).dt(2.0 / 400.0).run(400).unwrap());
    let errors = ladder.map(|steps| {
        let end = places(motion().scheme(scheme).dt(2.0 / steps as f64).run(steps).unwrap());
        end.iter().zip(&exact).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    });
    println!("{} of {D}: {errors:?}", S::NAME);
    assert!(errors[1] > 1e-13, "{errors:?}: at the level of rounding there is no order to measure");
    (errors[0] / errors[1]).ln() / (ladder[1] as f64 / ladder[0] as f64).ln()
}

#[test]
fn orders_hold_for_scenes() {
    let (line, stars) = (line().chain(SPRING), stars().pairs(Spring { length: 0.0, ..BOND }).field(BOWL));
    for (order, declared) in [
        (order_of_scene(&line, Relaxed::order6(), [8, 16]), 6.0),
        (order_of_scene(&line, Relaxed::order8(), [6, 10]), 8.0),
        (order_of_scene(&stars, Relaxed::order6(), [16, 28]), 6.0),
        (order_of_scene(&stars, Relaxed::order8(), [16, 24]), 8.0),
    ] {
        println!("{order:.3}");
        assert!((order - declared).abs() < 0.5, "{order}, declared {declared}");
    }
}

/// Twenty thousand steps: to some ulp of the parts of the energy, and the last tenth as near as the first.
#[test]
fn the_energy_is_that_of_the_start() {
    const STEPS: u64 = 20_000;
    macro_rules! one {
        ($scheme:expr, $plain:expr, $law:expr, $start:expr, $h:expr) => {{
            let motion = || Simulation::new($law, $start).mass(MASS).dt($h).record_every(50);
            let run = motion().scheme($scheme).run(STEPS).expect("small steps");
            let energy = run.drift(Invariant::Energy).expect("a conservative law");
            let scale = energy_scale(&$law, run.states());
            let plain = motion().scheme($plain).run(STEPS).expect("small steps").drift(Invariant::Energy).unwrap();
            let worst = energy.max_abs() / scale;
            println!("{:<24} {worst:.1e}, plain {:.1e}", run.report().scheme(), plain.max_abs() / scale);
            assert!(worst < 2e-15, "{worst:e}");
            assert!(plain.max_abs() > 100.0 * energy.max_abs(), "there is nothing to correct");
            assert_eq!(run.kept(Invariant::Energy), Kept::Exact);
            does_not_drift(&run, Invariant::Energy, run.report().scheme());
            work_balances(&run, [MASS; _], stringify!($law));
        }};
    }
    let (start, period) = ellipse();
    for_each_set!(one, Kepler::new(), start, period / 24.0);
    for_each_set!(one, HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]), 0.5);
    for_each_set!(one, Chain::new(), State::new([0.3, -0.2, 0.5, 0.1, -0.4], [0.2, 0.0, -0.3, 0.1, 0.0]), 0.3);
}

#[test]
fn the_energy_of_a_scene_is_that_of_the_start() {
    fn check<L, S, const D: usize>(scene: Scene<D, (), L>, scheme: S, h: f64)
    where
        L: Term<D, ()> + Clone,
        S: Scheme<SceneSystem<D, L::Ready>>,
    {
        let run = Simulation::scene(scene).scheme(scheme).dt(h).record_every(50).run(20_000).unwrap();
        let drift = run.drift(Invariant::Energy).unwrap();
        let rise = drift.slope().abs() * run.last().t;
        println!("{}: {:.1e}, rises by {rise:.1e}", S::NAME, drift.max_abs());
        assert!(drift.max_abs() < 2e-14 && rise < 2e-15, "{}: {drift:?}", S::NAME);
        let work = run.drift(Invariant::WorkEnergy).unwrap();
        assert!(work.max_abs() < 1e-12 && work.max_abs() > 0.0, "{}: {work:?}", S::NAME);
        // Pinned bodies stay where they are, to the bit.
        assert_eq!(D == 1, run.last().q[0] == run.states()[0].q[0]);
    }
    check(line().chain(SPRING), Relaxed::order6(), 0.2);
    check(line().chain(SPRING), Relaxed::order8(), 0.2);
    check(stars().pairs(BOND).field(BOWL), Relaxed::order6(), 0.1);
    check(stars().pairs(BOND).field(BOWL), Relaxed::order8(), 0.1);
}

/// Each coordinate has its own mass: the way back is along M⁻¹∇Φ.
#[test]
fn masses_of_their_own() {
    let motion = |masses: [f64; 2]| {
        Simulation::new(BOWL, State::new([1.1, 0.3], [-0.2, 0.5])).masses(masses).scheme(Relaxed::order6()).dt(0.2)
    };
    let one_mass = Simulation::new(BOWL, State::new([1.1, 0.3], [-0.2, 0.5])).mass(MASS).scheme(Relaxed::order6());
    let one_mass = one_mass.dt(0.2).run(200).unwrap();
    assert!(distance(motion([MASS; 2]).run(200).unwrap().last().q, one_mass.last().q) < 1e-12);
    let run = motion([MASS, 0.7]).run(20_000).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 2e-15);
    assert!(distance(run.states()[200].q, one_mass.last().q) > 1e-2, "masses make no difference");
    work_balances(&run, [MASS, 0.7], "Bowl");
}

/// A correction multiplies velocities by one number: momenta that are not zero drift, and are said to.
#[test]
fn momenta_are_not_kept() {
    let (start, period) = ellipse();
    let motion = Simulation::new(Kepler::new(), start).mass(MASS).dt(period / 24.0);
    let run = motion.scheme(Relaxed::order6()).run(20_000).unwrap();
    let turning = run.drift(Invariant::AngularMomentum).unwrap();
    println!("angular momentum: {:.1e}", turning.max_relative());
    assert_eq!(run.kept(Invariant::AngularMomentum), Kept::No);
    assert!(turning.max_relative() > 1e-9, "{turning:?}");
    let run = Simulation::scene(stars().pairs(BOND)).scheme(Relaxed::order6()).dt(0.2).run(20_000).unwrap();
    let momentum = run.drift(Invariant::LinearMomentum).unwrap();
    println!("linear momentum: {:.1e}", momentum.max_abs());
    assert!(momentum.max_abs() > 1e-9, "{momentum:?}");
    // That of bodies whose centre rests stays nothing.
    let resting = Scene::<2>::new().body(1.3, [0.9, 0.1], [0.0, 0.7]).body(0.7, [-0.8, 0.3], [0.0, -1.3]);
    let run = Simulation::scene(resting.pairs(BOND)).scheme(Relaxed::order6()).dt(0.2).run(20_000).unwrap();
    let momentum = run.drift(Invariant::LinearMomentum).unwrap();
    assert!(momentum.max_abs() < 1e-12, "{momentum:?}");
}

/// A test body that nothing but a field acts on moves as by the splitting, to the bit; the energy is that of the others.
#[test]
fn test_bodies_are_left_alone() {
    let scene = || {
        let scene = Scene::<2>::new().body(1.3, [1.1, 0.3], [-0.2, 0.5]).test_body(1.0, [0.4, -0.6], [0.3, 0.2]);
        Simulation::scene(scene.field(BOWL)).dt(0.2)
    };
    let run = scene().scheme(Relaxed::order6()).run(500).unwrap();
    let plain = scene().scheme(Nystrom::order6()).run(500).unwrap();
    assert_eq!((run.last().q[1], run.last().v[1]), (plain.last().q[1], plain.last().v[1]));
    assert!(run.last().q[0] != plain.last().q[0]);
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 2e-15);
}

/// What a scheme says of a system, whether that has such an invariant or not.
fn says<Y: System, S: Scheme<Y>>(stepper: &Stepper<Y, S>, invariant: Invariant) -> Kept {
    S::kept(stepper.system(), invariant)
}

/// Where there is no energy to keep the steps are those of the splitting.
#[test]
fn a_law_that_names_the_time_is_not_corrected() {
    let motion = || Simulation::new(SHAKEN, State::new([2.3], [1.3])).mass(MASS).dt(0.1);
    macro_rules! one {
        ($scheme:expr, $plain:expr,) => {{
            let (run, plain) = (motion().scheme($scheme).run(500).unwrap(), motion().scheme($plain).run(500).unwrap());
            assert_eq!(run.states(), plain.states(), "{}", stringify!($scheme));
            assert_eq!(says(&motion().scheme($scheme).stepper().unwrap(), Invariant::AngularMomentum), Kept::Exact);
            assert_eq!(run.report().iterations(), 0);
            work_balances(&run, [MASS], "Shaken");
        }};
    }
    for_each_set!(one,);
    // As is a scene with a body that is driven.
    let scene = || Simulation::scene(line().drive(8, |t| ([0.1 * t.sin()], [0.1 * t.cos()])).chain(SPRING)).dt(0.1);
    let (run, plain) =
        (scene().scheme(Relaxed::order6()).run(200).unwrap(), scene().scheme(Nystrom::order6()).run(200).unwrap());
    assert_eq!(run.states(), plain.states());
    assert!(run.drift(Invariant::Energy).is_none());
}

/// The energy that is aimed at is saved: a stepper that would start elsewhere goes on to the bit.
#[test]
fn a_checkpoint_holds_the_energy() {
    let (start, period) = ellipse();
    let motion = |start| Simulation::new(Kepler::new(), start).mass(MASS).scheme(Relaxed::order6()).dt(period / 24.0);
    let mut whole = motion(start).stepper().unwrap();
    whole.advance(1000).unwrap();
    let text = serde_json::to_string(&whole.checkpoint()).unwrap();
    let mut second = motion(State::new([1.3, 0.2], [0.1, 0.7])).resume(&serde_json::from_str(&text).unwrap()).unwrap();
    for _ in 0..100 {
        whole.step().unwrap();
        second.step().unwrap();
        assert_eq!(whole.state(), second.state());
    }
}

/// Another state or another law has another energy.
#[test]
fn changes_begin_anew() {
    let (start, period) = ellipse();
    let motion = Simulation::new(Kepler::new(), start).mass(MASS).scheme(Relaxed::order6()).dt(period / 24.0);
    let mut stepper = motion.stepper().unwrap();
    let stays = |stepper: &mut dmech::Stepper<Particle<Kepler, 2>, _>| {
        let energy = stepper.energy().unwrap();
        stepper.advance(500).unwrap();
        assert!((stepper.energy().unwrap() - energy).abs() < 4e-15);
        energy
    };
    let first = stays(&mut stepper);
    let second = {
        stepper.set_state(State::new([0.9, 0.2], [-0.1, 1.1]).at_time(3.0)).unwrap();
        stays(&mut stepper)
    };
    stepper.law_mut().gm = 1.1;
    let third = stays(&mut stepper);
    assert!((first - second).abs() > 0.01 && (second - third).abs() > 0.01);
}

/// States between the steps have the energy too.
#[test]
fn recorded_states_have_the_energy() {
    let (start, period) = ellipse();
    let motion = Simulation::new(Kepler::new(), start).mass(MASS).scheme(Relaxed::order6()).dt(period / 24.0);
    let run = motion.record_at((0..400).map(|k| 0.37 * f64::from(k))).run_until(150.0).unwrap();
    assert_eq!(run.states().len(), 400);
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 4e-15);
}

/// Steps that are too long end in an error that says so, and what was computed is kept.
#[test]
fn too_long_a_step_is_refused() {
    let gm = Kepler::new().gm / MASS;
    let comet = State::new([1.9, 0.0], [0.0, (gm * 0.1 / 1.9).sqrt()]);
    macro_rules! one {
        ($scheme:expr, $plain:expr,) => {{
            let motion = Simulation::new(Kepler::new(), comet).mass(MASS).dt(0.9).scheme($scheme);
            let Err(interrupted) = motion.run(1000) else { panic!("{} took it", stringify!($scheme)) };
            println!("{interrupted}");
            let Error::NotConverged { step, iterations, residual, .. } = interrupted.cause() else {
                panic!("{interrupted}")
            };
            assert!(residual > 1.0 / 16.0 && iterations > 0, "{iterations}, {residual}");
            assert!(interrupted.to_string().contains("the last correction was"), "{interrupted}");
            assert_eq!(interrupted.run().states().len() as u64, step);
            assert!(step > 3);
        }};
    }
    for_each_set!(one,);
}

/// One or two corrections a step, none allocates, and forces are counted.
#[test]
fn corrections_are_few_and_counted() {
    let (start, period) = ellipse();
    for (parts, most) in [(24.0, 2.2), (100.0, 1.3)] {
        let motion = Simulation::new(Kepler::new(), start).mass(MASS).scheme(Relaxed::order6()).dt(period / parts);
        let mut stepper = motion.stepper().unwrap();
        stepper.advance(10_000).unwrap();
        let each = stepper.iterations() as f64 / 1e4;
        println!("{parts} steps a period: {each} corrections");
        assert!(each > 0.5 && each < most, "{each}");
        assert_eq!(stepper.evaluations(), 14 * 10_000 + stepper.iterations());
    }
}

/// Numbers of more digits, and of fewer.
#[test]
fn the_energy_is_exact_in_any_digits() {
    let start =
        State::<2, DoubleDouble>::of([0.2, -0.1].map(DoubleDouble::from_f64), [0.25, 0.3].map(DoubleDouble::from_f64));
    let motion = Simulation::new(HenonHeiles::new(), start).scheme(Relaxed::order6()).dt(0.3);
    let mut stepper = motion.stepper().unwrap();
    let energy = |stepper: &dmech::Stepper<Particle<HenonHeiles, 2, DoubleDouble>, _>| {
        let state = stepper.state();
        let [vx, vy] = state.v;
        DoubleDouble::from_f64(0.5) * (vx * vx + vy * vy)
            + HenonHeiles::new().field(DoubleDouble::ONE, DoubleDouble::ZERO).potential(state.q)
    };
    let first = energy(&stepper);
    stepper.advance(1000).unwrap();
    let off = (energy(&stepper) - first).to_f64().abs();
    assert!(off < 1e-29, "{off:e}");
    let start = State::<2, f32>::of([0.2, -0.1], [0.25, 0.3]);
    let run = Simulation::new(HenonHeiles::new(), start).scheme(Relaxed::order6()).dt(0.3).run(1000).unwrap();
    assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-6);
}
