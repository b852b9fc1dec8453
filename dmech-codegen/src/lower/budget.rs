//! Bounds on the work of one law, so that no input makes the compiler hang.

use dmech_symbolic::expression::{Expr, Graph, Node, Unary};

use crate::diagnostics::body::Excess;

/// How many turns all loops together may take.
pub(super) const MAX_TURNS: usize = 10_000;
/// How many expressions may be stored on the way.
pub(super) const MAX_EXPRESSIONS: usize = 100_000;
/// How many pieces of code may be read, helpers anew at each call.
const MAX_STEPS: usize = 1_000_000;
/// How many terms and factors may be written, over all sums and products.
const MAX_TERMS: usize = 4_000_000;
/// How deep calls, blocks and brackets may be nested.
pub(super) const MAX_DEPTH: usize = 96;
/// How many expressions the finished potential may consist of: what is derived from it grows faster than it does.
pub(super) const MAX_SIZE: usize = 4000;
/// How deep sums, products and functions may be nested in it.
const MAX_HEIGHT: usize = 400;
/// How many functions may be applied to each other: f(f(f(…))).
const MAX_TOWER: usize = 24;
/// How many choices may depend on each other.
const MAX_CHOICES: usize = 6;
/// How large an integer exponent may become.
pub(super) const MAX_EXPONENT: i32 = 4096;
/// How many comparisons one condition may join.
pub(super) const MAX_COMPARISONS: usize = 200;

/// What has been used up.
#[derive(Default)]
pub(super) struct Budget {
    turns: usize,
    steps: usize,
    terms: usize,
    pub(super) depth: usize,
    /// Set once, when a bound is passed; then nothing more is read.
    pub(super) exhausted: bool,
}

/// The bound that a finished potential passes, if any.
pub(super) fn excess_of(graph: &Graph, potential: Expr) -> Option<Excess> {
    let order = graph.reachable(&[potential]);
    let mut heights = vec![[0; 3]; graph.len()];
    for &e in &order {
        let mut height = [0; 3];
        for child in graph.children(e) {
            for (highest, below) in height.iter_mut().zip(heights[child.index()]) {
                *highest = below.max(*highest);
            }
        }
        height[0] += 1;
        height[1] += usize::from(matches!(graph.node(e), Node::Unary(..) | Node::Binary(..) | Node::Select(..)));
        height[2] += match graph.node(e) {
            Node::Select(..) => 2,
            Node::Unary(Unary::Abs, _) => 1,
            Node::Binary(f, ..) if f.is_extremum() => 1,
            _ => 0,
        };
        heights[e.index()] = height;
    }
    let [height, tower, choices] = heights[potential.index()];
    match () {
        () if order.len() > MAX_SIZE => Some(Excess::Size),
        () if tower > MAX_TOWER => Some(Excess::Tower),
        () if choices > 2 * MAX_CHOICES => Some(Excess::Choices),
        () if height > MAX_HEIGHT => Some(Excess::Height),
        () => None,
    }
}

impl Budget {
    pub(super) fn step(&mut self) -> Option<Excess> {
        self.steps += 1;
        self.check(self.steps > MAX_STEPS, Excess::Steps)
    }

    pub(super) fn turns(&mut self, n: usize) -> Option<Excess> {
        self.turns = self.turns.saturating_add(n);
        self.check(self.turns > MAX_TURNS, Excess::Turns)
    }

    pub(super) fn expression(&mut self, stored: usize, terms: usize) -> Option<Excess> {
        self.terms += terms;
        self.check(stored > MAX_EXPRESSIONS, Excess::Expressions)
            .or_else(|| self.check(self.terms > MAX_TERMS, Excess::Terms))
    }

    fn check(&mut self, passed: bool, excess: Excess) -> Option<Excess> {
        (passed && !std::mem::replace(&mut self.exhausted, true)).then_some(excess)
    }
}
