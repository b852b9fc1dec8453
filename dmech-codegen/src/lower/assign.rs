//! `=`, `+=` and the like, and what can stand left of them.

use syn::{Expr, ExprAssign, ExprBinary, Member, UnOp};

use crate::diagnostics::body;

use super::code::component;
use super::interpreter::{Expression, Interpreter};
use super::operator::Operator;
use super::value::Value;

/// A variable, or a part of one.
struct Place {
    binding: usize,
    path: Vec<usize>,
}

impl<'m> Interpreter<'m> {
    pub(super) fn assign_expression(&mut self, assign: &'m ExprAssign) -> Value {
        let value = self.value(&assign.right);
        self.assign(&assign.left, value, &assign.right);
        Value::UNIT
    }

    /// `a = …`, `[a, b] = …`, `(a, b) = …`, `_ = …`
    fn assign(&mut self, left: &'m Expr, value: Value, right: &'m Expr) {
        let parts = match left {
            Expr::Infer(_) => return,
            Expr::Array(array) => &array.elems,
            Expr::Tuple(tuple) => &tuple.elems,
            place => return self.store(place, value, right),
        };
        match value {
            Value::Array(values) | Value::Tuple(values) if values.len() == parts.len() => {
                for (part, value) in parts.iter().zip(values) {
                    self.assign(part, value, right);
                }
            }
            Value::Unknown => parts.iter().for_each(|part| self.assign(part, Value::Unknown, right)),
            other => self.report(body::assignment_mismatch(left, &other.kind())),
        }
    }

    /// `a += b`, with a read before.
    pub(super) fn compound_assignment(&mut self, binary: &'m ExprBinary, operator: Operator, e: &'m Expr) -> Value {
        let right = self.value(&binary.right);
        let left = self.value(&binary.left);
        let mut value = self.combine(operator, left, right, e, &binary.left, &binary.right);
        if let Value::Number(formula) = value
            && !self.settle(formula, e)
        {
            value = Value::Unknown;
        }
        self.store(&binary.left, value, &binary.right);
        Value::UNIT
    }

    fn store(&mut self, left: &'m Expr, value: Value, right: &'m Expr) {
        let Some(place) = self.place(left) else { return };
        let mut slot = &mut self.scope.locals[place.binding].value;
        for (i, &step) in place.path.iter().enumerate() {
            slot = match slot {
                Value::Array(parts) | Value::Tuple(parts) if step < parts.len() => &mut parts[step],
                Value::Vector(components) if step < components.len() && i + 1 == place.path.len() => {
                    let number = self.number(value, right);
                    // The number may have been noted as wrong; then the whole vector is not known.
                    let slot = &mut self.scope.locals[place.binding].value;
                    store_component(slot, &place.path, number);
                    return;
                }
                // Whatever is wrong here has been noted when the place was read.
                _ => return,
            };
        }
        *slot = value;
    }

    fn place(&mut self, left: &'m Expr) -> Option<Place> {
        match left {
            Expr::Paren(inner) => self.place(&inner.expr),
            Expr::Group(inner) => self.place(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => self.place(&unary.expr),
            Expr::Path(path) => {
                let found = path.path.get_ident().map(ToString::to_string).and_then(|name| self.scope.find(&name));
                match found {
                    Some(_) => {}
                    None if path.path.is_ident("self") || path.path.get_ident().is_none() => {
                        self.report(body::not_a_place(left));
                    }
                    // What an unknown name is told anywhere.
                    None => drop(self.value(left)),
                }
                found.map(|binding| Place { binding, path: vec![] })
            }
            Expr::Index(index) => {
                let mut place = self.place(&index.expr)?;
                let at = self.value(&index.index);
                let n = self.integer(at, &*index.index)?;
                let length = self.part(&place).and_then(length);
                match usize::try_from(n) {
                    Ok(n) if length.is_none_or(|length| n < length) => place.path.push(n),
                    _ => {
                        self.report(body::index_out_of_range(&index.index, n, length.unwrap_or(0)));
                        return None;
                    }
                }
                self.reachable(place, left)
            }
            Expr::Field(field) => {
                let mut place = self.place(&field.base)?;
                let step = match &field.member {
                    Member::Named(name) => component(&name.to_string()),
                    Member::Unnamed(index) => Some(index.index as usize),
                };
                let Some(step) = step else {
                    self.report(body::not_a_place(left));
                    return None;
                };
                place.path.push(step);
                self.reachable(place, left)
            }
            _ => {
                self.report(body::not_a_place(left));
                None
            }
        }
    }

    /// The place, if there is one; a part of a field, or of what is unknown, has none.
    fn reachable(&mut self, place: Place, left: &Expr) -> Option<Place> {
        let (last, before) = place.path.split_last()?;
        let whole = Place { binding: place.binding, path: before.to_vec() };
        let error = match self.part(&whole)? {
            Value::Unknown => return None,
            Value::Field(_) => body::field_of_unknown_type(left),
            value if length(value).is_some_and(|length| *last < length) => return Some(place),
            _ => body::not_a_place(left),
        };
        self.report(error);
        None
    }

    fn part(&self, place: &Place) -> Option<&Value> {
        let mut value = &self.scope.locals[place.binding].value;
        for &step in &place.path {
            value = match value {
                Value::Array(parts) | Value::Tuple(parts) => parts.get(step)?,
                _ => return None,
            };
        }
        Some(value)
    }
}

fn length(value: &Value) -> Option<usize> {
    match value {
        Value::Array(parts) | Value::Tuple(parts) => Some(parts.len()),
        Value::Vector(components) => Some(components.len()),
        _ => None,
    }
}

/// Stores a component of a vector; without a number, the vector is no longer known.
fn store_component(mut slot: &mut Value, path: &[usize], number: Option<Expression>) {
    for &step in &path[..path.len() - 1] {
        slot = match slot {
            Value::Array(parts) | Value::Tuple(parts) => &mut parts[step],
            _ => return,
        };
    }
    match (slot, number, path.last()) {
        (Value::Vector(components), Some(number), Some(&i)) => components[i] = number,
        (slot, ..) => *slot = Value::Unknown,
    }
}
