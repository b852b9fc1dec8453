//! What the interpreter knows while it reads; it notes errors and keeps the bounds.

use std::collections::{BTreeMap, HashSet};

use dmech_symbolic::expression::{self, Graph, Node, Symbol};
use dmech_symbolic::kernel::{PairVariables, Variables};
use quote::ToTokens;
use syn::Expr;

use crate::diagnostics::body::{self, Excess};
use crate::diagnostics::{Mistakes, pair};
use crate::model::{Model, Shape};

use super::budget::{self, Budget};
use super::lowered::Parameter;
use super::scope::Scope;
use super::value::Value;

/// An expression of the engine.
pub(super) type Expression = expression::Expr;

pub(super) struct Interpreter<'m> {
    pub(super) model: &'m Model,
    pub(super) graph: Graph,
    pub(super) variables: Variables,
    /// Those that only a law between two bodies has.
    pub(super) pair: Option<PairVariables>,
    pub(super) parameters: Vec<Parameter>,
    /// Parameters by the code that reads them.
    pub(super) known: BTreeMap<String, Expression>,
    /// Names taken in the graph.
    pub(super) names: HashSet<String>,
    pub(super) scope: Scope,
    /// The helpers and constants that are being read, outermost first.
    pub(super) calls: Vec<String>,
    pub(super) budget: Budget,
    pub(super) mistakes: Mistakes,
    said: HashSet<String>,
}

/// Names that a parameter cannot have in formulas.
fn reserved_names(graph: &Graph, variables: &Variables, pair: Option<&PairVariables>) -> HashSet<String> {
    let Variables { q, v, a, b, .. } = variables;
    let coordinates = [q, v, a, b].into_iter().flatten().map(|&symbol| graph.name(symbol).to_owned());
    let of_two = pair.into_iter().flat_map(|pair| pair.va.iter().chain(&pair.vb));
    let of_two = of_two.map(|&symbol| graph.name(symbol).to_owned());
    let arguments: &[&str] = if pair.is_some() { &["ma", "mb", "t", "r", "ra", "rb"] } else { &["m", "t"] };
    coordinates.chain(of_two).chain(arguments.iter().map(|&name| name.to_owned())).collect()
}

impl<'m> Interpreter<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let mut graph = Graph::new();
        let variables = Variables::new(&mut graph, model.dimension);
        let pair = model.pair.as_ref().map(|_| PairVariables::new(&mut graph, model.dimension));
        let names = reserved_names(&graph, &variables, pair.as_ref());
        Self {
            model,
            graph,
            variables,
            pair,
            parameters: vec![],
            known: BTreeMap::new(),
            names,
            scope: Scope::default(),
            calls: vec![],
            budget: Budget::default(),
            mistakes: Mistakes::default(),
            said: HashSet::new(),
        }
    }

    /// Symbols in the form of a position.
    pub(super) fn coordinates(&mut self, symbols: &[Symbol], shape: Shape) -> Value {
        let x: Vec<_> = symbols.iter().map(|&s| self.graph.symbol(s)).collect();
        match shape {
            Shape::Number => x.first().map_or(Value::Unknown, |&x| Value::Number(x)),
            Shape::Array => Value::Array(x.into_iter().map(Value::Number).collect()),
            Shape::Vector => Value::Vector(x),
        }
    }

    /// Notes an error, once.
    pub(super) fn report(&mut self, error: syn::Error) {
        const ENOUGH: usize = 50;
        let span = error.span();
        if self.mistakes.errors.len() < ENOUGH && self.said.insert(format!("{span:?} {error}")) {
            self.mistakes.errors.push(error);
            let method = self.calls.iter().rfind(|call| !call.starts_with("const "));
            self.mistakes.methods.extend(method.cloned());
        }
    }

    /// Runs without noting errors; where there were any, the value is not known.
    pub(super) fn quietly(&mut self, run: impl FnOnce(&mut Self) -> Value) -> Value {
        let before = (std::mem::take(&mut self.mistakes), std::mem::take(&mut self.said));
        let value = run(self);
        let failed = !self.mistakes.errors.is_empty();
        (self.mistakes, self.said) = before;
        if failed { Value::Unknown } else { value }
    }

    /// Notes an error whose cause is elsewhere, once for all the places where it shows.
    pub(super) fn refuse_once(&mut self, error: syn::Error) -> Value {
        if self.said.insert(error.to_string()) { self.refuse(error) } else { Value::Unknown }
    }

    /// Notes an error; its value silences what follows.
    pub(super) fn refuse(&mut self, error: syn::Error) -> Value {
        self.report(error);
        Value::Unknown
    }

    /// Notes that a bound has been passed, if so; false when nothing more is to be read.
    pub(super) fn within(&mut self, excess: Option<Excess>, at: &Expr) -> bool {
        if let Some(excess) = excess {
            self.report(body::excess(at, excess));
        }
        !self.budget.exhausted
    }

    /// Keeps the bounds on what the engine has to store; false when they are passed.
    pub(super) fn settle(&mut self, formula: Expression, e: &Expr) -> bool {
        let (terms, exponent) = match self.graph.node(formula) {
            Node::Sum { terms, .. } => (terms.len(), 0),
            Node::Product { factors, .. } => {
                (factors.len(), factors.iter().map(|&(_, n)| n.saturating_abs()).max().unwrap_or(0))
            }
            _ => (1, 0),
        };
        if exponent > budget::MAX_EXPONENT {
            self.report(body::exponent_too_large(e, budget::MAX_EXPONENT));
            return false;
        }
        let excess = self.budget.expression(self.graph.len(), terms);
        self.within(excess, e)
    }

    /// The value as one number; integers where a number belongs are refused.
    pub(super) fn number(&mut self, value: Value, at: &dyn ToTokens) -> Option<Expression> {
        match value {
            Value::Number(formula) => Some(formula),
            Value::Field(field) if field.is_data() => {
                self.report(pair::whole_data(at));
                None
            }
            Value::Field(field) => Some(self.field_number(&field)),
            Value::Integer(n) => {
                self.report(body::integer(at));
                // The number that was meant, so that nothing else is found wrong with it.
                Some(self.graph.number(n as f64))
            }
            Value::Unknown => None,
            other => {
                self.report(body::expected_number(at, &other.kind()));
                None
            }
        }
    }

    /// The value as an integer that is known now.
    pub(super) fn integer(&mut self, value: Value, at: &dyn ToTokens) -> Option<i128> {
        match value {
            Value::Integer(n) => Some(n),
            Value::Unknown => None,
            other => {
                self.report(body::expected_integer(at, &other.kind()));
                None
            }
        }
    }

    /// A number as a value, unknown where there is none.
    pub(super) fn from_number(formula: Option<Expression>) -> Value {
        formula.map_or(Value::Unknown, Value::Number)
    }
}
