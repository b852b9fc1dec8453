//! The interpreter: finds the rule for an expression, notes errors, keeps the bounds.

use std::collections::{BTreeMap, HashSet};

use dmech_symbolic::expression::{self, Graph, Node, Symbol};
use dmech_symbolic::kernel::{PairVariables, Variables};
use quote::ToTokens;
use syn::{Expr, Lit};

use crate::diagnostics::{Mistakes, body, pair};
use crate::model::{ArgumentRole, Formula as Role, Model, Shape};

use super::budget::{self, Budget, Excess};
use super::lowered::{Lowered, Parameter, Source};
use super::scope::Scope;
use super::value::{At, Value};

/// An expression of the engine.
pub(super) type Formula = expression::Expr;

pub(super) struct Interpreter<'m> {
    pub(super) model: &'m Model,
    pub(super) graph: Graph,
    pub(super) variables: Variables,
    /// Those that only a law between two bodies has.
    pub(super) pair: Option<PairVariables>,
    pub(super) parameters: Vec<Parameter>,
    /// Parameters by the code that reads them.
    pub(super) known: BTreeMap<String, Formula>,
    /// Names taken in the graph.
    pub(super) names: HashSet<String>,
    pub(super) scope: Scope,
    /// The helpers and constants that are being read, outermost first.
    pub(super) calls: Vec<String>,
    pub(super) budget: Budget,
    mistakes: Mistakes,
    said: HashSet<String>,
}

impl<'m> Interpreter<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let mut graph = Graph::new();
        let variables = Variables::new(&mut graph, model.dimension);
        let pair = model.pair.as_ref().map(|_| PairVariables::new(&mut graph, model.dimension));
        let names = super::field::reserved_names(&graph, &variables, pair.as_ref());
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
        match (potential, force) {
            (Some(potential), Some(force)) if self.mistakes.errors.is_empty() => {
                let Self { mut graph, variables, mut parameters, pair, .. } = self;
                let roots: Vec<_> = std::iter::once(potential).chain(force.iter().flatten().copied()).collect();
                // What was read and then cancelled is no parameter of the law.
                parameters.retain(|parameter| roots.iter().any(|&root| graph.depends_on(root, &[parameter.symbol])));
                let pair = pair.map(|variables| super::pair::lowered(&mut graph, variables, &parameters));
                Ok(Lowered { graph, variables, potential, force, parameters, pair })
            }
            _ => Err(self.mistakes),
        }
    }

    /// The value of a whole body: one number, or as many as there are coordinates.
    fn result(&mut self, value: Value, shape: Shape, of: &'m Role) -> Option<Vec<Formula>> {
        let at = super::statement::result_of(&of.body);
        let unknown = value.is_unknown();
        let components = match (at, shape) {
            (None, _) => {
                if !unknown {
                    self.report(body::no_result(&of.ident, super::statement::thrown_away(&of.body)));
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
    fn components(&mut self, value: Value, shape: Shape, at: &'m Expr, of: &'m Role) -> Option<Vec<Formula>> {
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

    fn read(&mut self, formula: &'m Role) -> Value {
        self.scope = Scope::default();
        self.calls.clear();
        for argument in &formula.arguments {
            let value = self.argument(argument.role);
            self.bind(&argument.pattern, value, At::Other(&argument.pattern));
        }
        self.calls.push(formula.ident.to_string());
        self.function_body(&formula.body)
    }

    fn argument(&mut self, role: ArgumentRole) -> Value {
        match role {
            ArgumentRole::Position(shape) => self.coordinates(&self.variables.q.clone(), shape),
            ArgumentRole::Velocity(shape) => self.coordinates(&self.variables.v.clone(), shape),
            ArgumentRole::Mass => Value::Number(self.parameter("m", "m", Source::Mass)),
            ArgumentRole::Time => Value::Number(self.parameter("t", "t", Source::Time)),
            ArgumentRole::Pair(role) => self.pair_argument(role),
            ArgumentRole::Refused => Value::Unknown,
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

    /// The value of an expression.
    pub(super) fn value(&mut self, e: &'m Expr) -> Value {
        let excess = self.budget.step();
        if !self.within(excess, e) {
            return Value::Unknown;
        }
        if self.budget.depth >= budget::MAX_DEPTH {
            return self.refuse(body::too_deep(e));
        }
        self.budget.depth += 1;
        let value = self.dispatch(e);
        self.budget.depth -= 1;
        match &value {
            Value::Number(formula) if !self.settle(*formula, e) => Value::Unknown,
            Value::Vector(components) if !components.clone().into_iter().all(|c| self.settle(c, e)) => Value::Unknown,
            _ => value,
        }
    }

    /// Keeps the bounds on what the engine has to store; false when they are passed.
    pub(super) fn settle(&mut self, formula: Formula, e: &Expr) -> bool {
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

    fn dispatch(&mut self, e: &'m Expr) -> Value {
        match e {
            Expr::Lit(literal) => self.literal(&literal.lit, e),
            Expr::Path(path) => self.path(path, e),
            Expr::Paren(inner) => self.value(&inner.expr),
            Expr::Group(inner) => self.value(&inner.expr),
            Expr::Binary(binary) => self.binary_expression(binary, e),
            Expr::Unary(unary) => self.unary_expression(unary, e),
            Expr::MethodCall(call) => self.method_call(call, e),
            Expr::Call(call) => self.call(call, e),
            Expr::Field(field) => self.field_expression(field),
            Expr::Index(index) => self.index_expression(index, e),
            Expr::Array(array) => Value::Array(array.elems.iter().map(|element| self.value(element)).collect()),
            Expr::Tuple(tuple) => Value::Tuple(tuple.elems.iter().map(|element| self.value(element)).collect()),
            Expr::Repeat(repeat) => self.repeat(repeat),
            Expr::Range(range) => self.range(range, e),
            Expr::Cast(cast) => self.cast(cast, e),
            Expr::Block(block) => match &block.label {
                Some(label) => self.refuse(body::label(label)),
                None => self.block(&block.block),
            },
            Expr::If(branch) => self.if_expression(branch, e),
            Expr::ForLoop(each) => self.for_loop(each),
            Expr::Assign(assign) => self.assign_expression(assign),
            Expr::Reference(reference) => match &reference.mutability {
                Some(mutability) => self.refuse(body::mutable_reference(mutability)),
                None => self.value(&reference.expr),
            },
            Expr::Closure(_) => {
                self.abandon(e);
                self.refuse(body::stray_closure(e))
            }
            other => self.refused(other),
        }
    }

    /// What no formula contains, and what it leaves behind.
    fn refused(&mut self, e: &'m Expr) -> Value {
        self.abandon(e);
        self.refuse(match e {
            Expr::Return(_) => body::early_return(e),
            Expr::While(turns) => body::open_loop(&turns.while_token),
            Expr::Loop(turns) => body::open_loop(&turns.loop_token),
            Expr::Break(leave) => body::jump(&leave.break_token, "break"),
            Expr::Continue(skip) => body::jump(&skip.continue_token, "continue"),
            Expr::Match(choice) => body::match_expression(&choice.match_token),
            Expr::Macro(invocation) => body::macro_call(&invocation.mac),
            Expr::Struct(literal) => body::struct_literal(&literal.path),
            Expr::Unsafe(block) => body::not_a_formula(&block.unsafe_token, "an `unsafe` block"),
            Expr::Async(block) => body::not_a_formula(&block.async_token, "an `async` block"),
            Expr::Const(block) => body::not_a_formula(&block.const_token, "a `const` block"),
            Expr::Try(question) => body::not_a_formula(&question.question_token, "the operator `?`"),
            Expr::Let(condition) => body::if_let(&condition.let_token),
            other => body::not_a_formula(other, "this"),
        })
    }

    fn literal(&mut self, literal: &Lit, e: &Expr) -> Value {
        match literal {
            Lit::Float(number) => match (number.suffix(), number.base10_parse::<f64>()) {
                ("" | "f64", Ok(x)) if x.is_finite() => Value::Number(self.graph.number(x)),
                ("" | "f64", _) => self.refuse(body::number_too_large(e)),
                _ => self.refuse(body::single_precision_literal(number)),
            },
            Lit::Int(number) => match (number.suffix(), number.base10_parse::<i128>()) {
                ("f64", Ok(n)) => Value::Number(self.graph.number(n as f64)),
                ("f32", _) => self.refuse(body::single_precision_literal(number)),
                (_, Ok(n)) => Value::Integer(n),
                (_, Err(_)) => self.refuse(body::number_too_large(e)),
            },
            Lit::Bool(truth) => Value::known(truth.value),
            Lit::Str(_) => self.refuse(body::not_a_number(e, "text")),
            Lit::Char(_) => self.refuse(body::not_a_number(e, "a character")),
            _ => self.refuse(body::not_a_number(e, "no number")),
        }
    }

    /// The value as one number; integers where a number belongs are refused.
    pub(super) fn number(&mut self, value: Value, at: &dyn ToTokens) -> Option<Formula> {
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
    pub(super) fn from_number(formula: Option<Formula>) -> Value {
        formula.map_or(Value::Unknown, Value::Number)
    }
}
