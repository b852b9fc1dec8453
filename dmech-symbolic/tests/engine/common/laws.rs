//! Random laws with the points that they are tried at.

use dmech_symbolic::expression::{Expr, Graph, Symbol};
use dmech_symbolic::kernel::{Kernels, Variables};
use proptest::prelude::*;

use super::notation::{E, within};
use super::tree::{PARAMETERS, Tree, trees};

/// A law, a point, and a direction to a second one.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) tree: Tree,
    pub(crate) a: Vec<f64>,
    pub(crate) direction: Vec<f64>,
}

impl Case {
    pub(crate) fn dimension(&self) -> usize {
        self.a.len()
    }

    /// a + gap·direction.
    pub(crate) fn b(&self, gap: f64) -> Vec<f64> {
        self.a.iter().zip(&self.direction).map(|(a, d)| a + gap * d).collect()
    }
}

/// Laws in 1 to 4 coordinates; a within ±1.5, the direction within ±1.
pub(crate) fn cases() -> impl Strategy<Value = Case> {
    (1_usize..=4).prop_flat_map(|dimension| {
        let a = prop::collection::vec(-1.5..1.5, dimension);
        let direction = prop::collection::vec(-1.0..1.0, dimension);
        (trees(dimension), a, direction).prop_map(|(tree, a, direction)| Case { tree, a, direction })
    })
}

/// A law in the engine.
pub(crate) struct Law {
    pub(crate) graph: Graph,
    pub(crate) phi: Expr,
    pub(crate) variables: Variables,
    pub(crate) parameters: Vec<Symbol>,
}

impl Law {
    pub(crate) fn new(tree: &Tree, dimension: usize) -> Self {
        Self::build(dimension, |q, p| tree.build(q, p))
    }

    /// A law written by hand, in coordinates and three parameters.
    pub(crate) fn build(dimension: usize, phi: impl FnOnce(&[E], &[E]) -> E) -> Self {
        let mut graph = Graph::new();
        let variables = Variables::new(&mut graph, dimension);
        let parameters: Vec<_> = (0..PARAMETERS.len()).map(|i| graph.parameter(&format!("p{i}"))).collect();
        let mut list = |names: &[Symbol]| names.iter().map(|&s| E(graph.symbol(s))).collect::<Vec<_>>();
        let (q, p) = (list(&variables.q), list(&parameters));
        let phi = within(&mut graph, || phi(&q, &p)).0;
        Self { graph, phi, variables, parameters }
    }

    pub(crate) fn kernels(&mut self) -> Kernels {
        Kernels::new(&mut self.graph, self.phi, &self.variables)
    }

    /// The values of parameters, position and ends; every other symbol is 0.
    pub(crate) fn values<T: Clone, N: Fn(f64) -> T>(
        &self,
        number: N,
        q: &[T],
        a: &[T],
        b: &[T],
    ) -> impl Fn(Symbol) -> T + use<T, N> {
        let mut known: Vec<(Symbol, T)> = vec![];
        for (names, values) in [(&self.variables.q, q), (&self.variables.a, a), (&self.variables.b, b)] {
            known.extend(names.iter().copied().zip(values.iter().cloned()));
        }
        known.extend(self.parameters.iter().copied().zip(PARAMETERS.map(&number)));
        move |s| known.iter().find(|(name, _)| *name == s).map_or_else(|| number(0.0), |(_, value)| value.clone())
    }

    /// The values of the symbols with q = a, in binary64.
    pub(crate) fn at(&self, a: &[f64], b: &[f64]) -> impl Fn(Symbol) -> f64 + use<> {
        self.values(|x| x, a, a, b)
    }
}
