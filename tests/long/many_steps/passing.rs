//! Adaptive steps where bodies pass each other fast.

use dmech::models::Kepler;
use dmech::models::pairs::Gravity;
use dmech::prelude::*;

/// Of the sun, in astronomical units and years.
const GM: f64 = 39.478_417_604_357_43;

type Bodies = [[[f64; 3]; 3]; 2];

/// A sun, a planet and a stone.
macro_rules! bodies {
    ($planet:expr, $at:expr) => {{
        let (masses, [q, v]): (_, Bodies) = ([1.0, $planet, 1e-15], $at);
        let bodies = (0..3).fold(Scene::new(), |scene, i| scene.body(masses[i], q[i], v[i]));
        bodies.pairs(Gravity { g: GM })
    }};
}

macro_rules! system {
    ($planet:expr, $at:expr) => {
        Simulation::scene(bodies!($planet, $at)).record_every(1_000_000)
    };
}

/// An equal step that is half as long as the way past.
fn short(b: f64, speed: f64) -> f64 {
    (0.5 * b / speed).min(1e-4)
}

/// A time before the stone is at the distance b from the planet, at a relative speed.
fn before(planet: f64, [b, speed, time]: [f64; 3]) -> Bodies {
    let around = GM.sqrt();
    let q = [[0.0; 3], [1.0, 0.0, 0.0], [1.0 + 0.6 * b, 0.8 * b, 0.0]];
    let v = [[0.0; 3], [0.0, -around, 0.0], [-0.8 * speed, 0.6 * speed - around, -0.3]];
    let back = system!(planet, [q, v]).scheme(Gauss::order16()).dt(short(b, speed)).run_until(time).unwrap();
    let there = back.last();
    [[0, 1, 2].map(|i| there.q[i]), [0, 1, 2].map(|i| there.v[i].map(|x| -x))]
}

/// A passage is met, wherever steps fall before it: errors are below five tolerances, where a step that goes past makes them 10⁻⁴
/// to 1.
#[test]
fn what_passes_is_not_stepped_over() {
    let (mut passages, mut sharp) = (0, 0);
    for (planet, b, speed) in [
        (1e-3, 0.01, 4.0),
        (1e-3, 0.1, 4.0),
        (3e-6, 0.01, 1.0),
        (3e-6, 0.01, 4.0),
        (1e-8, 1e-4, 4.0),
        (1e-8, 1e-4, 12.0),
    ] {
        for phase in 0..4_u32 {
            let time = 0.2 + 0.013 * f64::from(phase);
            let start = before(planet, [b, speed, time]);
            let exact =
                system!(planet, start).scheme(Gauss::order16()).dt(short(b, speed)).run_until(time + 0.1).unwrap();
            macro_rules! meets {
                ($($scheme:expr),*) => {$(
                    for tolerance in [1e-6, 1e-9] {
                        let run = system!(planet, start).scheme($scheme).adaptive(tolerance).run_until(time + 0.1).unwrap();
                        let law = bodies!(planet, start).as_law::<3, 9>();
                        let one = Simulation::new(law, law.start()).record_every(1_000_000);
                        let one = one.scheme($scheme).adaptive(tolerance).run_until(time + 0.1).unwrap();
                        for end in [run.last().q[2], one.last().bodies().q[2]] {
                            let exact = exact.last().q[2];
                            let error = (0..3).map(|k| (end[k] - exact[k]).powi(2)).sum::<f64>().sqrt();
                            assert!(
                                error < 5.0 * tolerance,
                                "{} at {tolerance:e}: {error:e} in {} and {} steps past {planet:e} at {b}, phase {phase}",
                                run.report().scheme(), run.steps(), one.steps(),
                            );
                            passages += 1;
                        }
                    }
                )*};
            }
            meets!(Nystrom::order8(), Gauss::order16(), Composed::order6(DiscreteGradient));
            // That it was worth seeing: without the planet the stone ends elsewhere.
            let free = system!(1e-30, start).scheme(Gauss::order16()).dt(1e-3).run_until(time + 0.1).unwrap();
            sharp += u32::from((free.last().q[2][0] - exact.last().q[2][0]).abs() > 1e-5);
        }
    }
    println!("{passages} passages, {sharp} of 24 ways bent by more than 1e-5");
    assert!(passages == 288 && sharp >= 20, "{passages}, {sharp}");
}

/// Two bodies that turn around each other do not pass: they take the steps of one body in the same field.
#[test]
fn bodies_that_turn_around_each_other_take_the_steps_of_one() {
    for e in [0.0_f64, 0.5, 0.9] {
        let (q, v) = (1.0 - e, ((1.0 + e) / (1.0 - e)).sqrt());
        let scene = Scene::new().body(1.0, [0.0; 2], [0.0; 2]).body(1e-9, [q, 0.0], [0.0, v]).pairs(Gravity { g: 1.0 });
        let law = Simulation::new(Kepler { gm: 1.0 }, State::new([q, 0.0], [0.0, v]));
        for tolerance in [1e-5, 1e-9] {
            let alone = law.clone().scheme(Nystrom::order8()).adaptive(tolerance).run_until(62.0).unwrap().steps();
            let pair = Simulation::scene(scene.clone()).scheme(Nystrom::order8()).adaptive(tolerance);
            let pair = pair.run_until(62.0).unwrap().steps();
            println!("e = {e}, {tolerance:e}: {alone} and {pair} steps");
            assert!(pair.abs_diff(alone) <= 2 + alone / 100, "{alone} and {pair} steps");
        }
    }
}

/// In a box it is the nearest image that passes.
#[test]
fn images_pass_as_bodies_do() {
    let pass = |shift: f64| {
        let scene = Scene::new().body(1.0, [0.0; 2], [0.0; 2]).body(1e-3, [shift - 1.0, 0.01], [4.0, 0.0]);
        let simulation =
            Simulation::scene(scene.pairs(Gravity { g: 1e-4 }).periodic([8.0; 2])).scheme(Nystrom::order8());
        simulation.adaptive(1e-9).run_until(0.5).unwrap()
    };
    let (here, there) = (pass(0.0), pass(8.0));
    println!("{} and {} steps", here.steps(), there.steps());
    assert!(here.steps() > 20 && here.steps().abs_diff(there.steps()) <= 1, "{} and {}", here.steps(), there.steps());
    let [a, b] = [here, there].map(|run| run.last().q[1]);
    assert!((a[0] + 8.0 - b[0]).abs() < 1e-10 && (a[1] - b[1]).abs() < 1e-10, "{a:?} and {b:?}");
}

/// Softened gravity.
#[derive(Clone, Copy, Debug)]
struct Soft {
    g: f64,
    eps: f64,
}

#[dmech::law]
impl Soft {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        -self.g * ma * mb / (r * r + self.eps * self.eps).sqrt()
    }
}

/// The same of a fixed body.
#[derive(Clone, Copy, Debug)]
struct Core {
    g: f64,
    eps: f64,
}

#[dmech::law]
impl Core {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        -self.g * m / (q[0] * q[0] + q[1] * q[1] + self.eps * self.eps).sqrt()
    }
}

/// A bond on a line, with an order of its ends: the one may be on either side of the other.
#[derive(Clone, Copy, Debug)]
struct Bond {
    k: f64,
}

#[dmech::law]
impl Bond {
    #[pair]
    fn energy(&self, d: [f64; 1]) -> f64 {
        let x = d[0] + 1.0;
        self.k * x * x * (0.5 + 0.25 * x * x)
    }
}

/// The same of one coordinate.
#[derive(Clone, Copy, Debug)]
struct Well {
    k: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let x = q + 1.0;
        self.k * x * x * (0.5 + 0.25 * x * x)
    }
}

/// Bodies may pass through each other where nothing is singular as they meet: no step waits for that, whether one falls on it or not.
#[test]
fn bodies_pass_through_each_other() {
    let mut fast = 0;
    for (eps, speed) in [(0.3, 0.0), (0.3, 3.0), (0.3, 30.0), (0.02, 1.0), (0.02, 100.0)] {
        for side in [0.0, 1e-9, 0.01] {
            let (q, v) = ([1.0, side], [-speed, 0.0]);
            let scene = Scene::new().body(1.0, [0.0; 2], [0.0; 2]).body(1e-9, q, v).pairs(Soft { g: 1.0, eps });
            let law = Simulation::new(Core { g: 1.0, eps }, State::new(q, v)).dt(0.1);
            for tolerance in [1e-5, 1e-9] {
                let end = if speed > 1.0 { 3.0 / speed } else { 10.0 };
                let alone = law.clone().scheme(Nystrom::order8()).adaptive(tolerance).run_until(end).unwrap().steps();
                let pair = Simulation::scene(scene.clone()).scheme(Nystrom::order8()).adaptive(tolerance).dt(0.1);
                let pair = pair.run_until(end).unwrap().steps();
                println!("{eps}, {speed}, {side}, {tolerance:e}: {alone} and {pair} steps");
                assert!(pair < 2 * alone + 300, "{eps}, {speed}, {side}, {tolerance:e}: {alone} and {pair} steps");
                fast += u32::from(pair > 2 * alone);
            }
        }
    }
    assert!(fast > 5, "{fast}");
    // Where they are in one place when a step begins, too.
    for at in [0.0, 1e-13, 1e-3, 2.0] {
        let scene = Scene::new().body(0.7, [0.0], [0.4]).body(1.3, [at], [-9.0]).chain(Bond { k: 5.0 });
        let run = Simulation::scene(scene).scheme(DiscreteGradient).adaptive(1e-3).run_until(3.0).unwrap();
        let alone = Simulation::new(Well { k: 5.0 }, State::new([-at], [9.4])).mass(0.7 * 1.3 / 2.0);
        let alone = alone.scheme(DiscreteGradient).adaptive(1e-3).run_until(3.0).unwrap().steps();
        println!("{at}: {alone} and {} steps", run.steps());
        assert!(run.steps() < 3 * alone, "{at}: {alone} and {} steps", run.steps());
        assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
    }
}
