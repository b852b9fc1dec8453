//! How far rounding may move what is computed of a law: first-order error analysis, node by node, between two points.
//!
//! The figures belong to the law, not to the formulas that the engine chooses. With u one rounding, every node n carries
//!
//! - its values at the two ends and their errors E u:  E = |n| + Σ δ_c, where δ_c is what n moves when a child c moves by its
//!   own error: |∂n/∂c| E_c, or, where that error is not small beside c (√ near 0), the change itself;
//! - W = Σ |s_c| W_c, a bound of what the coordinates move it by, with the secant factors s_c = Δn/Δc, and W = |stepᵢ| at xᵢ;
//! - S u, the error of the sum Σ Gᵢ stepᵢ over its discrete gradient G:  S = Σ |s_c| S_c + (|s_c| + σ_c) W_c: what came from
//!   below, one rounding of the factor, and its change σ_c when the child's values, each rounded by itself, move.
//!
//! With step = b − a this is the scale of the secant identity; it vanishes with the gap. With b = a and step = the unit vector
//! of coordinate i it is the scale of ∂n/∂xᵢ.
//!
//! **Choices.** Where both ends lie in one branch the figures are that branch's. Across a seam no secant factor serves. What is
//! allowed there is what the plain quotient loses, S = E(a) + E(b) + |n(a)| + |n(b)| and W = |n(a)| + |n(b)|, each end in the
//! branch that it lies in, and what the way between the ends has, the straight line from a to b: how far the values range on it,
//! and
//!
//! - for `if`, the figures of each branch up to the seam and from there on;
//! - for `min` and `max` of u and w, with g = u − w, those of ω u + (1 − ω) w, ω = (gₐ⁺ + g_b⁺)/(|gₐ| + |g_b|) for the larger;
//!   an error of gₐ moves them by itself, one of g_b by itself, each less by its end's own share in |gₐ| + |g_b|.
//!
//! **Forms.** A law is tried as it was written and computed as it was rewritten. Where a rewritten form is coarser, the figures
//! are its own (see `forms`): products of powers take each base once, powers go into branches, what two branches share is no
//! choice.
//!
//! A branch that is not taken may be huge or no number: ω is then small, and what is not finite is left out. At an end so near to
//! the seam that rounding may put it on either side, both branches are added, with their difference there; what is computed of
//! such an end has the errors E of values.

/// One rounding, relative.
pub const ROUNDING: f64 = f64::EPSILON / 2.0;

/// The figures of a node.
#[derive(Clone, Debug)]
pub struct Scale {
    /// n(a), n(b).
    pub ends: [f64; 2],
    /// E.
    pub value_error: [f64; 2],
    /// W.
    pub width: f64,
    /// S.
    pub error: f64,
    /// Whether the ends lie in different branches of some choice.
    pub crosses: bool,
    /// Whether some end lies on a seam, or so near to it that rounding may put it on either side.
    pub doubtful: bool,
    /// Whether the argument of some root is 0 at an end.
    pub vertical: bool,
    /// Whether the step passes a place where two seams cross.
    pub corner: bool,
    /// Whether the argument of some sine is not known to a thousandth of a turn.
    pub unsettled: bool,
    /// The largest value on the way.
    pub largest: f64,
}

/// 0·∞ = 0: where nothing moves, no factor matters.
pub(crate) fn times(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 { 0.0 } else { x * y }
}

impl Scale {
    pub(crate) fn leaf(ends: [f64; 2], width: f64) -> Self {
        let largest = ends[0].abs().max(ends[1].abs());
        Self {
            ends,
            value_error: [0.0; 2],
            width,
            error: 0.0,
            crosses: false,
            doubtful: false,
            vertical: false,
            corner: false,
            unsettled: false,
            largest,
        }
    }

    /// The coarser of two figures, where the other is finite.
    pub(crate) fn coarsen(&mut self, (width, error): (f64, f64)) {
        if width.is_finite() && error.is_finite() {
            self.width = self.width.max(width);
            self.error = self.error.max(error);
        }
    }

    /// Whether all of it is a number, and nothing on the way was near to overflow.
    pub fn is_finite(&self) -> bool {
        self.largest < 1e100
            && [self.ends[0], self.ends[1], self.value_error[0], self.value_error[1], self.width, self.error]
                .iter()
                .all(|x| x.is_finite())
    }
}

/// A child with its factor in Δn = Σ s Δc, the change σ of that factor, and what its error moves n by at the ends.
struct Edge<'a> {
    child: &'a Scale,
    factor: f64,
    factor_error: f64,
    moves: [f64; 2],
}

fn node(ends: [f64; 2], edges: &[Edge<'_>]) -> Scale {
    let mut all = Scale::leaf(ends, 0.0);
    all.value_error = ends.map(f64::abs);
    for Edge { child, factor, factor_error, moves } in edges {
        for k in 0..2 {
            all.value_error[k] += moves[k];
        }
        all.width += times(factor.abs(), child.width);
        all.error += times(factor.abs(), child.error) + times(factor.abs() + factor_error, child.width);
        all.crosses |= child.crosses;
        all.doubtful |= child.doubtful;
        all.vertical |= child.vertical;
        all.corner |= child.corner;
        all.unsettled |= child.unsettled;
        all.largest = all.largest.max(child.largest);
    }
    all
}

/// How far `f` moves when x moves by e roundings, with its slope there.
fn moved(f: &dyn Fn(f64) -> f64, slope: f64, x: f64, e: f64) -> f64 {
    let e_absolute = ROUNDING * e;
    if e_absolute < 0.1 * x.abs() || e == 0.0 {
        return times(slope.abs(), e);
    }
    let change = |y: f64| (f(y) - f(x)).abs();
    change(x + e_absolute).max(change(x - e_absolute)) / ROUNDING
}

pub(crate) fn of_function(u: &Scale, jet: &dyn Fn(f64) -> [f64; 3]) -> Scale {
    let value = |x: f64| jet(x)[0];
    let jets = u.ends.map(jet);
    let moves = [0, 1].map(|k| moved(&value, jets[k][1], u.ends[k], u.value_error[k]));
    let [a, b] = u.ends;
    // Where an arcsine ends and nothing below is rounded, no formula rounds: √(1 − u²) is 0 there.
    let exact = |k: usize| u.value_error[k] == 0.0 && !jets[k][1].is_finite();
    let wobble = [0, 1].map(|k| if exact(k) { 0.0 } else { u.value_error[k] + u.ends[k].abs() });
    let gap = b - a;
    // The difference of the values is lost where they agree but for rounding, as those of e^u for u near 0 do.
    let straight = (0..2).all(|k| {
        let values = jets[0][0].abs() + jets[1][0].abs();
        (jets[1][0] - jets[0][0] - gap * jets[k][1]).abs() <= 4.0 * ROUNDING * values
    });
    let near = gap.abs() <= 1e-3 * (a.abs() + b.abs()) && jets.iter().all(|j| j[1].is_finite() || gap == 0.0);
    let (factor, factor_error) = if near || straight {
        let bend = (0..2).map(|k| moved(&|x| jet(x)[1], jets[k][2], u.ends[k], wobble[k]) / 2.0);
        (jets[0][1].abs().max(jets[1][1].abs()), bend.sum())
    } else {
        let s = (jets[1][0] - jets[0][0]) / gap;
        let change = (0..2).map(|k| {
            let small = ROUNDING * wobble[k] < 0.1 * u.ends[k].abs();
            if small || wobble[k] == 0.0 {
                times((s - jets[k][1]).abs(), wobble[k]) / gap.abs()
            } else {
                (s.abs() * wobble[k] + moved(&value, jets[k][1], u.ends[k], wobble[k])) / gap.abs()
            }
        });
        (s.abs(), change.sum())
    };
    let mut all = node(jets.map(|j| j[0]), &[Edge { child: u, factor, factor_error, moves }]);
    // At the foot of a root or where an arcsine ends, or so near to it that rounding may put it there.
    let at_foot = |k: usize| {
        let near = |foot: f64| (u.ends[k] - foot).abs() <= 8.0 * ROUNDING * u.value_error[k];
        [0.0, 1.0, -1.0].into_iter().any(|foot| near(foot) && !jet(foot)[1].is_finite())
    };
    all.vertical |= jets.iter().any(|j| !j[1].is_finite()) || (0..2).any(at_foot);
    if all.doubtful {
        all.error += all.value_error[0] + all.value_error[1];
    }
    all
}

pub(crate) fn of_sum(u: &Scale, w: &Scale, sign: f64) -> Scale {
    let edges = [u, w].map(|child| Edge { child, factor: 1.0, factor_error: 0.0, moves: child.value_error });
    let mut sum = node([0, 1].map(|k| u.ends[k] + sign * w.ends[k]), &edges);
    for k in 0..2 {
        // Sums are added in an order of the engine's own.
        sum.value_error[k] += u.ends[k].abs() + w.ends[k].abs();
    }
    sum
}

pub(crate) fn of_product(u: &Scale, w: &Scale) -> Scale {
    // Means of magnitudes: the engine may associate the factors otherwise.
    let mean = |c: &Scale| (c.ends[0].abs() + c.ends[1].abs()) / 2.0;
    let error = |c: &Scale| (c.value_error[0] + c.value_error[1]) / 2.0 + mean(c);
    let edge = |child, other: &Scale, its: &Scale| Edge {
        child,
        factor: mean(other),
        factor_error: error(other),
        moves: [0, 1].map(|k| {
            // To second order: both may be 0 but for rounding.
            times(other.ends[k].abs() + ROUNDING * other.value_error[k], its.value_error[k])
        }),
    };
    let mut product = node([0, 1].map(|k| u.ends[k] * w.ends[k]), &[edge(u, w, u), edge(w, u, w)]);
    if product.doubtful {
        product.error += product.value_error[0] + product.value_error[1];
    }
    product
}

/// The angle by its closed form K (mean(w) Δu − mean(u) Δw); how K moves is taken by differences.
pub(crate) fn of_angle(u: &Scale, w: &Scale) -> Scale {
    let ([ua, ub], [wa, wb]) = (u.ends, w.ends);
    let k = |[ua, ub, wa, wb]: [f64; 4]| {
        let (cross, dot) = (wa * ub - ua * wb, wa * wb + ua * ub);
        if cross.abs() < 1e-9 * dot { 1.0 / dot } else { cross.atan2(dot) / cross }
    };
    let at = [ua, ub, wa, wb];
    let errors = [u.value_error[0], u.value_error[1], w.value_error[0], w.value_error[1]];
    let value = k(at);
    let wobble = (0..4).fold(value.abs(), |sum, i| {
        let mut moved = at;
        let step = 1e-6 * (at[i].abs() + 1e-3);
        moved[i] += step;
        sum + ((k(moved) - value) / step).abs() * (errors[i] + at[i].abs())
    });
    let mean = |c: &Scale| (c.ends[0].abs() + c.ends[1].abs()) / 2.0;
    let error = |c: &Scale| (c.value_error[0] + c.value_error[1]) / 2.0 + mean(c);
    let r2 = [0, 1].map(|i| u.ends[i].powi(2) + w.ends[i].powi(2));
    let edges = [(u, w), (w, u)].map(|(child, other)| Edge {
        child,
        factor: mean(other) * value.abs(),
        factor_error: mean(other) * wobble + error(other) * value.abs(),
        moves: [0, 1].map(|i| times((other.ends[i] / r2[i]).abs(), child.value_error[i])),
    });
    node([0, 1].map(|i| u.ends[i].atan2(w.ends[i])), &edges)
}
