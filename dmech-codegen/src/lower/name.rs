//! Variables and constants.

use proc_macro2::Ident;
use quote::quote_spanned;
use syn::{Expr, ExprPath, GenericParam, ImplItemConst};

use crate::diagnostics::{body, law, nearest, pair};
use crate::model::{Known, PairArgument, Quantity, Sibling, is_integer, known_type};
use crate::role::Role;

use super::function::arity;
use super::interpreter::Interpreter;
use super::value::{At, Field, Owner, Value};

impl<'m> Interpreter<'m> {
    pub(super) fn path(&mut self, path: &'m ExprPath, e: &'m Expr) -> Value {
        let names: Vec<_> = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if let Some(qself) = &path.qself {
            return self.refuse(body::not_a_formula(&qself.ty, "a path through a trait"));
        }
        if let Some(name) = path.path.get_ident() {
            return self.variable(name);
        }
        if let Some(x) = float_constant(&names) {
            return Value::Number(self.graph.number(x));
        }
        let texts: Vec<_> = names.iter().map(String::as_str).collect();
        match texts[..] {
            [_, constant] if self.model.is_own_type(&path.path.segments[0].ident) => self.constant(constant, path),
            [.., constant] if is_not_finite(&names) => self.refuse(body::not_finite(e, constant)),
            [.., "f64", function] if arity(function).is_some() => self.refuse(body::function_as_value(e, function)),
            [.., integer, _] if is_integer(integer) => self.refuse(body::foreign_integer(e, &names.join("::"))),
            _ => self.refuse(body::foreign_constant(e, &names.join("::"))),
        }
    }

    fn variable(&mut self, name: &Ident) -> Value {
        let text = name.to_string();
        if let Some(found) = self.scope.find(&text) {
            return match &self.scope.locals[found].value {
                Value::Unset => self.refuse(body::unset_variable(name)),
                value => value.clone(),
            };
        }
        if text == "self" {
            return Value::Law;
        }
        let is_const = |p: &GenericParam| matches!(p, GenericParam::Const(c) if c.ident == *name);
        let error = if self.model.generics.params.iter().any(is_const) {
            if self.model.dimension == 0 {
                // The position has been refused, for the same reason as a rule.
                return Value::Unknown;
            }
            body::const_parameter(name)
        } else if float_constant(&["consts".to_owned(), text.clone()]).is_some() {
            body::imported_constant(name)
        } else {
            self.unknown_name(name)
        };
        self.refuse(error)
    }

    fn unknown_name(&self, name: &Ident) -> syn::Error {
        use PairArgument::{Distance, Separation};
        let text = name.to_string();
        let is_field = self.model.fields.iter().flatten().any(|(field, _)| *field == text);
        let variables = self.scope.locals.iter().map(|local| local.name.as_str());
        let near = nearest(&text, variables).filter(|_| !is_field);
        if self.calls.len() > 1 {
            return body::unknown_in_helper(name, near);
        }
        let formula =
            self.model.formulas().find(|formula| self.calls.first().is_some_and(|call| formula.ident == *call));
        let Some(formula) = formula else { return body::unknown_name(name, None, near) };
        let declares = |is: fn(Quantity) -> bool| formula.arguments.iter().any(|argument| is(argument.quantity));
        let other_of_two = match text.as_str() {
            "r" => declares(|quantity| matches!(quantity, Quantity::Pair(Separation(_)))),
            "d" => declares(|quantity| quantity == Quantity::Pair(Distance)),
            _ => false,
        };
        if other_of_two && formula.role == Role::Pair {
            return pair::distance_and_separation(name);
        }
        match formula.role.arguments().iter().find(|known| known.name == text) {
            Some(known) => {
                let data = self.model.pair.as_ref().and_then(|pair| pair.data.as_ref());
                body::undeclared_argument(name, known, &formula.ident, self.model.dimension, data)
            }
            None => law::argument_of_another_role(name, formula.role).unwrap_or_else(|| {
                let place = |quantity| match quantity {
                    Quantity::Pair(Distance) => Some("r"),
                    Quantity::Position(_) | Quantity::Pair(Separation(_)) | Quantity::Refused => {
                        Some(formula.role.place().name)
                    }
                    _ => None,
                };
                body::unknown_name(name, formula.arguments.iter().find_map(|argument| place(argument.quantity)), near)
            }),
        }
    }

    /// `Self::G`
    fn constant(&mut self, name: &str, path: &'m ExprPath) -> Value {
        let model = self.model;
        let last = &path.path.segments[1].ident;
        match model.constants.get(name) {
            None => {
                let near = nearest(name, self.model.constants.keys().map(String::as_str));
                self.refuse(body::unknown_constant(last, &self.model.name, near))
            }
            Some(Sibling::Conditional) => self.refuse(body::conditional_sibling(last)),
            Some(Sibling::One(constant)) => match known_type(&constant.ty) {
                // What a formula shows by its name, and the compiler folds anyway.
                known if reads_as_number(&known) && !self.calls.iter().any(|call| call.starts_with("const ")) => {
                    let ty = &model.self_ty;
                    let tokens = quote_spanned!(last.span()=> <#ty>::#last);
                    let field = Field { of: Owner::Law, tokens, key: format!("Self::{name}"), name: name.to_owned() };
                    self.conform(Value::Field(field), &constant.ty, At::Other(path))
                }
                _ => self.evaluated_constant(constant),
            },
        }
    }

    /// The value of a constant as far as it can be known now.
    pub(super) fn evaluated_constant(&mut self, constant: &'m ImplItemConst) -> Value {
        let name = format!("const {}", constant.ident);
        if self.calls.contains(&name) {
            return self.refuse(body::recursion(&constant.ident));
        }
        let outer = std::mem::take(&mut self.scope);
        self.calls.push(name);
        let value = self.value(&constant.expr);
        let value = self.conform(value, &constant.ty, At::Code(&constant.expr));
        self.calls.pop();
        self.scope = outer;
        value
    }

    /// The length in a type.
    pub(super) fn length(&mut self, length: &crate::model::Length) -> Option<usize> {
        match length {
            crate::model::Length::Literal(n) => Some(*n),
            crate::model::Length::Constant(name) => {
                let model = self.model;
                let Some(Sibling::One(constant)) = model.constants.get(name) else { return None };
                match self.evaluated_constant(constant) {
                    Value::Integer(n) => usize::try_from(n).ok(),
                    _ => None,
                }
            }
        }
    }

    /// Runs with no variables in sight, as a function of its own does.
    pub(super) fn in_new_scope<T>(&mut self, run: impl FnOnce(&mut Self) -> T) -> T {
        let outer = std::mem::take(&mut self.scope);
        let result = run(self);
        self.scope = outer;
        result
    }
}

/// Numbers, and arrays of arrays of them.
fn reads_as_number(known: &Known) -> bool {
    match known {
        Known::Float | Known::Vector(_) => true,
        Known::Array(of, _) => reads_as_number(of),
        _ => false,
    }
}

/// `std::f64::consts::PI`, `core::f64::consts::PI`, `consts::PI`, `f64::EPSILON`.
pub(super) fn float_constant(names: &[String]) -> Option<f64> {
    macro_rules! named {
        ($name:expr, $module:path, $($constant:ident)*) => {{
            use $module as module;
            $(if $name == stringify!($constant) {
                return Some(module::$constant);
            })*
            None
        }};
    }
    let names: Vec<_> = names.iter().map(String::as_str).collect();
    match names[..] {
        ["consts", name] | ["f64", "consts", name] | ["std" | "core", "f64", "consts", name] => named!(
            name, std::f64::consts,
            PI TAU E SQRT_2 FRAC_1_SQRT_2 FRAC_2_SQRT_PI FRAC_1_PI FRAC_2_PI FRAC_PI_2 FRAC_PI_3 FRAC_PI_4 FRAC_PI_6
            FRAC_PI_8 LN_2 LN_10 LOG2_E LOG10_E LOG2_10 LOG10_2
        ),
        ["f64", name] | ["std" | "core", "f64", name] => named!(name, std::f64, EPSILON MAX MIN MIN_POSITIVE),
        _ => None,
    }
}

fn is_not_finite(names: &[String]) -> bool {
    let [.., parent, name] = names else { return false };
    parent == "f64" && matches!(name.as_str(), "INFINITY" | "NEG_INFINITY" | "NAN")
}
