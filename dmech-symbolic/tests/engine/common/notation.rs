//! Expressions written as formulas: operators and methods on [`E`] act on a graph that [`within`] lends to them.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dmech_symbolic::expression::{Binary, Condition, Expr, Graph, Unary};

thread_local! {
    static GRAPH: RefCell<Graph> = RefCell::new(Graph::new());
}

/// An expression of the graph that is lent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct E(pub(crate) Expr);

/// Lends the graph to the formulas in `f`.
pub(crate) fn within<T>(graph: &mut Graph, f: impl FnOnce() -> T) -> T {
    let swap = |graph: &mut Graph| GRAPH.with(|lent| std::mem::swap(graph, &mut lent.borrow_mut()));
    swap(graph);
    let result = f();
    swap(graph);
    result
}

fn with(f: impl FnOnce(&mut Graph) -> Expr) -> E {
    E(GRAPH.with(|graph| f(&mut graph.borrow_mut())))
}

impl From<f64> for E {
    fn from(x: f64) -> Self {
        with(|g| g.number(x))
    }
}

impl Neg for E {
    type Output = Self;
    fn neg(self) -> Self {
        with(|g| g.neg(self.0))
    }
}

macro_rules! operators {
    ($($trait:ident $name:ident: |$g:ident, $u:ident, $w:ident| $body:expr;)*) => {$(
        impl<T: Into<E>> $trait<T> for E {
            type Output = E;
            fn $name(self, other: T) -> E {
                let ($u, $w) = (self.0, other.into().0);
                with(|$g| $body)
            }
        }
        impl $trait<E> for f64 {
            type Output = E;
            fn $name(self, other: E) -> E {
                $trait::$name(E::from(self), other)
            }
        }
    )*};
}

operators! {
    Add add: |g, u, w| g.add(&[u, w]);
    Sub sub: |g, u, w| g.sub(u, w);
    Mul mul: |g, u, w| g.mul(&[u, w]);
    Div div: |g, u, w| g.div(u, w);
}

impl E {
    pub(crate) fn of(self, f: Unary) -> Self {
        with(|g| g.unary(f, self.0))
    }
    pub(crate) fn sqrt(self) -> Self {
        self.of(Unary::Sqrt)
    }
    pub(crate) fn cbrt(self) -> Self {
        self.of(Unary::Cbrt)
    }
    pub(crate) fn abs(self) -> Self {
        self.of(Unary::Abs)
    }
    pub(crate) fn exp(self) -> Self {
        self.of(Unary::Exp)
    }
    pub(crate) fn ln(self) -> Self {
        self.of(Unary::Ln)
    }
    pub(crate) fn sin(self) -> Self {
        self.of(Unary::Sin)
    }
    pub(crate) fn cos(self) -> Self {
        self.of(Unary::Cos)
    }
    pub(crate) fn powi(self, n: i32) -> Self {
        with(|g| g.powi(self.0, n))
    }
    pub(crate) fn powf(self, p: impl Into<Self>) -> Self {
        self.binary(Binary::Powf, p)
    }
    pub(crate) fn binary(self, f: Binary, other: impl Into<Self>) -> Self {
        let other = other.into();
        with(|g| g.binary(f, self.0, other.0))
    }
    pub(crate) fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x)
    }
    pub(crate) fn min(self, other: impl Into<Self>) -> Self {
        self.binary(Binary::Min, other)
    }
    pub(crate) fn max(self, other: impl Into<Self>) -> Self {
        self.binary(Binary::Max, other)
    }
    pub(crate) fn hypot(self, other: impl Into<Self>) -> Self {
        let other = other.into();
        with(|g| g.hypot(self.0, other.0))
    }
    pub(crate) fn clamp(self, low: impl Into<Self>, high: impl Into<Self>) -> Self {
        let (low, high) = (low.into(), high.into());
        with(|g| g.clamp(self.0, low.0, high.0))
    }
    pub(crate) fn less(self, other: impl Into<Self>) -> Condition {
        Condition::less(self.0, other.into().0)
    }
    pub(crate) fn at_most(self, other: impl Into<Self>) -> Condition {
        Condition::less_or_equal(self.0, other.into().0)
    }
    pub(crate) fn equals(self, other: impl Into<Self>) -> Condition {
        Condition::equal(self.0, other.into().0)
    }
}

/// `yes` where the condition holds, `no` elsewhere.
pub(crate) fn choose(condition: Condition, yes: impl Into<E>, no: impl Into<E>) -> E {
    let (yes, no) = (yes.into(), no.into());
    with(|g| g.select(condition, yes.0, no.0))
}

/// Σ qᵢ².
pub(crate) fn squared(q: &[E]) -> E {
    q.iter().fold(E::from(0.0), |sum, x| sum + x.powi(2))
}

/// |q|.
pub(crate) fn norm(q: &[E]) -> E {
    squared(q).sqrt()
}
