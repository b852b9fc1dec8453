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
                let least = self.least_order(terms).min(start);
                let mut moving = terms.iter().filter(|&&(_, term)| self.moves(term)).peekable();
                // x − c vanishes elsewhere, but |x| − c and x² + c not where |x| and x² do.
                let shifted = least == 0.0 && moving.peek().is_some() && moving.all(|&(_, term)| self.is_linear(term));
                if shifted { 1.0 } else { least }
            }
            Node::Product { factors, .. } => factors.iter().map(|&(f, n)| f64::from(n) * self.order(f)).sum(),
            Node::Unary(Unary::Sqrt, u) => self.order(*u) / 2.0,
            Node::Unary(Unary::Cbrt, u) => self.order(*u) / 3.0,
            Node::Unary(f, u) if f.exact_value(0.0) == Some(0.0) => self.order(*u),
            Node::Unary(Unary::Ln, u) => self.order_beside_one(*u),
            Node::Unary(..) | Node::Binary(Binary::Atan2, ..) => 0.0,
            Node::Binary(Binary::Powf, u, w) => self.as_number(*w).map_or(0.0, |w| w * self.order(*u)),
            // max(x, 0) vanishes as x does: a branch that is 0 is so to every order.
            Node::Binary(_, one, two) | Node::Select(_, one, two) => {
                let of = |branch: Expr| if self.is_zero(branch) { f64::INFINITY } else { self.order(branch) };
                of(*one).min(of(*two))
            }
        }
    }

    /// The order to which u vanishes in 1 + u, and the logarithm of that; 0 of anything else.
    fn order_beside_one(&self, e: Expr) -> f64 {
        match self.node(e) {
            Node::Sum { constant, terms } if *constant == Number::ONE => self.least_order(terms).max(0.0),
            _ => 0.0,
        }
    }

    fn least_order(&self, terms: &[(Number, Expr)]) -> f64 {
        terms.iter().fold(f64::INFINITY, |least, &(_, term)| least.min(self.order(term)))
    }

    /// Whether e, times something outside, is above the first order where it vanishes: a root in it has a slope of 0 there.
    pub(crate) fn is_flat(&self, outside: Expr, e: Expr) -> bool {
        let may_have_root = !matches!(self.node(e), Node::Sum { .. });
        self.order(outside) + self.order(e) > 1.0 || may_have_root && self.own_order(e) > 1.0
    }

    /// The same of where an expression vanishes by itself, be that where its coordinates do or elsewhere: the second for squares, what
    /// they add up to, and 1 − cos x and its like, and so on for their roots.
    pub(crate) fn own_order(&self, e: Expr) -> f64 {
        let (below, degree) = self.below_roots(e);
        if degree != 1.0 || self.order(e) == 0.0 { degree * self.order_from_extremum(below) } else { self.order(e) }
    }

    /// An expression as a power of something without a root, k u√u as u^{3/2}.
    fn below_roots(&self, e: Expr) -> (Expr, f64) {
        match self.node(e) {
            Node::Unary(Unary::Sqrt, u) => self.times(*u, 0.5),
            Node::Unary(Unary::Cbrt, u) => self.times(*u, 1.0 / 3.0),
            Node::Product { factors, .. }
                if factors.len() == 1 || factors.iter().any(|&(f, _)| self.root(f).is_some()) =>
            {
                let moving = factors.iter().filter(|&&(f, _)| self.moves(f));
                let mut parts = moving.map(|&(f, n)| self.times(f, f64::from(n)));
                let (first, degree) = parts.next().unwrap_or((e, 1.0));
                let all =
                    parts.try_fold(degree, |sum, (below, degree)| self.are_alike(below, first).then_some(sum + degree));
                all.map_or((e, 1.0), |degree| (first, degree))
            }
            _ => (e, 1.0),
        }
    }

    fn times(&self, e: Expr, factor: f64) -> (Expr, f64) {
        let (below, degree) = self.below_roots(e);
        (below, factor * degree)
    }

    /// 2 for what comes to 0 and is on one side of it everywhere: there it has no slope.
    fn order_from_extremum(&self, e: Expr) -> f64 {
        let Node::Sum { constant, terms } = self.node(e) else { return self.order(e) };
        // The least that c times a term can be, none if it is not known; a parameter is not known to vanish.
        let least = |c: f64, term: Expr| match self.node(term) {
            Node::Unary(Unary::Sin | Unary::Cos, _) => Some(-c.abs()),
            Node::Unary(Unary::Cosh, _) => (c > 0.0).then_some(c),
            Node::Product { factors, .. } => {
                let is_square = factors.iter().all(|&(_, n)| n > 0 && n % 2 == 0) && self.moves(term);
                (is_square && c > 0.0).then_some(0.0)
            }
            _ => None,
        };
        let touches = [1.0, -1.0].into_iter().any(|side| {
            let start = side * constant.value();
            let all = terms.iter().try_fold(start, |sum, &(c, term)| Some(sum + least(side * c.value(), term)?));
            all == Some(0.0)
        });
        if touches { self.order(e).max(2.0) } else { self.order(e) }
    }

    /// Whether two expressions are the same but for their sign.
    fn are_alike(&self, one: Expr, two: Expr) -> bool {
        let opposite = |one: Number, two: Number| one.value() == -two.value();
        match (self.node(one), self.node(two)) {
            _ if one == two => true,
            (Node::Sum { constant: a, terms: one }, Node::Sum { constant: b, terms: two }) => {
                opposite(*a, *b)
                    && one.len() == two.len()
                    && one.iter().zip(two).all(|(&(c, one), &(d, two))| one == two && opposite(c, d))
            }
            _ => false,
        }
    }

    /// Whether there is a coordinate in an expression.
    fn moves(&self, e: Expr) -> bool {
        self.moving[e.index()]
    }

    /// A coordinate, or a multiple of one.
    fn is_linear(&self, e: Expr) -> bool {
        self.order(e) == 1.0 && self.factors(e).1.iter().any(|&(f, _)| self.is_coordinate(f))
    }

    /// A coordinate by itself.
    pub(crate) fn is_coordinate(&self, e: Expr) -> bool {
        matches!(self.node(e), Node::Symbol(_)) && self.order(e) == 1.0
    }
}
