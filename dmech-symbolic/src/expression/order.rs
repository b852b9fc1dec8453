//! To which order an expression vanishes where the coordinates in it do.

use super::{Binary, Expr, Graph, Node, Number, Unary, Variable};

impl Graph {
    /// The order to which an expression vanishes where the coordinates in it do, as it is written: x² + y² to the second, its root to
    /// the first, 1/x to order −1; 0 where it need not vanish. A root or power of a law has a slope of 0 there from above the first
    /// order on, and an infinite one below it.
    pub(crate) fn order(&self, e: Expr) -> f64 {
        self.orders[e.index()]
    }

    /// The order of a node of stored expressions.
    pub(super) fn order_of(&self, node: &Node) -> f64 {
        match node {
            Node::Number(_) => 0.0,
            Node::Symbol(s) => match self.variable(*s) {
                Variable::SquaredDistance => 2.0,
                Variable::Coordinate => 1.0,
                Variable::Parameter => 0.0,
            },
            Node::Sum { constant, terms } => {
                let start = if *constant == Number::ZERO { f64::INFINITY } else { 0.0 };
                let least = terms.iter().fold(start, |least, &(_, term)| least.min(self.order(term)));
                let mut moving = terms.iter().filter(|&&(_, term)| self.order(term) != 0.0).peekable();
                // x − c vanishes elsewhere, but |x| − c and x² + c not where |x| and x² do.
                let shifted = least == 0.0 && moving.peek().is_some() && moving.all(|&(_, term)| self.is_linear(term));
                if shifted { 1.0 } else { least }
            }
            Node::Product { factors, .. } => factors.iter().map(|&(f, n)| f64::from(n) * self.order(f)).sum(),
            Node::Unary(Unary::Sqrt, u) => self.order(*u) / 2.0,
            Node::Unary(Unary::Cbrt, u) => self.order(*u) / 3.0,
            Node::Unary(f, u) if f.exact_value(0.0) == Some(0.0) => self.order(*u),
            Node::Unary(..) | Node::Binary(Binary::Atan2, ..) => 0.0,
            Node::Binary(Binary::Powf, u, w) => self.as_number(*w).map_or(0.0, |w| w * self.order(*u)),
            Node::Binary(Binary::Min | Binary::Max, one, two) | Node::Select(_, one, two) => {
                self.order(*one).min(self.order(*two))
            }
        }
    }

    /// A coordinate, or a multiple of one.
    fn is_linear(&self, e: Expr) -> bool {
        let is_coordinate = |e: Expr| matches!(self.node(e), Node::Symbol(_)) && self.order(e) == 1.0;
        self.order(e) == 1.0 && self.factors(e).1.iter().any(|&(f, _)| is_coordinate(f))
    }
}
