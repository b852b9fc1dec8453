//! Every scheme over every seam, in equal steps.
//!
//! A step that straddles a seam misses there what one branch of the potential has and the other has not, and at a distance
//! of O(h) that is O(hˢ), s = 1 for a kink, 2 where the slope is continuous. So the energy of a scheme of order p that does
//! not keep it exactly errs by h^min(p, s), whatever is promised for smooth laws; what is kept exactly stays so.

use dmech::extend::Stride;
use dmech::extend::VelocityIndependent;
use dmech::prelude::*;
use dmech::scheme::KanataniMemory;
use dmech::{Kept, Potential};
use dmech_tests::erased::Erased;

use crate::laws::*;
use crate::measured::*;
use crate::schemes::*;

const SPAN: f64 = 24.0;
const STARTS: usize = 21;
/// Steps to the end: each halves those before.
const LADDER: [u64; 4] = [800, 1600, 3200, 6400];

impl<L: Law<D> + VelocityIndependent + Copy, const D: usize> Seam<L, D> {
    fn run<S: Scheme<Particle<L, D>>>(&self, scheme: S, start: State<D>, h: f64, steps: u64) -> Option<Run<State<D>>> {
        reached::<S, D>(Simulation::new(self.law, start).scheme(scheme).dt(h).run(steps), self.power)
    }

    /// What is exact is exact, and the energy is as good as order and seam permit.
    fn energies<S: Scheme<Particle<L, D>>>(&self, scheme: S) {
        let mut ended = 0;
        let errors = LADDER.map(|steps| {
            let (mut errors, mut crossed) = (Vec::new(), 0);
            for start in starts::<D>(STARTS) {
                let Some(run) = self.run(scheme, start, SPAN / steps as f64, steps) else {
                    ended += 1;
                    continue;
                };
                self.keeps::<S>(&run, &format!("{steps} steps from {start:?}"));
                let energy = run.drift(Invariant::Energy).expect("the law is conservative").max_abs();
                errors.push(energy / self.scale(&start));
                crossed += self.crossed(&run);
            }
            let runs = errors.len();
            assert!(2 * runs > STARTS, "{}: {runs} of {STARTS} runs reach their end", S::NAME);
            assert!(crossed > 3 * runs, "{}: {runs} runs cross their seam {crossed} times", S::NAME);
            // The median: where a period is a whole number of steps, crossings err alike, and by chance much or little.
            errors.sort_by(f64::total_cmp);
            errors[runs / 2]
        });
        if S::keeps(Invariant::Energy) == Kept::Exact {
            assert_eq!(ended, 0, "{}", S::NAME);
            return;
        }
        let (measured, allowed) =
            (order(LADDER.map(|steps| SPAN / steps as f64), errors), f64::from(S::ORDER).min(self.power));
        println!(
            "{:<44} s = {} energy {:8.1e} to {:8.1e}, order {measured:5.2}, {ended} ended",
            S::NAME,
            self.power,
            errors[0],
            errors[3]
        );
        let wrong = format!("{}: order {measured}, not {allowed}: {errors:?}", S::NAME);
        // What an explicit orbit gains it gains in proportion to what it has: from long steps more than h.
        assert!(measured > allowed - 0.5 && (S::ORDER == 1 || measured < allowed + 0.5), "{wrong}");
    }

    /// There and back through the seam, where nothing is lost but rounding: and where there is a step there, there is one back.
    fn returns<S: Scheme<Particle<L, D>>>(&self, scheme: S) {
        let (mut crossed, mut worst) = (0, 0.0_f64);
        for start in starts::<D>(STARTS) {
            let Some(there) = self.run(scheme, start, 0.013, 500) else { continue };
            let back = self.run(scheme, there.last().reversed(), 0.013, 500).expect("the same steps backward");
            let home = back.last().reversed();
            let miss = (0..D).map(|i| (home.q[i] - start.q[i]).abs() + (home.v[i] - start.v[i]).abs());
            worst = miss.fold(worst, f64::max);
            crossed += self.crossed(&there);
        }
        println!("{:<44} {worst:8.1e} away from home", S::NAME);
        // A force that rises from its seam as a root makes √ε of the rounding ε of a place beside it.
        let most = if 1.0 < self.power && self.power < 2.0 { f64::EPSILON.sqrt() } else { 2e-12 };
        assert!(2 * crossed > STARTS && worst < most, "{}: {worst:e}, {crossed} crossings", S::NAME);
    }

    /// Kanatani's way back is by its own two positions: the velocity of a state is only of second order.
    fn kanatani_returns(&self) {
        for start in starts::<D>(STARTS) {
            let (stride, steps) = (Stride::new(0.013, 1.0), 500);
            let mut stepper = Simulation::new(self.law, start).scheme(Kanatani).dt(0.013).stepper().expect("a start");
            let first = stepper.memory().q_before();
            stepper.advance(steps).expect("every step has a root");
            let (before, now) = (stepper.memory().q_before(), stepper.memory().q());
            let gradient = self.law.field(1.0, 0.0).gradient(before);
            let particle = Particle::new(self.law, 1.0);
            let mut memory = KanataniMemory::<Particle<_, D>>::from_positions(&stride, now, before, &gradient);
            for _ in 0..steps {
                Kanatani.step(&particle, &stride, 0.0, &mut memory, &mut ()).expect("the same steps backward");
            }
            let miss = (0..D).map(|i| (memory.q()[i] - first[i]).abs()).fold(0.0, f64::max);
            assert!(miss < 1e-10, "Kanatani from {start:?}: {miss:e}");
        }
    }
}

macro_rules! on_this_law {
    (Kanatani, $seam:ident) => {
        $seam.energies(Kanatani);
        $seam.kanatani_returns();
    };
    (Explicit, $seam:ident) => {
        $seam.energies(Explicit);
    };
    ($scheme:expr, $seam:ident) => {
        $seam.energies($scheme);
        $seam.returns($scheme);
    };
}

macro_rules! every_scheme {
    ($($test:ident: $law:expr, $d:literal, $power:literal, |$q:ident| $side:expr;)*) => {$(
        #[test]
        fn $test() {
            let seam = Seam { law: Erased::<$d, false, true>::new($law), power: $power, side: |$q: [f64; $d]| $side };
            for_each_scheme!(on_this_law, seam);
        }
    )*};
}

for_each_seam!(every_scheme);

/// Of a convex potential in one coordinate the trapezoid's equation rises with the end of the step, and has no root exactly
/// where it jumps over zero at the seam: there the run ends, and nowhere else.
#[test]
fn the_trapezoid_gives_up_where_it_has_no_root() {
    fn ends<L: Law<1> + Potential<1> + Copy + std::fmt::Debug>(law: L) -> usize {
        let mut ended = 0;
        for start in starts::<1>(40) {
            for h in [0.02, 0.05, 0.11] {
                let Err(interrupted) = Simulation::new(law, start).scheme(Implicit).dt(h).run(2000) else { continue };
                let State { q: [q], v: [v], .. } = *interrupted.run().last();
                // The equation's left side at an end just before and just behind the seam at 0.
                let at = |end: f64| end - q - h * v + 0.25 * h * h * (law.gradient([q])[0] + law.gradient([end])[0]);
                let [before, behind] = [-1e-300, 1e-300].map(at);
                assert!(before < 0.0 && behind > 0.0, "{law:?}, h = {h}: {before:e}, {behind:e}, {interrupted}");
                ended += 1;
            }
        }
        ended
    }
    let ended = [ends(Tent { k: 3.0, g: 1.1 }), ends(Kinked { k: 0.7 }), ends(Ramps { k: 0.7 })];
    println!("{ended:?} of 120 runs each");
    assert!(ended.iter().all(|&ended| ended > 5), "{ended:?}");
}
