//! Whether the potential of a law with choices is continuous: at a jump the force has no size, and no scheme steps it.

use core::array::from_fn;

use dmech_core::extend::vector::{difference, dot};
use dmech_core::{Explicit, Interrupted, Law, Potential, Simulation};

use super::derivatives::{ULPS, floor};
use super::keeps::PER_TIME;
use super::points::{Dice, norm};
use super::report::Check;
use super::{Borrowed, Subject};

/// Straight lines around the start, as many along the motion, and parts of each.
const LINES: usize = 64;
const PARTS: usize = 64;
/// Halvings of a part, to where its ends are neighbours.
const HALVINGS: i32 = 60;

const NAME: &str = "continuity";

pub(super) fn check<L: Law<D>, const D: usize>(subject: &Subject<L, D>, checks: &mut Vec<Check>) {
    let Subject { law, start, mass, scales } = subject;
    if !<L::Field<'_> as Potential<D>>::PIECEWISE {
        return;
    }
    let field = law.field(*mass, start.t);
    let (mut dice, moves) = (Dice::new(), subject.moves());
    let mut largest: Option<Jump<D>> = None;
    let around = (0..LINES).map(|_| [(); 2].map(|()| dice.near(start.q, moves, 2.5 * scales.length)));
    for [a, b] in around.chain(subject.chords()) {
        let line = Line { subject, field: &field, a, b };
        for part in line.uneven_parts() {
            let jump = line.jump_within(part);
            if largest.as_ref().is_none_or(|largest| jump.units > largest.units) {
                largest = Some(jump);
            }
        }
    }
    let Some(jump) = largest else {
        checks.push(Check::not_applicable(NAME, "the potential is not finite around the start"));
        return;
    };
    let note = if jump.units > ULPS {
        format!("the potential jumps by {:.3e} at q = {:.5?}: no scheme can step that", jump.height, jump.place)
    } else {
        "the largest jump of the potential, in units of rounding".to_owned()
    };
    checks.push(Check::at_most(NAME, jump.units, ULPS, note));
}

impl<L: Law<D>, const D: usize> Subject<L, D> {
    /// Along the motion, which may lead beyond what lies around the start. Of the schemes for every law the explicit formulas solve no
    /// equation, which at a jump may have no solution.
    fn chords(&self) -> Vec<[[f64; D]; 2]> {
        const STEPS: u64 = 32;
        let Subject { law, start, mass, scales } = self;
        let motion = Simulation::new(Borrowed(law), *start).mass(*mass).scheme(Explicit).dt(scales.time / PER_TIME);
        let run = motion.record_every(STEPS).run(STEPS * LINES as u64).unwrap_or_else(Interrupted::into_run);
        run.states().windows(2).map(|ends| [ends[0].q, ends[1].q]).filter(|[a, b]| a != b).collect()
    }
}

struct Jump<const D: usize> {
    /// Its height over a unit of rounding and what the potential rises by beside it.
    units: f64,
    height: f64,
    place: [f64; D],
}

/// The potential along a line, from 0 at a to 1 at b.
struct Line<'f, L, F, const D: usize> {
    subject: &'f Subject<L, D>,
    field: &'f F,
    a: [f64; D],
    b: [f64; D],
}

impl<L: Law<D>, F: Potential<D>, const D: usize> Line<'_, L, F, D> {
    fn place(&self, s: f64) -> [f64; D] {
        from_fn(|i| self.a[i] + s * (self.b[i] - self.a[i]))
    }

    fn potential(&self, s: f64) -> f64 {
        self.field.potential(self.place(s))
    }

    fn gradient(&self, s: f64) -> [f64; D] {
        self.subject.weighted(self.field.gradient(self.place(s)))
    }

    /// By how much the potential rises otherwise than its first and second derivatives at the ends say.
    fn excess(&self, [left, right]: [f64; 2]) -> f64 {
        let way = difference(self.b, self.a);
        let slopes = [left, right].map(|s| dot(self.gradient(s), way));
        let bends = [left, right].map(|s| {
            let hessian = self.field.hessian(self.place(s));
            dot(self.subject.weighted(hessian.map(|row| dot(row, way))), way)
        });
        let (rise, width) = (self.potential(right) - self.potential(left), right - left);
        let smooth = width * (0.5 * (slopes[0] + slopes[1]) - width * (bends[1] - bends[0]) / 12.0);
        let excess = (rise - smooth).abs();
        if excess.is_finite() { excess } else { 0.0 }
    }

    /// The parts with the largest excess, a few of each line.
    fn uneven_parts(&self) -> Vec<[f64; 2]> {
        let ends = |i: usize| [i as f64 / PARTS as f64, (i + 1) as f64 / PARTS as f64];
        let finite = |ends: &[f64; 2]| ends.iter().all(|&s| self.potential(s).is_finite());
        let mut parts: Vec<_> = (0..PARTS).map(ends).filter(finite).map(|part| (self.excess(part), part)).collect();
        parts.sort_by(|(one, _), (two, _)| two.total_cmp(one));
        parts.into_iter().take(3).map(|(_, part)| part).collect()
    }

    /// Halves a part again and again, and compares what is left of its rise with those on both sides.
    fn jump_within(&self, [mut left, mut right]: [f64; 2]) -> Jump<D> {
        let width = right - left;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (left + right);
            if middle <= left || middle >= right {
                break;
            }
            if self.excess([left, middle]) > self.excess([middle, right]) {
                right = middle;
            } else {
                left = middle;
            }
        }
        let height = (self.potential(right) - self.potential(left)).abs();
        // Beside a pole the potential rises too, and where it is steep: at a jump it does not.
        let away = 1e-9 * width;
        let beside =
            [(left, -away), (right, away)].map(|(s, away)| (self.potential(s + away) - self.potential(s)).abs());
        let place = self.place(left);
        let steepness = norm(self.gradient(left)).max(norm(self.gradient(right)));
        let size = floor(self.potential(left).abs() + self.potential(right).abs(), steepness * norm(place));
        let units = height / (f64::EPSILON * size + beside[0] + beside[1]);
        Jump { units: if units.is_finite() { units } else { 0.0 }, height, place }
    }
}
