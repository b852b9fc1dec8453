//! `+ - * / %` on numbers, integers and vectors, unary minus, casts.

use quote::ToTokens;
use syn::{BinOp, Expr, ExprBinary, ExprCast, ExprUnary, UnOp};

use crate::diagnostics::body;
use crate::model::{Known, known_type};

use super::code::bare;
use super::interpreter::{Expression, Interpreter};
use super::operator::{Comparison, Operator};
use super::value::{Truth, Value};

impl<'m> Interpreter<'m> {
    pub(super) fn binary_expression(&mut self, binary: &'m ExprBinary, e: &'m Expr) -> Value {
        if Operator::of(&binary.op).is_some() {
            return self.left_to_right(e);
        }
        if let Some(operator) = Operator::of_assignment(&binary.op) {
            return self.compound_assignment(binary, operator, e);
        }
        match &binary.op {
            BinOp::And(_) => self.connective(false, [&binary.left, &binary.right], e),
            BinOp::Or(_) => self.connective(true, [&binary.left, &binary.right], e),
            op => match Comparison::of(op) {
                Some(comparison) => self.comparison(comparison, binary, e),
                None => self.refuse(body::bit_operator(op)),
            },
        }
    }

    /// a + b − c + …, which the parser nests to the left, without recursion.
    fn left_to_right(&mut self, e: &'m Expr) -> Value {
        let mut links = vec![];
        let mut first = e;
        while let Expr::Binary(binary) = first
            && let Some(operator) = Operator::of(&binary.op)
        {
            links.push((operator, binary, first));
            first = &binary.left;
        }
        let mut left = self.value(first);
        for (operator, binary, whole) in links.into_iter().rev() {
            let excess = self.budget.step();
            if !self.within(excess, whole) {
                return Value::Unknown;
            }
            let right = self.value(&binary.right);
            left = self.combine(operator, left, right, whole, &binary.left, &binary.right);
        }
        left
    }

    /// left ∘ right
    pub(super) fn combine(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        whole: &'m Expr,
        left_at: &'m Expr,
        right_at: &'m Expr,
    ) -> Value {
        use Operator::*;
        match (left, right) {
            (Value::Unknown, _) | (_, Value::Unknown) => Value::Unknown,
            (Value::Integer(m), Value::Integer(n)) => self.integers(operator, m, n, whole),
            (Value::Vector(u), Value::Vector(w)) if matches!(operator, Add | Sub) && u.len() == w.len() => {
                self.componentwise(operator, &u, &w)
            }
            (Value::Vector(u), Value::Field(field)) if matches!(operator, Add | Sub) => {
                let w = self.field_vector(&field, u.len());
                self.componentwise(operator, &u, &w)
            }
            (Value::Field(field), Value::Vector(w)) if matches!(operator, Add | Sub) => {
                let u = self.field_vector(&field, w.len());
                self.componentwise(operator, &u, &w)
            }
            (Value::Vector(u), factor) if matches!(operator, Mul | Div) && is_scalar(&factor) => {
                let Some(factor) = self.number(factor, right_at) else { return Value::Unknown };
                Value::Vector(u.into_iter().map(|x| self.numbers(operator, x, factor)).collect())
            }
            (factor, Value::Vector(w)) if operator == Mul && is_scalar(&factor) => {
                let Some(factor) = self.number(factor, left_at) else { return Value::Unknown };
                Value::Vector(w.into_iter().map(|x| self.numbers(operator, factor, x)).collect())
            }
            (left, right) if is_scalar(&left) && is_scalar(&right) => {
                let (left, right) = (self.number(left, left_at), self.number(right, right_at));
                let (Some(left), Some(right)) = (left, right) else { return Value::Unknown };
                match operator {
                    Rem => self.refuse(body::remainder(whole)),
                    Div if self.graph.is_zero(right) => self.refuse(body::division_by_zero(right_at)),
                    _ => Value::Number(self.numbers(operator, left, right)),
                }
            }
            (left, right) => {
                let (left, right) = (left.kind(), right.kind());
                self.refuse(body::no_such_operation(whole, operator.sign(), (left_at, &left), (right_at, &right)))
            }
        }
    }

    fn numbers(&mut self, operator: Operator, left: Expression, right: Expression) -> Expression {
        match operator {
            Operator::Add => self.graph.add(&[left, right]),
            Operator::Sub => self.graph.sub(left, right),
            Operator::Mul => self.graph.mul(&[left, right]),
            Operator::Div | Operator::Rem => self.graph.div(left, right),
        }
    }

    fn componentwise(&mut self, operator: Operator, u: &[Expression], w: &[Expression]) -> Value {
        Value::Vector(u.iter().zip(w).map(|(&x, &y)| self.numbers(operator, x, y)).collect())
    }

    fn integers(&mut self, operator: Operator, m: i128, n: i128, whole: &Expr) -> Value {
        let result = match operator {
            Operator::Add => m.checked_add(n),
            Operator::Sub => m.checked_sub(n),
            Operator::Mul => m.checked_mul(n),
            Operator::Div => m.checked_div(n),
            Operator::Rem => m.checked_rem(n),
        };
        match result {
            Some(n) => Value::Integer(n),
            None => self.refuse(body::integer_overflow(whole)),
        }
    }

    pub(super) fn unary_expression(&mut self, unary: &'m ExprUnary, e: &'m Expr) -> Value {
        let value = self.value(&unary.expr);
        match (&unary.op, value) {
            (_, Value::Unknown) => Value::Unknown,
            (UnOp::Deref(_), _) if matches!(*unary.expr, Expr::Lit(_)) => self.refuse(body::stars(e)),
            (UnOp::Deref(_), value) => value,
            (UnOp::Neg(_), Value::Integer(n)) => match n.checked_neg() {
                Some(n) => Value::Integer(n),
                None => self.refuse(body::integer_overflow(e)),
            },
            (UnOp::Neg(_), Value::Vector(u)) => Value::Vector(u.into_iter().map(|x| self.graph.neg(x)).collect()),
            (UnOp::Neg(_), value) => match self.number(value, &*unary.expr) {
                Some(number) => Value::Number(self.graph.neg(number)),
                None => Value::Unknown,
            },
            (UnOp::Not(_), value) => match self.truth(value, &unary.expr) {
                Some(Truth::Known(truth)) => Value::known(!truth),
                Some(Truth::When(condition)) => Value::Truth(Truth::When(condition.negated())),
                None => Value::Unknown,
            },
            (op, _) => self.refuse(body::bit_operator(op)),
        }
    }

    /// `i as f64`, `self.n as f64`, `i as usize`
    pub(super) fn cast(&mut self, cast: &'m ExprCast, e: &'m Expr) -> Value {
        let value = self.value(&cast.expr);
        match (known_type(&cast.ty), value) {
            (_, Value::Unknown) => Value::Unknown,
            (Known::Float, Value::Integer(n)) => Value::Number(self.graph.number(n as f64)),
            (Known::Float, Value::Number(number)) => Value::Number(number),
            (Known::Float, Value::Field(field)) => self.cast_field(&field, &cast.ty),
            (Known::Integer, Value::Integer(n)) => match in_range(n, &cast.ty.to_token_stream().to_string()) {
                true => Value::Integer(n),
                false => self.refuse(body::integer_overflow(e)),
            },
            (Known::Single, _) => self.refuse(body::single_precision(&cast.ty)),
            (Known::Integer, Value::Number(_)) => self.refuse(body::cast_to_integer(e)),
            (Known::Integer, field @ Value::Field(_)) => {
                self.refuse(body::field_as_integer(e, bare(&cast.expr), &field.kind()))
            }
            (_, other) => self.refuse(body::cast(e, &other.kind())),
        }
    }
}

/// What can stand for one number, or is an integer that should.
fn is_scalar(value: &Value) -> bool {
    matches!(value, Value::Number(_) | Value::Field(_) | Value::Integer(_))
}

fn in_range(n: i128, ty: &str) -> bool {
    macro_rules! fits {
        ($($ty:ident)*) => {
            match ty.replace("size", "64").as_str() {
                $(stringify!($ty) => $ty::try_from(n).is_ok(),)*
                _ => true,
            }
        };
    }
    fits!(u8 i8 u16 i16 u32 i32 u64 i64 u128)
}
