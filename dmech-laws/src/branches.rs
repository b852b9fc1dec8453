//! The figures of choices: where both ends lie in one branch, and across the seam.

use super::scale::{ROUNDING, Scale, times};
use super::tree::Comparison;

/// What a condition says at the two ends, and whether rounding may change it.
#[derive(Clone, Copy)]
pub(crate) struct Truth {
    pub(crate) holds: [bool; 2],
    pub(crate) certain: [bool; 2],
}

impl Truth {
    pub(crate) fn of(comparison: Comparison, left: &Scale, right: &Scale) -> Self {
        let holds = [0, 1].map(|k| comparison.holds(left.ends[k], right.ends[k]));
        let certain = [0, 1].map(|k| {
            let error = left.value_error[k] + right.value_error[k];
            (left.ends[k] - right.ends[k]).abs() > 8.0 * ROUNDING * error
        });
        Self { holds, certain }
    }

    /// Whether the ends may lie in different branches.
    pub(crate) fn apart(self) -> bool {
        self.holds[0] != self.holds[1] || self.certain != [true; 2]
    }

    /// One that decides alone, with this truth, makes the other irrelevant.
    pub(crate) fn joined(self, other: Self, alone: bool) -> Self {
        let both = |k: usize| if alone { self.holds[k] || other.holds[k] } else { self.holds[k] && other.holds[k] };
        let decides = |t: &Self, k: usize| t.certain[k] && t.holds[k] == alone;
        Self {
            holds: [0, 1].map(both),
            certain: [0, 1].map(|k| decides(&self, k) || decides(&other, k) || (self.certain[k] && other.certain[k])),
        }
    }
}

/// Where both ends lie in one branch, that branch; otherwise what the plain quotient loses.
pub(crate) fn of_choice(truth: Truth, yes: &Scale, no: &Scale) -> Scale {
    let taken = [0, 1].map(|k| if truth.holds[k] { yes } else { no });
    if !truth.apart() {
        return taken[0].clone();
    }
    let mut all = Scale::leaf([0, 1].map(|k| taken[k].ends[k]), 0.0);
    all.largest = taken[0].largest.max(taken[1].largest);
    all.crosses = truth.holds[0] != truth.holds[1] || taken.iter().any(|t| t.crosses);
    all.doubtful = truth.certain != [true; 2] || taken.iter().any(|t| t.doubtful);
    all.vertical = taken.iter().any(|t| t.vertical);
    all.corner = taken.iter().any(|t| t.corner);
    all.unsettled = taken.iter().any(|t| t.unsettled);
    for k in 0..2 {
        all.value_error[k] = taken[k].value_error[k];
        if !truth.certain[k] {
            // Where 8 roundings decide, 8 may be off.
            let both = yes.value_error[k] + no.value_error[k];
            all.value_error[k] = 8.0 * both + (yes.ends[k] - no.ends[k]).abs() / ROUNDING;
        }
        all.width += all.ends[k].abs() + ROUNDING * all.value_error[k];
        all.error += all.ends[k].abs() + all.value_error[k];
    }
    if truth.holds[0] == truth.holds[1] {
        all.width += taken[0].width;
        all.error += taken[0].error;
    }
    all
}

/// The figures of ω u + (1 − ω) w between gaps g = u − w of different signs, if they are finite.
pub(crate) fn of_mixture(u: &Scale, w: &Scale, larger: bool) -> Option<(f64, f64)> {
    let gaps = [0, 1].map(|k| if larger { u.ends[k] - w.ends[k] } else { w.ends[k] - u.ends[k] });
    let total = gaps[0].abs() + gaps[1].abs();
    // Both without cancellation: the smaller one may belong to what is huge.
    let weight = |sign: f64| gaps.iter().map(|g| (sign * g).max(0.0)).sum::<f64>() / total;
    let (toward_u, toward_w) = if total > 0.0 { (weight(1.0), weight(-1.0)) } else { (0.5, 0.5) };
    // Of a branch with a vertical root its values.
    let part = |c: &Scale, figure: f64| if figure.is_finite() { figure } else { c.ends[0].abs() + c.ends[1].abs() };
    let width = times(toward_u, part(u, u.width)) + times(toward_w, part(w, w.width));
    let inner = times(toward_u, part(u, u.error)) + times(toward_w, part(w, w.error));
    let moved: f64 = (0..2)
        .map(|k| {
            let others = if total > 0.0 { gaps[1 - k].abs() / total } else { 1.0 };
            times(others, u.value_error[k] + w.value_error[k] + gaps[k].abs())
        })
        .sum();
    let error = inner + 2.0 * width + moved;
    (width.is_finite() && error.is_finite()).then_some((width, error))
}
