//! `if`, comparisons, `&&`, `||`.

use dmech_symbolic::expression::{Condition, Node, Relation};
use syn::{BinOp, Expr, ExprBinary, ExprIf};

use crate::diagnostics::body;

use super::budget::MAX_COMPARISONS;
use super::interpreter::{Formula, Interpreter};
use super::statement::result_of;
use super::value::{Truth, Value};

/// A merged value, or what the two branches are called where they do not go together.
type Merged<T> = Result<T, (String, String)>;

/// How two values are compared.
#[derive(Clone, Copy)]
pub(super) enum Comparison {
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    NotEqual,
}

impl Comparison {
    pub(super) fn of(op: &BinOp) -> Option<Self> {
        match op {
            BinOp::Lt(_) => Some(Self::Less),
            BinOp::Le(_) => Some(Self::LessOrEqual),
            BinOp::Gt(_) => Some(Self::Greater),
            BinOp::Ge(_) => Some(Self::GreaterOrEqual),
            BinOp::Eq(_) => Some(Self::Equal),
            BinOp::Ne(_) => Some(Self::NotEqual),
            _ => None,
        }
    }

    fn holds<T: PartialOrd>(self, left: T, right: T) -> bool {
        match self {
            Self::Less => left < right,
            Self::LessOrEqual => left <= right,
            Self::Greater => left > right,
            Self::GreaterOrEqual => left >= right,
            Self::Equal => left == right,
            Self::NotEqual => left != right,
        }
    }
}

impl<'m> Interpreter<'m> {
    pub(super) fn comparison(&mut self, comparison: Comparison, binary: &'m ExprBinary, e: &'m Expr) -> Value {
        let (left, right) = (self.value(&binary.left), self.value(&binary.right));
        match (left, right) {
            (Value::Unknown, _) | (_, Value::Unknown) => Value::Unknown,
            (Value::Integer(m), Value::Integer(n)) => Value::known(comparison.holds(m, n)),
            (Value::Truth(one), Value::Truth(two)) => match (one, two, comparison) {
                (Truth::Known(one), Truth::Known(two), _) => Value::known(comparison.holds(one, two)),
                _ => self.refuse(body::compared_conditions(e)),
            },
            (left, right) => {
                let (left, right) = (self.number(left, &*binary.left), self.number(right, &*binary.right));
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

    /// left && right; the right side is not looked at where the left one decides.
    pub(super) fn conjunction(&mut self, left: &'m Expr, right: &'m Expr, e: &'m Expr) -> Value {
        let one = self.condition(left);
        if let Some(Truth::Known(false)) = one {
            return Value::known(false);
        }
        match (one, self.condition(right)) {
            (Some(Truth::Known(true)), Some(two)) => Value::Truth(two),
            (Some(_), Some(Truth::Known(false))) => Value::known(false),
            (Some(one), Some(Truth::Known(true))) => Value::Truth(one),
            (Some(Truth::When(one)), Some(Truth::When(two))) => self.joined(one.and(two), e),
            _ => Value::Unknown,
        }
    }

    /// left || right
    pub(super) fn disjunction(&mut self, left: &'m Expr, right: &'m Expr, e: &'m Expr) -> Value {
        let one = self.condition(left);
        if let Some(Truth::Known(true)) = one {
            return Value::known(true);
        }
        match (one, self.condition(right)) {
            (Some(Truth::Known(false)), Some(two)) => Value::Truth(two),
            (Some(_), Some(Truth::Known(true))) => Value::known(true),
            (Some(one), Some(Truth::Known(false))) => Value::Truth(one),
            (Some(Truth::When(one)), Some(Truth::When(two))) => self.joined(one.or(two), e),
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
        let yes = self.block(&branch.then_branch);
        let after_yes = std::mem::replace(&mut self.scope, before.clone());
        let no = self.else_branch(branch);
        let after_no = std::mem::take(&mut self.scope);
        self.scope = before;
        let pairs = after_yes.bindings.into_iter().zip(after_no.bindings);
        for (binding, (yes, no)) in pairs.enumerate() {
            let before = std::mem::replace(&mut self.scope.bindings[binding].value, Value::Unknown);
            self.scope.bindings[binding].value = match &condition {
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

    /// `yes` where the condition holds, `no` elsewhere; what the two are called where they do not go together.
    fn merge(&mut self, condition: &Condition, before: Option<&Value>, yes: Value, no: Value) -> Merged<Value> {
        let kinds = (yes.kind(), no.kind());
        Ok(match (yes, no) {
            (Value::Unknown, _) | (_, Value::Unknown) => Value::Unknown,
            (Value::Unset, _) | (_, Value::Unset) => Value::Unset,
            (Value::Law, Value::Law) => Value::Law,
            (Value::Integer(m), Value::Integer(n)) if m == n => Value::Integer(m),
            (Value::Field(one), Value::Field(two)) if one.key == two.key => Value::Field(one),
            (yes @ (Value::Number(_) | Value::Field(_)), no @ (Value::Number(_) | Value::Field(_))) => {
                let (Some(yes), Some(no)) = (self.as_number(yes), self.as_number(no)) else { return Err(kinds) };
                Value::Number(match before {
                    Some(&Value::Number(before)) => self.select_change(condition, before, yes, no),
                    _ => self.graph.select(condition.clone(), yes, no),
                })
            }
            (Value::Vector(yes), Value::Vector(no)) if yes.len() == no.len() => {
                let pairs = yes.into_iter().zip(no);
                Value::Vector(pairs.map(|(yes, no)| self.graph.select(condition.clone(), yes, no)).collect())
            }
            (Value::Array(yes), Value::Array(no)) if yes.len() == no.len() => {
                Value::Array(self.merge_all(condition, before, yes, no)?)
            }
            (Value::Tuple(yes), Value::Tuple(no)) if yes.len() == no.len() => {
                Value::Tuple(self.merge_all(condition, before, yes, no)?)
            }
            (Value::Items(yes), Value::Items(no)) if yes.len() == no.len() => {
                Value::Items(self.merge_all(condition, before, yes, no)?)
            }
            (Value::Truth(Truth::Known(yes)), Value::Truth(Truth::Known(no))) if yes == no => Value::known(yes),
            (Value::Truth(yes), Value::Truth(no)) => {
                let merged = merged_truth(condition, yes, no);
                if merged.operands().len() > 2 * MAX_COMPARISONS {
                    return Err(kinds);
                }
                Value::Truth(Truth::When(merged))
            }
            _ => return Err(kinds),
        })
    }

    fn as_number(&mut self, value: Value) -> Option<Formula> {
        match value {
            Value::Number(number) => Some(number),
            Value::Field(field) => Some(self.field_number(&field)),
            _ => None,
        }
    }

    fn merge_all(
        &mut self,
        condition: &Condition,
        before: Option<&Value>,
        yes: Vec<Value>,
        no: Vec<Value>,
    ) -> Merged<Vec<Value>> {
        let before = match before {
            Some(Value::Array(parts) | Value::Tuple(parts)) => &parts[..],
            _ => &[],
        };
        let pairs = yes.into_iter().zip(no).enumerate();
        pairs.map(|(i, (yes, no))| self.merge(condition, before.get(i), yes, no)).collect()
    }

    /// s + {f if c, else 0} rather than {s + f if c, else s}: sums that collect terms under conditions stay flat.
    fn select_change(&mut self, condition: &Condition, before: Formula, yes: Formula, no: Formula) -> Formula {
        let (gain_yes, gain_no) = (self.graph.sub(yes, before), self.graph.sub(no, before));
        let held = self.terms(before);
        let is_part = |this: &Self, sum, gain| this.terms(gain) + held == this.terms(sum);
        if held == 0 || !is_part(self, yes, gain_yes) || !is_part(self, no, gain_no) {
            return self.graph.select(condition.clone(), yes, no);
        }
        let gain = self.graph.select(condition.clone(), gain_yes, gain_no);
        self.graph.add(&[before, gain])
    }

    /// How many terms a sum has.
    fn terms(&self, e: Formula) -> usize {
        match self.graph.node(e) {
            Node::Number(x) => usize::from(x.value() != 0.0),
            Node::Sum { constant, terms } => terms.len() + usize::from(constant.value() != 0.0),
            _ => 1,
        }
    }
}

/// (c and yes) or (not c and no), without what is known.
fn merged_truth(condition: &Condition, yes: Truth, no: Truth) -> Condition {
    let c = condition.clone();
    match (yes, no) {
        (Truth::Known(true), Truth::Known(_)) => c,
        (Truth::Known(false), Truth::Known(_)) => c.negated(),
        (Truth::Known(true), Truth::When(no)) => c.or(no),
        (Truth::Known(false), Truth::When(no)) => c.negated().and(no),
        (Truth::When(yes), Truth::Known(true)) => c.negated().or(yes),
        (Truth::When(yes), Truth::Known(false)) => c.and(yes),
        (Truth::When(yes), Truth::When(no)) => c.clone().and(yes).or(c.negated().and(no)),
    }
}

/// Below a condition that is itself wrong: only what both branches left alone is still known.
fn unknown_if_changed(one: Value, two: Value) -> Value {
    match (one, two) {
        (Value::Number(one), Value::Number(two)) if one == two => Value::Number(one),
        (Value::Integer(one), Value::Integer(two)) if one == two => Value::Integer(one),
        (Value::Field(one), Value::Field(two)) if one.key == two.key => Value::Field(one),
        (Value::Law, Value::Law) => Value::Law,
        (Value::Vector(one), Value::Vector(two)) if one == two => Value::Vector(one),
        (Value::Array(one), Value::Array(two)) if one.len() == two.len() => {
            Value::Array(one.into_iter().zip(two).map(|(one, two)| unknown_if_changed(one, two)).collect())
        }
        (Value::Tuple(one), Value::Tuple(two)) if one.len() == two.len() => {
            Value::Tuple(one.into_iter().zip(two).map(|(one, two)| unknown_if_changed(one, two)).collect())
        }
        _ => Value::Unknown,
    }
}
