//! Helpers of the block, functions called by their path, closures.

use proc_macro2::Ident;
use syn::punctuated::Punctuated;
use syn::{Expr, ExprCall, ExprMethodCall, ExprPath, FnArg, ImplItemFn, ReceiverKind, ReturnType, Safety, Token};

use crate::diagnostics::{body, nearest, pair};
use crate::model::{Sibling, vector_alias};

use super::code::{bare, is_sequence_method, is_vector_method, result_of, thrown_away};
use super::function::arity;
use super::interpreter::Interpreter;
use super::value::{At, Given, Owner, Value};

impl<'m> Interpreter<'m> {
    pub(super) fn method_call(&mut self, call: &'m ExprMethodCall, e: &'m Expr) -> Value {
        if let (Expr::Range(range), true, 1) = (bare(&call.receiver), call.method == "contains", call.args.len()) {
            return self.contains(range, &call.args[0], e);
        }
        let receiver = self.value(&call.receiver);
        if let Value::Law = receiver {
            let arguments = self.given(call.args.iter());
            return self.helper(&call.method, Some(()), arguments);
        }
        let receiver = Given { value: receiver, at: &call.receiver };
        self.method(&call.method, receiver, call, e)
    }

    pub(super) fn given(&mut self, arguments: impl Iterator<Item = &'m Expr>) -> Vec<Given<'m>> {
        arguments.map(|at| Given { value: self.value(at), at }).collect()
    }

    /// The arguments of a function of this name, of which that of an integer power comes last.
    fn given_to(&mut self, name: &str, arguments: &'m Punctuated<Expr, Token![,]>) -> Vec<Given<'m>> {
        match (name, arguments.last()) {
            ("powi", Some(exponent)) => {
                let mut given = self.given(arguments.iter().take(arguments.len() - 1));
                given.push(Given { value: self.exponent(exponent), at: exponent });
                given
            }
            _ => self.given(arguments.iter()),
        }
    }

    /// A method of anything but the law.
    fn method(&mut self, name: &'m Ident, receiver: Given<'m>, call: &'m ExprMethodCall, e: &'m Expr) -> Value {
        let text = name.to_string();
        if let ("clone" | "to_owned" | "copied" | "cloned", true) = (text.as_str(), call.args.is_empty()) {
            return receiver.value;
        }
        match &receiver.value {
            Value::Array(_) | Value::Items(_) => self.sequence_method(receiver, call, e),
            Value::Vector(_) => self.vector_method(receiver, call, e),
            Value::Field(_) if is_vector_method(&text) => self.vector_method(receiver, call, e),
            Value::Field(_) if is_sequence_method(&text) => {
                self.refuse(body::field_of_unknown_length(bare(&call.receiver)))
            }
            Value::Field(field) if field.of != Owner::Law && arity(&text).is_none() => {
                self.refuse(pair::method_of_data(name))
            }
            Value::Number(_) | Value::Field(_) if arity(&text).is_none() => {
                let field = matches!(receiver.value, Value::Field(_)).then(|| bare(&call.receiver));
                self.report(body::unknown_function(name, field));
                self.read_for_errors(call)
            }
            Value::Number(_) | Value::Field(_) => {
                let arguments = self.given_to(&text, &call.args);
                self.function(name, receiver, arguments, e)
            }
            Value::Integer(_) => {
                let arguments = self.given(call.args.iter());
                self.integer_method(name, receiver, arguments, e)
            }
            Value::Unknown => self.read_for_errors(call),
            other => self.refuse(body::no_method(name, &other.kind())),
        }
    }

    /// What is wrong with the arguments shows in the same run; closures have nothing to work on.
    fn read_for_errors(&mut self, call: &'m ExprMethodCall) -> Value {
        for argument in call.args.iter().filter(|a| !matches!(bare(a), Expr::Closure(_) | Expr::Path(_))) {
            self.value(argument);
        }
        Value::Unknown
    }

    pub(super) fn call(&mut self, call: &'m ExprCall, e: &'m Expr) -> Value {
        match bare(&call.func) {
            Expr::Path(path) => {
                if is_from_fn(path) {
                    return self.refuse(body::from_fn(&call.func));
                }
                let arguments = self.given_to(&name_of(path), &call.args);
                self.call_path(path, arguments, e)
            }
            _ => self.refuse(body::not_a_function(&call.func)),
        }
    }

    /// `f64::sqrt(x)`, `Self::helper(x)`, `Vector2::new(x, y)`
    fn call_path(&mut self, path: &'m ExprPath, mut arguments: Vec<Given<'m>>, e: &'m Expr) -> Value {
        let segments: Vec<_> = path.path.segments.iter().collect();
        let [.., owner, function] = &segments[..] else {
            return self.call_name(path, arguments.len());
        };
        let (owner, function) = (&owner.ident, &function.ident);
        if segments.len() == 2 && self.model.is_own_type(owner) {
            let takes_law = matches!(arguments.first(), Some(Given { value: Value::Law, .. }));
            if takes_law {
                arguments.remove(0);
            }
            return self.helper(function, takes_law.then_some(()), arguments);
        }
        if vector_alias(&owner.to_string()).is_some() {
            return self.vector_constructor(path, owner, function, arguments, e);
        }
        if owner == "f64" && arguments.is_empty() {
            return self.refuse(body::no_argument(function));
        }
        if owner == "f64" {
            let receiver = arguments.remove(0);
            if function == "from" && arguments.is_empty() {
                return match receiver.value {
                    Value::Integer(n) => Value::Number(self.graph.number(n as f64)),
                    value => {
                        let number = self.number(value, receiver.at);
                        Self::from_number(number)
                    }
                };
            }
            return self.function(function, receiver, arguments, e);
        }
        self.refuse(body::foreign_function(path, false, arguments.len(), arity))
    }

    /// `f(x)`, which is never right.
    fn call_name(&mut self, path: &'m ExprPath, given: usize) -> Value {
        let name = name_of(path);
        if let Some(found) = self.scope.find(&name) {
            let known_wrong = self.scope.locals[found].value.is_unknown();
            return if known_wrong { Value::Unknown } else { self.refuse(body::not_a_function(path)) };
        }
        let is_own =
            self.model.methods.contains_key(&name) || self.model.formulas().any(|formula| formula.ident == *name);
        self.refuse(body::foreign_function(path, is_own, given, arity))
    }

    /// A method of the same block, read as if it stood in place of the call.
    fn helper(&mut self, name: &Ident, receiver: Option<()>, arguments: Vec<Given<'m>>) -> Value {
        let model = self.model;
        let text = name.to_string();
        let method = match model.methods.get(&text) {
            Some(Sibling::One(method)) => method,
            Some(Sibling::Conditional) => return self.refuse(body::conditional_sibling(name)),
            None if model.formulas().any(|formula| formula.ident == *name) => {
                return self.refuse(body::recursion(name));
            }
            None => {
                let near = nearest(&text, model.methods.keys().map(String::as_str));
                return self.refuse(body::unknown_helper(name, &model.name, near));
            }
        };
        if self.calls.contains(&text) {
            return self.refuse(body::recursion(name));
        }
        if let Some(error) = self.unfit(method, name, receiver, &arguments) {
            return self.refuse(error);
        }
        let typed = method.sig.inputs.iter().filter_map(|input| match input {
            FnArg::Typed(typed) => Some(typed),
            FnArg::Receiver(_) => None,
        });
        // What does not fit is a mistake of the caller.
        let mut fitting = vec![];
        for (parameter, Given { value, at }) in typed.zip(arguments) {
            fitting.push((parameter, self.conform(value, &parameter.ty, At::Code(at)), at));
        }
        self.calls.push(text);
        let value = self.in_new_scope(|this| {
            for (parameter, value, at) in fitting {
                this.bind(&parameter.pat, value, At::Code(at));
            }
            let value = this.function_body(&method.block);
            match &method.sig.output {
                ReturnType::Type(_, ty) => match result_of(&method.block) {
                    Some(at) => this.conform(value, ty, At::Code(at)),
                    None if value.is_unknown() => Value::Unknown,
                    None => this.refuse(body::no_result(&method.sig.ident, thrown_away(&method.block))),
                },
                ReturnType::Default => value,
            }
        });
        self.calls.pop();
        value
    }

    /// Why a method of the block cannot be called, or not so.
    fn unfit(
        &self,
        method: &ImplItemFn,
        name: &Ident,
        receiver: Option<()>,
        arguments: &[Given<'m>],
    ) -> Option<syn::Error> {
        let signature = &method.sig;
        let takes_law = signature.receiver();
        let expected = signature.inputs.len() - usize::from(takes_law.is_some());
        if signature.asyncness.is_some() || matches!(signature.safety, Safety::Unsafe(_)) {
            return Some(body::unfit_helper(name));
        }
        if takes_law.is_some_and(|r| matches!(r.kind, ReceiverKind::Reference(_, _, Some(_)))) {
            return Some(body::changing_helper(name));
        }
        if takes_law.is_some() != receiver.is_some() {
            return Some(body::helper_receiver(name, takes_law.is_some()));
        }
        (expected != arguments.len()).then(|| body::wrong_arguments(name, expected, arguments.len()))
    }

    /// Applies a closure, or a function named by its path, to values.
    pub(super) fn apply(&mut self, function: &'m Expr, values: Vec<Value>) -> Value {
        match bare(function) {
            Expr::Closure(closure) => {
                if closure.asyncness.is_some() {
                    return self.refuse(body::not_a_formula(&closure.asyncness, "an `async` closure"));
                }
                if closure.inputs.len() != values.len() {
                    return self.refuse(body::closure_arguments(closure, closure.inputs.len(), values.len()));
                }
                let mark = self.scope.mark();
                for (pattern, value) in closure.inputs.iter().zip(values) {
                    self.bind(pattern, value, At::Other(pattern));
                }
                let mut value = self.value(&closure.body);
                if let ReturnType::Type(_, ty) = &closure.output {
                    value = self.conform(value, ty, At::Code(&closure.body));
                }
                self.scope.reset(mark);
                value
            }
            Expr::Path(path) if path.path.segments.len() > 1 => {
                let arguments = values.into_iter().map(|value| Given { value, at: function }).collect();
                self.call_path(path, arguments, function)
            }
            other => self.refuse(body::not_a_closure(other)),
        }
    }
}

fn name_of(path: &ExprPath) -> String {
    path.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default()
}

fn is_from_fn(path: &ExprPath) -> bool {
    name_of(path) == "from_fn"
}
