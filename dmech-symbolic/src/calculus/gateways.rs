//! The fewest inner expressions through which a choice depends on the coordinates.
//!
//! A choice between potentials of a distance is a choice in one variable, whatever the number of coordinates. What is
//! chosen across its seam is formed in that variable, and the way from there to the coordinates is the same in all
//! branches: so that central laws stay central and what depends on differences does not push the whole.
//!
//! The fewest are found as a least cut between the choice and the coordinates (L. R. Ford and D. R. Fulkerson,
//! Canad. J. Math. 8 (1956) 399), and of several such cuts the one next to the coordinates, whose expressions are the
//! simplest. Sums and products count without what does not move: x − y and x − y − d have one variable, x y and −k x y too;
//! and a sum that another was flattened into counts by itself: r² + r⁴ has the one variable r².
//!
//! The branches of an `if` join on its seam, which is a place in the variables only if these are independent there. As
//! y (x − d) is not of x at x = d, what stands in one branch alone is no variable unless it has nothing to do with the
//! condition or is a sum of coordinates; nor is anything that need not be a number where the other branch is taken.
//! What stands in both is one: a potential of r with a field beyond a wall has the variables r² and z.

use crate::expression::{Choice, Expr, Graph, Node, Number, Substitution, Symbol, Variable};
use crate::hash::Map;

use super::centre::Distance;

/// Inner expressions, each with a variable that stands for it.
pub(super) struct Gateways {
    /// The expressions.
    pub(super) inner: Vec<Expr>,
    /// What their variables stand for: a distance is one in the variable of its square.
    stands_for: Vec<Variable>,
    /// The variables.
    pub(super) symbols: Vec<Symbol>,
    inside: Substitution,
}

impl Gateways {
    /// Those between a choice and the coordinates.
    pub(super) fn of(graph: &mut Graph, e: Expr, choice: &Choice, coordinates: &[Symbol]) -> Self {
        let mut network = Network::new(graph, choice, coordinates);
        if matches!(graph.node(e), Node::Select(..)) {
            network.close_dependent(graph, choice, coordinates);
        }
        let inner = network.least_cut();
        let stands_for: Vec<_> = inner.iter().map(|&u| Distance::variable(graph, u)).collect();
        let symbols = Self::variables(graph, &stands_for, "u");
        let pairs: Vec<_> = inner.iter().zip(&symbols).map(|(&u, &name)| (u, graph.symbol(name))).collect();
        let mut inside = Substitution::of_expressions(pairs);
        // The simpler ones first: others are made of them.
        network.parts.sort_by_cached_key(|(e, parts)| (graph.children(*e).into_iter().max(), parts.rank(graph, *e)));
        for (e, Parts { moving, fixed }) in network.parts {
            let mut terms = vec![fixed];
            for (scale, part) in moving {
                let image = inside.apply(graph, part);
                terms.push(graph.mul(&[scale, image]));
            }
            let image = graph.add(&terms);
            inside.remember(e, image);
        }
        Self { inner, stands_for, symbols, inside }
    }

    /// New variables of such kinds.
    fn variables(graph: &mut Graph, kinds: &[Variable], name: &str) -> Vec<Symbol> {
        kinds.iter().enumerate().map(|(k, &kind)| graph.new_symbol(&format!("{name}{k}"), kind)).collect()
    }

    /// The variables at an end of a step.
    pub(super) fn at_end(&self, graph: &mut Graph, name: &str) -> Vec<Symbol> {
        Self::variables(graph, &self.stands_for, name)
    }

    /// The expression in the variables.
    pub(super) fn inside(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        self.inside.apply(graph, e)
    }
}

/// An expression as Σ scale·moving + fixed.
struct Parts {
    moving: Vec<(Expr, Expr)>,
    fixed: Expr,
}

impl Parts {
    /// Of expressions with the same terms, those that others are made of come first.
    fn rank(&self, graph: &Graph, e: Expr) -> (bool, usize) {
        (self.moving.len() == 1, graph.children(e).len())
    }

    /// What moves of a sum, its first coefficient positive, or of a product; or a sum within a sum, and the rest.
    fn of(graph: &mut Graph, e: Expr, moves: &dyn Fn(Expr) -> bool, sums: &[Expr]) -> Option<Self> {
        let whole = match graph.node(e).clone() {
            Node::Product { coefficient, factors } => {
                let (moving, fixed): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|&(f, _)| moves(f));
                let scale = graph.product_of(coefficient, fixed);
                let moving = vec![(scale, graph.product_of(Number::ONE, moving))];
                Self { moving, fixed: graph.zero() }
            }
            Node::Sum { .. } => {
                let Moving { sign, terms, fixed } = Moving::of(graph, e, moves)?;
                let (scale, fixed) = (graph.number(sign), graph.linear_combination(&fixed));
                Self { moving: vec![(scale, graph.linear_combination(&terms))], fixed }
            }
            _ => return None,
        };
        if whole.moving[0].1 != e { Some(whole) } else { Self::split(graph, e, sums) }
    }

    /// The longest of the sums whose terms all stand in this one, or all with the other sign, and the rest.
    fn split(graph: &mut Graph, e: Expr, sums: &[Expr]) -> Option<Self> {
        let Node::Sum { terms, .. } = graph.node(e).clone() else { return None };
        for &sum in sums.iter().filter(|&&sum| sum != e) {
            let Node::Sum { terms: inner, .. } = graph.node(sum).clone() else { continue };
            for sign in [1.0, -1.0] {
                let turned = |c: Number| Number::new(sign * c.value());
                let stands = |&(c, t): &(Number, Expr)| terms.contains(&(turned(c), t));
                if inner.len() >= terms.len() || !inner.iter().all(stands) {
                    continue;
                }
                let is_rest = |&&(c, t): &&(Number, Expr)| !inner.contains(&(turned(c), t));
                let rest: Vec<_> = terms.iter().filter(is_rest).copied().collect();
                let (turn, rest) = upright(&rest).expect("the other sum is shorter");
                let rest = (graph.number(turn), graph.linear_combination(&rest));
                let moving = vec![(graph.number(sign), sum), rest];
                return Some(Self { moving, fixed: graph.zero() });
            }
        }
        None
    }
}

/// The terms of a sum that move, the first one positive, and those that do not.
struct Moving {
    sign: f64,
    terms: Vec<(Number, Expr)>,
    fixed: Vec<(Number, Expr)>,
}

impl Moving {
    fn of(graph: &mut Graph, e: Expr, moves: &dyn Fn(Expr) -> bool) -> Option<Self> {
        let Node::Sum { constant, terms } = graph.node(e).clone() else { return None };
        let (moving, mut fixed): (Vec<_>, Vec<_>) = terms.iter().copied().partition(|&(_, t)| moves(t));
        fixed.push((constant, graph.one()));
        let (sign, terms) = upright(&moving)?;
        Some(Self { sign, terms, fixed })
    }

    /// Those of all sums in the expressions, as expressions, the longest first.
    fn all(graph: &mut Graph, roots: &[Expr], moves: &dyn Fn(Expr) -> bool) -> Vec<Expr> {
        let reachable: Vec<_> = graph.reachable(roots).into_iter().filter(|&e| moves(e)).collect();
        let mut sums: Vec<_> = reachable.into_iter().filter_map(|e| Self::of(graph, e, moves)).collect();
        sums.retain(|sum| sum.terms.len() > 1);
        sums.sort_by_key(|sum| std::cmp::Reverse(sum.terms.len()));
        sums.into_iter().map(|sum| graph.linear_combination(&sum.terms)).collect()
    }
}

/// Terms turned so that the first coefficient is positive, and by which sign: what moves has one spelling.
fn upright(terms: &[(Number, Expr)]) -> Option<(f64, Vec<(Number, Expr)>)> {
    let sign = if terms.first()?.0.value() < 0.0 { -1.0 } else { 1.0 };
    Some((sign, terms.iter().map(|&(c, t)| (Number::new(sign * c.value()), t)).collect()))
}

/// The way from a choice to the coordinates as a network in which each expression may be passed once.
struct Network {
    expressions: Vec<Expr>,
    /// How many of them are below the condition; these come first.
    of_condition: usize,
    /// To each vertex the edges that leave it. Vertex 0 is the source, 1 the sink; expression i is entered at 2 i + 2 and
    /// left at 2 i + 3.
    edges: Vec<Vec<usize>>,
    heads: Vec<usize>,
    /// What an edge may still carry; edge 2 k + 1 is edge 2 k backwards.
    capacity: Vec<usize>,
    /// More than can ever flow.
    unbounded: usize,
    /// The sums and products that are taken by their parts.
    parts: Vec<(Expr, Parts)>,
}

const SOURCE: usize = 0;
const SINK: usize = 1;

impl Network {
    fn new(graph: &mut Graph, choice: &Choice, coordinates: &[Symbol]) -> Self {
        let moving = graph.dependence(coordinates);
        // What is made on the way is made of what moves.
        let moves = |e: Expr| moving.get(e.index()).is_none_or(|&moves| moves);
        let sums = Moving::all(graph, &choice.roots(), &moves);
        let mut network = Self {
            expressions: vec![],
            of_condition: 0,
            edges: vec![vec![], vec![]],
            heads: vec![],
            capacity: vec![],
            unbounded: coordinates.len() + 1,
            parts: vec![],
        };
        let mut index: Map<Expr, usize> = Map::default();
        for (k, roots) in [choice.condition.operands(), vec![choice.yes, choice.no]].into_iter().enumerate() {
            let moving = roots.into_iter().filter(|&e| moves(e));
            network.grow(graph, moving.map(|e| (SOURCE, e)).collect(), &moves, &sums, &mut index);
            if k == 0 {
                network.of_condition = network.expressions.len();
            }
        }
        network
    }

    /// Adds all that the open expressions are made of.
    fn grow(
        &mut self,
        graph: &mut Graph,
        mut open: Vec<(usize, Expr)>,
        moves: &dyn Fn(Expr) -> bool,
        sums: &[Expr],
        index: &mut Map<Expr, usize>,
    ) {
        while let Some((from, e)) = open.pop() {
            if let Some(&i) = index.get(&e) {
                self.connect(from, 2 * i + 2, self.unbounded);
                continue;
            }
            let i = self.expressions.len();
            index.insert(e, i);
            self.expressions.push(e);
            self.edges.extend([vec![], vec![]]);
            self.connect(2 * i + 2, 2 * i + 3, 1);
            self.connect(from, 2 * i + 2, self.unbounded);
            if matches!(graph.node(e), Node::Symbol(_)) {
                self.connect(2 * i + 3, SINK, self.unbounded);
            } else if let Some(parts) = Parts::of(graph, e, moves, sums) {
                open.extend(parts.moving.iter().map(|&(_, part)| (2 * i + 3, part)));
                self.parts.push((e, parts));
            } else {
                let children = graph.children(e).into_iter().filter(|&c| moves(c));
                open.extend(children.map(|c| (2 * i + 3, c)));
            }
        }
    }

    /// No cut passes through what stands in one branch alone and depends on what the condition does, or may be no number.
    fn close_dependent(&mut self, graph: &Graph, choice: &Choice, coordinates: &[Symbol]) {
        let symbol = |e: &Expr| match graph.node(*e) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        };
        let of_condition: Vec<_> = self.expressions[..self.of_condition].iter().filter_map(symbol).collect();
        let (moves, bound) = (graph.dependence(coordinates), graph.dependence(&of_condition));
        let below = [choice.yes, choice.no].map(|branch| self.below(branch));
        for (i, &e) in self.expressions.iter().enumerate().skip(self.of_condition) {
            let in_both = below.iter().all(|below| below[2 * i + 2]);
            let is_own = is_linear(graph, e, &moves) || !bound[e.index()] && is_polynomial(graph, e, &moves);
            if symbol(&e).is_none() && !in_both && !is_own {
                let through = self.edges[2 * i + 2][0];
                self.capacity[through] = self.unbounded;
            }
        }
    }

    /// The vertices that an expression is made of.
    fn below(&self, e: Expr) -> Vec<bool> {
        let Some(i) = self.expressions.iter().position(|&other| other == e) else {
            return vec![false; self.edges.len()];
        };
        let mut below: Vec<_> = self.reach(2 * i + 2, false).into_iter().map(|by| by.is_some()).collect();
        below[2 * i + 2] = true;
        below
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

/// A sum of coordinates.
fn is_linear(graph: &Graph, e: Expr, moves: &[bool]) -> bool {
    let Node::Sum { terms, .. } = graph.node(e) else { return false };
    terms.iter().all(|(_, t)| !moves[t.index()] || matches!(graph.node(*t), Node::Symbol(_)))
}

/// A sum or product of coordinates, sums and products.
fn is_polynomial(graph: &Graph, e: Expr, moves: &[bool]) -> bool {
    graph.reachable(&[e]).into_iter().filter(|e| moves[e.index()]).all(|e| match graph.node(e) {
        Node::Symbol(_) | Node::Sum { .. } => true,
        Node::Product { factors, .. } => factors.iter().all(|&(f, n)| n > 0 || !moves[f.index()]),
        _ => false,
    })
}
