//! Arrays, ranges and iterators: all of their elements are known, one by one.

use quote::ToTokens;
use syn::{Expr, ExprIndex, ExprMethodCall, ExprRange, ExprRepeat, GenericArgument, RangeLimits};

use crate::diagnostics::body;
use crate::model::{Known, known_type};

use super::budget::MAX_TURNS;
use super::code::{bare, is_vector_method};
use super::interpreter::Interpreter;
use super::operator::Operator;
use super::value::{Given, Value};

impl<'m> Interpreter<'m> {
    /// `[x; 3]`
    pub(super) fn repeat(&mut self, repeat: &'m ExprRepeat) -> Value {
        let value = self.value(&repeat.expr);
        let n = self.value(&repeat.len);
        let Some(n) = self.integer(n, &*repeat.len) else { return Value::Unknown };
        match usize::try_from(n) {
            Ok(n) if n <= MAX_TURNS => Value::Array(vec![value; n]),
            _ => self.refuse(body::excess(&repeat.len, body::Excess::Turns)),
        }
    }

    /// `a..b`, `a..=b`
    pub(super) fn range(&mut self, range: &'m ExprRange, e: &'m Expr) -> Value {
        let (Some(start), Some(end)) = (&range.start, &range.end) else {
            return self.refuse(body::open_range(e));
        };
        let bounds = (self.bound(start), self.bound(end));
        let (Some(start), Some(mut end)) = bounds else { return Value::Unknown };
        if let RangeLimits::Closed(_) = range.limits {
            end = end.saturating_add(1);
        }
        match end.checked_sub(start) {
            Some(n) if n <= MAX_TURNS as i128 => Value::Items((start..end).map(Value::Integer).collect()),
            _ => self.refuse(body::excess(e, body::Excess::Turns)),
        }
    }

    fn bound(&mut self, e: &'m Expr) -> Option<i128> {
        match self.value(e) {
            Value::Integer(n) => Some(n),
            Value::Unknown => None,
            other => {
                self.report(body::range_bound(e, &other.kind()));
                None
            }
        }
    }

    /// What a loop runs over.
    pub(super) fn items(&mut self, value: Value, at: &Expr) -> Option<Vec<Value>> {
        match value {
            Value::Items(items) | Value::Array(items) => Some(items),
            Value::Vector(components) => Some(components.into_iter().map(Value::Number).collect()),
            Value::Unknown => None,
            Value::Field(_) => {
                self.report(body::field_of_unknown_length(bare(at)));
                None
            }
            other => {
                self.report(body::not_iterable(at, &other.kind()));
                None
            }
        }
    }

    /// `q[0]`, `q[1..]`, `self.k[i]`
    pub(super) fn index_expression(&mut self, index: &'m ExprIndex, e: &'m Expr) -> Value {
        let base = self.value(&index.expr);
        if let Expr::Range(range) = bare(&index.index) {
            return self.slice(base, range, e);
        }
        let at = self.value(&index.index);
        let n = match (&base, at) {
            (Value::Unknown, _) | (_, Value::Unknown) => return Value::Unknown,
            (_, Value::Integer(n)) => n,
            (_, other) => return self.refuse(body::index_not_known(&index.index, &other.kind())),
        };
        let Ok(i) = usize::try_from(n) else {
            return self.refuse(body::index_out_of_range(&index.index, n, 0));
        };
        match base {
            Value::Array(elements) => match elements.get(i) {
                Some(element) => element.clone(),
                None => self.refuse(body::index_out_of_range(&index.index, n, elements.len())),
            },
            Value::Vector(components) => match components.get(i) {
                Some(&component) => Value::Number(component),
                None => self.refuse(body::index_out_of_range(&index.index, n, components.len())),
            },
            Value::Field(field) => self.field_element(&field, i),
            Value::Number(_) => self.refuse_once(body::indexed_number(e, &index.expr)),
            other => self.refuse(body::not_indexable(&index.expr, &other.kind())),
        }
    }

    fn slice(&mut self, base: Value, range: &'m ExprRange, e: &Expr) -> Value {
        let elements = match base {
            Value::Array(elements) => elements,
            Value::Unknown => return Value::Unknown,
            other => return self.refuse(body::not_indexable(e, &other.kind())),
        };
        let bound = |this: &mut Self, e: &'m Option<Box<Expr>>, open: i128| match e {
            Some(e) => this.bound(e),
            None => Some(open),
        };
        let start = bound(self, &range.start, 0);
        let end = bound(self, &range.end, elements.len() as i128);
        let (Some(start), Some(mut end)) = (start, end) else { return Value::Unknown };
        if let (RangeLimits::Closed(_), Some(_)) = (&range.limits, &range.end) {
            end = end.saturating_add(1);
        }
        match (usize::try_from(start), usize::try_from(end)) {
            (Ok(i), Ok(j)) if i <= j && j <= elements.len() => Value::Array(elements[i..j].to_vec()),
            _ => self.refuse(body::index_out_of_range(range, end, elements.len())),
        }
    }

    /// A method of an array, a range or an iterator.
    pub(super) fn sequence_method(&mut self, receiver: Given<'m>, call: &'m ExprMethodCall, e: &'m Expr) -> Value {
        let name = &call.method;
        let text = name.to_string();
        let (mut items, is_array) = match receiver.value {
            Value::Array(items) => (items, true),
            Value::Items(items) => (items, false),
            _ => return Value::Unknown,
        };
        let arguments: Vec<&'m Expr> = call.args.iter().collect();
        let needs_iterator = !matches!(text.as_str(), "iter" | "into_iter" | "map" | "len" | "windows");
        if is_array && needs_iterator {
            return self.refuse(match text.as_str() {
                "iter_mut" => body::iter_mut(name, items.len()),
                _ if is_adaptor(&text) => body::array_is_no_iterator(name),
                _ if is_vector_method(&text) => body::vector_function_of_array(name, items.len()),
                _ => body::unknown_array_function(name),
            });
        }
        match (text.as_str(), &arguments[..]) {
            ("iter" | "into_iter" | "by_ref", []) => Value::Items(items),
            ("len" | "count", []) => Value::Integer(items.len() as i128),
            ("rev", []) => {
                items.reverse();
                Value::Items(items)
            }
            ("enumerate", []) => {
                let numbered = items.into_iter().enumerate();
                Value::Items(numbered.map(|(i, item)| Value::Tuple(vec![Value::Integer(i as i128), item])).collect())
            }
            ("map", &[function]) => {
                let excess = self.budget.turns(items.len());
                if !self.within(excess, e) {
                    return Value::Unknown;
                }
                let values = items.into_iter().map(|item| self.apply(function, vec![item])).collect();
                if is_array { Value::Array(values) } else { Value::Items(values) }
            }
            ("flat_map", &[function]) => {
                let mut all = vec![];
                for item in items {
                    let inner = self.apply(function, vec![item]);
                    let Some(inner) = self.items(inner, function) else { return Value::Unknown };
                    let excess = self.budget.turns(1 + inner.len());
                    if !self.within(excess, e) {
                        return Value::Unknown;
                    }
                    all.extend(inner);
                }
                Value::Items(all)
            }
            ("zip" | "chain", &[other]) => {
                let value = self.value(other);
                let Some(others) = self.items(value, other) else { return Value::Unknown };
                if text == "chain" {
                    items.extend(others);
                    let excess = self.budget.turns(items.len());
                    return if self.within(excess, e) { Value::Items(items) } else { Value::Unknown };
                }
                Value::Items(items.into_iter().zip(others).map(|(one, two)| Value::Tuple(vec![one, two])).collect())
            }
            ("windows", &[size]) => {
                let n = self.value(size);
                let Some(n) = self.integer(n, size) else { return Value::Unknown };
                match usize::try_from(n) {
                    Ok(n) if n > 0 => Value::Items(items.windows(n).map(|w| Value::Array(w.to_vec())).collect()),
                    _ => self.refuse(body::index_out_of_range(size, n, items.len())),
                }
            }
            ("skip" | "take" | "step_by", &[count]) => {
                let n = self.value(count);
                let Some(n) = self.integer(n, count) else { return Value::Unknown };
                match (text.as_str(), usize::try_from(n)) {
                    ("skip", Ok(n)) => Value::Items(items.into_iter().skip(n).collect()),
                    ("take", Ok(n)) => Value::Items(items.into_iter().take(n).collect()),
                    ("step_by", Ok(n)) if n > 0 => Value::Items(items.into_iter().step_by(n).collect()),
                    _ => self.refuse(body::index_out_of_range(count, n, items.len())),
                }
            }
            ("fold", &[initial, function]) => {
                let mut value = self.value(initial);
                let excess = self.budget.turns(items.len());
                if !self.within(excess, e) {
                    return Value::Unknown;
                }
                for item in items {
                    value = self.apply(function, vec![value, item]);
                }
                value
            }
            ("sum" | "product", []) => self.total(items, call, e),
            ("filter" | "filter_map" | "take_while" | "skip_while", _) => self.refuse(body::filter(name)),
            (known, given) if is_adaptor(known) => {
                let expected = match known {
                    "rev" | "enumerate" | "len" | "count" | "iter" | "into_iter" | "sum" | "product" | "by_ref" => 0,
                    "fold" => 2,
                    _ => 1,
                };
                self.refuse(body::wrong_arguments(name, expected, given.len()))
            }
            _ => self.refuse(body::unknown_iterator_function(name)),
        }
    }

    /// `.sum::<f64>()`, `.product::<f64>()`
    fn total(&mut self, items: Vec<Value>, call: &'m ExprMethodCall, e: &'m Expr) -> Value {
        let is_sum = call.method == "sum";
        let stated = call.turbofish.as_ref().and_then(|list| match list.args.first() {
            Some(GenericArgument::Type(ty)) => Some(known_type(ty)),
            _ => None,
        });
        let integers = items.iter().all(|item| matches!(item, Value::Integer(_)));
        if integers && (stated == Some(Known::Integer) || !items.is_empty() && stated.is_none()) {
            let mut numbers = items.iter().map(|item| if let Value::Integer(n) = item { *n } else { 0 });
            let total = numbers.try_fold(if is_sum { 0_i128 } else { 1 }, |total, n| {
                if is_sum { total.checked_add(n) } else { total.checked_mul(n) }
            });
            return total.map_or_else(|| self.refuse(body::integer_overflow(e)), Value::Integer);
        }
        if is_sum && matches!(items.first(), Some(Value::Vector(_))) {
            let mut items = items.into_iter();
            let first = items.next().unwrap_or(Value::Unknown);
            return items.fold(first, |sum, item| self.combine(Operator::Add, sum, item, e, e, e));
        }
        if integers && !items.is_empty() {
            return self.refuse(body::integer_terms(&call.receiver));
        }
        let at: &dyn ToTokens = &*call.receiver;
        let numbers: Vec<_> = items.into_iter().map(|item| self.number(item, at)).collect();
        match numbers.into_iter().collect::<Option<Vec<_>>>() {
            Some(numbers) if is_sum => Value::Number(self.graph.add(&numbers)),
            Some(numbers) => Value::Number(self.graph.mul(&numbers)),
            None => Value::Unknown,
        }
    }
}

fn is_adaptor(name: &str) -> bool {
    [
        "iter",
        "into_iter",
        "by_ref",
        "len",
        "count",
        "rev",
        "enumerate",
        "map",
        "flat_map",
        "zip",
        "chain",
        "windows",
        "skip",
        "take",
        "step_by",
        "fold",
        "sum",
        "product",
    ]
    .contains(&name)
}
