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
//! A branch that is not taken may be huge or no number: ω is then small, and what is not finite is left out. At an end so near to
//! the seam that rounding may put it on either side, both branches are added, with their difference there; what is computed of
//! such an end has the errors E of values.

use dmech_symbolic::expression::{Binary, Unary};

use super::jet::{of_integer_power, of_power, of_unary};
use super::tree::{Comparison, PARAMETERS, Test, Tree};

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
    /// The largest value on the way.
    pub largest: f64,
}

/// 0·∞ = 0: where nothing moves, no factor matters.
fn times(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 { 0.0 } else { x * y }
}

impl Scale {
    /// The figures of a law between a and b.
    pub fn of(tree: &Tree, a: &[f64], b: &[f64], step: &[f64]) -> Self {
        Analysis { a, b, step }.of(tree)
    }

    fn leaf(ends: [f64; 2], width: f64) -> Self {
        let largest = ends[0].abs().max(ends[1].abs());
        Self {
            ends,
            value_error: [0.0; 2],
            width,
            error: 0.0,
            crosses: false,
            doubtful: false,
            vertical: false,
            largest,
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

struct Analysis<'a> {
    a: &'a [f64],
    b: &'a [f64],
    step: &'a [f64],
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

fn of_function(u: &Scale, jet: &dyn Fn(f64) -> [f64; 3]) -> Scale {
    let value = |x: f64| jet(x)[0];
    let jets = u.ends.map(jet);
    let moves = [0, 1].map(|k| moved(&value, jets[k][1], u.ends[k], u.value_error[k]));
    let [a, b] = u.ends;
    let wobble = [0, 1].map(|k| u.value_error[k] + u.ends[k].abs());
    let gap = b - a;
    let (factor, factor_error) = if gap.abs() <= 1e-3 * (a.abs() + b.abs()) {
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
    // At the foot of a root, or so near to it that rounding may put it there.
    let at_foot = |k: usize| u.ends[k].abs() <= 8.0 * ROUNDING * u.value_error[k] && !jet(0.0)[1].is_finite();
    all.vertical |= jets.iter().any(|j| !j[1].is_finite()) || (0..2).any(at_foot);
    if all.doubtful {
        all.error += all.value_error[0] + all.value_error[1];
    }
    all
}

fn of_sum(u: &Scale, w: &Scale, sign: f64) -> Scale {
    let edges = [u, w].map(|child| Edge { child, factor: 1.0, factor_error: 0.0, moves: child.value_error });
    let mut sum = node([0, 1].map(|k| u.ends[k] + sign * w.ends[k]), &edges);
    for k in 0..2 {
        // Sums are added in an order of the engine's own.
        sum.value_error[k] += u.ends[k].abs() + w.ends[k].abs();
    }
    sum
}

fn of_product(u: &Scale, w: &Scale) -> Scale {
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
fn of_angle(u: &Scale, w: &Scale) -> Scale {
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

/// What a condition says at the two ends, and whether rounding may change it.
#[derive(Clone, Copy)]
struct Truth {
    holds: [bool; 2],
    certain: [bool; 2],
}

impl Truth {
    fn of(comparison: Comparison, left: &Scale, right: &Scale) -> Self {
        let holds = [0, 1].map(|k| comparison.holds(left.ends[k], right.ends[k]));
        let certain = [0, 1].map(|k| {
            let error = left.value_error[k] + right.value_error[k];
            (left.ends[k] - right.ends[k]).abs() > 8.0 * ROUNDING * error
        });
        Self { holds, certain }
    }

    /// Whether the ends may lie in different branches.
    fn apart(self) -> bool {
        self.holds[0] != self.holds[1] || self.certain != [true; 2]
    }

    /// One that decides alone, with this truth, makes the other irrelevant.
    fn joined(self, other: Self, alone: bool) -> Self {
        let both = |k: usize| if alone { self.holds[k] || other.holds[k] } else { self.holds[k] && other.holds[k] };
        let decides = |t: &Self, k: usize| t.certain[k] && t.holds[k] == alone;
        Self {
            holds: [0, 1].map(both),
            certain: [0, 1].map(|k| decides(&self, k) || decides(&other, k) || (self.certain[k] && other.certain[k])),
        }
    }
}

/// Where both ends lie in one branch, that branch; otherwise what the plain quotient loses.
fn of_choice(truth: Truth, yes: &Scale, no: &Scale) -> Scale {
    let taken = [0, 1].map(|k| if truth.holds[k] { yes } else { no });
    if !truth.apart() {
        return taken[0].clone();
    }
    let mut all = Scale::leaf([0, 1].map(|k| taken[k].ends[k]), 0.0);
    all.largest = taken[0].largest.max(taken[1].largest);
    all.crosses = truth.holds[0] != truth.holds[1] || taken.iter().any(|t| t.crosses);
    all.doubtful = truth.certain != [true; 2] || taken.iter().any(|t| t.doubtful);
    all.vertical = taken.iter().any(|t| t.vertical);
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
fn of_mixture(u: &Scale, w: &Scale, larger: bool) -> Option<(f64, f64)> {
    let gaps = [0, 1].map(|k| if larger { u.ends[k] - w.ends[k] } else { w.ends[k] - u.ends[k] });
    let total = gaps[0].abs() + gaps[1].abs();
    let toward_u = if total > 0.0 { (gaps[0].max(0.0) + gaps[1].max(0.0)) / total } else { 0.5 };
    // Of a branch with a vertical root its values.
    let part = |c: &Scale, figure: f64| if figure.is_finite() { figure } else { c.ends[0].abs() + c.ends[1].abs() };
    let width = times(toward_u, part(u, u.width)) + times(1.0 - toward_u, part(w, w.width));
    let inner = times(toward_u, part(u, u.error)) + times(1.0 - toward_u, part(w, w.error));
    let moved: f64 = (0..2)
        .map(|k| {
            let others = if total > 0.0 { 1.0 - gaps[k].abs() / total } else { 1.0 };
            times(others, u.value_error[k] + w.value_error[k] + gaps[k].abs())
        })
        .sum();
    let error = inner + 2.0 * width + moved;
    (width.is_finite() && error.is_finite()).then_some((width, error))
}

/// (u w)ⁿ as uⁿ wⁿ, as the engine multiplies powers; even ones through the absolute value.
fn distributed(tree: &Tree, n: i32) -> Option<[Tree; 2]> {
    let power = |t: &Tree, n: i32| Tree::Powi(t.clone().into(), n);
    match tree {
        Tree::Mul(u, w) => Some([power(u, n), power(w, n)]),
        Tree::Div(u, w) => Some([power(u, n), power(w, -n)]),
        Tree::Unary(Unary::Abs, u) if n % 2 == 0 => distributed(u, n),
        _ => None,
    }
}

impl Analysis<'_> {
    fn of(&self, tree: &Tree) -> Scale {
        let mut all = self.of_node(tree);
        let is_choice = matches!(
            tree,
            Tree::Unary(Unary::Abs, _)
                | Tree::Binary(Binary::Min | Binary::Max, ..)
                | Tree::Clamp(..)
                | Tree::Select(..)
        );
        if is_choice && (all.crosses || all.doubtful) {
            let way = self.way(tree);
            all.width += way;
            all.error += 2.0 * way;
        }
        all
    }

    fn of_node(&self, tree: &Tree) -> Scale {
        let of = |t: &Tree| self.of(t);
        match tree {
            Tree::Coordinate(i) => Scale::leaf([self.a[*i], self.b[*i]], self.step[*i].abs()),
            Tree::Parameter(i) => Scale::leaf([PARAMETERS[*i]; 2], 0.0),
            Tree::Number(x) => Scale::leaf([*x; 2], 0.0),
            Tree::Add(u, w) => of_sum(&of(u), &of(w), 1.0),
            Tree::Sub(u, w) => of_sum(&of(u), &of(w), -1.0),
            Tree::Mul(u, w) => of_product(&of(u), &of(w)),
            Tree::Div(u, w) => of_product(&of(u), &of_function(&of(w), &|x| of_integer_power(x, -1))),
            Tree::Powi(u, n) => {
                let mut all = of_function(&of(u), &|x| of_integer_power(x, *n));
                if let Some([one, other]) = distributed(u, *n) {
                    let product = of_product(&of(&one), &of(&other));
                    all.width += product.width;
                    all.error += product.error;
                }
                all
            }
            Tree::Unary(Unary::Abs, u) => {
                let u = of(u);
                let turned = Scale { ends: u.ends.map(|x| -x), ..u.clone() };
                self.of_extremum(u, turned, true)
            }
            Tree::Unary(f, u) => {
                let u = of(u);
                let mut all = of_function(&u, &|x| of_unary(*f, x));
                if (u.ends[1] - u.ends[0]).abs() > 1.0 {
                    all.error += match f {
                        // Where it saturates, the difference of two values that are nearly 1 is all there is.
                        Unary::Tanh => all.ends[0].abs() + all.ends[1].abs(),
                        // Of the mean of the arguments and of half their gap, both rounded.
                        Unary::Sin | Unary::Cos => u.ends[0].abs() + u.ends[1].abs(),
                        _ => 0.0,
                    };
                }
                all
            }
            Tree::Binary(Binary::Powf, u, w) => {
                let (u, w) = (of(u), of(w));
                if w.width == 0.0 && w.ends[0] == w.ends[1] {
                    let mut power = of_function(&u, &|x| of_power(x, w.ends[0]));
                    power.doubtful |= w.doubtful;
                    power.vertical |= w.vertical;
                    for k in 0..2 {
                        power.value_error[k] += times(times(power.ends[k], u.ends[k].ln()).abs(), w.value_error[k]);
                    }
                    return power;
                }
                let exponent = of_product(&w, &of_function(&u, &|x| of_unary(Unary::Ln, x)));
                of_function(&exponent, &|x| of_unary(Unary::Exp, x))
            }
            Tree::Binary(Binary::Atan2, u, w) => of_angle(&of(u), &of(w)),
            Tree::Binary(f, u, w) => self.of_extremum(of(u), of(w), *f == Binary::Max),
            Tree::Clamp(u, low, high) => {
                let raised = self.of_extremum(of(u), Scale::leaf([*low; 2], 0.0), true);
                self.of_extremum(raised, Scale::leaf([*high; 2], 0.0), false)
            }
            Tree::Hypot(u, w) => {
                let [u2, w2] = [u, w].map(|t| of_function(&of(t), &|x| of_integer_power(x, 2)));
                of_function(&of_sum(&u2, &w2, 1.0), &|x| of_unary(Unary::Sqrt, x))
            }
            Tree::Select(test, yes, no) => {
                let truth = self.truth(test);
                // The branch that neither end takes is not looked at.
                if !truth.apart() {
                    return of(if truth.holds[0] { yes } else { no });
                }
                let mut all = of_choice(truth, &of(yes), &of(no));
                if let Some((width, error)) = self.of_parts(test, yes, no, truth.holds) {
                    all.width += width;
                    all.error += error;
                }
                all
            }
        }
    }

    fn of_extremum(&self, u: Scale, w: Scale, larger: bool) -> Scale {
        let comparison = if larger { Comparison::AtLeast } else { Comparison::AtMost };
        let truth = Truth::of(comparison, &u, &w);
        let mut all = of_choice(truth, &u, &w);
        if truth.apart()
            && let Some((width, error)) = of_mixture(&u, &w, larger)
        {
            all.width += width;
            all.error += error;
        }
        all
    }

    /// The figures of a choice up to its seam and from there on, if they are finite.
    fn of_parts(&self, test: &Test, yes: &Tree, no: &Tree, holds: [bool; 2]) -> Option<(f64, f64)> {
        let seams = [self.a, self.b].map(|q| test.seam(q).abs());
        let total = seams[0] + seams[1];
        let share = if total > 0.0 { seams[0] / total } else { 0.5 };
        let at: Vec<f64> = self.a.iter().zip(self.b).map(|(a, b)| a + share * (b - a)).collect();
        let branch = |k: usize| if holds[k] { yes } else { no };
        let [up_to, from] = [(self.a, &at[..], share), (&at[..], self.b, 1.0 - share)];
        let part = |(a, b, share): (&[f64], &[f64], f64), tree: &Tree| {
            let step: Vec<f64> = self.step.iter().map(|s| share * s).collect();
            Scale::of(tree, a, b, &step)
        };
        let (up_to, from) = (part(up_to, branch(0)), part(from, branch(1)));
        let width = up_to.width + from.width;
        let error = up_to.error + from.error + width;
        (width.is_finite() && error.is_finite()).then_some((width, error))
    }

    /// How far the values on the line from a to b range.
    fn way(&self, tree: &Tree) -> f64 {
        let values = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| {
            let q: Vec<f64> = self.a.iter().zip(self.b).map(|(a, b)| a + share * (b - a)).collect();
            tree.value(&q)
        });
        let way: f64 = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        if way.is_finite() { way } else { 0.0 }
    }

    fn truth(&self, test: &Test) -> Truth {
        match test {
            Test::Compare(comparison, left, right) => Truth::of(*comparison, &self.of(left), &self.of(right)),
            Test::Not(inner) => {
                let Truth { holds, certain } = self.truth(inner);
                Truth { holds: holds.map(|h| !h), certain }
            }
            Test::And(one, two) => self.truth(one).joined(self.truth(two), false),
            Test::Or(one, two) => self.truth(one).joined(self.truth(two), true),
        }
    }
}
