//! Any expression: finds its rule.

use syn::{Expr, Lit};

use crate::diagnostics::body;

use super::budget;
use super::interpreter::Interpreter;
use super::value::Value;

impl<'m> Interpreter<'m> {
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
}
