//! The functions of `f64`, and the few of integers.

use std::cmp::Ordering;

use dmech_symbolic::expression::{Binary, Unary};
use proc_macro2::Ident;
use syn::Expr;

use crate::diagnostics::body;
use crate::model::Sibling;

use super::budget::MAX_EXPONENT;
use super::code::bare;
use super::interpreter::{Expression, Interpreter};
use super::value::{Given, Value};

/// Functions of one argument, by their name in Rust.
fn unary(name: &str) -> Option<Unary> {
    use Unary::*;
    const OF_F64: [Unary; 26] = [
        Sqrt, Cbrt, Exp, Exp2, ExpM1, Ln, Ln1p, Log2, Log10, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Asinh,
        Acosh, Atanh, Abs, Signum, Round, Floor, Trunc,
    ];
    OF_F64.into_iter().find(|f| f.method() == name)
}

/// How many arguments beside the receiver a function takes.
pub(super) fn arity(name: &str) -> Option<usize> {
    match name {
        "recip" | "sin_cos" | "to_radians" | "to_degrees" | "ceil" | "fract" => Some(0),
        "powi" | "powf" | "atan2" | "hypot" | "min" | "max" | "log" | "rem_euclid" => Some(1),
        "mul_add" | "clamp" => Some(2),
        name => unary(name).map(|_| 0),
    }
}

impl<'m> Interpreter<'m> {
    /// `x.f(…)` or `f64::f(x, …)`
    pub(super) fn function(
        &mut self,
        name: &Ident,
        receiver: Given<'m>,
        arguments: Vec<Given<'m>>,
        e: &'m Expr,
    ) -> Value {
        let text = name.to_string();
        let Some(expected) = arity(&text) else {
            return self.refuse(body::unknown_function(name, None));
        };
        if arguments.len() != expected {
            return self.refuse(body::wrong_arguments(name, expected, arguments.len()));
        }
        let x = self.number(receiver.value, receiver.at);
        if text == "powi" {
            return self.integer_power(x, &arguments[0], e);
        }
        if text == "powf" {
            return self.real_power(x, &arguments[0]);
        }
        let places: Vec<_> = arguments.iter().map(|a| a.at).collect();
        let others: Vec<_> = arguments.into_iter().map(|a| self.number(a.value, a.at)).collect();
        let others: Option<Vec<Expression>> = others.into_iter().collect();
        let (Some(x), Some(others)) = (x, others) else { return Value::Unknown };
        if let ("clamp", &[low, high], &[low_at, high_at]) = (text.as_str(), &others[..], &places[..])
            && let (Some(low), Some(high)) = (self.known_number(low, low_at), self.known_number(high, high_at))
            && !matches!(low.partial_cmp(&high), Some(Ordering::Less | Ordering::Equal))
        {
            return self.refuse(body::clamped_the_wrong_way(e, low, high));
        }
        if let ("rem_euclid", &[period], &[at]) = (text.as_str(), &others[..], &places[..])
            && self.graph.is_zero(period)
        {
            return self.refuse(body::division_by_zero(at));
        }
        let graph = &mut self.graph;
        Value::Number(match (text.as_str(), &others[..]) {
            ("recip", []) => graph.recip(x),
            ("sin_cos", []) => {
                let (sin, cos) = (graph.unary(Unary::Sin, x), graph.unary(Unary::Cos, x));
                return Value::Tuple(vec![Value::Number(sin), Value::Number(cos)]);
            }
            ("to_radians", []) => {
                let factor = graph.number(std::f64::consts::PI / 180.0);
                graph.mul(&[factor, x])
            }
            ("to_degrees", []) => {
                let factor = graph.number(180.0 / std::f64::consts::PI);
                graph.mul(&[factor, x])
            }
            ("atan2", &[y]) => graph.binary(Binary::Atan2, x, y),
            ("hypot", &[y]) => graph.hypot(x, y),
            ("min", &[y]) => graph.binary(Binary::Min, x, y),
            ("max", &[y]) => graph.binary(Binary::Max, x, y),
            ("log", &[base]) => {
                let (above, below) = (graph.unary(Unary::Ln, x), graph.unary(Unary::Ln, base));
                graph.div(above, below)
            }
            ("mul_add", &[a, b]) => {
                let product = graph.mul(&[x, a]);
                graph.add(&[product, b])
            }
            ("clamp", &[low, high]) => graph.clamp(x, low, high),
            ("ceil", []) => {
                let turned = graph.neg(x);
                let floor = graph.unary(Unary::Floor, turned);
                graph.neg(floor)
            }
            ("fract", []) => {
                let whole = graph.unary(Unary::Trunc, x);
                graph.sub(x, whole)
            }
            ("rem_euclid", &[period]) => {
                let period = graph.unary(Unary::Abs, period);
                let periods = graph.div(x, period);
                let whole = graph.unary(Unary::Floor, periods);
                let start = graph.mul(&[period, whole]);
                graph.sub(x, start)
            }
            _ => match unary(&text) {
                Some(f) => graph.unary(f, x),
                None => return self.refuse(body::unknown_function(name, None)),
            },
        })
    }

    /// The exponent of an integer power: what a field is, is not known.
    pub(super) fn exponent(&mut self, at: &'m Expr) -> Value {
        match self.field_among(at) {
            Some((field, found)) => {
                let is_cast = matches!(bare(at), Expr::Cast(cast) if std::ptr::eq(bare(&cast.expr), field));
                self.refuse(body::power_by_field(at, field, &found, is_cast))
            }
            None => self.value(at),
        }
    }

    /// A field in an integer expression, and what it is.
    fn field_among(&mut self, e: &'m Expr) -> Option<(&'m Expr, String)> {
        let mut e = bare(e);
        loop {
            e = match e {
                Expr::Cast(cast) => bare(&cast.expr),
                Expr::Unary(unary) => bare(&unary.expr),
                Expr::Binary(binary) => match self.field_among(&binary.right) {
                    // A long chain grows to the left.
                    None => bare(&binary.left),
                    found => return found,
                },
                Expr::Path(_) | Expr::Field(_) | Expr::Index(_) => {
                    return match self.quietly(|this| this.value(e)) {
                        value @ Value::Field(_) => Some((e, value.kind())),
                        _ => None,
                    };
                }
                _ => return None,
            };
        }
    }

    fn integer_power(&mut self, x: Option<Expression>, exponent: &Given<'m>, e: &Expr) -> Value {
        let n = match &exponent.value {
            Value::Integer(n) => *n,
            Value::Unknown => return Value::Unknown,
            other => return self.refuse(body::power_exponent(exponent.at, &other.kind())),
        };
        match (x, i32::try_from(n)) {
            (None, _) => Value::Unknown,
            (Some(x), Ok(n)) if n.abs() <= MAX_EXPONENT => Value::Number(self.graph.powi(x, n)),
            _ => self.refuse(body::exponent_too_large(e, MAX_EXPONENT)),
        }
    }

    fn real_power(&mut self, x: Option<Expression>, exponent: &Given<'m>) -> Value {
        let known = self.named_constant(exponent.at);
        let p = match (known, &exponent.value) {
            (Some(p), _) => Some(p),
            (None, Value::Integer(_)) => {
                self.report(body::integer_exponent(exponent.at));
                None
            }
            (None, value) => self.number(value.clone(), exponent.at),
        };
        match (x, p) {
            (Some(x), Some(p)) => Value::Number(self.graph.binary(Binary::Powf, x, p)),
            _ => Value::Unknown,
        }
    }

    /// The value of an expression that does not depend on anything, as far as the macro can see it.
    fn known_number(&mut self, e: Expression, at: &'m Expr) -> Option<f64> {
        let named = self.named_constant(at);
        self.graph.as_number(named.unwrap_or(e))
    }

    /// `Self::P`: powers become roots and products where the exponent is known.
    fn named_constant(&mut self, at: &'m Expr) -> Option<Expression> {
        let Expr::Path(path) = bare(at) else { return None };
        let mut segments = path.path.segments.iter();
        let (owner, name) = (segments.next()?, segments.next()?);
        if !self.model.is_own_type(&owner.ident) || segments.next().is_some() {
            return None;
        }
        let Some(Sibling::One(constant)) = self.model.constants.get(&name.ident.to_string()) else { return None };
        // Where the value cannot be seen, the constant is a parameter like any other.
        match self.quietly(|this| this.evaluated_constant(constant)) {
            Value::Number(p) => Some(p),
            _ => None,
        }
    }

    /// `i.pow(2)`, `i.abs()`, `i.min(j)` on integers that are known now.
    pub(super) fn integer_method(
        &mut self,
        name: &Ident,
        receiver: Given<'m>,
        arguments: Vec<Given<'m>>,
        e: &Expr,
    ) -> Value {
        let Value::Integer(m) = receiver.value else { return Value::Unknown };
        let text = name.to_string();
        let numbers: Vec<_> = arguments.iter().map(|a| self.integer(a.value.clone(), a.at)).collect();
        if !matches!(text.as_str(), "abs" | "pow" | "min" | "max" | "abs_diff" | "rem_euclid" | "signum") {
            let is_literal = matches!(bare(receiver.at), Expr::Lit(_));
            let error = match arity(&text) {
                Some(_) => body::integer(receiver.at),
                None if is_literal => body::unknown_function(name, None),
                None => body::no_method(name, "an integer"),
            };
            return self.refuse(error);
        }
        let Some(numbers) = numbers.into_iter().collect::<Option<Vec<_>>>() else { return Value::Unknown };
        let result = match (text.as_str(), &numbers[..]) {
            ("abs", []) => m.checked_abs(),
            ("signum", []) => Some(m.signum()),
            ("pow", &[n]) => u32::try_from(n).ok().and_then(|n| m.checked_pow(n)),
            ("min", &[n]) => Some(m.min(n)),
            ("max", &[n]) => Some(m.max(n)),
            ("abs_diff", &[n]) => i128::try_from(m.abs_diff(n)).ok(),
            ("rem_euclid", &[n]) => m.checked_rem_euclid(n),
            (_, given) => {
                let expected = usize::from(!matches!(text.as_str(), "abs" | "signum"));
                return self.refuse(body::wrong_arguments(name, expected, given.len()));
            }
        };
        match result {
            Some(n) => Value::Integer(n),
            None => self.refuse(body::integer_overflow(e)),
        }
    }
}
