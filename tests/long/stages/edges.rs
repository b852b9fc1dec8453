//! Where methods break: steps far too long, collisions, laws without a value, choices, rest, units.

use std::f64::consts::FRAC_PI_2;

use approx::assert_abs_diff_eq;
use dmech::extend::{AtStages, Fields, Rides};
use dmech::models::pairs::Gravity;
use dmech::models::{HenonHeiles, Kepler, Pendulum};
use dmech::prelude::*;

use crate::laws::*;

/// Evaluations of a step at most: of each half of a half the sweeps that a step may have, and as many from a guess.
const MOST: u64 = 8 * 120 * 511;

/// Either a run to its end or what it was until a step without a solution: with as many states as steps, finite, and never
/// more work than halving can make.
fn ends<const D: usize>(outcome: Result<Run<State<D>>, Interrupted<State<D>>>, steps: u64) -> (Run<State<D>>, bool) {
    let (run, failed) = match outcome {
        Ok(run) => (run, false),
        Err(interrupted) => {
            let next = interrupted.run().steps() + 1;
            let told = interrupted.cause();
            assert!(
                matches!(told, Error::NotConverged { step, .. } | Error::NotFinite { step, .. } | Error::LawInStep { step, .. } if step == next),
                "{told}"
            );
            (interrupted.into_run(), true)
        }
    };
    assert!(failed == (run.steps() < steps) && run.states().len() as u64 == run.steps() + 1);
    assert!(run.states().iter().all(|s| s.q.iter().chain(&s.v).all(|x| x.is_finite())));
    assert!(run.report().evaluations() <= MOST * steps && run.report().rough() <= run.steps());
    (run, failed)
}

/// From a pericentre, in steps of up to a period.
#[test]
fn steps_far_too_long_are_made_in_halves_or_refused() {
    let law = Kepler { gm: 1.3 };
    let (mut rough, mut in_halves, mut failed) = (0, 0, 0);
    macro_rules! one {
        ($scheme:expr, $e:ident, $n:ident) => {{
            let start = law.pericentre(0.9, $e);
            let run = Simulation::new(law, start).scheme($scheme).dt(law.period(0.9) / f64::from($n)).run(20);
            let (run, no_end) = ends(run, 20);
            rough += run.report().rough();
            in_halves += u32::from(run.report().rough() == 20);
            failed += u32::from(no_end);
            // What work does is known of halves as well.
            let work = run.drift(Invariant::WorkEnergy).unwrap();
            let largest = run.states().iter().map(|s| s.v[0] * s.v[0] + s.v[1] * s.v[1]).fold(0.0, f64::max);
            assert!(work.max_abs() < 1e-12 * largest, "{:e} of {largest:e}", work.max_abs());
        }};
    }
    for e in [0.0, 0.3, 0.9, 0.99] {
        for n in [1, 2, 3, 7] {
            for_each_order!(one! { e, n });
        }
    }
    println!("{rough} rough steps, {in_halves} runs of nothing else, {failed} failed");
    assert!(rough > 100 && in_halves > 3);
    // A circle in steps of a period: in halves that the force turns once round it is followed.
    let circle = Simulation::new(law, law.pericentre(0.9, 0.0)).scheme(Gauss::order16()).dt(law.period(0.9)).run(20);
    let run = circle.unwrap();
    assert!(run.report().rough() == 20 && (run.last().q[0] - 0.9).hypot(run.last().q[1]) < 1e-5);
    // A pendulum in steps of a hundred years ends, one way or the other.
    for dt in [10.0, 1e3, 1e6, 1e300] {
        let swung =
            Simulation::new(Pendulum { k: 1.3 }, State::new([1.0], [0.3])).scheme(Gauss::order16()).dt(dt).run(3);
        let (run, failed) = ends(swung, 3);
        assert!(failed || run.report().rough() == 3, "dt = {dt}");
    }
}

/// Of a step in halves the later ones begin later.
#[test]
fn halves_know_the_time() {
    let (law, start) = (Pushed { k: 0.02, push: 0.6, omega: 0.7, unit: 1.0 }, State::new([0.4], [0.3]));
    let end = |dt: f64, steps: u64| Simulation::new(law, start).scheme(Gauss::order16()).dt(dt).run(steps).unwrap();
    let (long, fine) = (end(12.0, 5), end(0.5, 120));
    let miss = (long.last().q[0] - fine.last().q[0]).abs();
    println!("in halves: {miss:e}");
    assert_eq!((long.report().rough(), fine.report().rough()), (5, 0));
    assert!(miss < 1e-2 && (fine.last().q[0] - start.q[0]).abs() > 0.1, "{miss:e}");
}

/// A fall into the centre, a law that ends, and equal places: told, and the stepper stays where it was.
#[test]
fn what_has_no_value_is_told() {
    /// A ball in a half-pipe of which the wall ends at 1.
    #[derive(Clone, Copy, Debug)]
    struct Pipe {
        g: f64,
    }
    #[dmech::law]
    impl Pipe {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            -self.g * (1.0 - q * q).sqrt()
        }
    }
    macro_rules! falls {
        ($scheme:expr, $_:tt) => {{
            let fall = Simulation::new(Kepler { gm: 1.3 }, State::new([1.0, 0.0], [0.0, 0.0])).scheme($scheme).dt(0.4);
            let (run, failed) = ends(fall.clone().run(1000), 1000);
            assert!(failed || run.report().rough() > 0, "through the centre, and nothing said");

            let simulation = Simulation::new(Pipe { g: 1.3 }, State::new([0.1], [1.9])).scheme($scheme).dt(0.1);
            let (run, failed) = ends(simulation.clone().run(1000), 1000);
            assert!(failed && run.steps() > 2 && run.last().q[0] < 1.0, "{}", run.steps());
            let mut stepper = simulation.stepper().unwrap();
            stepper.advance(run.steps()).unwrap();
            assert!(stepper.step().is_err() && stepper.advance(5).is_err());
            assert_eq!((stepper.state(), stepper.steps()), (*run.last(), run.steps()));
        }};
    }
    for_each_order!(falls! { 0 });
    for dt in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let refused = Simulation::new(Pipe { g: 1.3 }, State::new([0.1], [0.9])).scheme(Gauss::order16()).dt(dt).run(1);
        assert!(matches!(refused.unwrap_err().cause(), Error::TimeStep { .. }));
    }
    let pair = |b: [f64; 2], v: f64| {
        let scene = Scene::new().body(1.3, [0.3, 0.1], [v, 0.0]).body(0.7, b, [0.0; 2]).pairs(Gravity { g: 1.0 });
        Simulation::scene(scene).scheme(Gauss::order16()).dt(0.3).run(100)
    };
    let told = pair([0.3, 0.1], 0.0).unwrap_err();
    assert!(told.cause().to_string().contains("bodies 0 and 1") && told.run().steps() == 0, "{told}");
    // Head on, one into the other.
    match pair([1.3, 0.1], 0.5) {
        Ok(run) => assert!(run.report().rough() > 0),
        Err(told) => assert!(matches!(told.cause(), Error::NotConverged { .. } | Error::Link { .. }), "{told}"),
    }
}

/// Choices: rough steps are counted where a force bends or jumps, nowhere else, and each has an end.
#[test]
fn choices_are_counted() {
    #[derive(Clone, Copy, Debug)]
    struct Kinked {
        k: f64,
        at: f64,
    }
    #[dmech::law]
    impl Kinked {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            0.5 * q * q + self.k * (q - self.at).abs()
        }
    }
    #[derive(Clone, Copy, Debug)]
    struct Contact {
        k: f64,
        at: f64,
    }
    #[dmech::law]
    impl Contact {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let deep = (self.at - q[0]).max(0.0);
            let wall = if q[1] > self.at { 0.5 * (q[1] - self.at) * (q[1] - self.at) } else { 0.0 };
            0.5 * (q[0] * q[0] + 1.3 * q[1] * q[1]) + self.k * (deep * deep.sqrt() + wall)
        }
    }
    let mut counted = 0;
    macro_rules! bounded {
        ($scheme:expr, $law:expr, $start:expr, $dt:ident) => {{
            let run = Simulation::new($law, $start).scheme($scheme).dt($dt).run(200);
            let (run, failed) = ends(run, 200);
            assert!(!failed && run.report().evaluations() < 200 * 8 * 2000, "{}", run.report().evaluations());
            let work = run.drift(Invariant::WorkEnergy).unwrap().max_abs();
            let kinetic = run.states().iter().map(|s| s.v.iter().map(|v| v * v).sum()).fold(0.0, f64::max);
            assert!(work < 1e-12 * f64::max(kinetic, 10.0 * $dt * $dt), "{work:e} of {kinetic:e}");
            run
        }};
    }
    macro_rules! each {
        ($($run:tt)*) => { counted += bounded!($($run)*).report().rough() };
    }
    for dt in [0.05, 0.3, 4.0] {
        for k in [0.4, 7.0, 300.0] {
            for_each_order!(each! { Kinked { k, at: 0.2 }, State::new([0.7], [0.1]), dt });
            for_each_order!(each! { Contact { k, at: 0.2 }, State::new([0.7, 0.4], [0.1, -0.6]), dt });
        }
    }
    assert!(counted > 1000, "{counted}");
    // As often as it goes across.
    let dt = 0.05;
    let run = bounded!(Gauss::order16(), Kinked { k: 2.0, at: 0.2 }, State::new([0.7], [0.1]), dt);
    let across = run.states().windows(2).filter(|pair| (pair[0].q[0] > 0.2) != (pair[1].q[0] > 0.2)).count() as u64;
    assert!(across > 5 && run.report().rough().abs_diff(across) <= across / 4, "{} of {across}", run.report().rough());
    assert!(run.to_string().contains("rough steps"));
    // On one side it is smooth, and a law without choices always.
    let run = bounded!(Gauss::order16(), Kinked { k: 2.0, at: 50.0 }, State::new([3.7], [0.1]), dt);
    assert_eq!(run.report().rough(), 0);
    let run = bounded!(Gauss::order16(), Contact { k: 7.0, at: 0.2 }, State::new([0.9, -0.6], [0.1, 0.0]), dt);
    assert!(run.report().rough() > 0 && run.report().rough() < 60, "{}", run.report().rough());
}

/// Steps in which a force jumps are counted, and no others: in those a law with choices is as smooth as a polynomial, however
/// long they are.
#[test]
fn a_jump_is_seen_and_a_polynomial_is_none() {
    #[derive(Clone, Copy, Debug)]
    struct Jump {
        by: f64,
        at: f64,
    }
    #[dmech::law]
    impl Jump {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            0.5 * q * q + 0.1 * q.powi(4) + self.by * (q - self.at).max(0.0)
        }
    }
    #[derive(Clone, Copy, Debug)]
    struct Rod {
        by: f64,
        at: f64,
    }
    #[dmech::law]
    impl Rod {
        #[pair]
        fn energy(&self, r: f64) -> f64 {
            0.5 * (r - 1.0) * (r - 1.0) + self.by * (r - self.at).max(0.0)
        }
    }
    /// Of a step of several of these some is on the one side before it and on the other after.
    fn steps_across(at: f64, places: impl Iterator<Item = Vec<f64>>) -> u64 {
        let sides = places.map(|q| q.into_iter().map(|q| q > at).collect()).collect::<Vec<Vec<bool>>>();
        sides.windows(2).filter(|pair| pair[0] != pair[1]).count() as u64
    }
    macro_rules! counted {
        ($scheme:expr, $at:ident, $jumps:ident) => {{
            let (by, steps, dt) = (0.6, 90, 0.4);
            let alone = Simulation::new(Jump { by, at: $at }, State::new([0.7], [0.1])).scheme($scheme).dt(dt);
            let alone = alone.run(steps).unwrap();
            let bodies = || Scene::new().body(1.3, [0.9], [0.1]).body(0.8, [-0.6], [-0.2]);
            let placed = Simulation::scene(bodies().field(Jump { by, at: $at })).scheme($scheme).dt(dt);
            let placed = placed.run(steps).unwrap();
            let linked = Simulation::scene(bodies().pairs(Rod { by, at: $at + 1.0 })).scheme($scheme).dt(dt);
            let linked = linked.run(steps).unwrap();
            for (across, rough) in [
                (steps_across($at, alone.states().iter().map(|s| s.q.to_vec())), alone.report().rough()),
                (steps_across($at, placed.states().iter().map(|s| s.q.concat())), placed.report().rough()),
                (
                    steps_across($at + 1.0, linked.states().iter().map(|s| vec![s.q[0][0] - s.q[1][0]])),
                    linked.report().rough(),
                ),
            ] {
                println!("{rough} of {across}");
                assert!((across > 5) == $jumps && rough.abs_diff(across) <= across / 4, "{rough} of {across}");
            }
        }};
    }
    for (at, jumps) in [(0.2, true), (50.0, false)] {
        counted!(Gauss::order16(), at, jumps);
        counted!(LineIntegral::order6(), at, jumps);
    }
}

/// x y: at rest at (1, 0) nothing acts on x until y has moved, and on y until x has.
#[derive(Clone, Copy, Debug)]
struct Crossed {
    k: f64,
}

#[dmech::law]
impl Crossed {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        self.k * q[0] * q[1]
    }
}

/// Crossed fields: from rest a cycloid.
#[derive(Clone, Copy, Debug)]
struct Cycloid {
    e: f64,
    b: f64,
}

#[dmech::law]
impl Cycloid {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.e * q[1]
    }
    #[force]
    fn lorentz(&self, v: [f64; 2]) -> [f64; 2] {
        [self.b * v[1], -self.b * v[0]]
    }
}

/// Each coordinate pulls the next.
#[derive(Clone, Copy, Debug)]
struct Round {
    k: f64,
}

#[dmech::law]
impl Round {
    #[force]
    fn pull(&self, q: [f64; 3]) -> [f64; 3] {
        [self.k * q[2], self.k * q[0], self.k * q[1]]
    }
}

/// Coordinates on which nothing acts before another has moved change in one sweep, and the others in the next: alone, in a scene, and
/// beside members that all move.
#[test]
fn coordinates_that_wait_for_others() {
    fn check<L, const D: usize>(law: L, exact: impl Fn(f64) -> [f64; D])
    where
        L: Fields<D> + Law<D> + AtStages<D, f64> + Copy + std::fmt::Debug + Sync + 'static,
        Gauss: Rides<L, D>,
    {
        let start = State::new(exact(0.0), [0.0; D]);
        for h in [0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0] {
            let alone = |start| Simulation::new(law, start).scheme(Gauss::order16()).dt(h).run(3).unwrap();
            let scene = Simulation::scene(Scene::new().body(1.0, start.q, start.v).field(law));
            let scene = scene.scheme(Gauss::order16()).dt(h).run(3).unwrap();
            let run = alone(start);
            let (last, wanted) = (run.last().q, exact(3.0 * h));
            for i in 0..D {
                assert_abs_diff_eq!(last[i], wanted[i], epsilon = 1e-14 * wanted[i].abs().max(1.0));
                assert_abs_diff_eq!(last[i], scene.last().q[0][i], epsilon = 1e-14 * wanted[i].abs().max(1.0));
            }
            assert_eq!(run.report().rough(), 0, "{law:?}, h = {h}");
            let starts = |k: usize| {
                let mut start = start;
                start.v[0] += 0.3 * (k % 3) as f64;
                start
            };
            let members = Ensemble::of(21).law(|_| law).start(starts).scheme(Gauss::order16()).dt(h).run(3).unwrap();
            for k in 0..21 {
                let (member, alone) = (members.member(k).unwrap(), alone(starts(k)));
                assert_eq!(member.last(), alone.last(), "{law:?}, member {k}, h = {h}");
                assert_eq!(member.report().evaluations(), alone.report().evaluations(), "{law:?}, member {k}, h = {h}");
            }
        }
    }
    let k: f64 = 1.3;
    let phase = move |t: f64| k.sqrt() * t;
    check(Crossed { k }, move |t| [(phase(t).cosh() + phase(t).cos()) / 2.0, (phase(t).cos() - phase(t).cosh()) / 2.0]);
    let (e, b) = (0.7, 1.1);
    check(Cycloid { e, b }, move |t| [e * (t - (b * t).sin() / b) / b, e * (1.0 - (b * t).cos()) / (b * b)]);
    let series = |t: f64, from: i32| {
        let term = |n: i32| t.powi(n) / (1..=n).map(f64::from).product::<f64>();
        (0..5).rev().map(|k| term(6 * k + from)).sum::<f64>()
    };
    check(Round { k }, move |t| [0, 2, 4].map(|from| series(phase(t), from)));
    // The circle of a charge is the same circle in whatever direction it begins, and the way back is the way there.
    let magnet = |b| Cycloid { e: 0.0, b };
    for turn in [0.0, 1e-9, 0.1, 0.7, FRAC_PI_2] {
        for h in [0.4, 0.9, 1.6] {
            let run =
                |b, start| Simulation::new(magnet(b), start).scheme(LineIntegral::order4()).dt(h).run(10).unwrap();
            let there = run(b, State::new([0.0; 2], [turn.cos(), turn.sin()]));
            let back = run(-b, there.last().reversed());
            assert_eq!(there.report().rough(), 0, "{turn}, h = {h}");
            let home = back.last().q[0].abs().max(back.last().q[1].abs());
            assert!(home < 1e-12, "{turn}, h = {h}: {home:e}");
        }
    }
}

/// Where nothing moves nothing does, and what begins to move is followed in any unit of length.
#[test]
fn from_rest() {
    let start = State::new([0.0; 2], [0.0; 2]);
    let run = Simulation::new(HenonHeiles { lambda: 0.9 }, start).scheme(Gauss::order16()).dt(0.3).run(9).unwrap();
    assert_eq!((run.last().q, run.last().v, run.report().rough()), ([0.0; 2], [0.0; 2], 0));
    let two =
        Scene::new().body(1.3, [0.0; 2], [0.0; 2]).body(0.6, [0.0; 2], [0.0; 2]).field(HenonHeiles { lambda: 0.9 });
    let run = Simulation::scene(two).scheme(LineIntegral::order6()).dt(0.3).run(9).unwrap();
    assert_eq!((run.last().q.concat(), run.report().rough()), (vec![0.0; 4], 0));

    let pushed = |unit| Pushed { k: 0.9, push: 0.6, omega: 1.7, unit };
    let law = |unit| {
        let run =
            Simulation::new(pushed(unit), State::new([0.0], [0.0])).scheme(Gauss::order16()).dt(0.5).run(20).unwrap();
        assert_eq!(run.report().rough(), 0);
        [run.last().q[0] / unit, run.last().v[0] / unit]
    };
    let scene = |unit| {
        let bodies = Scene::new().body(1.0, [0.0], [0.0]).field(pushed(unit));
        let run = Simulation::scene(bodies).scheme(Gauss::order16()).dt(0.5).run(20).unwrap();
        assert_eq!(run.report().rough(), 0);
        [run.last().q[0][0] / unit, run.last().v[0][0] / unit]
    };
    let exact = law(1.0);
    assert!(exact[0].abs() > 0.05);
    for unit in [1e-60, 1e-30, 1e-10, 1.0, 1e11] {
        for found in [law(unit), scene(unit)] {
            let miss = (found[0] - exact[0]).abs().max((found[1] - exact[1]).abs());
            assert!(miss < 1e-14, "unit {unit:e}: {miss:e}");
        }
    }
    // None of many such starts is taken for a step too long.
    for i in 0..300 {
        let wave = |rate: f64| (rate * f64::from(i)).sin().abs();
        let law = Tugged { k: 0.1 + 3.0 * wave(0.37), push: 0.05 + 5.0 * wave(0.71), omega: 0.2 + 4.0 * wave(0.13) };
        let dt = 0.02 + 0.6 * wave(0.917);
        let step = Simulation::new(law, start).scheme(Gauss::order16()).dt(dt).run(1).unwrap();
        assert_eq!(step.report().rough(), 0, "{law:?}");
        let body = Scene::new().body(1.0, start.q, start.v).field(law);
        let step = Simulation::scene(body).scheme(Gauss::order16()).dt(dt).run(1).unwrap();
        assert_eq!(step.report().rough(), 0, "{law:?}, in a scene");
    }
}

/// Lengths, times and masses in units that are powers of two: the same motion to the bit, whatever it is measured in.
#[test]
fn units_do_not_matter() {
    let (e, steps) = (0.6, 500);
    let law = |length: f64, time: f64| Kepler { gm: 1.3 * length.powi(3) / time.powi(2) };
    let end = |length: f64, time: f64, mass: f64| {
        let State { q, v, .. } = Kepler { gm: 1.3 }.pericentre(0.9, e);
        let start = State::new(q.map(|q| q * length), v.map(|v| v * length / time));
        let simulation = Simulation::new(Kepler { gm: mass * law(length, time).gm }, start).mass(mass);
        let run = simulation.scheme(Gauss::order16()).dt(0.125 * time).run(steps).unwrap();
        let last = run.last();
        ([last.q.map(|q| q / length), last.v.map(|v| v * time / length)], run.report().evaluations())
    };
    let scene = |length: f64, time: f64, mass: f64| {
        let State { q, v, .. } = Kepler { gm: 1.3 }.pericentre(0.9, e);
        let [q, v] = [q.map(|q| q * length), v.map(|v| v * length / time)];
        let bodies = Scene::new().body(0.6 * mass, [0.0; 2], [0.0; 2]).body(0.4 * mass, q, v);
        let g = 1.3 * length.powi(3) / time.powi(2) / mass;
        let run =
            Simulation::scene(bodies.pairs(Gravity { g })).scheme(LineIntegral::order8()).dt(0.125 * time).run(steps);
        let run = run.unwrap();
        (run.last().q.concat().into_iter().map(|q| q / length).collect::<Vec<_>>(), run.report().evaluations())
    };
    let two = |n: i32| 2.0_f64.powi(n);
    let (here, there) = (end(1.0, 1.0, 1.0), scene(1.0, 1.0, 1.0));
    assert!(here.1 > 8 * steps && here.0[0] != [0.0; 2]);
    for (length, time, mass) in [(36, 24, 100), (-33, -40, -80), (36, 0, -90), (0, 0, 66), (-100, 3, 0)] {
        let (length, time, mass) = (two(length), two(time), two(mass));
        assert_eq!(end(length, time, mass), here, "{length:e} {time:e} {mass:e}");
        assert_eq!(scene(length, time, mass), there, "{length:e} {time:e} {mass:e}");
    }
}

/// A pair that turns quickly keeps its digits beside bodies that are far away, wherever these are.
#[test]
fn far_bodies_take_no_digits() {
    let law = Kepler { gm: 1.0 };
    let State { q: [q, _], v: [_, v], .. } = law.pericentre(1.0, 0.6);
    // What roundings make of one orbit is chance: the root of the mean square over eight orientations.
    let miss = |far: Option<f64>| {
        let square = |k: u32| {
            let (sin, cos) = (0.77 * f64::from(k)).sin_cos();
            let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
            let pair = |scene: Scene<2>, x: f64| {
                let [a, b] = [-0.4, 0.6].map(|share| (turned([share * q, 0.0]), turned([0.0, share * v])));
                scene.body(0.6, [x + a.0[0], a.0[1]], a.1).body(0.4, [x + b.0[0], b.0[1]], b.1)
            };
            let scene = far.into_iter().fold(pair(Scene::new(), 0.0), pair);
            let links = (0..scene.bodies()).step_by(2).map(|i| (i, i + 1)).collect::<Vec<_>>();
            let run = Simulation::scene(scene.bonds(Gravity { g: 1.0 }, links)).scheme(Gauss::order16());
            let run = run.dt(law.period(1.0) / 80.0).run(80 * 20).unwrap();
            let ([x, y], [to_x, to_y]) = (run.last().q[1], turned([0.6 * q, 0.0]));
            (x - to_x).powi(2) + (y - to_y).powi(2)
        };
        ((0..8).map(square).sum::<f64>() / 8.0).sqrt()
    };
    let alone = miss(None);
    println!("{alone:e}");
    assert!(alone < 4e-13, "{alone:e}");
    for far in [3.0, 1e3, 1e6, 1e9] {
        assert!(miss(Some(far)) < 2.0 * alone, "{far:e}: {:e}", miss(Some(far)));
    }
}

/// x″ = −x′ − x, which goes to rest.
#[derive(Clone, Copy)]
struct Damper;

#[dmech::law]
impl Damper {
    #[force]
    fn force(&self, q: [f64; 1], v: [f64; 1]) -> [f64; 1] {
        [-v[0] - q[0]]
    }
}

/// A motion dies away, and steps are as short as numbers can be: what a push changes by then has no reciprocal.
#[test]
fn nothing_is_too_small() {
    fn dies<S: Scheme<Particle<Damper, 1>>>(scheme: S) {
        let motion = Simulation::new(Damper, State::new([1.0], [1.0])).scheme(scheme);
        let run = motion.dt(0.1).record_every(1000).run(20_000).unwrap();
        let State { q: [q], v: [v], .. } = *run.last();
        assert!(q.abs() + v.abs() < 1e-307, "{}: {q:e}, {v:e}", S::NAME);
    }
    dies(Gauss::order16());
    dies(LineIntegral::order8());
    for h in [1e-280, 1e-288, 1e-289, 1e-290, 1e-300, 1e-307, 5e-324] {
        let swings = Simulation::new(HenonHeiles::default(), State::new([0.3, 0.1], [0.5, -0.2]));
        let run = swings.scheme(Gauss::order16()).dt(h).run(9).unwrap();
        assert_eq!((run.last().q, run.last().v), ([0.3, 0.1], [0.5, -0.2]), "{h:e}");
    }
    for h in [1e-20_f64, 1e-29, 1e-30, 1e-33, 1e-38] {
        let swings = Simulation::new(HenonHeiles::default(), State::<2, f32>::of([0.3, 0.1], [0.5, -0.2]));
        let run = swings.scheme(Gauss::order16()).dt(h).run(9).unwrap();
        assert_eq!((run.last().q, run.last().v), ([0.3, 0.1], [0.5, -0.2]), "{h:e}");
    }
}
