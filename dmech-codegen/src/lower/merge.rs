//! Joining what two branches leave behind.

use dmech_symbolic::expression::{Condition, Node};

use super::budget::MAX_COMPARISONS;
use super::interpreter::{Expression, Interpreter};
use super::value::{Truth, Value};

/// A merged value, or what the two branches are called where they do not go together.
type Merged<T> = Result<T, (String, String)>;

impl Interpreter<'_> {
    /// `yes` where the condition holds, `no` elsewhere; what the two are called where they do not go together.
    pub(super) fn merge(
        &mut self,
        condition: &Condition,
        before: Option<&Value>,
        yes: Value,
        no: Value,
    ) -> Merged<Value> {
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
            // A condition that neither branch has touched stays as it was: joined with itself it would double at every `if`.
            (Value::Truth(Truth::When(yes)), Value::Truth(Truth::When(no))) if yes == no => {
                Value::Truth(Truth::When(yes))
            }
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

    fn as_number(&mut self, value: Value) -> Option<Expression> {
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
    fn select_change(
        &mut self,
        condition: &Condition,
        before: Expression,
        yes: Expression,
        no: Expression,
    ) -> Expression {
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
    fn terms(&self, e: Expression) -> usize {
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
pub(super) fn unknown_if_changed(one: Value, two: Value) -> Value {
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
