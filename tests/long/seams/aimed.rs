//! Steps that end beside a seam, by any distance from a rounding error to a part of a step.
//!
//! A motion comes so near to one once in millions of crossings, and an iteration can go wrong there that never does elsewhere:
//! its guess is before the seam and the root behind it, and what it knows of the force on the one side says nothing of the
//! other. Here each run is aimed: the length of its steps is varied until one of them ends on the seam.

use dmech::extend::VelocityIndependent;
use dmech::prelude::*;
use dmech_tests::erased::Erased;

use crate::laws::*;
use crate::measured::*;

/// Steps to the seam: the guess of the last goes by the forces of three steps.
pub(crate) const AHEAD: u64 = 6;
/// Steps in all: the seam is then behind.
pub(crate) const MADE: u64 = 9;

/// The length of steps, between five sixths of `h` and `h`, at which `beyond` changes, to the last digit.
pub(crate) fn aim(h: f64, beyond: impl Fn(f64) -> bool) -> Option<f64> {
    let [mut before, mut behind] = [h * (AHEAD - 1) as f64 / AHEAD as f64, h];
    if beyond(before) || !beyond(behind) {
        return None;
    }
    loop {
        let middle = 0.5 * (before + behind);
        if middle <= before || middle >= behind {
            return Some(behind);
        }
        *if beyond(middle) { &mut behind } else { &mut before } = middle;
    }
}

/// The same length and those beside it, by 2⁻¹⁰ to 2⁻⁵⁰ of it.
pub(crate) fn around(h: f64) -> impl Iterator<Item = f64> {
    let beside = (0..60).map(|k| (-0.67 * f64::from(k) - 10.0).exp2());
    beside.flat_map(move |part| [h + h * part, h - h * part]).chain([h])
}

impl<L: Law<D> + VelocityIndependent + Copy, const D: usize> Seam<L, D> {
    /// States so many steps before one over the seam.
    fn ahead<S: Scheme<Particle<L, D>>>(&self, scheme: S, start: State<D>, h: f64) -> Vec<State<D>> {
        let run = Simulation::new(self.law, start).scheme(scheme).dt(h).run((6.0 / h) as u64);
        let run = run.unwrap_or_else(Interrupted::into_run);
        let sides: Vec<bool> = run.states().iter().map(|state| (self.side)(state.q)).collect();
        let over = (AHEAD as usize..sides.len()).filter(|&k| sides[k] != sides[k - 1]);
        over.take(3).map(|k| run.states()[k - AHEAD as usize].at_time(0.0)).collect()
    }

    /// What is exact is exact, and the equation of the trapezoid is solved, however near to the seam a step ends.
    fn beside<S: Scheme<Particle<L, D>>>(&self, scheme: S) {
        let (mut aimed, mut runs, mut worst) = (0, 0, 0.0_f64);
        for start in starts::<D>(4) {
            for h in [0.05, 0.02, 0.01, 0.006, 0.0035, 0.002] {
                for start in self.ahead(scheme, start, h) {
                    let run = |h, steps| Simulation::new(self.law, start).scheme(scheme).dt(h).run(steps);
                    let side = |h| Some((self.side)(run(h, AHEAD).ok()?.last().q));
                    let Some(beyond) = side(h) else { continue };
                    let Some(h) = aim(h, |h| side(h) == Some(beyond)) else { continue };
                    aimed += 1;
                    for h in around(h) {
                        let Some(run) = reached::<S, D>(run(h, MADE), self.power) else { continue };
                        runs += 1;
                        let what = format!("steps of {h:e} from {start:?}");
                        self.keeps::<S>(&run, &what);
                        if S::NAME == "Implicit" {
                            worst = worst.max(self.residual(&run, h) / self.scale(&start).sqrt());
                            assert!(worst < 1e-13, "{what}: {worst:e}");
                        }
                    }
                }
            }
        }
        println!("{:<44} {aimed} aimed, {runs} runs, residual {worst:.1e}", S::NAME);
        // On one side of a seam the trapezoid may have no root.
        let few = if S::NAME == "Implicit" && self.power == 1.0 { 40 } else { 121 };
        assert!(aimed > 10 && runs >= few * aimed, "{}: {aimed} aimed, {runs} runs", S::NAME);
    }

    /// The largest |v′ − v + h (∇Φ(q) + ∇Φ(q′))/2| of a run.
    fn residual(&self, run: &Run<State<D>>, h: f64) -> f64 {
        let field = self.law.field(1.0, 0.0);
        // Where rounding decides on which side a place is, so it does on its force.
        let told = |q: [f64; D]| {
            let corner = |signs: u32| {
                let sign = |i: usize| if signs >> i & 1 == 0 { -4.0 } else { 4.0 };
                (self.side)(std::array::from_fn(|i| q[i] + sign(i) * f64::EPSILON * q[i].abs().max(h)))
            };
            (1..1 << D).all(|signs| corner(signs) == corner(0))
        };
        let steps = run.states().windows(2).filter(|pair| told(pair[0].q) && told(pair[1].q));
        let left = |pair: &[State<D>]| {
            let [before, after] = [0, 1].map(|k| (pair[k].v, field.gradient(pair[k].q)));
            (0..D).map(|i| (after.0[i] - before.0[i] + 0.5 * h * (before.1[i] + after.1[i])).abs()).fold(0.0, f64::max)
        };
        steps.map(left).fold(0.0, f64::max)
    }
}

macro_rules! every_law {
    ($($test:ident: $law:expr, $d:literal, $power:literal, |$q:ident| $side:expr;)*) => {$(
        #[test]
        fn $test() {
            let seam = Seam { law: Erased::<$d, false, true>::new($law), power: $power, side: |$q: [f64; $d]| $side };
            seam.beside(DiscreteGradient);
            seam.beside(Kanatani);
            // Where the force rises from the seam as a root, its slope there is infinite: corrections of the trapezoid may
            // then not lead to the end that it has.
            if seam.power <= 1.0 || seam.power >= 2.0 {
                seam.beside(Implicit);
            }
            seam.beside(Composed::order4(DiscreteGradient));
        }
    )*};
}

for_each_seam!(every_law);
