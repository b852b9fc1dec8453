//! Atoms: what products are made of once powers and denominators have been decided.
//!
//! A root's odd power is written r^(2k+1) = r·s^k and r^−(2k−1) = r·(1/s^k) with s = r², so that root and division run
//! side by side rather than in series. Denominators of one product are multiplied first and divided by once, unless
//! one of their factors is wanted inverted elsewhere too.

use crate::expression::{Expr, Graph, Node, Number, Unary};
use crate::hash::Map;

use super::latency;

/// An index into the table of atoms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Atom(pub u32);

impl Atom {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum AtomKind {
    /// An expression that is not a product.
    Base(Expr),
    /// A number.
    Number(Number),
    /// baseⁿ, n > 1.
    Power(Expr, i32),
    /// 1/baseⁿ, n > 0.
    Inverse(Expr, i32),
    /// 1/(Π baseᵢ^nᵢ).
    Denominator(Vec<(Expr, i32)>),
    /// Two atoms multiplied.
    Pair(Atom, Atom),
}

/// All atoms of a program.
pub(super) struct Atoms {
    pub(super) kinds: Vec<AtomKind>,
    pub(super) ready: Vec<u32>,
    index: Map<AtomKind, Atom>,
}

/// A product: |coefficient| Π factors.
pub(super) type Factors = (Number, Vec<(Expr, i32)>);

/// Which expressions stand below a fraction stroke, and how.
#[derive(Default)]
pub(super) struct Denominators {
    /// base → the exponent it is inverted to, over all products (a root counts toward its radicand).
    exponents: Map<Expr, Single<i32>>,
    /// base → the denominator it is part of.
    company: Map<Expr, Single<Vec<(Expr, i32)>>>,
}

/// One thing, or several different ones.
enum Single<T> {
    One(T),
    Several,
}

impl<T: PartialEq + Clone> Single<T> {
    fn join(known: &mut Map<Expr, Self>, key: Expr, other: &T) {
        let known = known.entry(key).or_insert_with(|| Self::One(other.clone()));
        if matches!(known, Self::One(one) if one != other) {
            *known = Self::Several;
        }
    }
}

impl Denominators {
    pub(super) fn of<'a>(graph: &Graph, products: impl Iterator<Item = &'a Factors>) -> Self {
        let mut found = Self::default();
        for (_, factors) in products {
            let below: Vec<_> = below(factors);
            for &(f, n) in &below {
                let (base, exponent) = match graph.node(f) {
                    Node::Unary(Unary::Sqrt, s) if n > 1 => (*s, (n + 1) / 2),
                    _ => (f, n),
                };
                Single::join(&mut found.exponents, base, &exponent);
                for key in [Some(f), radicand(graph, f)].into_iter().flatten() {
                    Single::join(&mut found.company, key, &below);
                }
            }
        }
        found
    }

    /// Whether this denominator shares no factor with another.
    fn stands_alone(&self, graph: &Graph, below: &[(Expr, i32)]) -> bool {
        let alone = |e: Expr| !matches!(self.company.get(&e), Some(Single::Several));
        below.iter().all(|&(f, _)| alone(f) && radicand(graph, f).is_none_or(alone))
    }

    /// Whether 1/base is wanted to one power only.
    pub(super) fn single_exponent(&self, base: Expr) -> bool {
        !matches!(self.exponents.get(&base), Some(Single::Several))
    }
}

fn below(factors: &[(Expr, i32)]) -> Vec<(Expr, i32)> {
    factors.iter().filter(|(_, n)| *n < 0).map(|&(f, n)| (f, -n)).collect()
}

fn radicand(graph: &Graph, f: Expr) -> Option<Expr> {
    match graph.node(f) {
        Node::Unary(Unary::Sqrt, s) => Some(*s),
        _ => None,
    }
}

impl Atoms {
    pub(super) fn new() -> Self {
        Self { kinds: vec![], ready: vec![], index: Map::default() }
    }

    pub(super) fn intern(&mut self, kind: AtomKind, ready_of: &[u32]) -> Atom {
        if let Some(&atom) = self.index.get(&kind) {
            return atom;
        }
        let ready = match &kind {
            AtomKind::Base(e) => ready_of[e.index()],
            AtomKind::Number(_) => 0,
            AtomKind::Power(e, n) => latency::power(ready_of[e.index()], *n),
            AtomKind::Inverse(e, n) => latency::power(ready_of[e.index()], -n),
            AtomKind::Denominator(below) => {
                let latest = below.iter().map(|(e, n)| latency::power(ready_of[e.index()], *n)).max();
                latest.unwrap_or(0) + latency::MUL + latency::DIV
            }
            AtomKind::Pair(one, two) => self.ready[one.index()].max(self.ready[two.index()]) + latency::MUL,
        };
        let atom = Atom(self.kinds.len() as u32);
        self.kinds.push(kind.clone());
        self.ready.push(ready);
        self.index.insert(kind, atom);
        atom
    }

    pub(super) fn kind(&self, atom: Atom) -> &AtomKind {
        &self.kinds[atom.index()]
    }

    /// The atoms of a product, repeated as often as they stand in it. Without a view of the other denominators it is divided by
    /// its own: r·(1/r²) would be 0·∞ at r = 0.
    pub(super) fn of_product(
        &mut self,
        graph: &Graph,
        (coefficient, factors): &Factors,
        denominators: Option<&Denominators>,
        ready: &[u32],
    ) -> Vec<Atom> {
        let mut atoms = vec![];
        if *coefficient != Number::ONE {
            atoms.push(self.intern(AtomKind::Number(*coefficient), ready));
        }
        for &(f, n) in factors.iter().filter(|(_, n)| *n > 0) {
            match graph.node(f) {
                Node::Unary(Unary::Sqrt, s) if n > 1 => {
                    atoms.push(self.intern(AtomKind::Base(f), ready));
                    self.push_power(*s, (n - 1) / 2, &mut atoms, ready);
                }
                _ => self.push_power(f, n, &mut atoms, ready),
            }
        }
        let below = below(factors);
        if below.len() > 1 && denominators.is_none_or(|d| d.stands_alone(graph, &below)) {
            atoms.push(self.intern(AtomKind::Denominator(below), ready));
            return atoms;
        }
        for (f, n) in below {
            match graph.node(f) {
                // A lone 1/√s stays a division by the root, unless 1/s is there anyway.
                Node::Unary(Unary::Sqrt, s) if denominators.is_some_and(|d| n > 1 || d.exponents.contains_key(s)) => {
                    atoms.push(self.intern(AtomKind::Base(f), ready));
                    atoms.push(self.intern(AtomKind::Inverse(*s, (n + 1) / 2), ready));
                }
                _ => atoms.push(self.intern(AtomKind::Inverse(f, n), ready)),
            }
        }
        atoms
    }

    /// Small powers as repeated factors, so that x·(c x) and y·(c x) share c x.
    fn push_power(&mut self, base: Expr, n: i32, atoms: &mut Vec<Atom>, ready: &[u32]) {
        if n <= 3 {
            let atom = self.intern(AtomKind::Base(base), ready);
            atoms.extend(std::iter::repeat_n(atom, n as usize));
        } else {
            atoms.push(self.intern(AtomKind::Power(base, n), ready));
        }
    }
}
