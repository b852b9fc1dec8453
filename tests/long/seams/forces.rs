//! Forces with seams and without a potential or a velocity: dry friction of a surface that is rough in places, a whirl that
//! ends at a rim. No energy is claimed of them; what holds is the balance of work, by each scheme's own definition.

use dmech::Kept;
use dmech::extend::VelocityIndependent;
use dmech::prelude::*;

use crate::laws::{crossings, starts};
use crate::schemes::*;

/// Friction on a string that is pulled through the origin: always towards it, with a jump there.
#[derive(Clone, Copy, Debug)]
struct Rough {
    mu: f64,
}

#[dmech::law]
impl Rough {
    #[potential]
    fn bowl(&self, q: f64) -> f64 {
        0.5 * q * q
    }
    #[force]
    fn friction(&self, q: f64) -> f64 {
        if q > 0.0 { -self.mu } else { self.mu }
    }
}

/// The same, rising to its full size over a width: continuous, with two kinks.
#[derive(Clone, Copy, Debug)]
struct Worn {
    mu: f64,
    width: f64,
}

#[dmech::law]
impl Worn {
    #[potential]
    fn bowl(&self, q: f64) -> f64 {
        0.5 * q * q
    }
    #[force]
    fn friction(&self, q: f64) -> f64 {
        -self.mu * (q / self.width).clamp(-1.0, 1.0)
    }
}

/// A bowl with a whirl inside a rim, where it stops short: along the rim, so that the jump does not stand in the way.
#[derive(Clone, Copy, Debug)]
struct Whirl {
    c: f64,
}

#[dmech::law]
impl Whirl {
    #[potential]
    fn bowl(&self, q: [f64; 2]) -> f64 {
        0.5 * (q[0] * q[0] + 1.3 * q[1] * q[1])
    }
    #[force]
    fn whirl(&self, q: [f64; 2]) -> [f64; 2] {
        let inside = q[0] * q[0] + q[1] * q[1] < 0.5;
        let c = if inside { self.c } else { 0.0 };
        [-c * q[1], c * q[0]]
    }
}

/// A law, a side of its seam, and whether the force jumps against the motion.
struct Seam<L, const D: usize> {
    law: L,
    side: fn([f64; D]) -> bool,
    against: bool,
}

const STEPS: u64 = 2000;
const H: f64 = 0.011;

impl<L: Law<D> + VelocityIndependent + Copy, const D: usize> Seam<L, D> {
    /// What comes of the steps; nothing where a scheme that takes the force at the end of its step found none, as may be where
    /// the force jumps against the motion.
    fn run<S: Scheme<Particle<L, D>>>(&self, scheme: S, start: State<D>, steps: u64) -> Option<Run<State<D>>> {
        let run = match Simulation::new(self.law, start).scheme(scheme).dt(H).run(steps) {
            Ok(run) => run,
            Err(interrupted) => {
                let at_its_end = S::NAME.contains("Implicit") || S::NAME.contains("DiscreteGradient");
                let told = matches!(interrupted.cause(), Error::NotConverged { .. });
                assert!(told && self.against && at_its_end, "{}: {interrupted}", S::NAME);
                return None;
            }
        };
        assert!(run.states().iter().all(|s| s.q.iter().chain(&s.v).all(|x| x.is_finite())), "{}", S::NAME);
        Some(run)
    }

    fn check<S: Scheme<Particle<L, D>>>(&self, scheme: S) {
        let (mut runs, mut crossed, mut worst, mut away) = (0, 0, 0.0_f64, 0.0_f64);
        for start in starts::<D>(12) {
            let Some(run) = self.run(scheme, start, STEPS) else { continue };
            (runs, crossed) = (runs + 1, crossed + crossings(run.states(), |state| (self.side)(state.q)));
            assert!(run.drift(Invariant::Energy).is_none() && run.drift(Invariant::DiscreteEnergy).is_none());
            assert_eq!(S::keeps(Invariant::WorkEnergy), Kept::Exact);
            let kinetic = |state: &State<D>| state.v.iter().map(|v| 0.5 * v * v).sum::<f64>();
            let largest = run.states().iter().map(kinetic).fold(0.0, f64::max);
            worst = worst.max(run.drift(Invariant::WorkEnergy).expect("every law has work").max_abs() / largest);
            if !S::SYMMETRIC || S::NAME == "Kanatani" {
                continue;
            }
            let Some(there) = self.run(scheme, start, 500) else { continue };
            let home = self.run(scheme, there.last().reversed(), 500).expect("the same steps backward");
            away = (0..D).map(|k| (home.last().q[k] - start.q[k]).abs()).fold(away, f64::max);
        }
        println!("{:<44} {runs} runs, {crossed} crossings, work {worst:.1e}, {away:.1e} away from home", S::NAME);
        assert!(worst > 0.0 && worst < 2e-13, "{}: {worst:e}", S::NAME);
        assert!(runs >= 4 && crossed > 5 * runs, "{}: {runs} runs, {crossed} crossings", S::NAME);
        assert!(away < 2e-12, "{}: {away:e}", S::NAME);
    }
}

macro_rules! on_this_law {
    ($scheme:expr, $seam:ident) => {
        $seam.check($scheme);
    };
}

macro_rules! every_scheme {
    ($($test:ident: $seam:expr;)*) => {$(
        #[test]
        fn $test() {
            let seam = $seam;
            for_each_scheme!(on_this_law, seam);
        }
    )*};
}

every_scheme! {
    dry_friction: Seam { law: Rough { mu: 0.4 }, side: |q: [f64; 1]| q[0] > 0.0, against: true };
    worn_friction: Seam { law: Worn { mu: 0.4, width: 0.1 }, side: |q: [f64; 1]| q[0].abs() < 0.1, against: false };
    a_whirl: Seam { law: Whirl { c: 0.3 }, side: |q: [f64; 2]| q[0] * q[0] + q[1] * q[1] < 0.5, against: false };
}
