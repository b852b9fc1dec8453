//! nalgebra's column vectors.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprMethodCall, ExprPath};

use dmech_symbolic::expression::Unary;

use crate::diagnostics::body;
use crate::model::{Known, Length, VectorAlias, vector_alias};

use super::interpreter::{Expression, Interpreter};
use super::value::{Given, Value};

impl<'m> Interpreter<'m> {
    pub(super) fn vector_method(&mut self, receiver: Given<'m>, call: &'m ExprMethodCall, e: &'m Expr) -> Value {
        let name = &call.method;
        let text = name.to_string();
        if let (Value::Vector(components), "iter" | "iter_mut" | "into_iter" | "map" | "len" | "fold") =
            (&receiver.value, text.as_str())
        {
            // To these, a vector is what an array is.
            let elements = Value::Array(components.iter().map(|&x| Value::Number(x)).collect());
            let value = self.sequence_method(Given { value: elements, at: receiver.at }, call, e);
            return match (text.as_str(), value) {
                ("map", Value::Array(elements)) => self.vector_of(elements, e),
                (_, value) => value,
            };
        }
        let expected = match text.as_str() {
            "norm" | "norm_squared" | "magnitude" | "magnitude_squared" | "normalize" | "sum" | "abs" => 0,
            "dot" | "cross" | "metric_distance" | "component_mul" | "component_div" | "scale" | "add_scalar" => 1,
            _ => return self.refuse(body::unknown_vector_function(name)),
        };
        let arguments = self.given(call.args.iter());
        if arguments.len() != expected {
            return self.refuse(body::wrong_arguments(name, expected, arguments.len()));
        }
        let (u, argument) = (receiver.value, arguments.into_iter().next());
        match argument {
            None => match u {
                Value::Vector(u) => self.function_of_vector(&text, u),
                _ => self.refuse(body::field_of_unknown_dimension(receiver.at)),
            },
            Some(argument) if matches!(text.as_str(), "scale" | "add_scalar") => {
                let factor = self.number(argument.value, argument.at);
                match (u, factor) {
                    (Value::Vector(u), Some(c)) if text == "scale" => {
                        Value::Vector(u.into_iter().map(|x| self.graph.mul(&[x, c])).collect())
                    }
                    (Value::Vector(u), Some(c)) => {
                        Value::Vector(u.into_iter().map(|x| self.graph.add(&[x, c])).collect())
                    }
                    _ => Value::Unknown,
                }
            }
            Some(argument) => {
                let (u, w) = match (u, argument.value) {
                    (_, Value::Unknown) | (Value::Unknown, _) => return Value::Unknown,
                    (Value::Vector(u), Value::Vector(w)) => (u, w),
                    (Value::Vector(u), Value::Field(field)) => {
                        let w = self.field_vector(&field, u.len());
                        (u, w)
                    }
                    (Value::Field(field), Value::Vector(w)) => (self.field_vector(&field, w.len()), w),
                    (Value::Field(_), Value::Field(_)) => {
                        return self.refuse(body::field_of_unknown_dimension(receiver.at));
                    }
                    (_, other) => return self.refuse(body::expected_vector(argument.at, &other.kind())),
                };
                if u.len() != w.len() {
                    return self.refuse(body::dimensions_differ(argument.at, u.len(), w.len()));
                }
                self.function_of_vectors(name, u, w)
            }
        }
    }

    fn function_of_vector(&mut self, name: &str, u: Vec<Expression>) -> Value {
        match name {
            "sum" => Value::Number(self.graph.add(&u)),
            "abs" => Value::Vector(u.into_iter().map(|x| self.graph.unary(Unary::Abs, x)).collect()),
            "norm_squared" | "magnitude_squared" => Value::Number(self.dot(&u, &u)),
            "normalize" => {
                let norm = self.norm(&u);
                Value::Vector(u.into_iter().map(|x| self.graph.div(x, norm)).collect())
            }
            _ => Value::Number(self.norm(&u)),
        }
    }

    fn function_of_vectors(&mut self, name: &Ident, u: Vec<Expression>, w: Vec<Expression>) -> Value {
        let graph = &mut self.graph;
        match name.to_string().as_str() {
            "dot" => Value::Number(self.dot(&u, &w)),
            "metric_distance" => {
                let difference: Vec<_> = u.iter().zip(&w).map(|(&x, &y)| graph.sub(x, y)).collect();
                Value::Number(self.norm(&difference))
            }
            "component_mul" => Value::Vector(u.iter().zip(&w).map(|(&x, &y)| graph.mul(&[x, y])).collect()),
            "component_div" => Value::Vector(u.iter().zip(&w).map(|(&x, &y)| graph.div(x, y)).collect()),
            _ => match (&u[..], &w[..]) {
                (&[a, b, c], &[x, y, z]) => {
                    let mut minor = |p, q, r, s| {
                        let (plus, minus) = (graph.mul(&[p, q]), graph.mul(&[r, s]));
                        graph.sub(plus, minus)
                    };
                    Value::Vector(vec![minor(b, z, c, y), minor(c, x, a, z), minor(a, y, b, x)])
                }
                _ => self.refuse(body::cross_product(name, u.len())),
            },
        }
    }

    fn dot(&mut self, u: &[Expression], w: &[Expression]) -> Expression {
        let products: Vec<_> = u.iter().zip(w).map(|(&x, &y)| self.graph.mul(&[x, y])).collect();
        self.graph.add(&products)
    }

    fn norm(&mut self, u: &[Expression]) -> Expression {
        let square = self.dot(u, u);
        self.graph.unary(Unary::Sqrt, square)
    }

    fn vector_of(&mut self, elements: Vec<Value>, at: &dyn ToTokens) -> Value {
        let numbers: Vec<_> = elements.into_iter().map(|value| self.number(value, at)).collect();
        numbers.into_iter().collect::<Option<Vec<_>>>().map_or(Value::Unknown, Value::Vector)
    }

    /// `Vector2::new(x, y)`, `Vector3::zeros()`, `SVector::<f64, 4>::from([…])`
    pub(super) fn vector_constructor(
        &mut self,
        path: &'m ExprPath,
        owner: &Ident,
        name: &Ident,
        arguments: Vec<Given<'m>>,
        e: &'m Expr,
    ) -> Value {
        let dimension = match vector_alias(&owner.to_string()) {
            Some(VectorAlias::Fixed(n)) => Some(n),
            _ => self.stated_dimension(path),
        };
        match (name.to_string().as_str(), &arguments[..], dimension) {
            ("new", given, n) if n.is_none_or(|n| n == given.len()) => {
                let numbers: Vec<_> = given.iter().map(|a| self.number(a.value.clone(), a.at)).collect();
                numbers.into_iter().collect::<Option<Vec<_>>>().map_or(Value::Unknown, Value::Vector)
            }
            ("new", given, Some(n)) => self.refuse(body::wrong_arguments(name, n, given.len())),
            ("zeros", [], Some(n)) => Value::Vector(vec![self.graph.zero(); n]),
            ("repeat" | "from_element", [x], Some(n)) => match self.number(x.value.clone(), x.at) {
                Some(x) => Value::Vector(vec![x; n]),
                None => Value::Unknown,
            },
            ("from" | "from_row_slice" | "from_column_slice", [Given { value, at }], n) => match value {
                Value::Array(elements) if n.is_none_or(|n| n == elements.len()) => self.vector_of(elements.clone(), at),
                Value::Field(field) if n.is_some() => Value::Vector(self.field_vector(field, n.unwrap_or(0))),
                Value::Unknown => Value::Unknown,
                other => self.refuse(body::expected_array(at, &other.kind())),
            },
            ("zeros" | "repeat" | "from_element", ..) if dimension.is_none() => {
                self.refuse(body::unstated_dimension(e))
            }
            _ => self.refuse(body::unknown_constructor(name, &owner.to_string())),
        }
    }

    /// The 4 of `SVector::<f64, 4>::zeros()`.
    fn stated_dimension(&mut self, path: &ExprPath) -> Option<usize> {
        let mut owner = path.path.clone();
        owner.segments.pop();
        owner.segments.pop_punct();
        let ty = syn::Type::Path(syn::TypePath { attrs: vec![], qself: None, path: owner });
        match crate::model::known_type(&ty) {
            Known::Vector(Some(Length::Literal(n))) => Some(n),
            Known::Vector(Some(length)) => self.length(&length),
            _ => None,
        }
    }
}
