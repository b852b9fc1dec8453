//! Bounds on the work of one law, so that no input makes the compiler hang.

/// How many turns all loops together may take.
pub(super) const MAX_TURNS: usize = 10_000;
/// How many expressions the law may consist of.
pub(super) const MAX_EXPRESSIONS: usize = 100_000;
/// How many pieces of code may be read, helpers anew at each call.
const MAX_STEPS: usize = 1_000_000;
/// How many terms and factors may be written, over all sums and products.
const MAX_TERMS: usize = 4_000_000;
/// How deep calls, blocks and brackets may be nested.
pub(super) const MAX_DEPTH: usize = 96;
/// How deep the finished expression may be nested: f(f(f(…))).
pub(super) const MAX_EXPRESSION_DEPTH: usize = 400;
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

/// Which bound was passed.
#[derive(Clone, Copy)]
pub(crate) enum Excess {
    Turns,
    Expressions,
    Steps,
    Terms,
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
