//! Every rewriting rule of expressions: what comes out, and that it means the same on the rule's domain.

use crate::common::U;
use crate::common::evaluate::evaluate;
use crate::common::notation::{E, choose, within};
use dmech_symbolic::expression::{Binary, Graph, Unary};

/// A rule: spellings that must become one expression, its display, the meaning of the first spelling, its domain.
struct Rule {
    spellings: Vec<fn([E; 3]) -> E>,
    shown: &'static str,
    plain: fn([f64; 3]) -> f64,
    domain: fn([f64; 3]) -> bool,
}

fn rule(shown: &'static str, plain: fn([f64; 3]) -> f64, spellings: Vec<fn([E; 3]) -> E>) -> Rule {
    Rule { spellings, shown, plain, domain: |_| true }
}

impl Rule {
    fn on(mut self, domain: fn([f64; 3]) -> bool) -> Self {
        self.domain = domain;
        self
    }
}

/// Spellings that are one expression, shown and valued as said, at all points of the domain, zeros and signs included.
fn check(rules: Vec<Rule>) {
    let points = [-3.7, -1.0, -0.4, 0.0, 0.3, 1.0, 2.6];
    for rule in rules {
        let mut graph = Graph::new();
        let names = ["x", "y", "z"].map(|name| graph.coordinate(name));
        let symbols = names.map(|s| E(graph.symbol(s)));
        let forms =
            within(&mut graph, || rule.spellings.iter().map(|spelling| spelling(symbols).0).collect::<Vec<_>>());
        for &form in &forms {
            assert_eq!(form, forms[0], "{} and {}", graph.display(form), graph.display(forms[0]));
        }
        assert_eq!(graph.display(forms[0]).to_string(), rule.shown);
        let grid = points.iter().flat_map(|&x| points.iter().flat_map(move |&y| points.map(|z| [x, y, z])));
        let mut tried = 0;
        for at in grid.filter(|&at| (rule.domain)(at)) {
            let value =
                evaluate(&graph, &forms[..1], &|s| at[names.iter().position(|&n| n == s).expect("x, y or z")])[0];
            let plain = (rule.plain)(at);
            let scale = plain.abs() + at.iter().map(|x| x.abs()).sum::<f64>();
            assert!((value - plain).abs() <= 16.0 * U * scale, "{} at {at:?}: {value} for {plain}", rule.shown);
            tried += 1;
        }
        assert!(tried >= 7, "{}: {tried} points", rule.shown);
    }
}

fn number(x: f64) -> E {
    E::from(x)
}

#[test]
fn sums() {
    check(vec![
        // (a + b) + c = a + b + c, sorted
        rule(
            "x + y + z",
            |[x, y, z]| (x + y) + z,
            vec![|[x, y, z]| (x + y) + z, |[x, y, z]| x + (z + y), |[x, y, z]| (y + z) + x],
        ),
        // −(a + b) = −a − b inside a sum
        rule(
            "z − x − y",
            |[x, y, z]| z - (x + y),
            vec![|[x, y, z]| z - (x + y), |[x, y, z]| (-x + z) + -y, |[x, y, z]| -((x - z) + y)],
        ),
        // c t + d t = (c + d) t …
        rule("5·x", |[x, ..]| 2.0 * x + 3.0 * x, vec![|[x, ..]| 2.0 * x + 3.0 * x, |[x, ..]| x + x + x + x + x]),
        rule("x", |[x, y, _]| (x + y) - y, vec![|[x, y, _]| (x + y) - y, |[x, ..]| 0.75 * x + 0.25 * x]),
        // … but only where c + d is exact
        rule("0.1·x + 0.2·x", |[x, ..]| 0.1 * x + 0.2 * x, vec![|[x, ..]| 0.1 * x + 0.2 * x]),
        // 0 + a = a, 0·t = 0, constants
        rule("x", |[x, ..]| 0.0 + x, vec![|[x, ..]| 0.0 + x, |[x, ..]| x - 0.0]),
        rule("0", |[x, ..]| x - x, vec![|[x, ..]| x - x, |[x, ..]| 0.0 * x, |_| number(0.0)]),
        rule("x + 3.5", |[x, ..]| (3.0 + x) + 0.5, vec![|[x, ..]| (3.0 + x) + 0.5, |[x, ..]| x + 4.0 - 0.5]),
        // Numbers that have no exact sum stay side by side, whatever order they came in.
        rule(
            "x + 0.1 + 0.7",
            |[x, ..]| (x + 0.1) + 0.7,
            vec![|[x, ..]| (x + 0.1) + 0.7, |[x, ..]| 0.7 + (0.1 + x), |[x, ..]| (number(0.7) + 0.1) + x],
        ),
        // Nothing is multiplied out, either way.
        rule("3·(x + y)", |[x, y, _]| 3.0 * (x + y), vec![|[x, y, _]| 3.0 * (x + y)]),
        rule("3·x + 3·y", |[x, y, _]| 3.0 * x + 3.0 * y, vec![|[x, y, _]| 3.0 * x + 3.0 * y]),
    ]);
}

#[test]
fn products() {
    check(vec![
        // (a b) c = a b c, sorted; a^m a^n = a^(m+n)
        rule("x·y·z", |[x, y, z]| (x * y) * z, vec![|[x, y, z]| (x * y) * z, |[x, y, z]| y * (z * x)]),
        rule("x⁵", |[x, ..]| x.powi(5), vec![|[x, ..]| x.powi(2) * x.powi(3), |[x, ..]| x.powi(7) / (x * x)])
            .on(|[x, ..]| x != 0.0),
        rule("1", |[x, ..]| x / x, vec![|[x, ..]| x / x, |[x, ..]| x.powi(0)]).on(|[x, ..]| x != 0.0),
        // (a b)^n = a^n b^n
        rule("x³·y³", |[x, y, _]| (x * y).powi(3), vec![|[x, y, _]| (x * y).powi(3)]),
        rule("0.25/(x²·y²)", |[x, y, _]| 1.0 / (2.0 * x * y).powi(2), vec![|[x, y, _]| (2.0 * x * y).powi(-2)])
            .on(|[x, y, _]| x != 0.0 && y != 0.0),
        // (√s)² = s, s^k √s^n = √s^(2k+n)
        rule("x", |[x, ..]| x.sqrt() * x.sqrt(), vec![|[x, ..]| x.sqrt() * x.sqrt()]).on(|[x, ..]| x >= 0.0),
        rule(
            "(√x)³",
            |[x, ..]| x * x.sqrt(),
            vec![|[x, ..]| x * x.sqrt(), |[x, ..]| x.sqrt().powi(3), |[x, ..]| x.powi(2) / x.sqrt()],
        )
        .on(|[x, ..]| x > 0.0),
        rule("1/(√x)³", |[x, ..]| x.powf(-1.5), vec![|[x, ..]| 1.0 / (x * x.sqrt()), |[x, ..]| x.sqrt() / x.powi(2)])
            .on(|[x, ..]| x > 0.0),
        // (∛u)³ = u, |u|² = u²
        rule("x", |[x, ..]| x.cbrt().powi(3), vec![|[x, ..]| x.cbrt().powi(3), |[x, ..]| x.cbrt() * x.cbrt().powi(2)]),
        rule("x²", |[x, ..]| x.abs() * x.abs(), vec![|[x, ..]| x.abs() * x.abs(), |[x, ..]| x.abs().powi(2)]),
        // (−a − b)^n = (−1)^n (a + b)^n
        rule("(x − y)²", |[x, y, _]| (y - x).powi(2), vec![|[x, y, _]| (x - y).powi(2), |[x, y, _]| (y - x).powi(2)]),
        rule("−(x + y)³", |[x, y, _]| (-x - y).powi(3), vec![|[x, y, _]| (-x - y).powi(3)]),
        rule("y − x", |[x, y, _]| -(x - y), vec![|[x, y, _]| -(x - y), |[x, y, _]| y - x]),
        // (c/d) a = e a where e = c/d is exact; 0·a = 0
        rule("2·x", |[x, ..]| 6.0 * x / 3.0, vec![|[x, ..]| 6.0 * x / 3.0, |[x, ..]| 3.0 * (x / 3.0) * 2.0]),
        rule("x/3", |[x, ..]| x / 3.0, vec![|[x, ..]| x / 3.0]),
        rule("0", |[x, y, _]| x * 0.0 * y, vec![|[x, y, _]| x * 0.0 * y]),
        // Numbers that have no exact product stay side by side, whatever order they came in.
        rule(
            "0.3·0.1·x",
            |[x, ..]| 0.1 * (0.3 * x),
            vec![|[x, ..]| 0.1 * (0.3 * x), |[x, ..]| 0.3 * (0.1 * x), |[x, ..]| (number(0.3) * 0.1) * x],
        ),
    ]);
}

#[test]
fn functions() {
    let positive: fn([f64; 3]) -> bool = |[x, ..]| x > 0.0;
    check(vec![
        // √(u²) = |u|
        rule("|x|", |[x, ..]| (x * x).sqrt(), vec![|[x, ..]| (x * x).sqrt()]),
        rule(
            "1.5·y²·|x|",
            |[x, y, _]| (2.25 * x * x * y.powi(4)).sqrt(),
            vec![|[x, y, _]| (2.25 * x.powi(2) * y.powi(4)).sqrt()],
        ),
        rule("√2·|x|", |[x, ..]| (2.0 * x * x).sqrt(), vec![|[x, ..]| (2.0 * x * x).sqrt()]),
        rule(
            "1/|x|",
            |[x, ..]| (1.0 / (x * x)).sqrt(),
            vec![|[x, ..]| x.powi(-2).sqrt(), |[x, ..]| (1.0 / (x * x)).sqrt(), |[x, ..]| 1.0 / x.powi(2).sqrt()],
        )
        .on(|[x, ..]| x != 0.0),
        rule("1/|x|³", |[x, ..]| x.powi(-6).sqrt(), vec![|[x, ..]| x.powi(-6).sqrt(), |[x, ..]| x.abs().powi(-3)])
            .on(|[x, ..]| x != 0.0),
        // u^p by integer powers and roots
        rule("x²", |[x, ..]| x.powf(2.0), vec![|[x, ..]| x.powf(2.0)]),
        rule("√x", |[x, ..]| x.powf(0.5), vec![|[x, ..]| x.powf(0.5)]).on(positive),
        rule("1/(√x)³", |[x, ..]| x.powf(-1.5), vec![|[x, ..]| x.powf(-1.5)]).on(positive),
        rule(
            "(∛x)²",
            |[x, ..]| x.powf(2.0 / 3.0),
            vec![|[x, ..]| x.powf(2.0 / 3.0), |[x, ..]| x.powf(number(2.0) / 3.0)],
        )
        .on(positive),
        rule("(√(√x))³", |[x, ..]| x.powf(0.75), vec![|[x, ..]| x.powf(0.75)]).on(positive),
        rule("x^2.7", |[x, ..]| x.powf(2.7), vec![|[x, ..]| x.powf(2.7)]).on(positive),
        rule("x^y", |[x, y, _]| x.powf(y), vec![|[x, y, _]| x.powf(y)]).on(positive),
        // hypot(x, y) = √(x² + y²)
        rule("√(x² + y²)", |[x, y, _]| x.hypot(y), vec![|[x, y, _]| x.hypot(y), |[x, y, _]| y.hypot(x)]),
        rule("|x|", |[x, ..]| x.hypot(0.0), vec![|[x, ..]| x.hypot(0.0)]),
        // atan2 is odd in its first argument; min and max of one thing are that thing
        rule("−atan2(x, y)", |[x, y, _]| (-x).atan2(y), vec![|[x, y, _]| (-x).atan2(y)])
            .on(|[x, y, _]| x != 0.0 || y > 0.0),
        rule("x", |[x, ..]| x.min(x), vec![|[x, ..]| x.min(x), |[x, ..]| x.max(x)]),
        rule("at_most(at_least(x, −0.5), 0.75)", |[x, ..]| x.clamp(-0.5, 0.75), vec![|[x, ..]| x.clamp(-0.5, 0.75)]),
        // Choices: decided between numbers, dropped between equal branches, turned by a negation.
        rule(
            "x",
            |[x, ..]| x,
            vec![
                |[x, y, _]| choose(number(1.0).less(2.0), x, y),
                |[x, y, _]| choose(number(2.0).at_most(1.0), y, x),
                |[x, y, z]| choose(y.less(z), x, x),
                |[x, y, _]| choose(number(1.0).equals(1.0).and(number(1.0).less(1.0).negated()), x, y),
                |[x, y, z]| choose(number(1.0).equals(1.0).or(y.less(z)), x, y),
            ],
        ),
        rule(
            "{x if x < y, else y}",
            |[x, y, _]| if x < y { x } else { y },
            vec![|[x, y, _]| choose(x.less(y), x, y), |[x, y, _]| choose(x.less(y).negated(), y, x)],
        ),
        // Joined conditions and equalities do not depend on their order.
        rule(
            "{0 if (x < z and x = y), else z}",
            |[x, y, z]| if x == y && x < z { 0.0 } else { z },
            vec![|[x, y, z]| choose(x.equals(y).and(x.less(z)), 0.0, z), |[x, y, z]| {
                choose(x.less(z).and(y.equals(x)), 0.0, z)
            }],
        ),
    ]);
}

/// f(−u) = f(u) for even f, −f(u) for odd f; neither for the others.
#[test]
fn parity() {
    use Unary::*;
    let (mut even, mut odd, mut neither) = (vec![], vec![], vec![]);
    for f in Unary::ALL {
        let mut graph = Graph::new();
        let [x, y] = ["x", "y"].map(|name| graph.coordinate(name)).map(|s| E(graph.symbol(s)));
        within(&mut graph, || {
            let (value, mirrored) = (x.of(f), (-x).of(f));
            let (gap, turned) = ((x - y).of(f), (y - x).of(f));
            let (at, opposite): (f64, f64) = (f.apply(0.7), f.apply(-0.7));
            if mirrored == value {
                assert!(gap == turned && at == opposite, "{f:?}");
                even.push(f);
            } else if mirrored == -value {
                assert!(gap == -turned && at == -opposite, "{f:?}");
                odd.push(f);
            } else {
                neither.push(f);
            }
        });
    }
    assert_eq!(odd, [Cbrt, Sin, Tan, Asin, Atan, Sinh, Tanh, Asinh, Atanh, Round, Trunc]);
    assert_eq!(even, [Cos, Cosh, Abs, Sinc, SincSlope, Sinhc, SinhcSlope, Atanc, AtancSlope, Atanhc, AtanhcSlope]);
    assert_eq!(neither, [Sqrt, Exp, Exp2, ExpM1, Ln, Ln1p, Log2, Log10, Acos, Acosh, Signum, Floor]);
}

/// Functions of numbers: the exact values and no others.
#[test]
fn exact_values() {
    use Unary::*;
    let zero_at_zero = [Sqrt, Cbrt, ExpM1, Ln1p, Sin, Tan, Asin, Atan, Sinh, Tanh, Asinh, Atanh].map(|f| (f, 0.0, 0.0));
    let one_at_zero = [Exp, Exp2, Cos, Cosh, Sinc, Sinhc, Atanc, Atanhc].map(|f| (f, 0.0, 1.0));
    let zero_at_one = [Ln, Log2, Log10, Acos, Acosh].map(|f| (f, 1.0, 0.0));
    let others = [(Sqrt, 4.0, 2.0), (Sqrt, 2.25, 1.5), (Cbrt, -1.0, -1.0), (Abs, -3.5, 3.5), (Signum, -3.5, -1.0)];
    let steps = [Round, Floor, Trunc].map(|f| (f, -3.0, -3.0));
    let mut g = Graph::new();
    for (f, x, value) in zero_at_zero.into_iter().chain(one_at_zero).chain(zero_at_one).chain(others).chain(steps) {
        let u = g.number(x);
        let folded = g.unary(f, u);
        assert_eq!(g.as_number(folded), Some(value), "{f:?} of {x}");
        assert_eq!(f.apply(x), value, "{f:?} of {x}");
    }
    for f in Unary::ALL {
        let u = g.number(0.3);
        let kept = g.unary(f, u);
        assert_eq!(g.as_number(kept).is_some(), matches!(f, Abs | Signum), "{f:?} of 0.3");
    }
    for (f, expected) in [(Binary::Min, -0.5), (Binary::Max, 2.5)] {
        let (u, w) = (g.number(2.5), g.number(-0.5));
        let folded = g.binary(f, u, w);
        assert_eq!(g.as_number(folded), Some(expected));
    }
}
