//! Bodies that move along given paths.

use dmech::SceneError;
use dmech::models::pairs::Spring;
use dmech::prelude::*;
use dmech_tests::few::Damper;

const SPRING: Spring = Spring { k: 7.0, length: 0.8 };
const AMPLITUDE: [f64; 2] = [0.3, -0.2];
const RATES: [f64; 2] = [2.3, 3.1];

/// Where the hand is, and how fast it moves.
fn hand(t: f64) -> ([f64; 2], [f64; 2]) {
    let [x, y] = [0, 1].map(|k| RATES[k] * t);
    let ([a, b], [u, w]) = (AMPLITUDE, RATES);
    ([a * x.sin(), 1.0 + b * y.cos()], [a * u * x.cos(), -b * w * y.sin()])
}

/// The same spring, as a law of one body that names the time.
#[derive(Clone, Copy, Debug)]
struct Hung {
    k: f64,
    length: f64,
    a: [f64; 2],
    w: [f64; 2],
}

#[dmech::law]
impl Hung {
    #[potential]
    fn energy(&self, q: [f64; 2], t: f64) -> f64 {
        let x = q[0] - self.a[0] * (self.w[0] * t).sin();
        let y = q[1] - (1.0 + self.a[1] * (self.w[1] * t).cos());
        let stretch = (x * x + y * y).sqrt() - self.length;
        0.5 * self.k * stretch * stretch
    }
}

const HUNG: Hung = Hung { k: 7.0, length: 0.8, a: AMPLITUDE, w: RATES };
const MASS: f64 = 1.3;
const START: ([f64; 2], [f64; 2]) = ([0.4, -0.1], [-0.3, 0.2]);

/// Two bodies, of which the first is in no place of its own.
fn two() -> Scene<2> {
    Scene::new().body(5.0, [9.0, 9.0], [4.0, 4.0]).body(MASS, START.0, START.1)
}

/// A body that is linked to a driven one, which is given in a wrong place.
fn bodies() -> Scene<2> {
    two().drive(0, hand)
}

fn apart(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

macro_rules! hung {
    ($scheme:expr, $dt:expr) => {
        Simulation::new(HUNG, State::new(START.0, START.1)).mass(MASS).scheme($scheme).dt($dt)
    };
}

/// Under every scheme, by pairs, along a chain and on bonds: the motion under the law that names the time.
#[test]
fn a_driven_body_is_a_law_that_names_the_time() {
    let mut cells = 0;
    macro_rules! every {
        ($($scheme:expr),* $(,)?) => {$({
            let (name, dt, steps) = (stringify!($scheme), 0.02, 300);
            let alone = hung!($scheme, dt).run(steps).unwrap();
            let scenes = [
                Simulation::scene(bodies().pairs(SPRING)).scheme($scheme).dt(dt).run(steps).unwrap(),
                Simulation::scene(bodies().chain(SPRING)).scheme($scheme).dt(dt).run(steps).unwrap(),
                Simulation::scene(bodies().bonds(SPRING, [(0, 1)])).scheme($scheme).dt(dt).run(steps).unwrap(),
            ];
            for run in &scenes {
                let (there, here) = (run.last(), alone.last());
                let error = apart(&there.q[1], &here.q).max(apart(&there.v[1], &here.v));
                assert!(error < 2e-12, "{name}: {error:e}");
                let (q, v) = hand(there.t);
                assert_eq!((there.q[0], there.v[0]), (q, v), "{name}");
                assert!(run.drift(Invariant::Energy).is_none() && run.drift(Invariant::LinearMomentum).is_none());
                let work = run.drift(Invariant::WorkEnergy).unwrap().max_abs();
                let alone = alone.drift(Invariant::WorkEnergy).unwrap().max_abs();
                assert!((work - alone).abs() < 1e-12, "{name}: {work:e} {alone:e}");
                cells += 1;
            }
        })*};
    }
    every!(
        Explicit,
        Leapfrog,
        CompensatedLeapfrog,
        Boris,
        Kanatani,
        Implicit,
        DiscreteGradient,
        Nystrom::order6(),
        ForceGradient::order4(),
        Composed::order6(Leapfrog),
        Composed::order4(Implicit),
        Composed::order4(DiscreteGradient),
        LineIntegral::order4(),
        Gauss::order16(),
    );
    assert_eq!(cells, 42);
}

/// Steps that follow the motion need a longest, as under a law that names the time: no look tells what the hand will do.
#[test]
fn steps_that_follow_the_motion_need_a_longest() {
    // It rests until t = 3, and strikes within a tenth.
    let strike = |t: f64| {
        let s = ((t - 3.0) / 0.1).clamp(0.0, 1.0);
        let speed = if s == 0.0 || s == 1.0 { 0.0 } else { 0.5 * 30.0 * s * s * (1.0 - s) * (1.0 - s) / 0.1 };
        ([0.5 * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)], [speed])
    };
    let scene = || {
        let ends = Scene::new().body(1.0, [0.0], [0.0]).body(1.0, [-1.0], [0.01]).drive(0, strike);
        ends.chain(Spring { k: 4.0, length: 1.0 })
    };
    let exact = Simulation::scene(scene()).scheme(Nystrom::order6()).dt(1e-3).run_until(5.0).unwrap();
    macro_rules! each {
        ($($scheme:expr),* $(,)?) => {$({
            let follows = || Simulation::scene(scene()).scheme($scheme).adaptive(1e-9);
            let refused = follows().run_until(5.0).unwrap_err();
            assert_eq!(refused.cause(), Error::NoTimeScale { step: 1, time: 0.0 }, "{}", stringify!($scheme));
            let run = follows().dt(0.02).run_until(5.0).unwrap();
            let error = apart(&run.last().q[1], &exact.last().q[1]);
            assert!(error < 1e-3, "{}: {error:e}", stringify!($scheme));
        })*};
    }
    each!(Composed::order4(DiscreteGradient), Nystrom::order6(), RungeKuttaNystrom::order12(), Gauss::order16());
}

/// Steps that follow the motion see it come, outputs between steps have it where it is, and events are found.
#[test]
fn everything_that_runs_sees_it_where_it_is() {
    // A look at the time scale sees a law that names the time change, and a link of which one end moves: not the same number.
    let run = Simulation::scene(bodies().pairs(SPRING))
        .scheme(Nystrom::order6())
        .dt(0.5)
        .adaptive(1e-6)
        .run_until(6.0)
        .unwrap();
    let fine = hung!(Leapfrog, 1e-4).run(60_000).unwrap();
    let error = apart(&run.last().q[1], &fine.last().q);
    assert!(error < 1e-5 && run.steps() > 15, "{error:e} in {} steps", run.steps());

    let times = [0.005, 0.31, 0.777];
    let crossing = |state: &SceneState<2>| state.q[0][0] - 0.1;
    let run = Simulation::scene(bodies().chain(SPRING))
        .scheme(DiscreteGradient)
        .dt(0.02)
        .record_at(times)
        .event(crossing, Crossing::Rising)
        .run_until(6.0)
        .unwrap();
    for (state, t) in run.states().iter().zip(times) {
        assert_eq!((state.q[0], state.v[0]), hand(t));
    }
    assert_eq!(run.states().len(), 3);
    // 0.3 sin 2.3 t rises through 0.1 three times until 6.
    let rises: Vec<f64> =
        (0..3).map(|k| ((1.0_f64 / 3.0).asin() + f64::from(k) * core::f64::consts::TAU) / 2.3).collect();
    let found: Vec<f64> = run.events().iter().map(|event| event.state().t).collect();
    assert!(found.len() == 3 && apart(&found, &rises) < 1e-13, "{found:?} {rises:?}");
}

/// m dv/dt = −c (v − u(t)) with u = dp/dt, solved by hand: a damper feels how fast the hand moves.
#[test]
fn a_damper_feels_the_velocity() {
    let c = 0.9;
    let exact = |t: f64| {
        let rate = c / MASS;
        // The response to cos(w t − φ) is (rate / (rate² + w²)) (rate cos + w sin), and what dies out.
        let part = |w: f64, phase: f64, t: f64| {
            rate * (rate * (w * t - phase).cos() + w * (w * t - phase).sin()) / (rate * rate + w * w)
        };
        let along = |k: usize, amplitude: f64, phase: f64| {
            let forced = |t| amplitude * part(RATES[k], phase, t);
            forced(t) + (START.1[k] - forced(0.0)) * (-rate * t).exp()
        };
        let quarter = core::f64::consts::FRAC_PI_2;
        [along(0, AMPLITUDE[0] * RATES[0], 0.0), along(1, -AMPLITUDE[1] * RATES[1], quarter)]
    };
    macro_rules! order {
        ($($scheme:expr, $order:expr);*) => {$({
            let error = |steps: u64| {
                let scene = bodies().bonds(Damper { c }, [(0, 1)]);
                let run = Simulation::scene(scene).scheme($scheme).dt(3.0 / steps as f64).run(steps).unwrap();
                apart(&run.last().v[1], &exact(3.0))
            };
            let (coarse, fine) = (error(60), error(120));
            let order = (coarse / fine).log2();
            assert!((order - $order).abs() < 0.15 && fine > 1e-10, "{}: {order} {coarse:e}", stringify!($scheme));
        })*};
    }
    order!(Explicit, 1.0; Implicit, 2.0; DiscreteGradient, 2.0);
}

/// Saved and resumed, and changed between steps.
#[test]
fn it_is_carried_on() {
    let simulation = || Simulation::scene(bodies().chain(SPRING)).scheme(Leapfrog).dt(0.01);
    let (mut whole, mut first) = (simulation().stepper().unwrap(), simulation().stepper().unwrap());
    whole.advance(300).unwrap();
    first.advance(120).unwrap();
    let mut second = simulation().resume(&first.checkpoint()).unwrap();
    second.advance(180).unwrap();
    assert_eq!(whole.state(), second.state());
    assert_eq!(whole.q().get(0), hand(3.0).0);

    // A pin where it was driven is another scene.
    let pinned = Scene::new().body(5.0, [9.0, 9.0], [0.0; 2]).body(MASS, START.0, START.1).pin(0).chain(SPRING);
    assert!(Simulation::scene(pinned).scheme(Leapfrog).dt(0.01).resume(&first.checkpoint()).is_err());

    let error = second.set_body(0, [0.0; 2], [0.0; 2]).unwrap_err();
    assert_eq!(error.to_string(), "body 0 moves along a given path: it cannot be put elsewhere");
    let now = second.state();
    second.set_body(1, [0.5, 0.5], now.v[1]).unwrap();
    assert_eq!(second.state().q, [hand(3.0).0, [0.5, 0.5]]);
    second.set_state(now.clone()).unwrap();
    assert_eq!(second.state(), now);
    // At another time, and where it is said to be but is not: as a new simulation, and one that was saved.
    let elsewhere = SceneState { t: 1.7, q: vec![[5.0, 6.0], [0.4, 0.5]], v: vec![[7.0, 8.0], now.v[1]] };
    second.set_state(elsewhere.clone()).unwrap();
    let anew = simulation().starting_from(&elsewhere).stepper().unwrap();
    assert_eq!((second.state(), second.q().get(0)), (anew.state(), anew.q().get(0)));
    assert_eq!(second.state(), second.at(1.7).unwrap());
    assert_eq!((second.state().q[0], second.state().v[0]), hand(1.7));

    let error = Simulation::scene(bodies().drive(7, hand).chain(SPRING)).scheme(Leapfrog).dt(0.01).run(1).unwrap_err();
    assert_eq!(error.to_string(), "body 7 cannot be pinned or driven: the bodies are 0 to 1");
}

/// Of two paths of a body one would not be walked; other bodies have their own, and a pin beside a path says the same.
#[test]
fn a_body_has_one_path() {
    let still = |t: f64| ([0.0, t], [0.0, 1.0]);
    let set_up =
        |scene: Scene<2>| Simulation::scene(scene.pairs(SPRING)).scheme(Leapfrog).dt(0.01).stepper().map(|_| ());
    assert_eq!(set_up(bodies().drive(0, still)), Err(SceneError::DrivenTwice { body: 0 }.into()));
    assert_eq!(set_up(bodies().drive(1, hand).drive(0, hand)), Err(SceneError::DrivenTwice { body: 0 }.into()));
    assert_eq!(set_up(bodies().drive(7, hand).drive(7, still)), Err(SceneError::Pin { body: 7, bodies: 2 }.into()));
    assert_eq!(set_up(bodies().body(1.0, [2.0; 2], [0.0; 2]).drive(1, still).pin(0)), Ok(()));
}

/// A path that leads nowhere is named, when it is lost.
#[test]
fn a_path_that_is_lost_is_named() {
    macro_rules! lost {
        ($($scheme:expr),*) => {$({
            for from in [0.0, 0.25] {
                let path = move |t: f64| ([if t >= from { f64::NAN } else { 0.1 * t }, 0.0], [0.1, 0.0]);
                let scene = two().drive(0, path).chain(SPRING);
                let told = match Simulation::scene(scene).scheme($scheme).dt(0.1).run(100) {
                    Ok(_) => panic!("{} follows a path that is lost", stringify!($scheme)),
                    Err(interrupted) => interrupted.to_string(),
                };
                assert!(told.contains("the path that body 0 is driven along is not finite"), "{told}");
            }
        })*};
    }
    lost!(
        Leapfrog,
        Explicit,
        Implicit,
        DiscreteGradient,
        Nystrom::order6(),
        Gauss::order16(),
        Composed::order4(DiscreteGradient)
    );
}

/// A rope of which both ends are moved, as a chain, on bonds and, explicitly, in small steps: the same motion.
#[test]
fn a_rope_is_shaken() {
    let rope = || {
        let bead = |scene: Scene<2>, i: u32| scene.body(0.2 + 0.01 * f64::from(i), [0.3 * f64::from(i), 1.0], [0.0; 2]);
        let other = |t: f64| ([3.9, 1.0 + 0.1 * (1.9 * t).sin()], [0.0, 0.19 * (1.9 * t).cos()]);
        (0..14).fold(Scene::new(), bead).drive(0, hand).drive(13, other)
    };
    let bonds = || (0..13).map(|i| (i, i + 1));
    let spring = Spring { k: 40.0, length: 0.3 };
    let reference = Simulation::scene(rope().chain(spring)).scheme(Nystrom::order8()).dt(0.005).run(400).unwrap();
    macro_rules! shaken {
        ($($scheme:expr, $dt:expr, $error:expr);*) => {$({
            let steps = (2.0_f64 / $dt).round() as u64;
            let chain = Simulation::scene(rope().chain(spring)).scheme($scheme).dt($dt).run(steps).unwrap();
            let list = Simulation::scene(rope().bonds(spring, bonds())).scheme($scheme).dt($dt).run(steps).unwrap();
            let flat = |run: &Run<SceneState<2>>| run.last().q.iter().flatten().copied().collect::<Vec<_>>();
            let (same, error) = (apart(&flat(&chain), &flat(&list)), apart(&flat(&chain), &flat(&reference)));
            assert!(same < 1e-11 && error < $error, "{}: {same:e} {error:e}", stringify!($scheme));
            assert!(error > 1e-3 * $error, "{}: {error:e} of {:e}", stringify!($scheme), $error);
        })*};
    }
    shaken!(
        Leapfrog, 0.005, 1e-3;
        Implicit, 0.005, 1e-3;
        DiscreteGradient, 0.005, 1e-3;
        Kanatani, 0.005, 2e-3;
        Composed::order4(DiscreteGradient), 0.01, 1e-4;
        Nystrom::order4(), 0.01, 1e-5
    );
}

/// A ball on a path goes through a gas in a box, across its edges: lists of neighbours follow it, and it is felt as by all pairs.
#[test]
fn a_ball_goes_through_a_box() {
    // Soft, and smooth where it ends.
    let law = Spring { k: 5.0, length: 1.6 };
    let gas = || {
        let atom = |scene: Scene<2>, i: u32| {
            let place = [i % 5, i / 5].map(|x| 0.7 * f64::from(x) + 0.05 * f64::from(i * i % 7));
            scene.body(1.0, place, [0.1 * f64::from(i % 3) - 0.1, 0.05 * f64::from(i % 4)])
        };
        // Slowly at first, and then through the edge to the left and below.
        let path = |t: f64| ([1.7 - t * t, 1.6 - 0.8 * t], [-2.0 * t, -0.8]);
        (0..25).fold(Scene::new(), atom).drive(12, path)
    };
    let end = |steps: u64| {
        let run = Simulation::scene(gas().pairs(law).cutoff(1.6).periodic([3.5, 3.5]))
            .scheme(Leapfrog)
            .dt(3.0 / steps as f64)
            .run(steps)
            .unwrap();
        run.last().clone()
    };
    let (coarse, fine, finer) = (end(1500), end(3000), end(6000));
    let flat = |state: &SceneState<2>| state.q.iter().flatten().copied().collect::<Vec<_>>();
    let [first, second] = [(&coarse, &fine), (&fine, &finer)].map(|(a, b)| apart(&flat(a), &flat(b)));
    assert!(second < 0.5 * first && first < 0.05, "{first:e} {second:e}");
    assert_eq!(finer.q[12], [1.7 - 9.0, 1.6 - 0.8 * 3.0]);
    // A stepper whose lists are made anew at every step.
    let mut whole = Simulation::scene(gas().pairs(law).cutoff(1.6).periodic([3.5, 3.5]))
        .scheme(Leapfrog)
        .dt(0.002)
        .stepper()
        .unwrap();
    let mut other = whole.clone();
    whole.advance(1500).unwrap();
    for _ in 0..1500 {
        other = other.clone();
        other.advance(1).unwrap();
    }
    assert_eq!(whole.state(), other.state());
}

/// A path that has a gap ends the run before a state without a place is recorded, whether anything is linked to the body or not, and
/// whoever looks there: steps, output, events, a picture of a game.
#[test]
fn a_path_with_a_gap() {
    let gap = |from: f64, to: f64| {
        move |t: f64| {
            let (q, v) = hand(t);
            (if from < t && t < to { [f64::NAN; 2] } else { q }, v)
        }
    };
    let mut ended = 0;
    macro_rules! all {
        ($($scheme:expr),*) => {$(
            for linked in [false, true] {
                let motion = |from: f64, to: f64| {
                    let links = if linked { vec![(0, 1)] } else { Vec::new() };
                    let scene = two().drive(0, gap(from, to)).bonds(SPRING, links);
                    Simulation::scene(scene).scheme($scheme).dt(0.1)
                };
                // At the end of the fourth step.
                let error = motion(0.35, 0.45).run(9).unwrap_err();
                assert!(matches!(error.cause(), Error::Path { body: 0, step: 4, .. }), "{error}");
                assert_eq!(error.run().states().len(), 4);
                assert!(error.run().states().iter().chain([error.run().last()]).all(|state| state.q[0][0].is_finite()));
                let mut stepper = motion(0.35, 0.45).stepper().unwrap();
                assert!(matches!(stepper.advance(9), Err(Error::Path { step: 4, .. })));
                assert_eq!(stepper.steps(), 3);
                // Where output is asked for.
                let error = motion(0.33, 0.335).record_at([0.0, 0.333]).run(9).unwrap_err();
                assert!(matches!(error.cause(), Error::Path { body: 0, .. } | Error::NotFinite { .. }), "{error}");
                // At the start.
                let error = motion(-1.0, 0.05).run(9).unwrap_err();
                assert!(matches!(error.cause(), Error::Path { body: 0, step: 0, .. }), "{error}");
                ended += 4;
            }
        )*};
    }
    all!(
        Leapfrog,
        Nystrom::order6(),
        DiscreteGradient,
        Implicit,
        Kanatani,
        Gauss::order16(),
        Composed::order4(Leapfrog)
    );
    assert_eq!(ended, 56);
}
