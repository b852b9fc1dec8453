//! The arguments of a law between two bodies, and the numbers that it reads of each.

use dmech_symbolic::expression::{Graph, Symbol};
use dmech_symbolic::kernel::PairVariables;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Type;

use crate::model::{Body, Known, PairArgument, known_type};

use super::interpreter::Interpreter;
use super::lowered::{LoweredPair, Parameter, Read, Source};
use super::value::{At, Field, Owner, Value};

/// What generated code calls the data of a body.
pub(crate) fn data() -> Ident {
    Ident::new("data", Span::mixed_site())
}

impl Owner {
    /// A number that is read there.
    pub(super) fn source(self, tokens: TokenStream) -> Source {
        match self {
            Self::Law => Source::Law(tokens),
            Self::Body(body) => Source::Body(body, Read::Data(tokens)),
        }
    }
}

impl Field {
    /// Whether this is all the data of a body, in a type that the macro does not know.
    pub(super) fn is_data(&self) -> bool {
        matches!(self.of, Owner::Body(body) if self.key == body.name())
    }
}

impl<'m> Interpreter<'m> {
    pub(super) fn pair_argument(&mut self, role: PairArgument) -> Value {
        let Some(pair) = self.pair.clone() else { return Value::Unknown };
        match role {
            PairArgument::Distance => Value::Number(pair.distance(&mut self.graph)),
            PairArgument::Separation(shape) => self.coordinates(&self.variables.q.clone(), shape),
            PairArgument::Velocity(Body::A, shape) => self.coordinates(&pair.va, shape),
            PairArgument::Velocity(Body::B, shape) => self.coordinates(&pair.vb, shape),
            PairArgument::Mass(body) => {
                let name = format!("m{}", body.name());
                Value::Number(self.parameter(&name, &name, Source::Body(body, Read::Mass)))
            }
            PairArgument::Data(body) => {
                let model = self.model;
                let data_type = model.pair.as_ref().and_then(|pair| pair.data.as_ref());
                data_type.map_or(Value::Unknown, |ty| self.data(body, ty))
            }
        }
    }

    /// The data of a body: a number, an array, or a struct whose fields are seen when they are named.
    fn data(&mut self, body: Body, ty: &Type) -> Value {
        let (data, name) = (data(), body.name());
        let whole = Field { of: Owner::Body(body), tokens: quote!(#data), key: name.into(), name: name.into() };
        match known_type(ty) {
            Known::Float => Value::Number(self.parameter(name, name, whole.of.source(quote!(*#data)))),
            _ => self.conform(Value::Field(whole), ty, At::Other(ty)),
        }
    }
}

/// Finds the layout of what is read of a body, which is the same for both.
pub(super) fn lowered(graph: &mut Graph, variables: PairVariables, parameters: &[Parameter]) -> LoweredPair {
    let mut layout: Vec<(Read, [Option<Symbol>; 2])> = vec![];
    for parameter in parameters {
        let Source::Body(body, read) = &parameter.source else { continue };
        let known = layout.iter().position(|(other, _)| other.is_same(read));
        let i = known.unwrap_or_else(|| {
            layout.push((read.clone(), [None; 2]));
            layout.len() - 1
        });
        layout[i].1[*body as usize] = Some(parameter.symbol);
    }
    // What is read of one body only has a partner that nothing depends on.
    let mut partner = |symbol: Option<Symbol>| symbol.unwrap_or_else(|| graph.parameter("unread"));
    let exchange = layout.iter().map(|&(_, [a, b])| (partner(a), partner(b))).collect();
    LoweredPair { variables, exchange, layout: layout.into_iter().map(|(read, _)| read).collect() }
}
