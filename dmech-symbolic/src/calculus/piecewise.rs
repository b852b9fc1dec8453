//! Discrete gradients of choices.
//!
//! A choice is taken as a function of its [gateways](super::gateways). Where both ends lie in one branch, it has that
//! branch's own form. Otherwise the seam lies between them, and the form must satisfy the secant identity and become that
//! of a branch as an end comes to the seam, or the equation of a step has no root there:
//!
//! - in one variable it is the plain quotient, which cannot cancel there;
//! - for `min`, `max` and `clamp` of u and w, with the gaps g = u − w at the ends, it is ω ∇̄u + (1 − ω) ∇̄w with
//!   ω = (gₐ⁺ + g_b⁺)/(|gₐ| + |g_b|) for the larger: max = (u + w)/2 + |u − w|/2;
//! - for `if` the step is cut where the seam is crossed, at p = a + λ (b − a) with λ = cₐ/(cₐ − c_b), where c is 0 on
//!   the seam: λ ∇̄yes(a, p) + (1 − λ) ∇̄no(p, b) if the condition holds at a. Where the seam is curved, the rest of the
//!   rise goes along b − a, as in Gonzalez' correction (J. Nonlinear Sci. 6 (1996) 449). Terms that both branches have are
//!   no choice: they have their own form, and need not be finite where the seam is crossed.

use std::rc::Rc;

use crate::expression::{Binary, Choice, Condition, Expr, Graph, Node, Relation, Substitution, Symbol, Unary};

use super::discrete_gradient::{TwoPoints, discrete_gradient};
use super::divided_difference::or_zero;
use super::gateways::Gateways;

/// A choice between two ends of the step: what its discrete gradient is made of, for each gateway.
pub(super) struct Placed {
    at_a: Condition,
    at_b: Condition,
    /// Where the condition holds at both ends; at neither; at one of them.
    forms: Vec<[Expr; 3]>,
    /// The discrete gradient of the gateway itself.
    toward: Vec<Vec<Expr>>,
}

/// `adjoint`·∇̄e of a choice e, one component for each coordinate.
///
/// The adjoint is multiplied within the branches: where one does not depend on the coordinates, 0·∞ must not arise.
pub(super) fn shares(graph: &mut Graph, e: Expr, adjoint: Expr, ends: &mut TwoPoints) -> Vec<Expr> {
    let placed = match ends.choices.get(&e) {
        Some(placed) => placed.clone(),
        None => {
            let placed = Rc::new(Placed::new(graph, e, ends));
            ends.choices.insert(e, placed.clone());
            placed
        }
    };
    let Placed { at_a, at_b, forms, toward } = &*placed;
    let mut found = vec![graph.zero(); ends.coordinates.len()];
    for (form, toward) in forms.iter().zip(toward) {
        let [yes, no, across] = form.map(|secant| graph.mul_within(adjoint, secant));
        let not_both = graph.select(at_a.clone().or(at_b.clone()), across, no);
        let share = graph.select(at_a.clone().and(at_b.clone()), yes, not_both);
        for (sum, &toward) in found.iter_mut().zip(toward) {
            let summand = graph.mul_within(toward, share);
            *sum = graph.add(&[*sum, summand]);
        }
    }
    found
}

impl Placed {
    fn new(graph: &mut Graph, e: Expr, ends: &mut TwoPoints) -> Self {
        let (shared, e) = graph.shared_terms(e);
        let choice = graph.choice(e).expect("a choice, and without what its branches share still one");
        let mut gateways = Gateways::of(graph, e, &choice, &ends.coordinates);
        let forms = Inside::new(graph, e, choice, &mut gateways).forms(graph);
        let mut pairs = vec![];
        for (k, &u) in gateways.inner.iter().enumerate() {
            let (at_a, at_b) = ends.values(graph, u);
            pairs.extend([(forms.a[k], at_a), (forms.b[k], at_b)]);
        }
        let mut place = Substitution::new(graph, pairs);
        let [at_a, at_b] = [&forms.at_a, &forms.at_b].map(|c| c.map(&mut |e| place.apply(graph, e)));
        let all = [forms.yes, forms.no, forms.across];
        let mut forms: Vec<_> =
            (0..gateways.inner.len()).map(|k| [0, 1, 2].map(|i| place.apply(graph, all[i][k]))).collect();
        let mut inner = gateways.inner;
        if let Some(shared) = shared {
            forms.push([graph.one(); 3]);
            inner.push(shared);
        }
        let toward = inner.iter().map(|&u| discrete_gradient(graph, u, ends)).collect();
        Self { at_a, at_b, forms, toward }
    }
}

/// A choice in the variables of its gateways.
struct Inside {
    choice: Choice,
    whole: Expr,
    /// It is the smaller or the larger of the two.
    extremum: bool,
    ends: TwoPoints,
}

/// Its discrete gradient between the ends a and b, component by component.
struct Forms {
    a: Vec<Symbol>,
    b: Vec<Symbol>,
    at_a: Condition,
    at_b: Condition,
    /// Where the condition holds at both ends,
    yes: Vec<Expr>,
    /// at neither,
    no: Vec<Expr>,
    /// at one of them.
    across: Vec<Expr>,
}

impl Inside {
    fn new(graph: &mut Graph, e: Expr, choice: Choice, gateways: &mut Gateways) -> Self {
        let mut inside = |e: Expr| gateways.inside(graph, e);
        let choice =
            Choice { condition: choice.condition.map(&mut inside), yes: inside(choice.yes), no: inside(choice.no) };
        let whole = inside(e);
        let extremum = matches!(graph.node(e), Node::Binary(f, ..) if f.is_extremum());
        let [a, b] = ["ua", "ub"].map(|end| gateways.at_end(graph, end));
        let ends = TwoPoints::new(graph, &gateways.symbols, &a, &b);
        Self { choice, whole, extremum, ends }
    }

    fn forms(mut self, graph: &mut Graph) -> Forms {
        let (at_a, at_b) = self.ends.conditions(graph, &self.choice.condition);
        let yes = discrete_gradient(graph, self.choice.yes, &mut self.ends);
        let no = discrete_gradient(graph, self.choice.no, &mut self.ends);
        let [a, b] = [self.ends.a.clone(), self.ends.b.clone()];
        let across = match a[..] {
            [_] => vec![self.quotient(graph)],
            _ if self.extremum => self.mixed(graph, &yes, &no),
            _ => self.cut(graph, &yes, &no, &at_a),
        };
        Forms { a, b, at_a, at_b, yes, no, across }
    }

    /// (Φ(b) − Φ(a))/(b − a) in the one variable.
    fn quotient(&mut self, graph: &mut Graph) -> Expr {
        let (value_a, value_b) = self.ends.values(graph, self.whole);
        let rise = graph.sub(value_b, value_a);
        let [a, b] = [self.ends.a[0], self.ends.b[0]].map(|end| graph.symbol(end));
        let run = graph.sub(b, a);
        or_zero(graph, rise, run)
    }

    /// ω ∇̄yes + (1 − ω) ∇̄no, both weights without cancellation.
    fn mixed(&mut self, graph: &mut Graph, yes: &[Expr], no: &[Expr]) -> Vec<Expr> {
        let seam = seam(graph, &self.choice.condition);
        let (gap_a, gap_b) = self.ends.values(graph, seam);
        let zero = graph.zero();
        // The seam is negative where the condition holds.
        let mut outside = |gap: Expr| graph.binary(Binary::Max, gap, zero);
        let toward_no = [outside(gap_a), outside(gap_b)];
        let opposite = [graph.neg(gap_a), graph.neg(gap_b)];
        let mut inside = |gap: Expr| graph.binary(Binary::Max, gap, zero);
        let toward_yes = [inside(opposite[0]), inside(opposite[1])];
        let (toward_yes, toward_no) = (graph.add(&toward_yes), graph.add(&toward_no));
        let total = graph.add(&[toward_yes, toward_no]);
        let weights = [toward_yes, toward_no].map(|part| or_zero(graph, part, total));
        yes.iter().zip(no).map(|(&yes, &no)| mixture(graph, weights, yes, no)).collect()
    }

    /// λ ∇̄yes(y, p) + (1 − λ) ∇̄no(p, n), and along n − y what is missing of the rise, between the end y where the condition
    /// holds and the end n where it does not: whichever is called a, the same numbers are computed.
    fn cut(&mut self, graph: &mut Graph, yes: &[Expr], no: &[Expr], at_a: &Condition) -> Vec<Expr> {
        let [a, b] = [self.ends.a.clone(), self.ends.b.clone()].map(|end| graph.symbols(&end));
        let chosen = |graph: &mut Graph, one: &[Expr], other: &[Expr]| -> Vec<Expr> {
            one.iter().zip(other).map(|(&one, &other)| graph.select(at_a.clone(), one, other)).collect()
        };
        let (inner, outer) = (chosen(graph, &a, &b), chosen(graph, &b, &a));
        let coordinates = self.ends.coordinates.clone();
        let mut at_inner = Substitution::new(graph, coordinates.iter().copied().zip(inner.iter().copied()));
        let mut at_outer = Substitution::new(graph, coordinates.iter().copied().zip(outer.iter().copied()));

        let seam = seam(graph, &self.choice.condition);
        let (below, above) = (at_inner.apply(graph, seam), at_outer.apply(graph, seam));
        let width = graph.sub(above, below);
        let below = graph.neg(below);
        let weights = [or_zero(graph, below, width), or_zero(graph, above, width)];
        let crossing: Vec<_> = inner.iter().zip(&outer).map(|(&y, &n)| mixture(graph, weights, n, y)).collect();
        let mut within = Substitution::new(graph, self.places(&inner, &crossing));
        let mut beyond = Substitution::new(graph, self.places(&crossing, &outer));
        let pieces: Vec<_> = yes
            .iter()
            .zip(no)
            .map(|(&yes, &no)| {
                let (before, after) = (within.apply(graph, yes), beyond.apply(graph, no));
                mixture(graph, weights, before, after)
            })
            .collect();
        let gaps: Vec<_> = inner.iter().zip(&outer).map(|(&y, &n)| graph.sub(n, y)).collect();
        let along: Vec<_> = pieces.iter().zip(&gaps).map(|(&piece, &gap)| graph.mul(&[piece, gap])).collect();
        let squares: Vec<_> = gaps.iter().map(|&gap| graph.square(gap)).collect();
        let (along, length2) = (graph.add(&along), graph.add(&squares));
        let (start, end) = (at_inner.apply(graph, self.choice.yes), at_outer.apply(graph, self.choice.no));
        let rise = graph.sub(end, start);
        let missing = graph.sub(rise, along);
        let missing = or_zero(graph, missing, length2);
        pieces
            .iter()
            .zip(&gaps)
            .map(|(&piece, &gap)| {
                let correction = graph.mul(&[missing, gap]);
                graph.add(&[piece, correction])
            })
            .collect()
    }

    /// What the ends are replaced by.
    fn places(&self, a: &[Expr], b: &[Expr]) -> Vec<(Symbol, Expr)> {
        let (at_a, at_b) = (self.ends.a.iter().zip(a), self.ends.b.iter().zip(b));
        at_a.chain(at_b).map(|(&symbol, &place)| (symbol, place)).collect()
    }
}

/// w₀ x + w₁ y, where what has no weight need not be finite.
fn mixture(graph: &mut Graph, weights: [Expr; 2], x: Expr, y: Expr) -> Expr {
    let zero = graph.zero();
    let parts = [(weights[0], x), (weights[1], y)].map(|(weight, x)| {
        let part = graph.mul(&[weight, x]);
        graph.select(Condition::equal(weight, zero), zero, part)
    });
    graph.add(&parts)
}

/// A function that is negative where the condition holds, positive where it does not, and 0 on the seam between.
///
/// Twice the difference of the sides: a [tangent](super::tangent) of a distance at the centre is then 0.
fn seam(graph: &mut Graph, condition: &Condition) -> Expr {
    match condition {
        Condition::Compare(Relation::Less | Relation::LessOrEqual, left, right) => {
            let (left, right) = (graph.scale(2.0, *left), graph.scale(2.0, *right));
            graph.sub(left, right)
        }
        Condition::Compare(Relation::Equal, left, right) => {
            let gap = graph.sub(*left, *right);
            graph.unary(Unary::Abs, gap)
        }
        Condition::Not(inner) => {
            let inner = seam(graph, inner);
            graph.neg(inner)
        }
        Condition::And(one, two) | Condition::Or(one, two) => {
            let (one, two) = (seam(graph, one), seam(graph, two));
            let both = matches!(condition, Condition::And(..));
            graph.binary(if both { Binary::Max } else { Binary::Min }, one, two)
        }
    }
}
