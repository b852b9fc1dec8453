//! What the law reads of itself: `self.k`, `self.k[2]`, `self.spring.k`, `Self::G`. Each becomes one parameter.

use proc_macro2::{Ident, Literal, Span};
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{ExprField, Member, Type};

use crate::diagnostics::body;

use super::code::{cast_tokens, component};
use super::interpreter::{Expression, Interpreter};
use super::lowered::{Parameter, Read, Source};
use super::value::{At, Field, Owner, Value};

impl<'m> Interpreter<'m> {
    pub(super) fn field_expression(&mut self, field: &'m ExprField) -> Value {
        match (self.value(&field.base), &field.member) {
            (Value::Unknown, _) => Value::Unknown,
            (Value::Law, member) => self.law_field(member),
            (Value::Field(base), member) => self.field_member(&base, member),
            (Value::Tuple(mut parts), Member::Unnamed(index)) if (index.index as usize) < parts.len() => {
                parts.swap_remove(index.index as usize)
            }
            (Value::Vector(components), Member::Named(name)) => {
                match component(&name.to_string()).and_then(|i| components.get(i)) {
                    Some(&number) => Value::Number(number),
                    None => self.refuse_once(body::no_component(name, components.len())),
                }
            }
            (other, _) => self.refuse(body::no_field(&field.member, &field.base, &other.kind())),
        }
    }

    /// `self.k`
    pub(super) fn law_field(&mut self, member: &Member) -> Value {
        let span = member.span();
        // The receiver of the generated function is meant, wherever the text stands.
        let receiver = Ident::new("self", Span::call_site().located_at(span));
        let text = member.to_token_stream().to_string();
        let field = Field {
            of: Owner::Law,
            tokens: quote_spanned!(span=> #receiver.#member),
            key: format!("self.{text}"),
            name: member_name(member),
        };
        match &self.model.fields {
            None => Value::Field(field),
            Some(fields) => match fields.iter().find(|(name, _)| *name == text) {
                Some((_, ty)) => self.conform(Value::Field(field), ty, At::Other(member)),
                None => {
                    let declared: Vec<_> = fields.iter().map(|(name, _)| name.as_str()).collect();
                    self.refuse(body::unknown_field(member, &declared))
                }
            },
        }
    }

    /// `self.spring.k`
    pub(super) fn field_member(&mut self, base: &Field, member: &Member) -> Value {
        let tokens = &base.tokens;
        Value::Field(Field {
            of: base.of,
            tokens: quote!(#tokens.#member),
            key: format!("{}.{}", base.key, member.to_token_stream()),
            name: format!("{}_{}", base.name, member_name(member)),
        })
    }

    /// `self.k[2]`
    pub(super) fn field_element(&mut self, base: &Field, i: usize) -> Value {
        let tokens = &base.tokens;
        let index = Literal::usize_unsuffixed(i);
        // Where the author reads it, so that a type that does not fit is told there.
        let span = Span::call_site().located_at(tokens.span());
        Value::Field(Field {
            of: base.of,
            tokens: quote_spanned!(span=> #tokens[#index]),
            key: format!("{}[{i}]", base.key),
            name: format!("{}_{i}", base.name),
        })
    }

    /// The first n elements of an array.
    pub(super) fn field_elements(&mut self, base: &Field, n: usize) -> Vec<Value> {
        (0..n).map(|i| self.field_element(base, i)).collect()
    }

    /// The components of a vector of dimension n.
    pub(super) fn field_vector(&mut self, base: &Field, n: usize) -> Vec<Expression> {
        let components = self.field_elements(base, n);
        let as_number = |value| match value {
            Value::Field(field) => self.field_number(&field),
            _ => self.graph.zero(),
        };
        components.into_iter().map(as_number).collect()
    }

    /// `self.n as f64`
    pub(super) fn cast_field(&mut self, base: &Field, ty: &Type) -> Value {
        let tokens = cast_tokens(&base.tokens, ty);
        let key = format!("{} as f64", base.key);
        Value::Number(self.parameter(&key, &base.name, base.of.source(tokens)))
    }

    /// A field where a number is needed.
    pub(super) fn field_number(&mut self, field: &Field) -> Expression {
        self.parameter(&field.key, &field.name, field.of.source(field.tokens.clone()))
    }

    /// The parameter with that key, new if need be.
    pub(super) fn parameter(&mut self, key: &str, name: &str, source: Source) -> Expression {
        if let Some(&found) = self.known.get(key) {
            return found;
        }
        let mut free = name.to_owned();
        if matches!(source, Source::Law(_) | Source::Body(_, Read::Data(_))) {
            while !self.names.insert(free.clone()) {
                free.insert_str(0, "law_");
            }
        }
        let symbol = self.graph.parameter(&free);
        let formula = self.graph.symbol(symbol);
        self.parameters.push(Parameter { symbol, name: name.to_owned(), source });
        self.known.insert(key.to_owned(), formula);
        formula
    }
}

fn member_name(member: &Member) -> String {
    match member {
        Member::Named(name) => name.to_string().trim_start_matches("r#").to_owned(),
        Member::Unnamed(index) => format!("p{}", index.index),
    }
}
