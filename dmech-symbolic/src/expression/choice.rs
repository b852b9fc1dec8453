//! Choices: expressions that are one thing here and another there.

use super::{Binary, Condition, Expr, Graph, Node, Number, Relation, Symbol, Unary};

/// `yes` where the condition holds, `no` elsewhere: `if`, `min`, `max` or `clamp`.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Which of the two.
    pub condition: Condition,
    /// The expression where it holds.
    pub yes: Expr,
    /// The expression where it does not.
    pub no: Expr,
}

impl Choice {
    /// All expressions that it is made of.
    pub fn roots(&self) -> Vec<Expr> {
        let mut roots = self.condition.operands();
        roots.extend([self.yes, self.no]);
        roots
    }
}

impl Node {
    /// Whether it is one of two expressions, as a condition says: [`Graph::choice`] has them.
    pub(crate) fn is_choice(&self) -> bool {
        match self {
            Self::Select(..) => true,
            Self::Binary(f, ..) => f.is_extremum(),
            _ => false,
        }
    }
}

impl Condition {
    /// What is not negative is so small that its inverse is lost.
    pub(crate) fn lost(graph: &mut Graph, power: Expr) -> Self {
        Self::less(power, graph.number(Number::LEAST.value()))
    }

    /// Its truth where both sides are numbers.
    fn decided(&self, graph: &Graph) -> Option<bool> {
        match self {
            Self::Compare(relation, left, right) => {
                let (left, right) = (graph.as_number(*left)?, graph.as_number(*right)?);
                Some(match relation {
                    Relation::Less => left < right,
                    Relation::LessOrEqual => left <= right,
                    Relation::Equal => left == right,
                })
            }
            Self::Not(inner) => inner.decided(graph).map(|truth| !truth),
            Self::And(one, two) => match (one.decided(graph), two.decided(graph)) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (Some(true), Some(true)) => Some(true),
                _ => None,
            },
            Self::Or(one, two) => match (one.decided(graph), two.decided(graph)) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (Some(false), Some(false)) => Some(false),
                _ => None,
            },
        }
    }
}

impl Graph {
    /// The first expression where the condition holds, the second elsewhere.
    ///
    /// Rules, on all of the domain: a condition between numbers is decided; equal branches need none.
    pub fn select(&mut self, condition: Condition, yes: Expr, no: Expr) -> Expr {
        match condition.decided(self) {
            Some(true) => yes,
            Some(false) => no,
            None if yes == no => yes,
            None => match condition {
                Condition::Not(inner) => self.intern(Node::Select(*inner, no, yes)),
                condition => self.intern(Node::Select(condition, yes, no)),
            },
        }
    }

    /// The expression as a choice between two others, if it is one.
    pub fn choice(&self, e: Expr) -> Option<Choice> {
        match self.node(e) {
            Node::Select(condition, yes, no) => Some(Choice { condition: condition.clone(), yes: *yes, no: *no }),
            Node::Binary(Binary::Min, u, w) => {
                Some(Choice { condition: Condition::less_or_equal(*u, *w), yes: *u, no: *w })
            }
            Node::Binary(Binary::Max, u, w) => {
                Some(Choice { condition: Condition::less_or_equal(*w, *u), yes: *u, no: *w })
            }
            Node::Binary(Binary::AtMost, u, w) => Some(Choice { condition: Condition::less(*w, *u), yes: *w, no: *u }),
            Node::Binary(Binary::AtLeast, u, w) => Some(Choice { condition: Condition::less(*u, *w), yes: *w, no: *u }),
            _ => None,
        }
    }

    /// For every expression that has been stored since, whether it is made with a choice.
    pub(crate) fn extend_choosing(&self, chosen: &mut Vec<bool>) {
        self.extend_marks(chosen, Node::is_choice);
    }

    /// The terms that both branches of an `if` have, if there are any, and the choice between what is left of the branches.
    pub(crate) fn shared_terms(&mut self, e: Expr) -> (Option<Expr>, Expr) {
        let Node::Select(condition, yes, no) = self.node(e).clone() else { return (None, e) };
        let [of_yes, of_no] = [yes, no].map(|branch| self.terms(branch));
        let (shared, own): (Vec<_>, Vec<_>) = of_yes.into_iter().partition(|term| of_no.contains(term));
        if shared.is_empty() {
            return (None, e);
        }
        let others: Vec<_> = of_no.into_iter().filter(|term| !shared.contains(term)).collect();
        let [shared, yes, no] = [shared, own, others].map(|terms| self.linear_combination(&terms));
        (Some(shared), self.select(condition, yes, no))
    }

    /// The expression as Σ cᵢ tᵢ; the term of a constant is 1.
    fn terms(&mut self, e: Expr) -> Vec<(Number, Expr)> {
        let one = self.one();
        match self.node(e).clone() {
            Node::Number(c) => vec![(c, one)],
            Node::Sum { constant, terms } => {
                let constant = (constant != Number::ZERO).then_some((constant, one));
                terms.iter().copied().chain(constant).collect()
            }
            Node::Product { coefficient, factors } => {
                vec![(coefficient, self.product_of(Number::ONE, factors.to_vec()))]
            }
            _ => vec![(Number::ONE, e)],
        }
    }

    /// The parts of an expression that choose by the values of the symbols: their gradients may jump.
    pub fn choices(&self, e: Expr, symbols: &[Symbol]) -> Vec<Expr> {
        let moves = self.dependence(symbols);
        let chooses = |e: &Expr| match self.node(*e) {
            Node::Unary(f, _) => *f == Unary::Abs || f.is_step(),
            _ => self.choice(*e).is_some(),
        };
        self.reachable(&[e]).into_iter().filter(|e| moves[e.index()] && chooses(e)).collect()
    }
}
