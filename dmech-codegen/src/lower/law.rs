//! The bodies of a law, one after the other.

use syn::Expr;

use crate::diagnostics::{Mistakes, body};
use crate::model::{Formula, Quantity, Shape};

use super::budget;
use super::code::{result_of, thrown_away};
use super::interpreter::{Expression, Interpreter};
use super::lowered::{Lowered, Source};
use super::scope::Scope;
use super::value::{At, Value};

impl<'m> Interpreter<'m> {
    /// The law as expressions, or what is wrong with its bodies.
    pub(super) fn run(mut self) -> Result<Lowered, Mistakes> {
        let model = self.model;
        let potential = match &model.potential {
            Some(potential) => {
                let value = self.read(potential);
                self.result(value, Shape::Number, potential).map(|components| components[0])
            }
            None => Some(self.graph.zero()),
        };
        let force = match &model.force {
            Some((force, shape)) => {
                let value = self.read(force);
                self.result(value, *shape, force).map(Some)
            }
            None => Some(None),
        };
        let mut invariants = vec![];
        for invariant in &model.invariants {
            let value = self.read(invariant);
            invariants.extend(self.result(value, Shape::Number, invariant).into_iter().flatten());
        }
        match (potential, force) {
            (Some(potential), Some(force)) if self.mistakes.errors.is_empty() => {
                let Self { mut graph, variables, mut parameters, pair, .. } = self;
                let kept = invariants.iter().copied();
                let roots: Vec<_> =
                    std::iter::once(potential).chain(force.iter().flatten().copied()).chain(kept).collect();
                // What was read and then cancelled is no parameter of the law.
                parameters.retain(|parameter| roots.iter().any(|&root| graph.depends_on(root, &[parameter.symbol])));
                let pair = pair.map(|variables| super::pair::lowered(&mut graph, variables, &parameters));
                Ok(Lowered { graph, variables, potential, force, invariants, parameters, pair })
            }
            _ => Err(self.mistakes),
        }
    }

    /// The value of a whole body: one number, or as many as there are coordinates.
    fn result(&mut self, value: Value, shape: Shape, of: &'m Formula) -> Option<Vec<Expression>> {
        let at = result_of(&of.body);
        let unknown = value.is_unknown();
        let components = match (at, shape) {
            (None, _) => {
                if !unknown {
                    self.report(body::no_result(&of.ident, thrown_away(&of.body)));
                }
                None
            }
            (Some(e), Shape::Number) => self.number(value, e).map(|x| vec![x]),
            (Some(e), shape) => self.components(value, shape, e, of),
        };
        for &component in components.iter().flatten() {
            if let Some(excess) = budget::excess_of(&self.graph, component) {
                self.report(body::excess(&of.ident, excess));
            }
        }
        if components.is_none() && self.mistakes.errors.is_empty() {
            self.report(body::not_understood(&of.ident));
        }
        components
    }

    /// The components of a force.
    fn components(&mut self, value: Value, shape: Shape, at: &'m Expr, of: &'m Formula) -> Option<Vec<Expression>> {
        let dimension = self.model.dimension;
        let found = match &value {
            Value::Vector(components) => components.len(),
            Value::Array(elements) => elements.len(),
            _ => dimension,
        };
        if found != dimension {
            self.report(body::wrong_components(at, &of.ident, found, dimension));
            return None;
        }
        match value {
            Value::Vector(components) => Some(components),
            Value::Array(elements) => {
                let numbers = elements.into_iter().enumerate().map(|(i, x)| self.number(x, &At::Code(at).part(i)));
                numbers.collect::<Option<Vec<_>>>()
            }
            Value::Field(field) => Some(self.field_vector(&field, dimension)),
            Value::Unknown => None,
            other => {
                self.report(body::expected_components(at, &of.ident, dimension, shape == Shape::Vector, &other.kind()));
                None
            }
        }
    }

    /// What is wrong with the bodies of a law whose signature is refused already.
    pub(super) fn mistakes(mut self) -> Mistakes {
        for formula in self.model.formulas() {
            self.read(formula);
        }
        self.mistakes
    }

    fn read(&mut self, formula: &'m Formula) -> Value {
        self.scope = Scope::default();
        self.calls.clear();
        for argument in &formula.arguments {
            let value = self.argument(argument.quantity);
            self.bind(&argument.pattern, value, At::Other(&argument.pattern));
        }
        self.calls.push(formula.ident.to_string());
        self.function_body(&formula.body)
    }

    fn argument(&mut self, quantity: Quantity) -> Value {
        match quantity {
            Quantity::Position(shape) => self.coordinates(&self.variables.q.clone(), shape),
            Quantity::Velocity(shape) => self.coordinates(&self.variables.v.clone(), shape),
            Quantity::Mass => Value::Number(self.parameter("m", "m", Source::Mass)),
            Quantity::Time => Value::Number(self.parameter("t", "t", Source::Time)),
            Quantity::Pair(role) => self.pair_argument(role),
            Quantity::Refused => Value::Unknown,
        }
    }
}
