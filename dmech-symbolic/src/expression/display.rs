//! Expressions in readable mathematics: −gm/√(x² + y²).

use std::fmt::{self, Formatter};

use super::{Binary, Condition, Expr, Graph, Node, Number, Relation, Unary, Variable};

/// Shows an expression.
#[derive(Clone, Copy, Debug)]
pub struct Display<'a> {
    graph: &'a Graph,
    root: Expr,
}

/// How tightly the surroundings bind.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Power,
}

impl Graph {
    /// The expression in readable mathematics.
    pub fn display(&self, e: Expr) -> Display<'_> {
        Display { graph: self, root: e }
    }
}

impl<'a> Display<'a> {
    fn write(self, f: &mut Formatter<'_>, e: Expr, within: Precedence) -> fmt::Result {
        match self.graph.node(e) {
            Node::Number(n) => self.write_number(f, n.value(), within),
            Node::Symbol(s) => f.write_str(self.graph.name(*s)),
            Node::Sum { constant, terms } => {
                let parenthesised = within > Precedence::Sum;
                if parenthesised {
                    f.write_str("(")?;
                }
                // A difference reads better with its positive term first.
                let mut order: Vec<_> = terms.iter().collect();
                order.sort_by_key(|(c, t)| (c.value() < 0.0 || self.graph.leads_with_minus(*t)) as u8);
                for (i, &&(c, t)) in order.iter().enumerate() {
                    self.write_term(f, c.value(), t, i == 0)?;
                }
                if constant.value() != 0.0 {
                    f.write_str(if constant.value() < 0.0 { " − " } else { " + " })?;
                    self.write_number(f, constant.value().abs(), Precedence::Sum)?;
                }
                if parenthesised {
                    f.write_str(")")?;
                }
                Ok(())
            }
            Node::Product { coefficient, .. } => {
                let negative = coefficient.value() < 0.0;
                let parenthesised = within > Precedence::Product || (negative && within > Precedence::Sum);
                if parenthesised {
                    f.write_str("(")?;
                }
                if negative {
                    f.write_str("−")?;
                }
                self.write_product(f, coefficient.value().abs(), e)?;
                if parenthesised {
                    f.write_str(")")?;
                }
                Ok(())
            }
            Node::Unary(function, u) => self.write_unary(f, *function, *u, within),
            Node::Binary(Binary::Powf, u, p) => {
                self.write(f, *u, Precedence::Power)?;
                f.write_str("^")?;
                self.write(f, *p, Precedence::Power)
            }
            Node::Binary(function, u, w) => {
                write!(f, "{}(", function.method())?;
                self.write(f, *u, Precedence::Sum)?;
                f.write_str(", ")?;
                self.write(f, *w, Precedence::Sum)?;
                f.write_str(")")
            }
            Node::Select(condition, yes, no) => {
                f.write_str("{")?;
                self.write(f, *yes, Precedence::Sum)?;
                f.write_str(" if ")?;
                self.write_condition(f, condition)?;
                f.write_str(", else ")?;
                self.write(f, *no, Precedence::Sum)?;
                f.write_str("}")
            }
        }
    }

    fn write_number(self, f: &mut Formatter<'_>, x: f64, within: Precedence) -> fmt::Result {
        let size = x.abs();
        let digits = if Number::new(x) == Number::ROUNDING {
            "7ε".to_owned()
        } else if x == 0.0 || (1e-5..1e16).contains(&size) {
            format!("{size}")
        } else {
            format!("{size:e}")
        };
        match (x < 0.0 && within > Precedence::Sum, x < 0.0) {
            (true, _) => write!(f, "(−{digits})"),
            (false, true) => write!(f, "−{digits}"),
            (false, false) => write!(f, "{digits}"),
        }
    }

    fn write_term(self, f: &mut Formatter<'_>, c: f64, t: Expr, first: bool) -> fmt::Result {
        let (own, _) = self.graph.factors(t);
        let negative = (c < 0.0) != (own.value() < 0.0);
        f.write_str(match (first, negative) {
            (true, true) => "−",
            (true, false) => "",
            (false, true) => " − ",
            (false, false) => " + ",
        })?;
        self.write_product(f, c.abs() * own.value().abs(), t)
    }

    /// |c| times the factors of e, negative powers below a stroke.
    fn write_product(self, f: &mut Formatter<'_>, c: f64, e: Expr) -> fmt::Result {
        let (_, mut factors) = self.graph.factors(e);
        // Numbers and parameters before what moves: 3·gm·x.
        factors.sort_by_key(|(f, _)| match self.graph.node(*f) {
            Node::Number(_) => 0,
            Node::Symbol(s) if self.graph.variable(*s) == Variable::Parameter => 1,
            _ => 2,
        });
        let numbers = |above: bool| factors.iter().filter(move |(_, n)| (*n > 0) == above);
        let (above, below) = (numbers(true).count(), numbers(false).count());
        let mut dot = false;
        if c != 1.0 || above == 0 {
            self.write_number(f, c, Precedence::Product)?;
            dot = true;
        }
        for &(factor, n) in numbers(true) {
            if std::mem::replace(&mut dot, true) {
                f.write_str("·")?;
            }
            self.write_power(f, factor, n, above + below + usize::from(c != 1.0) > 1)?;
        }
        if below > 0 {
            f.write_str(if below > 1 { "/(" } else { "/" })?;
            for (i, &(factor, n)) in numbers(false).enumerate() {
                if i > 0 {
                    f.write_str("·")?;
                }
                self.write_power(f, factor, -n, true)?;
            }
            if below > 1 {
                f.write_str(")")?;
            }
        }
        Ok(())
    }

    fn write_power(self, f: &mut Formatter<'_>, base: Expr, n: i32, in_product: bool) -> fmt::Result {
        if n == 1 {
            return self.write(f, base, if in_product { Precedence::Product } else { Precedence::Sum });
        }
        self.write(f, base, Precedence::Power)?;
        for digit in n.to_string().chars() {
            let raised = match digit {
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                '-' => '⁻',
                '0' => '⁰',
                digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
            };
            write!(f, "{raised}")?;
        }
        Ok(())
    }

    fn write_unary(self, f: &mut Formatter<'_>, function: Unary, u: Expr, within: Precedence) -> fmt::Result {
        match function {
            Unary::Abs => {
                f.write_str("|")?;
                self.write(f, u, Precedence::Sum)?;
                f.write_str("|")
            }
            Unary::Sqrt | Unary::Cbrt => {
                let parenthesised = within == Precedence::Power;
                f.write_str(if parenthesised { "(" } else { "" })?;
                f.write_str(if function == Unary::Sqrt { "√" } else { "∛" })?;
                self.write(f, u, Precedence::Power)?;
                f.write_str(if parenthesised { ")" } else { "" })
            }
            Unary::Exp => {
                f.write_str("exp(")?;
                self.write(f, u, Precedence::Sum)?;
                f.write_str(")")
            }
            _ => {
                write!(f, "{}(", function.method())?;
                self.write(f, u, Precedence::Sum)?;
                f.write_str(")")
            }
        }
    }

    fn write_condition(self, f: &mut Formatter<'_>, condition: &Condition) -> fmt::Result {
        match condition {
            Condition::Compare(relation, left, right) => {
                self.write(f, *left, Precedence::Sum)?;
                f.write_str(match relation {
                    Relation::Less => " < ",
                    Relation::LessOrEqual => " ≤ ",
                    Relation::Equal => " = ",
                })?;
                self.write(f, *right, Precedence::Sum)
            }
            Condition::Not(inner) => {
                f.write_str("not (")?;
                self.write_condition(f, inner)?;
                f.write_str(")")
            }
            Condition::And(one, two) | Condition::Or(one, two) => {
                f.write_str("(")?;
                self.write_condition(f, one)?;
                f.write_str(if matches!(condition, Condition::And(..)) { " and " } else { " or " })?;
                self.write_condition(f, two)?;
                f.write_str(")")
            }
        }
    }
}

impl fmt::Display for Display<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.write(f, self.root, Precedence::Sum)
    }
}
