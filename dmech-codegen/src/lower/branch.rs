//! `if`, comparisons, `&&`, `||`.

use dmech_symbolic::expression::{Condition, Relation};
use syn::{Expr, ExprBinary, ExprIf, ExprPath, ExprRange, RangeLimits};

use crate::diagnostics::body;

use super::budget::MAX_COMPARISONS;
use super::code::{bare, result_of};
use super::interpreter::Interpreter;
use super::merge::unknown_if_changed;
use super::name::float_constant;
use super::operator::Comparison;
use super::value::{Truth, Value};

impl<'m> Interpreter<'m> {
    pub(super) fn comparison(&mut self, comparison: Comparison, binary: &'m ExprBinary, e: &'m Expr) -> Value {
        if let Some((field, variant)) = self.with_a_variant(&binary.left, &binary.right) {
            return self.refuse(body::field_and_variant(e, field, variant));
        }
        let sides = (self.value(&binary.left), self.value(&binary.right));
        self.compared(comparison, sides, (&binary.left, &binary.right), e)
    }

    fn compared(&mut self, comparison: Comparison, sides: (Value, Value), at: (&Expr, &Expr), e: &Expr) -> Value {
        match sides {
            (Value::Unknown, _) | (_, Value::Unknown) => Value::Unknown,
            (Value::Integer(m), Value::Integer(n)) => Value::known(comparison.holds(m, n)),
            (Value::Truth(one), Value::Truth(two)) => match (one, two, comparison) {
                (Truth::Known(one), Truth::Known(two), _) => Value::known(comparison.holds(one, two)),
                _ => self.refuse(body::compared_conditions(e)),
            },
            (left, right) => {
                let (left, right) = (self.number(left, at.0), self.number(right, at.1));
                let (Some(left), Some(right)) = (left, right) else { return Value::Unknown };
                if let (Some(left), Some(right)) = (self.graph.as_number(left), self.graph.as_number(right)) {
                    return Value::known(comparison.holds(left, right));
                }
                let condition = match comparison {
                    Comparison::Less => Condition::Compare(Relation::Less, left, right),
                    Comparison::LessOrEqual => Condition::Compare(Relation::LessOrEqual, left, right),
                    Comparison::Greater => Condition::Compare(Relation::Less, right, left),
                    Comparison::GreaterOrEqual => Condition::Compare(Relation::LessOrEqual, right, left),
                    Comparison::Equal => Condition::Compare(Relation::Equal, left, right),
                    Comparison::NotEqual => Condition::Compare(Relation::Equal, left, right).negated(),
                };
                Value::Truth(Truth::When(condition))
            }
        }
    }

    /// `(a..b).contains(&x)`: a <= x && x < b.
    pub(super) fn contains(&mut self, range: &'m ExprRange, x: &'m Expr, e: &'m Expr) -> Value {
        let [low, high] = [&range.start, &range.end].map(|end| end.as_deref().map(|at| (self.value(at), at)));
        let (value, x) = (self.value(x), bare(x));
        let below = if let RangeLimits::Closed(_) = range.limits { Comparison::LessOrEqual } else { Comparison::Less };
        let low = low.map(|(a, at)| self.compared(Comparison::LessOrEqual, (a, value.clone()), (at, x), e));
        let high = high.map(|(b, at)| self.compared(below, (value, b), (x, at), e));
        match (low, high) {
            (Some(low), Some(high)) => {
                let both = [low, high].map(|value| self.truth(value, e));
                self.connected(false, both, e)
            }
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => self.refuse(body::contains_everything(e)),
        }
    }

    /// A field of the law and what looks like a variant of an enum, `Kind::Stiff` or `K::A`, which no constant `f64` can stand for.
    fn with_a_variant<'e>(&self, one: &'e Expr, other: &'e Expr) -> Option<(&'e Expr, &'e Expr)> {
        let is_field = |e: &Expr| match e {
            Expr::Field(field) => matches!(&*field.base, Expr::Path(base) if base.path.is_ident("self")),
            _ => false,
        };
        let is_variant = |e: &Expr| {
            let Expr::Path(ExprPath { qself: None, path, .. }) = e else { return false };
            let names: Vec<_> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
            let [_, .., name] = &names[..] else { return false };
            let known = self.model.is_own_type(&path.segments[0].ident) || float_constant(&names).is_some();
            let camel = name.starts_with(char::is_uppercase) && name.contains(char::is_lowercase);
            !known && (camel || name.chars().count() == 1)
        };
        [(one, other), (other, one)].into_iter().find(|&(field, variant)| is_field(field) && is_variant(variant))
    }

    /// left && right, which a false side decides, or left || right, which a true one does; the right side is not looked at where the left
    /// one decides.
    pub(super) fn connective(&mut self, decides: bool, [left, right]: [&'m Expr; 2], e: &'m Expr) -> Value {
        let one = self.condition(left);
        if let Some(Truth::Known(known)) = one
            && known == decides
        {
            return Value::known(decides);
        }
        let two = self.condition(right);
        self.connected(decides, [one, two], e)
    }

    fn connected(&mut self, decides: bool, [one, two]: [Option<Truth>; 2], e: &Expr) -> Value {
        match (one, two) {
            (Some(Truth::Known(known)), Some(_)) if known == decides => Value::known(decides),
            (Some(Truth::Known(_)), Some(two)) => Value::Truth(two),
            (Some(_), Some(Truth::Known(known))) if known == decides => Value::known(decides),
            (Some(one), Some(Truth::Known(_))) => Value::Truth(one),
            (Some(Truth::When(one)), Some(Truth::When(two))) => {
                let both = if decides { one.or(two) } else { one.and(two) };
                self.joined(both, e)
            }
            _ => Value::Unknown,
        }
    }

    fn joined(&mut self, condition: Condition, e: &Expr) -> Value {
        if condition.operands().len() > 2 * MAX_COMPARISONS {
            return self.refuse(body::condition_too_large(e));
        }
        Value::Truth(Truth::When(condition))
    }

    fn condition(&mut self, e: &'m Expr) -> Option<Truth> {
        let value = self.value(e);
        self.truth(value, e)
    }

    /// The value as a condition.
    pub(super) fn truth(&mut self, value: Value, at: &Expr) -> Option<Truth> {
        match value {
            Value::Truth(truth) => Some(truth),
            Value::Unknown => None,
            Value::Field(_) => {
                self.report(body::field_as_condition(at));
                None
            }
            _ if matches!(at, Expr::Assign(_)) => {
                self.report(body::assignment_as_condition(at));
                None
            }
            other => {
                self.report(body::expected_condition(at, &other.kind()));
                None
            }
        }
    }

    /// A condition that is known now chooses a branch; any other merges both.
    pub(super) fn if_expression(&mut self, branch: &'m ExprIf, e: &'m Expr) -> Value {
        let condition = match self.condition(&branch.cond) {
            Some(Truth::Known(true)) => return self.block(&branch.then_branch),
            Some(Truth::Known(false)) => return self.else_branch(branch),
            Some(Truth::When(condition)) => Some(condition),
            None => None,
        };
        let before = self.scope.clone();
        self.bind_let(&branch.cond);
        let yes = self.block(&branch.then_branch);
        let after_yes = std::mem::replace(&mut self.scope, before.clone());
        let no = self.else_branch(branch);
        let after_no = std::mem::take(&mut self.scope);
        self.scope = before;
        let pairs = after_yes.locals.into_iter().zip(after_no.locals);
        for (binding, (yes, no)) in pairs.enumerate() {
            let before = std::mem::replace(&mut self.scope.locals[binding].value, Value::Unknown);
            self.scope.locals[binding].value = match &condition {
                Some(condition) => {
                    let merged = self.merge(condition, Some(&before), yes.value, no.value);
                    merged.unwrap_or_else(|_| self.refuse(body::branches_differ_in(&branch.if_token, &yes.name)))
                }
                None => unknown_if_changed(yes.value, no.value),
            };
        }
        let Some(condition) = condition else { return Value::Unknown };
        self.merge_results(&condition, (yes, no), branch, e)
    }

    /// The value of the whole: integers that stand where numbers belong are found here.
    fn merge_results(&mut self, condition: &Condition, values: (Value, Value), branch: &'m ExprIf, e: &Expr) -> Value {
        let has_value =
            !matches!(&values.0, Value::Unknown) && !matches!(&values.0, Value::Tuple(parts) if parts.is_empty());
        if branch.else_branch.is_none() && has_value {
            return self.refuse(body::no_else(&branch.if_token));
        }
        let (yes, no) = match values {
            (Value::Integer(m), no) if !matches!(no, Value::Integer(_)) => {
                (self.integer_result(m, result_of(&branch.then_branch)), no)
            }
            (yes, Value::Integer(n)) if !matches!(yes, Value::Integer(_)) => {
                let at = branch.else_branch.as_ref().and_then(|(_, other)| match &**other {
                    Expr::Block(block) => result_of(&block.block),
                    _ => None,
                });
                (yes, self.integer_result(n, at))
            }
            values => values,
        };
        match self.merge(condition, None, yes, no) {
            Ok(value) => value,
            Err((yes, no)) => self.refuse(body::branches_differ(e, &yes, &no)),
        }
    }

    /// The names of `if let`, which is refused.
    fn bind_let(&mut self, condition: &Expr) {
        match condition {
            Expr::Let(condition) => self.bind_names(&condition.pat),
            Expr::Binary(both) => {
                self.bind_let(&both.left);
                self.bind_let(&both.right);
            }
            _ => {}
        }
    }

    fn integer_result(&mut self, n: i128, at: Option<&Expr>) -> Value {
        match at {
            Some(at) => {
                let number = self.number(Value::Integer(n), at);
                Self::from_number(number)
            }
            None => Value::Integer(n),
        }
    }

    fn else_branch(&mut self, branch: &'m ExprIf) -> Value {
        match &branch.else_branch {
            Some((_, other)) => self.value(other),
            None => Value::UNIT,
        }
    }
}
