//! The store of expressions.

use crate::hash::Map;

use super::{Expr, Node, Number, Symbol, Variable};

/// A store of hash-consed expressions and the names of their variables.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    /// To which [order](Graph::order) each of them vanishes.
    pub(super) orders: Vec<f64>,
    /// Whether there is a coordinate in each of them.
    pub(super) moving: Vec<bool>,
    /// A law has a slope where a distance vanishes, which has none there.
    has_centre: bool,
    index: Map<Node, Expr>,
    names: Vec<(String, Variable)>,
}

impl Graph {
    /// An empty store.
    pub fn new() -> Self {
        Self::default()
    }

    /// A new variable that moves.
    pub fn coordinate(&mut self, name: &str) -> Symbol {
        self.new_symbol(name, Variable::Coordinate)
    }

    /// A new variable that is a squared distance.
    pub fn squared_distance(&mut self, name: &str) -> Symbol {
        self.new_symbol(name, Variable::SquaredDistance)
    }

    /// A new variable that is constant along a step.
    pub fn parameter(&mut self, name: &str) -> Symbol {
        self.new_symbol(name, Variable::Parameter)
    }

    /// A new variable.
    pub(crate) fn new_symbol(&mut self, name: &str, stands_for: Variable) -> Symbol {
        self.names.push((name.to_owned(), stands_for));
        Symbol(u32::try_from(self.names.len() - 1).expect("fewer than 2³² symbols"))
    }

    /// The name of a variable.
    pub fn name(&self, symbol: Symbol) -> &str {
        &self.names[symbol.0 as usize].0
    }

    /// What a variable stands for.
    pub fn variable(&self, symbol: Symbol) -> Variable {
        self.names[symbol.0 as usize].1
    }

    /// The node behind an expression.
    pub fn node(&self, e: Expr) -> &Node {
        &self.nodes[e.index()]
    }

    /// How many expressions there are.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    pub(super) fn intern(&mut self, node: Node) -> Expr {
        if let Some(&e) = self.index.get(&node) {
            return e;
        }
        let e = Expr(u32::try_from(self.nodes.len()).expect("fewer than 2³² expressions"));
        self.orders.push(self.order_of(&node));
        self.nodes.push(node.clone());
        let mut moving = std::mem::take(&mut self.moving);
        self.extend_marks(
            &mut moving,
            |node| matches!(node, Node::Symbol(s) if self.variable(*s) != Variable::Parameter),
        );
        self.moving = moving;
        self.index.insert(node, e);
        e
    }

    /// Remembers that a law has a slope where a distance in it vanishes, which has none there.
    pub(crate) fn remember_centre(&mut self) {
        self.has_centre = true;
    }

    /// Whether one has.
    pub(crate) fn has_centre(&self) -> bool {
        self.has_centre
    }

    /// The number x.
    pub fn number(&mut self, x: f64) -> Expr {
        self.intern(Node::Number(Number::new(x)))
    }

    /// 0.
    pub fn zero(&mut self) -> Expr {
        self.number(0.0)
    }

    /// 1.
    pub fn one(&mut self) -> Expr {
        self.number(1.0)
    }

    /// The value of a variable.
    pub fn symbol(&mut self, symbol: Symbol) -> Expr {
        self.intern(Node::Symbol(symbol))
    }

    /// The values of variables.
    pub fn symbols(&mut self, symbols: &[Symbol]) -> Vec<Expr> {
        symbols.iter().map(|&symbol| self.symbol(symbol)).collect()
    }

    /// The number, if the expression is one.
    pub fn as_number(&self, e: Expr) -> Option<f64> {
        match self.node(e) {
            Node::Number(n) => Some(n.value()),
            _ => None,
        }
    }

    /// Whether the expression is the number 0.
    pub fn is_zero(&self, e: Expr) -> bool {
        self.as_number(e) == Some(0.0)
    }

    /// The expressions that this one is made of.
    pub fn children(&self, e: Expr) -> Vec<Expr> {
        let mut children = vec![];
        self.each_child(e, |c| children.push(c));
        children
    }

    /// Visits them, without a list.
    pub(crate) fn each_child(&self, e: Expr, mut visit: impl FnMut(Expr)) {
        match self.node(e) {
            Node::Number(_) | Node::Symbol(_) => {}
            Node::Sum { terms, .. } => terms.iter().for_each(|&(_, t)| visit(t)),
            Node::Product { factors, .. } => factors.iter().for_each(|&(f, _)| visit(f)),
            Node::Unary(_, u) => visit(*u),
            Node::Binary(_, u, w) => [*u, *w].into_iter().for_each(visit),
            Node::Select(condition, yes, no) => {
                condition.operands().into_iter().chain([*yes, *no]).for_each(visit);
            }
        }
    }

    /// All expressions that the given ones are made of, themselves included, children before parents.
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        let end = roots.iter().map(|e| e.index() + 1).max().unwrap_or(0);
        let mut seen = vec![false; end];
        let mut stack: Vec<Expr> = roots.to_vec();
        while let Some(e) = stack.pop() {
            if !std::mem::replace(&mut seen[e.index()], true) {
                self.each_child(e, |c| stack.push(c));
            }
        }
        (0..end).filter(|&i| seen[i]).map(|i| Expr(i as u32)).collect()
    }

    /// For every expression, whether it contains one of the symbols.
    pub fn dependence(&self, symbols: &[Symbol]) -> Vec<bool> {
        let mut depends = vec![];
        self.extend_dependence(&mut depends, symbols);
        depends
    }

    /// The same for the expressions that have been stored since.
    pub(crate) fn extend_dependence(&self, depends: &mut Vec<bool>, symbols: &[Symbol]) {
        self.extend_marks(depends, |node| matches!(node, Node::Symbol(s) if symbols.contains(s)));
    }

    /// Marks what has been stored since: what is marked itself, and all that is made of it.
    pub(super) fn extend_marks(&self, marks: &mut Vec<bool>, marked: impl Fn(&Node) -> bool) {
        for i in marks.len()..self.nodes.len() {
            let mut any = marked(&self.nodes[i]);
            self.each_child(Expr(i as u32), |c| any |= marks[c.index()]);
            marks.push(any);
        }
    }

    /// Whether the expression contains one of the symbols.
    pub fn depends_on(&self, e: Expr, symbols: &[Symbol]) -> bool {
        self.reachable(&[e]).iter().any(|&n| matches!(self.node(n), Node::Symbol(s) if symbols.contains(s)))
    }
}
