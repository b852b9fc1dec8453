//! What patterns bind, and what type annotations say about a value.

use syn::punctuated::Punctuated;
use syn::{Pat, PatStruct, Token, Type};

use crate::diagnostics::body;
use crate::model::{Known, known_type};

use super::interpreter::Interpreter;
use super::value::{At, Value};

impl<'m> Interpreter<'m> {
    /// Binds the names of a pattern; `at` is the code that the value comes from.
    pub(super) fn bind(&mut self, pattern: &'m Pat, value: Value, at: At<'_>) {
        match pattern {
            Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => {
                self.scope.bind(name.ident.to_string(), value);
            }
            Pat::Wild(_) => {}
            Pat::Paren(inner) => self.bind(&inner.pat, value, at),
            Pat::Reference(inner) => self.bind(&inner.pat, value, at),
            Pat::Type(typed) => {
                let value = self.conform(value, &typed.ty, at);
                self.bind(&typed.pat, value, at);
            }
            Pat::Slice(slice) => match value {
                Value::Array(elements) => self.bind_all(pattern, &slice.elems, elements, at),
                Value::Field(field) if !slice.elems.iter().any(is_rest) => {
                    let elements = self.field_elements(&field, slice.elems.len());
                    self.bind_all(pattern, &slice.elems, elements, at);
                }
                other => self.mismatch(pattern, other),
            },
            Pat::Tuple(tuple) => match value {
                Value::Tuple(parts) => self.bind_all(pattern, &tuple.elems, parts, at),
                Value::Field(field) if !tuple.elems.iter().any(is_rest) => {
                    let parts = (0..tuple.elems.len()).map(|i| self.field_member(&field, &i.into())).collect();
                    self.bind_all(pattern, &tuple.elems, parts, at);
                }
                other => self.mismatch(pattern, other),
            },
            Pat::Struct(fields) if self.names_law(&fields.path, &value) => self.bind_fields(fields),
            Pat::TupleStruct(fields) if self.names_law(&fields.path, &value) && !fields.elems.iter().any(is_rest) => {
                let parts = (0..fields.elems.len()).map(|i| self.law_field(&i.into())).collect();
                self.bind_all(pattern, &fields.elems, parts, at);
            }
            _ => {
                self.report(body::pattern(pattern));
                self.bind_unknown(pattern);
            }
        }
    }

    fn names_law(&self, path: &syn::Path, value: &Value) -> bool {
        let own = path.segments.len() == 1 && self.model.is_own_type(&path.segments[0].ident);
        own && matches!(value, Value::Law)
    }

    /// `let Self { gm, .. } = *self;`
    fn bind_fields(&mut self, fields: &'m PatStruct) {
        for field in &fields.fields {
            let value = self.law_field(&field.member);
            self.bind(&field.pat, value, At::Other(&field.member));
        }
    }

    /// Binds element by element, with `..` in at most one place.
    fn bind_all(
        &mut self,
        whole: &'m Pat,
        patterns: &'m Punctuated<Pat, Token![,]>,
        mut values: Vec<Value>,
        at: At<'_>,
    ) {
        let rest = patterns.iter().position(is_rest);
        let fits = match rest {
            None => patterns.len() == values.len(),
            Some(_) => patterns.len() - 1 <= values.len(),
        };
        if !fits {
            self.report(body::wrong_count(whole, patterns.len() - usize::from(rest.is_some()), values.len()));
            self.bind_unknown(whole);
            return;
        }
        if let Some(i) = rest {
            let after = patterns.len() - 1 - i;
            let middle: Vec<_> = values.drain(i..values.len() - after).collect();
            values.insert(i, Value::Array(middle));
        }
        for (i, (pattern, value)) in patterns.iter().zip(values).enumerate() {
            match pattern {
                Pat::Rest(_) => {}
                Pat::Ident(name) if name.subpat.is_some() => self.scope.bind(name.ident.to_string(), value),
                pattern => self.bind(pattern, value, if rest.is_none() { at.part(i) } else { at }),
            }
        }
    }

    fn mismatch(&mut self, pattern: &'m Pat, value: Value) {
        if !value.is_unknown() {
            self.report(body::pattern_mismatch(pattern, &value.kind(), matches!(value, Value::Vector(_))));
        }
        self.bind_unknown(pattern);
    }

    /// Binds every name in the pattern to nothing known.
    fn bind_unknown(&mut self, pattern: &'m Pat) {
        match pattern {
            Pat::Ident(name) => self.scope.bind(name.ident.to_string(), Value::Unknown),
            Pat::Paren(inner) => self.bind_unknown(&inner.pat),
            Pat::Reference(inner) => self.bind_unknown(&inner.pat),
            Pat::Type(typed) => self.bind_unknown(&typed.pat),
            Pat::Slice(slice) => slice.elems.iter().for_each(|p| self.bind_unknown(p)),
            Pat::Tuple(tuple) => tuple.elems.iter().for_each(|p| self.bind_unknown(p)),
            Pat::TupleStruct(fields) => fields.elems.iter().for_each(|p| self.bind_unknown(p)),
            Pat::Struct(fields) => fields.fields.iter().for_each(|f| self.bind_unknown(&f.pat)),
            Pat::Or(cases) => cases.cases.iter().for_each(|p| self.bind_unknown(p)),
            _ => {}
        }
    }

    /// The value as the type says: what a field is becomes known, and integers are not numbers.
    pub(super) fn conform(&mut self, value: Value, ty: &Type, at: At<'_>) -> Value {
        if let Type::Reference(reference) = ty
            && let Some(mutability) = &reference.mutability
        {
            return self.refuse(body::mutable_reference(mutability));
        }
        self.conform_known(value, &known_type(ty), ty, at)
    }

    fn conform_known(&mut self, value: Value, known: &Known, ty: &Type, at: At<'_>) -> Value {
        match (known, value) {
            (_, Value::Unknown) => Value::Unknown,
            (Known::Single, _) => self.refuse(body::single_precision(ty)),
            (Known::Float, value) => {
                let number = self.number(value, &at);
                Self::from_number(number)
            }
            (Known::Integer, value) => {
                let n = self.integer(value, &at);
                n.map_or(Value::Unknown, Value::Integer)
            }
            (Known::Array(of, length), value) => match (value, length.as_ref().and_then(|n| self.length(n))) {
                (Value::Field(field), Some(n)) => {
                    let elements = self.field_elements(&field, n);
                    Value::Array(elements.into_iter().map(|v| self.conform_known(v, of, ty, at)).collect())
                }
                (Value::Array(elements), _) => {
                    let parts = elements.into_iter().enumerate();
                    Value::Array(parts.map(|(i, v)| self.conform_known(v, of, ty, at.part(i))).collect())
                }
                (value, _) => value,
            },
            (Known::Tuple(known), Value::Tuple(parts)) if known.len() == parts.len() => {
                let parts = known.iter().zip(parts).enumerate();
                Value::Tuple(parts.map(|(i, (known, v))| self.conform_known(v, known, ty, at.part(i))).collect())
            }
            (Known::Tuple(_), value) => value,
            (Known::Vector(length), value) => match (value, length.as_ref().and_then(|n| self.length(n))) {
                (Value::Field(field), Some(n)) => Value::Vector(self.field_vector(&field, n)),
                (value, _) => value,
            },
            (Known::Other, value) => value,
        }
    }
}

fn is_rest(pattern: &Pat) -> bool {
    match pattern {
        Pat::Rest(_) => true,
        Pat::Ident(name) => matches!(&name.subpat, Some((_, sub)) if matches!(**sub, Pat::Rest(_))),
        _ => false,
    }
}
