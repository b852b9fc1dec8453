//! Random laws: trees of all functions that a potential may use, with every argument inside its domain.
//!
//! A tree is evaluated as it stands, without any rewriting: it is what the engine's normal forms are held against.

use dmech_symbolic::expression::{Binary, Unary};
use proptest::prelude::*;

use super::algebra::Algebra;
use super::notation::E;

#[derive(Clone, Debug)]
pub(crate) enum Tree {
    Coordinate(usize),
    Parameter(usize),
    Number(f64),
    Add(Box<Tree>, Box<Tree>),
    Sub(Box<Tree>, Box<Tree>),
    Mul(Box<Tree>, Box<Tree>),
    Div(Box<Tree>, Box<Tree>),
    Powi(Box<Tree>, i32),
    Unary(Unary, Box<Tree>),
    Binary(Binary, Box<Tree>, Box<Tree>),
    Hypot(Box<Tree>, Box<Tree>),
}

/// The functions of one argument that a law may call and a random tree is made of. The sign function is missing: it
/// is not continuous.
pub(crate) const FUNCTIONS: [Unary; 22] = {
    use Unary::*;
    [
        Sqrt, Cbrt, Exp, Exp2, ExpM1, Ln, Ln1p, Log2, Log10, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Asinh,
        Acosh, Atanh, Abs,
    ]
};

/// The coordinates stay within ±2.5; see [`laws`](super::laws).
pub(crate) const REACH: f64 = 2.5;

/// Distinct and none of them 1.
pub(crate) const PARAMETERS: [f64; 3] = [0.7, 1.9, 3.3];

impl Tree {
    pub(crate) fn evaluate<T: Algebra>(&self, coordinates: &[T]) -> T {
        let of = |t: &Tree| t.evaluate(coordinates);
        match self {
            Self::Coordinate(i) => coordinates[*i].clone(),
            Self::Parameter(i) => T::number(PARAMETERS[*i]),
            Self::Number(x) => T::number(*x),
            Self::Add(u, w) => of(u).plus(&of(w)),
            Self::Sub(u, w) => of(u).minus(&of(w)),
            Self::Mul(u, w) => of(u).times(&of(w)),
            Self::Div(u, w) => of(u).over(&of(w)),
            Self::Powi(u, n) => of(u).power(*n),
            Self::Unary(f, u) => of(u).unary(*f),
            Self::Binary(f, u, w) => of(u).binary(*f, &of(w)),
            Self::Hypot(u, w) => {
                let (u, w) = (of(u), of(w));
                u.times(&u).plus(&w.times(&w)).unary(Unary::Sqrt)
            }
        }
    }

    pub(crate) fn build(&self, q: &[E], p: &[E]) -> E {
        let of = |t: &Tree| t.build(q, p);
        match self {
            Self::Coordinate(i) => q[*i],
            Self::Parameter(i) => p[*i],
            Self::Number(x) => E::from(*x),
            Self::Add(u, w) => of(u) + of(w),
            Self::Sub(u, w) => of(u) - of(w),
            Self::Mul(u, w) => of(u) * of(w),
            Self::Div(u, w) => of(u) / of(w),
            Self::Powi(u, n) => of(u).powi(*n),
            Self::Unary(f, u) => of(u).of(*f),
            Self::Binary(f, u, w) => of(u).binary(*f, of(w)),
            Self::Hypot(u, w) => of(u).hypot(of(w)),
        }
    }

    /// How often each function stands in it, by the name of its method.
    pub(crate) fn count(&self, counts: &mut std::collections::BTreeMap<&'static str, usize>) {
        let (name, children): (&str, Vec<&Tree>) = match self {
            Self::Coordinate(_) | Self::Parameter(_) | Self::Number(_) => return,
            Self::Add(u, w) => ("+", vec![u, w]),
            Self::Sub(u, w) => ("-", vec![u, w]),
            Self::Mul(u, w) => ("*", vec![u, w]),
            Self::Div(u, w) => ("/", vec![u, w]),
            Self::Powi(u, _) => ("powi", vec![u]),
            Self::Unary(f, u) => (f.method(), vec![u]),
            Self::Binary(f, u, w) => (f.method(), vec![u, w]),
            Self::Hypot(u, w) => ("hypot", vec![u, w]),
        };
        *counts.entry(name).or_default() += 1;
        children.into_iter().for_each(|c| c.count(counts));
    }

    /// An interval that holds its values.
    fn range(&self) -> (f64, f64) {
        use Unary::*;
        let corners = |f: &dyn Fn(f64, f64) -> f64, u: (f64, f64), w: (f64, f64)| {
            let values = [f(u.0, w.0), f(u.0, w.1), f(u.1, w.0), f(u.1, w.1)];
            (
                values.iter().copied().fold(f64::INFINITY, f64::min),
                values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            )
        };
        let even = |f: &dyn Fn(f64) -> f64, u: (f64, f64)| {
            let (p, q) = (f(u.0), f(u.1));
            let across = u.0 < 0.0 && u.1 > 0.0;
            (if across { f(0.0).min(p.min(q)) } else { p.min(q) }, p.max(q))
        };
        match self {
            Self::Coordinate(_) => (-REACH, REACH),
            Self::Parameter(i) => (PARAMETERS[*i], PARAMETERS[*i]),
            Self::Number(x) => (*x, *x),
            Self::Add(u, w) => corners(&|x, y| x + y, u.range(), w.range()),
            Self::Sub(u, w) => corners(&|x, y| x - y, u.range(), w.range()),
            Self::Mul(u, w) => corners(&|x, y| x * y, u.range(), w.range()),
            Self::Div(u, w) => corners(&|x, y| x / y, u.range(), w.range()),
            Self::Powi(u, n) if n % 2 == 0 && *n > 0 => even(&|x| x.powi(*n), u.range()),
            Self::Powi(u, n) => corners(&|x, _| x.powi(*n), u.range(), (0.0, 0.0)),
            Self::Unary(Sin | Cos, _) => (-1.0, 1.0),
            Self::Unary(f @ (Cosh | Abs), u) => even(&|x| f.apply(x), u.range()),
            Self::Unary(f, u) => corners(&|x, _| f.apply(x), u.range(), (0.0, 0.0)),
            Self::Binary(Binary::Atan2, ..) => (-3.2, 3.2),
            Self::Binary(f, u, w) => corners(&|x, y| f.apply(x, y), u.range(), w.range()),
            Self::Hypot(u, w) => {
                let (u, w) = (even(&f64::abs, u.range()), even(&f64::abs, w.range()));
                corners(&f64::hypot, u, w)
            }
        }
    }

    fn boxed(self) -> Box<Self> {
        Box::new(self)
    }

    /// c + u².
    fn above(self, c: f64) -> Self {
        Self::Add(Self::Number(c).boxed(), Self::Powi(self.boxed(), 2).boxed())
    }

    /// c sin u.
    fn within(self, c: f64) -> Self {
        Self::Mul(Self::Number(c).boxed(), Self::Unary(Unary::Sin, self.boxed()).boxed())
    }

    fn lies_in(&self, low: f64, high: f64) -> bool {
        let (least, most) = self.range();
        low <= least && most <= high
    }

    fn positive(self) -> Self {
        if self.lies_in(0.2, 1e3) { self } else { self.tame(20.0).above(0.4) }
    }

    fn tame(self, bound: f64) -> Self {
        if self.lies_in(-bound, bound) { self } else { self.within(1.7) }
    }

    /// The same law with every argument inside the domain of its function, not too near its edge, and no value large.
    pub(crate) fn in_domain(self) -> Self {
        use Unary::*;
        let fix = |t: Box<Tree>| t.in_domain();
        let fixed = match self {
            Self::Coordinate(_) | Self::Parameter(_) | Self::Number(_) => return self,
            Self::Add(u, w) => Self::Add(fix(u).boxed(), fix(w).boxed()),
            Self::Sub(u, w) => Self::Sub(fix(u).boxed(), fix(w).boxed()),
            Self::Mul(u, w) => Self::Mul(fix(u).tame(50.0).boxed(), fix(w).tame(50.0).boxed()),
            Self::Div(u, w) => Self::Div(fix(u).tame(50.0).boxed(), fix(w).positive().boxed()),
            Self::Powi(u, n) => {
                let u = fix(u).tame(4.0);
                Self::Powi((if n < 0 { u.positive() } else { u }).boxed(), n)
            }
            Self::Unary(f, u) => {
                let u = fix(u);
                let u = match f {
                    Sqrt | Ln | Log2 | Log10 | Cbrt => u.positive(),
                    Ln1p if u.lies_in(-0.8, 1e3) => u,
                    Ln1p => u.tame(20.0).above(-0.5),
                    Asin | Acos | Atanh if u.lies_in(-0.9, 0.9) => u,
                    Asin | Acos | Atanh => u.within(0.9),
                    Acosh if u.lies_in(1.1, 1e3) => u,
                    Acosh => u.tame(20.0).above(1.2),
                    Tan => {
                        if u.lies_in(-1.3, 1.3) {
                            u
                        } else {
                            u.within(1.3)
                        }
                    }
                    Exp | Exp2 | ExpM1 | Sinh | Cosh => {
                        if u.lies_in(-4.0, 4.0) {
                            u
                        } else {
                            u.within(2.2)
                        }
                    }
                    _ => u.tame(100.0),
                };
                Self::Unary(f, u.boxed())
            }
            Self::Binary(Binary::Powf, u, w) => {
                let w = fix(w);
                let w = if w.lies_in(-3.5, 3.5) { w } else { w.within(2.3) };
                Self::Binary(Binary::Powf, fix(u).tame(3.0).positive().boxed(), w.boxed())
            }
            // Away from the cut, where the angle jumps: the upper half plane, or the right one.
            Self::Binary(Binary::Atan2, u, w) => {
                let (u, w) = (fix(u).tame(20.0), fix(w).tame(20.0));
                let u = if w.lies_in(0.2, 20.0) { u } else { u.positive() };
                Self::Binary(Binary::Atan2, u.boxed(), w.boxed())
            }
            Self::Binary(f, u, w) => Self::Binary(f, fix(u).boxed(), fix(w).boxed()),
            Self::Hypot(u, w) => Self::Hypot(fix(u).tame(50.0).boxed(), fix(w).tame(50.0).positive().boxed()),
        };
        fixed.tame(1e4)
    }
}

/// Trees in the given number of coordinates, inside their domain.
pub(crate) fn trees(dimension: usize) -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        6 => (0..dimension).prop_map(Tree::Coordinate),
        2 => (0..PARAMETERS.len()).prop_map(Tree::Parameter),
        1 => prop::sample::select(vec![0.5, 3.0, -2.0, 0.3]).prop_map(Tree::Number),
    ];
    let exponent = prop_oneof![
        3 => prop::sample::select(vec![0.5, 1.5, -0.5, 2.7, -1.3, 0.75]).prop_map(Tree::Number),
        1 => Just(Tree::Div(Tree::Number(1.0).boxed(), Tree::Number(3.0).boxed())),
        1 => Just(Tree::Parameter(1)),
        1 => (0..dimension).prop_map(Tree::Coordinate),
    ];
    let inner = leaf.clone();
    leaf.prop_recursive(5, 18, 2, move |t| {
        let two = (t.clone(), t.clone());
        prop_oneof![
            3 => two.clone().prop_map(|(u, w)| Tree::Add(u.boxed(), w.boxed())),
            2 => two.clone().prop_map(|(u, w)| Tree::Sub(u.boxed(), w.boxed())),
            4 => two.clone().prop_map(|(u, w)| Tree::Mul(u.boxed(), w.boxed())),
            2 => two.clone().prop_map(|(u, w)| Tree::Div(u.boxed(), w.boxed())),
            3 => (t.clone(), prop::sample::select(vec![-4, -3, -2, -1, 2, 3, 4, 5, 6]))
                .prop_map(|(u, n)| Tree::Powi(u.boxed(), n)),
            10 => (prop::sample::select(FUNCTIONS.to_vec()), t.clone()).prop_map(|(f, u)| Tree::Unary(f, u.boxed())),
            2 => (t.clone(), exponent.clone()).prop_map(|(u, p)| Tree::Binary(Binary::Powf, u.boxed(), p.boxed())),
            2 => (prop::sample::select(vec![Binary::Atan2, Binary::Min, Binary::Max]), t.clone(), inner.clone())
                .prop_map(|(f, u, w)| Tree::Binary(f, u.boxed(), w.boxed())),
            1 => two.prop_map(|(u, w)| Tree::Hypot(u.boxed(), w.boxed())),
        ]
    })
    .prop_map(Tree::in_domain)
}
