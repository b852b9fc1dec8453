//! The fewest inner expressions through which an expression depends on the coordinates.
//!
//! A choice between potentials of a distance is a choice in one variable, whatever the number of coordinates. What is
//! chosen across its seam is formed in that variable, and the way from there to the coordinates is the same in all
//! branches: so that central laws stay central and what depends on differences does not push the whole.
//!
//! The fewest are found as a least cut between the expression and the coordinates (L. R. Ford and D. R. Fulkerson,
//! Canad. J. Math. 8 (1956) 399), and of several such cuts the one next to the coordinates, whose expressions are the
//! simplest. Sums and products count without what does not move: x − y and x − y − d have one variable, x y and −k x y too.

use std::collections::HashMap;

use crate::expression::{Expr, Graph, Node, Number, Substitution, Symbol};

/// Inner expressions, each with a variable that stands for it.
pub(super) struct Gateways {
    /// The expressions.
    pub(super) inner: Vec<Expr>,
    /// The variables.
    pub(super) symbols: Vec<Symbol>,
    inside: Substitution,
}

impl Gateways {
    /// Those between the roots and the coordinates.
    pub(super) fn of(graph: &mut Graph, roots: &[Expr], coordinates: &[Symbol]) -> Self {
        let mut network = Network::new(graph, roots, coordinates);
        let inner = network.least_cut();
        let symbols: Vec<_> = (0..inner.len()).map(|k| graph.coordinate(&format!("u{k}"))).collect();
        let mut inside: Vec<_> = inner.iter().zip(&symbols).map(|(&u, &name)| (u, graph.symbol(name))).collect();
        for (sum, part) in network.parts {
            let Some(k) = inner.iter().position(|&u| u == part.moving) else { continue };
            let u = graph.symbol(symbols[k]);
            let scaled = graph.mul(&[part.scale, u]);
            inside.push((sum, graph.add(&[scaled, part.fixed])));
        }
        Self { inner, symbols, inside: Substitution::of_expressions(inside) }
    }

    /// The expression in the variables.
    pub(super) fn inside(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        self.inside.apply(graph, e)
    }
}

/// An expression as scale·moving + fixed.
struct Part {
    moving: Expr,
    scale: Expr,
    fixed: Expr,
}

/// The moving part of a sum, its first coefficient positive, or of a product; and the rest.
fn parts(graph: &mut Graph, e: Expr, moves: &[bool]) -> Option<Part> {
    if let Node::Product { coefficient, factors } = graph.node(e).clone() {
        let (moving, fixed): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|(f, _)| moves[f.index()]);
        let (moving, scale) = (graph.product_of(Number::ONE, moving), graph.product_of(coefficient, fixed));
        return Some(Part { moving, scale, fixed: graph.zero() });
    }
    let Node::Sum { constant, terms } = graph.node(e).clone() else { return None };
    let (moving, mut fixed): (Vec<_>, Vec<_>) = terms.iter().copied().partition(|(_, t)| moves[t.index()]);
    let sign = if moving.first()?.0.value() < 0.0 { -1.0 } else { 1.0 };
    fixed.push((constant, graph.one()));
    let turned: Vec<_> = moving.into_iter().map(|(c, t)| (Number::new(sign * c.value()), t)).collect();
    let scale = graph.number(sign);
    Some(Part { moving: graph.linear_combination(&turned), scale, fixed: graph.linear_combination(&fixed) })
}

/// The way from the roots to the coordinates as a network in which each expression may be passed once.
struct Network {
    expressions: Vec<Expr>,
    /// To each vertex the edges that leave it. Vertex 0 is the source, 1 the sink; expression i is entered at 2 i + 2 and
    /// left at 2 i + 3.
    edges: Vec<Vec<usize>>,
    heads: Vec<usize>,
    /// What an edge may still carry; edge 2 k + 1 is edge 2 k backwards.
    capacity: Vec<usize>,
    /// The sums and products that have a fixed part or another sign.
    parts: Vec<(Expr, Part)>,
}

const SOURCE: usize = 0;
const SINK: usize = 1;

impl Network {
    fn new(graph: &mut Graph, roots: &[Expr], coordinates: &[Symbol]) -> Self {
        let moves = graph.dependence(coordinates);
        let mut network =
            Self { expressions: vec![], edges: vec![vec![], vec![]], heads: vec![], capacity: vec![], parts: vec![] };
        let unbounded = coordinates.len() + 1;
        let mut index: HashMap<Expr, usize> = HashMap::new();
        let mut open: Vec<(usize, Expr)> = roots.iter().filter(|e| moves[e.index()]).map(|&e| (SOURCE, e)).collect();
        while let Some((from, e)) = open.pop() {
            if let Some(&i) = index.get(&e) {
                network.connect(from, 2 * i + 2, unbounded);
                continue;
            }
            let i = network.expressions.len();
            index.insert(e, i);
            network.expressions.push(e);
            network.edges.extend([vec![], vec![]]);
            network.connect(2 * i + 2, 2 * i + 3, 1);
            network.connect(from, 2 * i + 2, unbounded);
            if matches!(graph.node(e), Node::Symbol(_)) {
                network.connect(2 * i + 3, SINK, unbounded);
                continue;
            }
            match parts(graph, e, &moves) {
                Some(part) if part.moving != e => {
                    open.push((2 * i + 3, part.moving));
                    network.parts.push((e, part));
                }
                _ => {
                    let children = graph.children(e).into_iter().filter(|c| moves[c.index()]);
                    open.extend(children.map(|c| (2 * i + 3, c)));
                }
            }
        }
        network
    }

    fn connect(&mut self, from: usize, to: usize, capacity: usize) {
        for (tail, head, capacity) in [(from, to, capacity), (to, from, 0)] {
            self.edges[tail].push(self.heads.len());
            self.heads.push(head);
            self.capacity.push(capacity);
        }
    }

    /// The vertices from which a vertex can be reached, or those that can be reached, each with the edge next to it.
    fn reach(&self, from: usize, backwards: bool) -> Vec<Option<usize>> {
        let mut by = vec![None; self.edges.len()];
        let mut open = vec![from];
        let mut seen = vec![false; self.edges.len()];
        seen[from] = true;
        while let Some(vertex) = open.pop() {
            for &edge in &self.edges[vertex] {
                let free = self.capacity[if backwards { edge ^ 1 } else { edge }] > 0;
                let next = self.heads[edge];
                if free && !std::mem::replace(&mut seen[next], true) {
                    by[next] = Some(edge);
                    open.push(next);
                }
            }
        }
        by
    }

    /// Sends one unit after the other until no way is left; then the cut is where the ways to the sink begin.
    fn least_cut(&mut self) -> Vec<Expr> {
        loop {
            let by = self.reach(SOURCE, false);
            let mut vertex = SINK;
            if by[SINK].is_none() {
                break;
            }
            while let Some(edge) = by[vertex] {
                self.capacity[edge] -= 1;
                self.capacity[edge ^ 1] += 1;
                vertex = self.heads[edge ^ 1];
            }
        }
        let to_sink = self.reach(SINK, true);
        let cut = |i: &usize| to_sink[2 * i + 3].is_some() && to_sink[2 * i + 2].is_none();
        let mut inner: Vec<_> = (0..self.expressions.len()).filter(cut).map(|i| self.expressions[i]).collect();
        inner.sort_unstable();
        inner
    }
}
