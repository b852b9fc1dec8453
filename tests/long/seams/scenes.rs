//! Scenes with seams by every scheme that a scene has: sheets that pass through each other, potentials that are cut off, boxes,
//! ropes that go slack, bonds that break and heal.

use dmech::Kept;
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

use crate::aimed::{AHEAD, MADE, aim, around};
use crate::measured::order;
use crate::schemes::*;

/// Declares laws with named numbers.
macro_rules! laws {
    ($($(#[$doc:meta])* $kind:ident $name:ident($($field:ident),*) |$q:ident: $at:ty| $energy:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        struct $name {
            $($field: f64,)*
        }

        #[dmech::law]
        impl $name {
            #[$kind]
            fn energy(&self, $q: $at) -> f64 {
                let Self { $($field),* } = *self;
                $energy
            }
        }
    )*};
}

laws! {
    /// Two sheets that attract with a force that does not depend on their distance: gravity in one dimension.
    pair Sheets(k) |d: f64| k * d.abs();
    /// Lennard-Jones, shifted and cut off: the force jumps there.
    pair CutOff(epsilon, cut) |r: f64| {
        let (near, far) = (r.powi(-6), cut.powi(-6));
        if r < cut { 4.0 * epsilon * (near * near - near - far * far + far) } else { 0.0 }
    };
    /// Soft balls: nothing beyond their diameter, where the force has a kink.
    pair Soft(k, cut) |r: f64| if r < cut { 0.5 * k * (cut - r) * (cut - r) } else { 0.0 };
    /// A rope, which does not push.
    pair Rope(k, length) |r: f64| {
        let over = (r - length).max(0.0);
        0.5 * k * over * over
    };
    /// A spring of which one half is stiffer.
    pair Uneven(k, l) |d: f64| if d > 0.0 { 0.5 * k * d * d } else { 0.5 * l * d * d };
    /// A spring that lets go where it has taken up so much, and takes hold again.
    pair Breaking(k, most) |r: f64| (0.5 * k * r * r).min(most);
    /// A box.
    potential Walls(k, wide) |q: [f64; 2]| {
        let [x, y] = [(q[0].abs() - wide).max(0.0), (q[1].abs() - wide).max(0.0)];
        0.5 * k * (x * x + y * y)
    };
    potential Well(k) |q: f64| 0.5 * k * (q - 1.5) * (q - 1.5);
    potential Bowl(k) |q: [f64; 2]| 0.5 * k * (q[0] * q[0] + 1.3 * q[1] * q[1]);
}

/// Bodies of unequal mass about one apart, in motion; `seed` turns the velocities.
fn bodies<const D: usize>(n: usize, seed: f64) -> Scene<D> {
    (0..n).fold(Scene::new(), |scene, i| {
        let x = i as f64;
        let (row, column) = ((i % 2) as f64, (i / 2) as f64);
        let place = [1.15 * column + 0.1 * (1.7 * x).sin() - 1.0, 1.2 * row + 0.1 * (2.3 * x).cos() - 0.6];
        let q = std::array::from_fn(|k| if D == 1 { 1.1 * x + 0.3 * (2.9 * x).sin() } else { place[k] });
        let v = std::array::from_fn(|k| 0.9 * (2.1 * x + 1.3 * k as f64 + seed).sin());
        scene.body(1.0 + 0.25 * (i % 5) as f64, q, v)
    })
}

/// A scene, the step of its motion, and on which side of their seams the bodies are.
struct Seams<const D: usize, L> {
    scene: fn(Scene<D>) -> Scene<D, (), L>,
    bodies: usize,
    dt: f64,
    sides: fn(&[[f64; D]]) -> Vec<bool>,
    /// Whether the force jumps at a seam.
    jumps: bool,
}

/// On which side of a seam each pair is, by its separation.
fn by_pairs<const D: usize>(q: &[[f64; D]], side: impl Fn([f64; D]) -> bool) -> Vec<bool> {
    let pairs = (0..q.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
    pairs.map(|(a, b)| side(std::array::from_fn(|k| q[a][k] - q[b][k]))).collect()
}

fn length<const D: usize>(d: [f64; D]) -> f64 {
    d.iter().map(|x| x * x).sum::<f64>().sqrt()
}

const STEPS: u64 = 3000;
const SEEDS: [f64; 3] = [0.2, 1.1, 2.3];
/// Parts of the step.
const LADDER: [u64; 4] = [1, 2, 4, 8];

impl<const D: usize, L: Term<D, ()>> Seams<D, L> {
    /// The run, and its crossings; none where it did not reach its end, as the trapezoid need not where its force jumps.
    fn run<S: Scheme<SceneSystem<D, L::Ready>>>(
        &self,
        scheme: S,
        bodies: Scene<D>,
        dt: f64,
        steps: u64,
    ) -> Option<(Run<SceneState<D>>, usize)> {
        let run = match Simulation::scene((self.scene)(bodies)).scheme(scheme).dt(dt).run(steps) {
            Ok(run) => run,
            Err(interrupted) => {
                let told = matches!(interrupted.cause(), Error::NotConverged { .. });
                assert!(told && self.jumps && S::NAME == "Implicit", "{}: {interrupted}", S::NAME);
                return None;
            }
        };
        let finite = |state: &SceneState<D>| state.q.iter().chain(&state.v).flatten().all(|x| x.is_finite());
        assert!(run.states().iter().all(finite), "{}", S::NAME);
        let sides: Vec<_> = run.states().iter().map(|state| (self.sides)(&state.q)).collect();
        let crossed = |pair: &[Vec<bool>]| pair[0].iter().zip(&pair[1]).filter(|(a, b)| a != b).count();
        let crossed = sides.windows(2).map(crossed).sum();
        Some((run, crossed))
    }

    /// What is exact is exact, over many crossings.
    fn keeps<S: Scheme<SceneSystem<D, L::Ready>>>(&self, scheme: S) {
        let (mut runs, mut crossed, mut worst) = (0, 0, 0.0_f64);
        for seed in SEEDS {
            let bodies = bodies::<D>(self.bodies, seed);
            let masses = bodies.masses().to_vec();
            let Some((run, seams)) = self.run(scheme, bodies, self.dt, STEPS) else { continue };
            (runs, crossed) = (runs + 1, crossed + seams);
            let first = &run.states()[0];
            // Sums of absolute values, as momenta may cancel; K, or all the energy where that is more.
            let sum = |of: &dyn Fn(usize) -> f64| (0..masses.len()).map(|i| masses[i] * of(i)).sum::<f64>();
            let kinetic = sum(&|i| 0.5 * length(first.v[i]).powi(2));
            let energy = kinetic.max(run.drift(Invariant::Energy).expect("a closed system").start().abs());
            for invariant in Invariant::ALL {
                let Some(drift) = run.drift(invariant) else { continue };
                let (scale, most) = match invariant {
                    Invariant::LinearMomentum => (sum(&|i| length(first.v[i])), 2e-13),
                    Invariant::AngularMomentum => (sum(&|i| length(first.q[i]) * length(first.v[i])), 2e-13),
                    Invariant::WorkEnergy => (energy, 2e-13),
                    _ => (energy, 1e-14),
                };
                let moved = drift.max_abs() / scale;
                // An explicit scheme gains energy without end, and rounding with it.
                if S::keeps(invariant) == Kept::Exact && S::ORDER > 1 {
                    worst = worst.max(moved / most);
                    assert!(moved < most, "{} from seed {seed}: {invariant} {moved:e}", S::NAME);
                }
            }
        }
        println!("{:<44} {runs} runs, {crossed} crossings, {worst:.2} of what is allowed", S::NAME);
        assert!(runs > 0 && crossed > 20 * runs, "{}: {runs} runs, {crossed} crossings", S::NAME);
        assert!(S::NAME == "Implicit" || runs == SEEDS.len(), "{}: {runs} runs", S::NAME);
    }

    /// The energy is as good as the order and the seam permit: hˢ where the potential departs by the power s.
    fn errs<S: Scheme<SceneSystem<D, L::Ready>>>(&self, scheme: S) {
        let errors = LADDER.map(|part| {
            let run = |seed| {
                let (run, crossed) =
                    self.run(scheme, bodies::<D>(self.bodies, seed), self.dt / part as f64, 400 * part)?;
                assert!(crossed > 0, "{} from seed {seed} crosses no seam", S::NAME);
                run.drift(Invariant::Energy).map(|drift| drift.max_abs() / drift.start().abs())
            };
            let mut errors: Vec<f64> = SEEDS.into_iter().filter_map(run).collect();
            errors.sort_by(f64::total_cmp);
            errors[errors.len() / 2]
        });
        if S::keeps(Invariant::Energy) == Kept::Exact {
            assert!(errors.iter().all(|&error| error < 1e-14), "{}: {errors:?}", S::NAME);
            return;
        }
        let power = if self.jumps { 1.0 } else { 2.0 };
        let (measured, allowed) = (order(LADDER.map(|part| 1.0 / part as f64), errors), f64::from(S::ORDER).min(power));
        println!("{:<44} energy {:.1e}, order {measured:.2}", S::NAME, errors[0]);
        assert!(measured > allowed - 0.5, "{}: order {measured}, not {allowed}: {errors:?}", S::NAME);
    }

    /// There and back.
    fn returns<S: Scheme<SceneSystem<D, L::Ready>>>(&self, scheme: S) {
        let mut worst = 0.0_f64;
        for seed in SEEDS {
            let Some((there, crossed)) = self.run(scheme, bodies::<D>(self.bodies, seed), self.dt, 300) else {
                continue;
            };
            assert!(crossed > 0, "{} from seed {seed} crosses no seam", S::NAME);
            let (first, turned) = (&there.states()[0], there.last().clone().reversed());
            let masses = bodies::<D>(self.bodies, seed).masses().to_vec();
            let (back, _) = self.run(scheme, resume(&masses, &turned), self.dt, 300).expect("the same steps backward");
            let miss = back.last().q.iter().zip(&first.q).flat_map(|(a, b)| (0..D).map(|k| (a[k] - b[k]).abs()));
            worst = miss.fold(worst, f64::max);
        }
        println!("{:<44} {worst:.1e} away from home", S::NAME);
        // Where the force jumps along with the motion, the trapezoid's step has an end on either side of the seam, and the
        // step back may take the other: that both are roots, the balance of work in `keeps` shows.
        assert!(worst < 1e-10 || self.jumps && S::NAME == "Implicit", "{}: {worst:e}", S::NAME);
    }

    /// What is exact is exact, however near to a seam a step ends.
    fn beside<S: Scheme<SceneSystem<D, L::Ready>>>(&self, scheme: S) {
        let exact =
            if S::keeps(Invariant::Energy) == Kept::Exact { Invariant::Energy } else { Invariant::DiscreteEnergy };
        let (mut aimed, mut runs, mut worst) = (0, 0, 0.0_f64);
        for (seed, part) in SEEDS.into_iter().flat_map(|seed| [2.0, 1.0, 0.5, 0.25].map(|part| (seed, part))) {
            let (bodies, h) = (bodies::<D>(self.bodies, seed), part * self.dt);
            let masses = bodies.masses().to_vec();
            let (way, _) = self.run(scheme, bodies, h, 600).expect("it reaches its end");
            let states = way.states();
            let over = |&k: &usize| (self.sides)(&states[k - 1].q) != (self.sides)(&states[k].q);
            for k in (AHEAD as usize..states.len()).filter(over).take(5) {
                let start = &states[k - AHEAD as usize];
                let run = |h, steps| self.run(scheme, resume(&masses, start), h, steps).expect("it reaches its end").0;
                let sides = |h| (self.sides)(&run(h, AHEAD).last().q);
                let beyond = sides(h);
                let Some(h) = aim(h, |h| sides(h) == beyond) else { continue };
                aimed += 1;
                for h in around(h) {
                    let run = run(h, MADE);
                    let drift = run.drift(exact).expect("a closed system");
                    let kinetic = |i: usize| 0.5 * masses[i] * length(start.v[i]).powi(2);
                    let scale = (0..masses.len()).map(kinetic).sum::<f64>().max(drift.start().abs());
                    worst = worst.max(drift.max_abs() / scale);
                    assert!(worst < 5e-15, "{} from seed {seed}, steps of {h:e}: {worst:e}", S::NAME);
                    runs += 1;
                }
            }
        }
        println!("{:<44} {aimed} aimed, {runs} runs, energy {worst:.1e}", S::NAME);
        assert!(aimed > 20, "{}: {aimed} aimed", S::NAME);
    }
}

/// The same masses from another state.
fn resume<const D: usize>(masses: &[f64], state: &SceneState<D>) -> Scene<D> {
    (0..masses.len()).fold(Scene::new(), |scene, i| scene.body(masses[i], state.q[i], state.v[i]))
}

macro_rules! on_this_scene {
    (Explicit, $seams:ident) => {
        $seams.keeps(Explicit);
        $seams.errs(Explicit);
    };
    // The velocity of a state is only of second order: the way back is another motion.
    (Kanatani, $seams:ident) => {
        $seams.keeps(Kanatani);
        $seams.beside(Kanatani);
    };
    (DiscreteGradient, $seams:ident) => {
        $seams.keeps(DiscreteGradient);
        $seams.errs(DiscreteGradient);
        $seams.returns(DiscreteGradient);
        $seams.beside(DiscreteGradient);
    };
    ($scheme:expr, $seams:ident) => {
        $seams.keeps($scheme);
        $seams.errs($scheme);
        $seams.returns($scheme);
    };
}

macro_rules! every_scheme {
    ($($test:ident: $seams:expr;)*) => {$(
        #[test]
        fn $test() {
            let seams = $seams;
            for_each_scene_scheme!(on_this_scene, seams);
        }
    )*};
}

every_scheme! {
    sheets: Seams {
        scene: |scene: Scene<1>| scene.pairs(Sheets { k: 0.4 }),
        bodies: 6, dt: 0.01, jumps: true,
        sides: |q| by_pairs(q, |d| d[0] > 0.0),
    };
    a_chain_of_tents_in_a_bowl: Seams {
        scene: |scene: Scene<1>| scene.chain(Sheets { k: 0.9 }).field(Well { k: 1.7 }),
        bodies: 9, dt: 0.01, jumps: true,
        sides: |q| q.windows(2).map(|p| p[0][0] > p[1][0]).collect(),
    };
    a_cut_off: Seams {
        scene: |scene: Scene<2>| scene.pairs(CutOff { epsilon: 0.7, cut: 1.6 }).field(Bowl { k: 0.8 }),
        bodies: 5, dt: 0.004, jumps: true,
        sides: |q| by_pairs(q, |d| length(d) > 1.6),
    };
    balls_in_a_box: Seams {
        scene: |scene: Scene<2>| scene.pairs(Soft { k: 60.0, cut: 0.9 }).field(Walls { k: 80.0, wide: 1.5 }),
        bodies: 6, dt: 0.01, jumps: false,
        sides: |q| by_pairs(q, |d| length(d) > 0.9).into_iter().chain(q.iter().flatten().map(|x| x.abs() > 1.5)).collect(),
    };
    a_rope_of_beads: Seams {
        scene: |scene: Scene<2>| scene.chain(Rope { k: 40.0, length: 1.2 }),
        bodies: 9, dt: 0.01, jumps: false,
        sides: |q| q.windows(2).map(|p| length([p[0][0] - p[1][0], p[0][1] - p[1][1]]) > 1.2).collect(),
    };
    an_uneven_chain: Seams {
        scene: |scene: Scene<1>| scene.chain(Uneven { k: 3.0, l: 30.0 }),
        bodies: 18, dt: 0.01, jumps: false,
        sides: |q| q.windows(2).map(|p| p[0][0] > p[1][0]).collect(),
    };
    a_chain_of_tents: Seams {
        scene: |scene: Scene<1>| scene.chain(Sheets { k: 0.9 }),
        bodies: 9, dt: 0.01, jumps: true,
        sides: |q| q.windows(2).map(|p| p[0][0] > p[1][0]).collect(),
    };
    bonds_that_break_and_heal: Seams {
        scene: |scene: Scene<2>| scene.bonds(Breaking { k: 2.0, most: 1.3 }, [(0, 1), (1, 2), (2, 0), (3, 1)]).field(Bowl { k: 0.8 }),
        bodies: 4, dt: 0.01, jumps: true,
        sides: |q| by_pairs(q, |d| length(d) > 1.3_f64.sqrt()),
    };
}
