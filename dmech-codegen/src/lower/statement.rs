//! Blocks, `let`, `for`.

use syn::{Attribute, Block, Expr, ExprForLoop, Item, Local, Pat, Stmt, UseTree};

use crate::diagnostics::body;

use super::interpreter::Interpreter;
use super::name::float_constant;
use super::value::{At, Value};

impl<'m> Interpreter<'m> {
    /// The body of a function, where `return` may come last.
    pub(super) fn function_body(&mut self, block: &'m Block) -> Value {
        if let Some((Stmt::Expr(Expr::Return(leave), _), before)) = block.stmts.split_last() {
            for statement in before {
                self.statement(statement);
            }
            return match &leave.expr {
                Some(e) => self.value(e),
                None => Value::UNIT,
            };
        }
        self.block(block)
    }

    /// The value of a block; what it binds is forgotten after it.
    pub(super) fn block(&mut self, block: &'m Block) -> Value {
        let mark = self.scope.mark();
        let mut value = Value::UNIT;
        for statement in &block.stmts {
            if self.budget.exhausted {
                value = Value::Unknown;
                break;
            }
            value = self.statement(statement);
        }
        self.scope.reset(mark);
        value
    }

    fn statement(&mut self, statement: &'m Stmt) -> Value {
        match statement {
            Stmt::Local(local) => self.local(local),
            // A semicolon by itself.
            Stmt::Expr(Expr::Verbatim(nothing), _) if nothing.is_empty() => Value::UNIT,
            Stmt::Expr(e, semicolon) => {
                if let Some(cfg) = conditional(attributes(e)) {
                    return self.refuse(body::conditional_code(cfg));
                }
                let value = self.value(e);
                match (semicolon, value) {
                    (None, value) | (Some(_), value @ Value::Unknown) => value,
                    (Some(_), _) => Value::UNIT,
                }
            }
            Stmt::Item(item) => self.item(item),
            Stmt::Macro(invocation) => self.refuse(body::macro_call(&invocation.mac)),
        }
    }

    fn local(&mut self, local: &'m Local) -> Value {
        if let Some(cfg) = conditional(&local.attrs) {
            return self.refuse(body::conditional_code(cfg));
        }
        let Some(init) = &local.init else {
            let pattern = match &local.pat {
                Pat::Type(typed) => &typed.pat,
                other => other,
            };
            return match pattern {
                Pat::Ident(name) => {
                    self.scope.bind(name.ident.to_string(), Value::Unset);
                    Value::UNIT
                }
                other => self.refuse(body::pattern(other)),
            };
        };
        if let Some((diverge, _)) = &init.diverge {
            self.bind_names(&local.pat);
            return self.refuse(body::let_else(diverge));
        }
        let value = self.value(&init.expr);
        self.bind(&local.pat, value, At::Code(&init.expr));
        Value::UNIT
    }

    fn item(&mut self, item: &'m Item) -> Value {
        match item {
            Item::Const(constant) => {
                let value = self.value(&constant.expr);
                let value = self.conform(value, &constant.ty, At::Code(&constant.expr));
                self.scope.bind(constant.ident.to_string(), value);
                Value::UNIT
            }
            Item::Use(import) => {
                self.import(&mut vec![], &import.tree);
                Value::UNIT
            }
            Item::Fn(function) => {
                self.scope.bind(function.sig.ident.to_string(), Value::Unknown);
                self.refuse(body::inner_function(&function.sig.ident))
            }
            other => self.refuse(body::inner_item(other)),
        }
    }

    /// `use std::f64::consts::{PI, TAU as TURN};` binds numbers; other imports may serve the compiler.
    fn import(&mut self, above: &mut Vec<String>, tree: &UseTree) {
        let (name, bound) = match tree {
            UseTree::Path(path) => {
                above.push(path.ident.to_string());
                self.import(above, &path.tree);
                above.pop();
                return;
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.import(above, tree);
                }
                return;
            }
            UseTree::Name(name) => (&name.ident, &name.ident),
            UseTree::Rename(rename) => (&rename.ident, &rename.rename),
            UseTree::Glob(_) => return,
        };
        above.push(name.to_string());
        if let Some(x) = float_constant(above) {
            let number = Value::Number(self.graph.number(x));
            self.scope.bind(bound.to_string(), number);
        }
        above.pop();
    }

    pub(super) fn for_loop(&mut self, each: &'m ExprForLoop) -> Value {
        if let Some(label) = &each.label {
            self.report(body::label(label));
        }
        let items = self.value(&each.expr);
        let Some(items) = self.items(items, &each.expr) else {
            // Reading the body once finds what else is wrong in it.
            let mark = self.scope.mark();
            self.bind(&each.pat, Value::Unknown, At::Other(&each.pat));
            self.block(&each.body);
            self.scope.reset(mark);
            self.abandon(&each.body);
            return Value::Unknown;
        };
        let excess = self.budget.turns(items.len());
        if !self.within(excess, &each.expr) {
            return Value::Unknown;
        }
        for item in items {
            let mark = self.scope.mark();
            self.bind(&each.pat, item, At::Other(&each.pat));
            self.block(&each.body);
            self.scope.reset(mark);
            if self.budget.exhausted {
                return Value::Unknown;
            }
        }
        Value::UNIT
    }
}

/// An attribute that may remove the code it stands on.
fn conditional(attributes: &[Attribute]) -> Option<&Attribute> {
    attributes.iter().find(|a| a.path().is_ident("cfg") || a.path().is_ident("cfg_attr"))
}

/// The attributes of the expressions that can be statements of their own.
fn attributes(e: &Expr) -> &[Attribute] {
    match e {
        Expr::Assign(e) => &e.attrs,
        Expr::Binary(e) => &e.attrs,
        Expr::Block(e) => &e.attrs,
        Expr::Call(e) => &e.attrs,
        Expr::ForLoop(e) => &e.attrs,
        Expr::If(e) => &e.attrs,
        Expr::Lit(e) => &e.attrs,
        Expr::MethodCall(e) => &e.attrs,
        Expr::Paren(e) => &e.attrs,
        Expr::Path(e) => &e.attrs,
        Expr::Return(e) => &e.attrs,
        Expr::Unary(e) => &e.attrs,
        _ => &[],
    }
}
