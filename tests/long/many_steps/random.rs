//! Newton on random scenes: what stops it is rounding, or there is no root; it never gives up at corrections that are rounding.

use approx::abs_diff_eq;
use dmech::Error;
use dmech::models::pairs::{Gravity, LennardJones, Spring};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};
use dmech_tests::few::Damper;

/// A slope and a bowl.
#[derive(Clone, Copy, Debug)]
struct Field {
    pull: f64,
    k: f64,
}

#[dmech::law]
impl Field {
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64) -> f64 {
        m * self.pull * q[1] + 0.5 * self.k * (q[0] * q[0] + q[1] * q[1])
    }
}

/// Numbers in [0, 1), the same on every run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        // Marsaglia's xorshift.
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Evenly in the logarithm.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

/// What came of the runs.
#[derive(Debug, Default)]
struct Outcome {
    runs: usize,
    ended: usize,
    steps: u64,
    iterations: u64,
    /// Failures whose last correction is less than ten thousand units in the last place of the positions.
    rounding: Vec<String>,
}

impl Outcome {
    fn run<L: Term<2, ()>, S: Scheme<SceneSystem<2, L::Ready>>>(
        &mut self,
        scene: Scene<2, (), L>,
        scheme: S,
        h: f64,
        extent: f64,
        what: &str,
    ) {
        self.runs += 1;
        let run = Simulation::scene(scene).scheme(scheme).dt(h).record_every(1000).run(200);
        let run = match run {
            Ok(run) => run,
            Err(interrupted) => {
                self.ended += 1;
                let least = 1e4 * f64::EPSILON * extent;
                if matches!(interrupted.cause(), Error::NotConverged { residual, .. } if residual < least) {
                    self.rounding.push(format!("{what}, {}, h = {h}: {interrupted}", S::NAME));
                }
                interrupted.into_run()
            }
        };
        self.steps += run.steps();
        self.iterations += run.report().iterations();
    }

    fn each<L>(&mut self, scene: &Scene<2, (), L>, h: f64, extent: f64, what: &str)
    where
        L: Term<2, ()> + Clone,
        Implicit: Scheme<SceneSystem<2, L::Ready>>,
        DiscreteGradient: Scheme<SceneSystem<2, L::Ready>>,
    {
        self.run(scene.clone(), Implicit, h, extent, what);
        self.run(scene.clone(), DiscreteGradient, h, extent, what);
        self.run(scene.clone(), Composed::order4(DiscreteGradient), h, extent, what);
        self.run(scene.clone(), Implicit.with(Newton::from_previous()), h, extent, what);
    }
}

#[test]
fn newton_gives_up_at_no_correction_that_is_rounding() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut outcome = Outcome::default();
    for _ in 0..if cfg!(debug_assertions) { 40 } else { 400 } {
        let bodies = 2 + random.below(5);
        // Near the origin and far from it, spread out and close, in motion and at rest.
        let (away, spread) = (if random.unit() < 0.5 { 0.0 } else { random.size(1.0, 1e4) }, random.size(0.5, 4.0));
        let speed = if random.unit() < 0.25 { 0.0 } else { random.size(1e-3, 2.0) };
        let masses = random.size(1.0, 1e3);
        let scene = (0..bodies).fold(Scene::<2>::new(), |scene, i| {
            let mass = random.size(1.0, masses);
            // On a grid, so that no two bodies begin at one place.
            let (x, y) = (1.2 * (i % 3) as f64, 1.2 * (i / 3) as f64);
            let q = [x, y].map(|x| away + spread * (x + random.between(-0.3, 0.3)));
            scene.body(mass, q, [0.0; 2].map(|_| speed * random.between(-1.0, 1.0)))
        });
        let h = random.size(0.01, 0.3);
        let extent = away + 4.0 * spread;
        let spring = Spring { k: random.size(1e-2, 1e5), length: spread * random.between(0.0, 1.5) };
        let soft = Spring { k: random.size(1e-4, 1.0), length: spread * random.between(0.0, 1.5) };
        let ring: Vec<_> =
            (0..bodies.max(3)).map(|i| (i, (i + 1) % bodies)).take(if bodies == 2 { 1 } else { bodies }).collect();
        let field = Field { pull: random.between(0.0, 10.0), k: random.size(1e-3, 10.0) };
        let gravity = Gravity { g: random.size(1e-2, 2.0) };
        let atoms = LennardJones { epsilon: random.size(1e-3, 5.0), sigma: 1.0 };
        outcome.each(&scene.clone().pairs(soft), h, extent, "soft springs between all");
        outcome.each(&scene.clone().pairs(spring), h, extent, "springs between all");
        outcome.each(&scene.clone().pairs(gravity), h, extent, "gravity");
        outcome.each(&scene.clone().pairs(atoms), h, extent, "atoms");
        outcome.each(&scene.clone().chain(spring), h, extent, "a chain");
        outcome.each(&scene.clone().pin(0).chain(spring).field(field), h, extent, "a hanging chain");
        outcome.each(&scene.clone().pin(0).chain(soft).field(field), h, extent, "a soft hanging chain");
        outcome.each(&scene.clone().bonds(spring, ring.clone()).field(field), h, extent, "a ring in a bowl");
        outcome.each(&scene.clone().bonds(soft, ring).pairs(atoms), h, extent, "a ring of atoms");
        outcome.each(&scene.clone().chain(spring).chain(Damper { c: spring.k.sqrt() }), h, extent, "a damped chain");
        outcome.each(&scene.pairs(spring).pairs(Damper { c: soft.k }), h, extent, "damped springs between all");
    }
    let Outcome { runs, ended, steps, iterations, rounding } = &outcome;
    println!("{runs} runs, {ended} ended early, {:.2} corrections a step", *iterations as f64 / *steps as f64);
    println!("{}", rounding.iter().take(40).cloned().collect::<Vec<_>>().join("\n"));
    assert!(rounding.is_empty(), "{} of {ended} failures are rounding", rounding.len());
    assert!(ended * 3 < *runs, "{ended} of {runs} ended early");
}

/// The friction of a pair is linear in the velocities, so that Newton with the right Jacobian needs one correction, and one
/// or two more to see that it did: the derivative by the velocity of either body is among it, with its sign.
#[test]
fn the_jacobian_of_friction_is_right_in_both_velocities() {
    let bodies = || {
        let scene = Scene::<2>::new().body(1.0, [0.0, 0.0], [1.0, 0.3]).body(1.7, [1.0, 0.2], [-0.4, 0.9]);
        scene.body(0.6, [0.1, 1.3], [0.2, -1.1])
    };
    fn check<L: Term<2, ()>, S: Scheme<SceneSystem<2, L::Ready>>>(scene: Scene<2, (), L>, scheme: S, what: &str) {
        let run = Simulation::scene(scene).scheme(scheme).dt(0.2).run(100).unwrap();
        let (steps, iterations) = (run.steps(), run.report().iterations());
        assert!(iterations <= 3 * steps, "{what}, {}: {iterations} corrections in {steps} steps", S::NAME);
    }
    let damper = Damper { c: 3.0 };
    check(bodies().pairs(damper), Implicit, "pairs");
    check(bodies().pairs(damper), DiscreteGradient, "pairs");
    check(bodies().chain(damper), Implicit, "a chain");
    check(bodies().bonds(damper, [(0, 1), (1, 2), (0, 2)]), DiscreteGradient, "bonds");
}

/// Whom a body runs from and whom it runs after.
#[derive(Clone, Copy, Debug)]
struct Creature {
    fear: f64,
    hunger: f64,
    smell: f64,
}

/// A force that is not reciprocal, and reads other data of the body that it acts on than of the other one.
#[derive(Clone, Copy, Debug)]
struct Chase {
    k: f64,
}

#[dmech::law]
impl Chase {
    #[pair_force]
    fn force(&self, d: [f64; 2], vb: [f64; 2], ma: f64, a: &Creature, b: &Creature) -> [f64; 2] {
        let c = self.k * ma * (a.fear - a.hunger) * b.smell;
        [c * d[0] + 0.1 * b.fear * vb[0], c * d[1] + 0.1 * b.fear * vb[1]]
    }
}

/// On each body the force that the law's own method gives for it, its data first.
#[test]
fn a_force_that_is_not_reciprocal_reads_the_data_of_the_right_bodies() {
    let data = [(0.3, 1.1, 2.0), (1.7, 0.2, 0.5), (0.4, 0.9, 1.3)];
    let data = data.map(|(fear, hunger, smell)| Creature { fear, hunger, smell });
    let masses = [1.0, 1.9, 0.7];
    let q = [[0.0, 0.1], [1.2, -0.3], [0.4, 1.5]];
    let v = [[0.3, 0.0], [-0.2, 0.5], [0.1, -0.7]];
    let (law, h) = (Chase { k: 1.3 }, 0.01);
    let bodies =
        || (0..3).fold(Scene::<2, Creature>::new(), |scene, i| scene.body_with(masses[i], q[i], v[i], data[i]));
    fn stepped<L: Term<2, Creature>>(scene: Scene<2, Creature, L>, h: f64) -> Vec<[f64; 2]>
    where
        Explicit: Scheme<SceneSystem<2, L::Ready>>,
    {
        let mut stepper = Simulation::scene(scene).scheme(Explicit).dt(h).stepper().unwrap();
        stepper.step().unwrap();
        stepper.state().v
    }
    let links = [(0, 1), (0, 2), (1, 2)];
    let cases = [
        (stepped(bodies().pairs(law), h), &links[..]),
        (stepped(bodies().bonds(law, [(1, 0), (2, 0)]), h), &links[..2]),
        (stepped(bodies().chain(law), h), &[(0, 1), (1, 2)]),
    ];
    for (found, links) in cases {
        for body in 0..3 {
            let mut expected = v[body];
            for &(a, b) in links {
                let Some(other) = (if a == body {
                    Some(b)
                } else if b == body {
                    Some(a)
                } else {
                    None
                }) else {
                    continue;
                };
                let d = [0, 1].map(|k| q[body][k] - q[other][k]);
                let force = law.force(d, v[other], masses[body], &data[body], &data[other]);
                expected = [0, 1].map(|k| expected[k] + h / masses[body] * force[k]);
            }
            for k in 0..2 {
                assert!(
                    abs_diff_eq!(found[body][k], expected[k], epsilon = 1e-15),
                    "body {body}: {:?}, {expected:?}",
                    found[body]
                );
            }
        }
    }
}

/// √(1 − x) and √(2 − r) end at x = 1 and r = 2, with forces that lead there.
#[derive(Clone, Copy, Debug)]
struct Cliff;

#[dmech::law]
impl Cliff {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        (1.0 - q[0]).sqrt()
    }
}

#[derive(Clone, Copy, Debug)]
struct Thread;

#[dmech::law]
impl Thread {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        (2.0 - r).sqrt()
    }
}

/// The body or the pair on which the law ends is named, with the place, and not a lack of convergence.
#[test]
fn a_law_that_is_not_finite_in_a_step_of_a_scene_is_named() {
    let bodies = || Scene::<2>::new().body(1.0, [0.0, 0.0], [0.0, 0.1]).body(1.0, [0.9, 0.3], [1.0, 0.0]);
    fn cause<L: Term<2, ()>, S: Scheme<SceneSystem<2, L::Ready>>>(scene: Scene<2, (), L>, scheme: S) -> Error {
        let interrupted = Simulation::scene(scene).scheme(scheme).dt(0.05).run(1000).unwrap_err();
        println!("{interrupted}");
        interrupted.cause()
    }
    for error in [cause(bodies().field(Cliff), DiscreteGradient), cause(bodies().field(Cliff), Implicit)] {
        let Error::Body { body: 1, value, place, step, time, .. } = error else { panic!("{error}") };
        assert!(value.is_nan() && place.first()[0] > 1.0 && (place.first()[1] - 0.3).abs() < 1e-12, "{error}");
        assert!(step > 0 && (time - 0.05 * (step - 1) as f64).abs() < 1e-12, "{error}");
    }
    for error in [cause(bodies().pairs(Thread), DiscreteGradient), cause(bodies().chain(Thread), Implicit)] {
        let Error::Link { a: 0, b: 1, distance, step, .. } = error else { panic!("{error}") };
        assert!(distance > 2.0 && step > 0, "{error}");
    }
}
