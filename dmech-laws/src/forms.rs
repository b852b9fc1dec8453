//! Forms that a law may be rewritten in, the same in exact numbers and coarser in rounded ones.
//!
//! | written | rewritten | what the discrete gradient is made of, and the written form is not |
//! |---|---|---|
//! | (x y)² w (x y)^{3/2} | \|x\|^{7/2} \|y\|^{7/2} w | means of each factor: from 0·1 to 1·0 x y is 0 at both ends, and x² y² changes by ½ with x and by −½ with y |
//! | (if c { u } else { w })ⁿ, its root | if c { uⁿ } else { wⁿ } | the parts of the powers |
//! | if c { s + u } else { s + w } | s + if c { u } else { w } | the way of s, although it ends where it began |
//!
//! Which form is taken is the affair of the engine, which needs one for all that is equal; the figures of a law are those of
//! the coarser one.

use dmech_symbolic::expression::{Binary, Unary};

use super::scale::{Scale, times};
use super::tree::{Comparison, Test, Tree};

/// A factor with its exponent.
#[derive(Clone, Debug)]
pub(crate) struct Power<'a> {
    pub(crate) base: &'a Tree,
    pub(crate) exponent: f64,
}

/// The factors of a tree with their exponents. `taken` says which branch of a choice stands for it, if one does.
pub(crate) fn powers<'a>(tree: &'a Tree, taken: &dyn Fn(&'a Tree) -> Option<&'a Tree>) -> Vec<Power<'a>> {
    let mut found = vec![];
    gather(tree, 1.0, taken, &mut found);
    found.retain(|p: &Power<'_>| p.exponent != 0.0);
    found
}

/// Whether a node is a product or a power.
pub(crate) fn is_power(tree: &Tree) -> bool {
    match tree {
        Tree::Mul(..) | Tree::Div(..) | Tree::Powi(..) | Tree::Unary(Unary::Sqrt | Unary::Cbrt, _) => true,
        Tree::Binary(Binary::Powf, _, p) => constant(p).is_some(),
        _ => false,
    }
}

/// Whether the factors are others than those that the tree itself multiplies: a power went into a product, or was joined with
/// another of the same base.
pub(crate) fn is_regrouped(tree: &Tree, factors: &[Power<'_>]) -> bool {
    let plain = |t: &Tree, exponent: f64| factors.iter().any(|p| p.base == t && p.exponent == exponent);
    let own = match tree {
        Tree::Mul(u, w) => plain(u, 1.0) && plain(w, 1.0),
        Tree::Div(u, w) => plain(u, 1.0) && plain(w, -1.0),
        _ => factors.len() == 1,
    };
    !own
}

fn gather<'a>(tree: &'a Tree, exponent: f64, taken: &dyn Fn(&'a Tree) -> Option<&'a Tree>, found: &mut Vec<Power<'a>>) {
    match tree {
        Tree::Mul(u, w) => {
            gather(u, exponent, taken, found);
            gather(w, exponent, taken, found);
        }
        Tree::Div(u, w) => {
            gather(u, exponent, taken, found);
            gather(w, -exponent, taken, found);
        }
        Tree::Powi(u, n) => gather(u, exponent * f64::from(*n), taken, found),
        Tree::Unary(Unary::Sqrt, u) => gather(u, exponent / 2.0, taken, found),
        Tree::Unary(Unary::Cbrt, u) => gather(u, exponent / 3.0, taken, found),
        Tree::Unary(Unary::Abs, u) => gather(u, exponent, taken, found),
        Tree::Binary(Binary::Powf, u, p) => match constant(p) {
            Some(p) => gather(u, exponent * p, taken, found),
            None => join(tree, exponent, found),
        },
        _ => match taken(tree) {
            Some(branch) => gather(branch, exponent, taken, found),
            None => join(tree, exponent, found),
        },
    }
}

fn constant(p: &Tree) -> Option<f64> {
    match p {
        Tree::Number(p) => Some(*p),
        Tree::Div(above, below) => Some(constant(above)? / constant(below)?),
        _ => None,
    }
}

fn join<'a>(base: &'a Tree, exponent: f64, found: &mut Vec<Power<'a>>) {
    match found.iter_mut().find(|p| p.base == base) {
        Some(power) => power.exponent += exponent,
        None => found.push(Power { base, exponent }),
    }
}

/// Whether roots meet whose product is no smaller than what is below them: ∛(x² (x + x²)) is nearly x at 0, where the slope of
/// each root is infinite and its factor 0. That limit is seen only if x + x² is x (1 + x), which no normal form of sums shows.
pub(crate) fn roots_meet(tree: &Tree, q: &[f64]) -> bool {
    let mut meet = false;
    tree.visit(&mut |t| {
        if is_power(t) {
            let mut factors = powers(t, &|_| None);
            factors.retain(|p| p.exponent > 0.0 && p.base.value(q) == 0.0);
            let is_root = factors.iter().any(|p| p.exponent.fract() != 0.0);
            meet |= is_root && factors.len() > 1 && factors.iter().map(|p| p.exponent).sum::<f64>() < 1.0 + 1e-9;
        }
    });
    meet
}

/// W and S of a product with the figures of its factors, in whatever order they are multiplied.
pub(crate) fn of_factors(factors: &[Scale]) -> (f64, f64) {
    let mean = |c: &Scale| (c.ends[0].abs() + c.ends[1].abs()) / 2.0;
    let error = |c: &Scale| (c.value_error[0] + c.value_error[1]) / 2.0 + mean(c);
    let (mut width, mut total) = (0.0, 0.0);
    for (i, own) in factors.iter().enumerate() {
        let others = || factors.iter().enumerate().filter(move |&(j, _)| j != i).map(|(_, c)| c);
        let of_means: f64 = others().map(mean).product();
        let of_ends: f64 = (0..2).map(|k| others().map(|c| c.ends[k].abs()).product::<f64>()).sum::<f64>() / 2.0;
        let factor = of_means.max(of_ends);
        // One at a time is off by its error.
        let wobble: f64 = (0..factors.len())
            .filter(|&j| j != i)
            .map(|j| {
                let rest = factors.iter().enumerate().filter(|&(k, _)| k != i && k != j).map(|(_, c)| mean(c));
                times(rest.product(), error(&factors[j]))
            })
            .sum();
        width += times(factor, own.width);
        total += times(factor, own.error) + times(factor + wobble, own.width);
    }
    (width, total)
}

/// A power or root of a choice as the choice of the powers or roots.
pub(crate) fn within_branches(tree: &Tree) -> Option<Tree> {
    let (u, power): (_, &dyn Fn(Tree) -> Tree) = match tree {
        Tree::Powi(u, n) => (u, &|u| Tree::Powi(u.into(), *n)),
        Tree::Unary(f @ (Unary::Sqrt | Unary::Cbrt), u) => (u, &|u| Tree::Unary(*f, u.into())),
        Tree::Binary(Binary::Powf, u, p) => (u, &|u| Tree::Binary(Binary::Powf, u.into(), p.clone())),
        _ => return None,
    };
    let chosen =
        |test: Test, yes: &Tree, no: &Tree| Tree::Select(test, power(yes.clone()).into(), power(no.clone()).into());
    match &**u {
        Tree::Select(test, yes, no) => Some(chosen(test.clone(), yes, no)),
        Tree::Binary(f @ (Binary::Min | Binary::Max), u, w) => {
            let comparison = if *f == Binary::Min { Comparison::AtMost } else { Comparison::AtLeast };
            Some(chosen(Test::Compare(comparison, u.clone(), w.clone()), u, w))
        }
        _ => None,
    }
}

/// What both branches of an `if` have, and the choice between what is left of them.
pub(crate) fn shared_terms(tree: &Tree) -> Option<Tree> {
    let Tree::Select(test, yes, no) = tree else { return None };
    let (of_yes, of_no) = (terms(yes), terms(no));
    let (shared, own): (Vec<_>, Vec<_>) = of_yes.into_iter().partition(|term| of_no.contains(term));
    if shared.is_empty() {
        return None;
    }
    let others = of_no.into_iter().filter(|term| !shared.contains(term)).collect();
    let choice = Tree::Select(test.clone(), sum(own).into(), sum(others).into());
    Some(Tree::Add(sum(shared).into(), choice.into()))
}

/// A tree as a sum; which of its terms are subtracted.
fn terms(tree: &Tree) -> Vec<(bool, &Tree)> {
    let (u, w, turned) = match tree {
        Tree::Add(u, w) => (u, w, false),
        Tree::Sub(u, w) => (u, w, true),
        _ => return vec![(false, tree)],
    };
    let mut all = terms(u);
    all.extend(terms(w).into_iter().map(|(minus, t)| (minus != turned, t)));
    all
}

fn sum(terms: Vec<(bool, &Tree)>) -> Tree {
    let signed = |(minus, t): (bool, &Tree)| {
        if minus { Tree::Mul(Tree::Number(-1.0).into(), t.clone().into()) } else { t.clone() }
    };
    let all = terms.into_iter().map(signed);
    all.reduce(|sum, term| Tree::Add(sum.into(), term.into())).unwrap_or(Tree::Number(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::Tree::{Add, Coordinate, Mul, Number, Powi};

    fn x() -> Box<Tree> {
        Coordinate(0).into()
    }

    fn y() -> Box<Tree> {
        Coordinate(1).into()
    }

    /// (x y)² ∛(x y) x⁻² is x^{1/3} y^{7/3}.
    #[test]
    fn each_base_is_taken_once() {
        let product = || Mul(x(), y()).into();
        let powers_of_it = Mul(Powi(product(), 2).into(), Tree::Unary(Unary::Cbrt, product()).into());
        let law = Tree::Div(powers_of_it.into(), Powi(x(), 2).into());
        let found = powers(&law, &|_| None);
        let exponents: Vec<_> = found.iter().map(|p| (p.base.clone(), (3.0 * p.exponent).round())).collect();
        assert_eq!(exponents, [(*x(), 1.0), (*y(), 7.0)]);
        assert!(is_regrouped(&law, &found));
        let plain = Mul(x(), y());
        assert!(!is_regrouped(&plain, &powers(&plain, &|_| None)));
    }

    /// Between ends where x y is 0 and x² y² is made of changes of ±½ the figures are of that size; those of x y, which is
    /// computed as it is written, are not enlarged where neither factor is.
    #[test]
    fn figures_are_those_of_the_coarser_form() {
        let [a, b] = [[1.0, 0.0], [0.0, 1.0]];
        let step = [-1.0, 1.0];
        let squared = Powi(Mul(x(), y()).into(), 2);
        let error = Scale::of(&squared, &a, &b, &step).error;
        assert!(error > 0.9 && error < 20.0, "{error}");
        let of_y = Scale::of(&Powi(y(), 2), &[1.0, 1e-3], &[0.0, 2e-3], &step.map(|s| 1e-3 * s)).error;
        assert!(of_y < 1e-4, "{of_y}");
    }

    /// Only roots whose exponents add to 1 at most, and only where two different bases are 0.
    #[test]
    fn roots_meet_where_their_limit_is_hidden() {
        let other = Add(x(), Powi(x(), 2).into());
        let law = |n: i32| Tree::Unary(Unary::Cbrt, Mul(Powi(x(), n).into(), other.clone().into()).into());
        assert!(roots_meet(&law(2), &[0.0]));
        assert!(!roots_meet(&law(2), &[0.5]) && !roots_meet(&law(3), &[0.0]));
        assert!(!roots_meet(&Tree::Unary(Unary::Cbrt, x()), &[0.0]));
    }

    /// What both branches have is taken out; what is left is the same choice.
    #[test]
    fn shared_terms_are_no_choice() {
        let test = Test::Compare(Comparison::Less, x(), Number(0.0).into());
        let law = Tree::Select(test.clone(), y(), Add(y(), x()).into());
        let rest = Tree::Select(test, Number(0.0).into(), x());
        assert_eq!(shared_terms(&law), Some(Add(y(), rest.clone().into())));
        assert_eq!(shared_terms(&rest), None);
    }
}
