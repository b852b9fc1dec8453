//! Steps that follow the motion, over every seam.
//!
//! The rule looks at where steps end and sees no seam ahead: a contact is entered with the step of the free flight before it.
//! What is exact for any sequence of steps stays exact. What is not errs as with equal steps, by h^min(p, s) at least, if the longest
//! step shrinks with the others.

use approx::relative_eq;
use dmech::extend::{Adaptable, Adaptive, Carried, VelocityIndependent};
use dmech::prelude::*;
use dmech::{Kept, Potential};
use dmech_tests::erased::Erased;

use crate::laws::*;
use crate::measured::*;
use crate::schemes::*;

const SPAN: f64 = 24.0;
const STARTS: usize = 21;
/// By how many radians a step turns the motion: each halves that before. The longest step is that of a frequency of 1.
const LADDER: [f64; 4] = [0.04, 0.02, 0.01, 0.005];

/// The tolerance at which steps turn the motion by an angle.
fn tolerance<S: Adaptable>(scheme: &S, angle: f64) -> f64 {
    let known = 1e-14;
    let tolerance = known * (angle / scheme.angle(known)).powi(S::ORDER as i32);
    assert!(relative_eq!(scheme.angle(tolerance), angle, max_relative = 1e-9), "{}", S::NAME);
    tolerance
}

/// How the steps of a run should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Steps {
    /// The frequency does not change.
    Equal,
    /// It does, and for long enough to be seen.
    Varied,
    /// There is little to be seen.
    Either,
}

impl<L: Law<D> + VelocityIndependent + Copy, const D: usize> Seam<L, D> {
    fn follow<S>(&self, scheme: S, start: State<D>, angle: f64) -> Option<Run<State<D>>>
    where
        S: Adaptable + Scheme<Particle<L, D>>,
    {
        let simulation = Simulation::new(self.law, start).scheme(scheme).dt(angle);
        reached::<S, D>(simulation.adaptive(tolerance(&scheme, angle)).run_until(SPAN), self.power)
    }

    /// What the frequencies of the linearised motion say, ω² = ‖∂a/∂q‖; where ω < 1 steps are the longest.
    fn steps(&self, run: &Run<State<D>>) -> Steps {
        let stiffness = |state: &State<D>| {
            let hessian = self.law.field(1.0, 0.0).hessian(state.q);
            hessian.as_flattened().iter().map(|x| x * x).sum::<f64>().sqrt()
        };
        let all: Vec<f64> = run.states().iter().map(stiffness).collect();
        let [least, most] = [f64::min, f64::max].map(|of| all.iter().copied().reduce(of).expect("states"));
        if most - least <= 1e-12 * most {
            return Steps::Equal;
        }
        let [least, most] = [least, most].map(|stiffness| stiffness.max(1.0));
        // Two units of time of the 24: rows of equal steps are an eighth long.
        let long = |which: &dyn Fn(&f64) -> bool| {
            let there = run.states().windows(2).zip(&all).filter(|(_, x)| which(x));
            there.map(|(pair, _)| pair[1].t - pair[0].t).sum::<f64>() > 2.0
        };
        let varied = most > 2.0 * least && long(&|x| *x > 2.0 * least) && long(&|x| *x < 0.5 * most);
        if varied { Steps::Varied } else { Steps::Either }
    }

    /// The run ends on its end; what is exact is exact, and the energy is as good as order and seam permit.
    fn adapts<S>(&self, scheme: S)
    where
        S: Adaptable + Scheme<Particle<L, D>>,
    {
        let (mut ended, mut equal, mut varied) = (0, 0, 0);
        let errors = LADDER.map(|angle| {
            let (mut errors, mut crossed) = (Vec::new(), 0);
            for start in starts::<D>(STARTS) {
                let Some(run) = self.follow(scheme, start, angle) else {
                    ended += 1;
                    continue;
                };
                let what = format!("steps of {angle} from {start:?}");
                assert_eq!(run.last().t, SPAN, "{}, {what}", S::NAME);
                let [shortest, longest] = run.report().dt_range().expect("it made steps");
                assert!(longest <= angle, "{}, {what}: {longest}", S::NAME);
                match self.steps(&run) {
                    Steps::Equal => {
                        equal += 1;
                        assert!(longest < shortest * (1.0 + 1e-9), "{}, {what}: {shortest} to {longest}", S::NAME);
                    }
                    Steps::Varied => {
                        varied += 1;
                        assert!(longest > 1.2 * shortest, "{}, {what}: {shortest} to {longest}", S::NAME);
                    }
                    Steps::Either => {}
                }
                self.keeps::<S>(&run, &what);
                let energy = run.drift(Invariant::Energy).expect("the law is conservative").max_abs();
                errors.push(energy / self.scale(&start));
                crossed += self.crossed(&run);
            }
            let runs = errors.len();
            assert!(2 * runs > STARTS, "{}: {runs} of {STARTS} runs reach their end", S::NAME);
            assert!(crossed > 3 * runs, "{}: {runs} runs cross their seam {crossed} times", S::NAME);
            errors.sort_by(f64::total_cmp);
            errors[runs / 2]
        });
        let exact = S::keeps(Invariant::Energy) == Kept::Exact;
        let (measured, allowed) = (order(LADDER, errors), f64::from(S::ORDER).min(self.power));
        println!(
            "{:<44} s = {} energy {:8.1e} to {:8.1e}, order {measured:5.2}, {equal} equal, {varied} varied, {ended} ended",
            S::NAME,
            self.power,
            errors[0],
            errors[3]
        );
        if exact {
            assert_eq!(ended, 0, "{}", S::NAME);
        } else {
            // A contact that is seen within a longest step is met in shorter ones the sooner: errors fall faster than it becomes sharp.
            assert!(measured > allowed - 0.5, "{}: order {measured}, not {allowed}: {errors:?}", S::NAME);
        }
    }

    /// Saved after any of its steps and resumed, a run is the one that never stopped, to the bit, and goes over the seam.
    fn resumes<S>(&self, scheme: S)
    where
        S: Adaptable + Scheme<Particle<L, D>>,
        <Adaptive<S> as Scheme<Particle<L, D>>>::Memory: Carried,
    {
        const STEPS: usize = 360;
        let (mut saved, mut crossed) = (0, 0);
        for start in starts::<D>(3) {
            let simulation = || {
                let tolerance = tolerance(&scheme, 0.04);
                Simulation::new(self.law, start).scheme(scheme).dt(0.04).adaptive(tolerance)
            };
            let mut stepper = simulation().stepper().expect("a start");
            let mut passed = Vec::new();
            // As far as it goes.
            while passed.len() < STEPS {
                passed.push((stepper.checkpoint(), stepper.state()));
                if stepper.step().is_err() {
                    break;
                }
            }
            let bits = |state: &State<D>| (state.t.to_bits(), state.q.map(f64::to_bits), state.v.map(f64::to_bits));
            let sides: Vec<bool> = passed.iter().map(|(_, state)| (self.side)(state.q)).collect();
            for seam in (1..sides.len()).filter(|&k| sides[k] != sides[k - 1]) {
                // Before the step over the seam, after it, and in the row of equal steps before.
                for from in [seam.saturating_sub(2), seam - 1, seam] {
                    let text = serde_json::to_string(&passed[from].0).expect("numbers");
                    let checkpoint: Checkpoint = serde_json::from_str(&text).expect("the same");
                    let mut resumed = simulation().resume(&checkpoint).expect("its own");
                    for (checkpoint, state) in passed.iter().skip(from).take(40) {
                        assert_eq!(bits(&resumed.state()), bits(state), "{}, saved after {from} steps", S::NAME);
                        assert_eq!(&resumed.checkpoint(), checkpoint, "{}, saved after {from} steps", S::NAME);
                        let _ = resumed.step();
                    }
                    saved += 1;
                }
                crossed += 1;
            }
        }
        assert!(crossed > 5, "{}: saved {saved} times around {crossed} crossings", S::NAME);
    }
}

macro_rules! on_this_law {
    ($scheme:expr, $seam:ident) => {
        $seam.adapts($scheme);
        $seam.resumes($scheme);
    };
}

macro_rules! every_scheme {
    ($($test:ident: $law:expr, $d:literal, $power:literal, |$q:ident| $side:expr;)*) => {$(
        #[test]
        fn $test() {
            let seam = Seam { law: Erased::<$d, false, true>::new($law), power: $power, side: |$q: [f64; $d]| $side };
            for_each_adaptable!(on_this_law, seam);
        }
    )*};
}

for_each_seam!(every_scheme);

/// Between walls, and out of contact, nothing tells how long a step may be: a longest step does.
#[test]
fn free_flight_needs_a_longest_step() {
    /// Not from there, from inside the wall up to where it ends, and with a longest step all the way.
    fn check<L: Law<1> + Potential<1> + VelocityIndependent + Copy, S: Adaptable + Scheme<Particle<L, 1>>>(
        law: L,
        scheme: S,
        [free, touching]: [f64; 2],
    ) {
        let tolerance = tolerance(&scheme, 0.04);
        let simulation = |q| Simulation::new(law, State::new([q], [0.3])).scheme(scheme);
        let refused = simulation(free).adaptive(tolerance).run_until(9.0).expect_err("there is no time scale");
        assert_eq!(refused.cause(), Error::NoTimeScale { step: 1, time: 0.0 }, "{}", S::NAME);
        let left = simulation(touching).adaptive(tolerance).run_until(9.0).expect_err("it comes out of contact");
        let (run, State { t, q, .. }) = (left.run(), *left.run().last());
        assert_eq!(left.cause(), Error::NoTimeScale { step: run.steps() + 1, time: t }, "{}", S::NAME);
        assert!(run.steps() > 2 && law.hessian(q) == [[0.0]], "{}: {left} at {q:?}", S::NAME);
        for q in [free, touching] {
            let run = simulation(q).dt(0.04).adaptive(tolerance).run_until(9.0).expect("it has a longest step");
            assert_eq!(run.last().t, 9.0);
            let touches = run.states().iter().filter(|state| law.hessian(state.q) != [[0.0]]).count();
            assert!(touches > 10 && touches < run.states().len() - 10, "{}: {touches} in contact", S::NAME);
        }
    }
    macro_rules! both {
        ($scheme:expr, $unused:ident) => {
            check(Gap { k: 40.0 }, $scheme, [0.2, 0.8]);
            check(Hertz { k: 50.0, g: 1.1 }, $scheme, [0.2, -0.2]);
        };
    }
    for_each_adaptable!(both, unused);
}
