//! From tokens to one checked [`Model`]: which type, which potential, in which coordinates, with which helpers.
//!
//! Nothing is known here of what the body of the potential computes; that is the business of the stage after this one.

mod argument;
mod attribute;
mod derived;
mod implementation;
mod nesting;
mod options;
mod outline;
mod pair;
mod signature;
mod types;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use syn::{Block, ExprClosure, Generics, Ident, ImplItemConst, ImplItemFn, Item, Path, Type, parse_quote};

use crate::diagnostics::Mistakes;
use crate::role::Role;

pub use argument::Body;
pub(crate) use derived::from_derive;
pub(crate) use implementation::{MAX_INVARIANTS, from_impl};
pub use pair::PairSignature;

pub(crate) use argument::{Argument, PairArgument, Quantity, Shape};
pub(crate) use types::{Known, Length, VectorAlias, is_integer, known_type, vector_alias};

/// What was read, and the user's item as it is to be emitted again.
pub(crate) struct Parsed {
    /// The item without the attributes of roles; empty for the derive, where the compiler keeps the item itself.
    pub(crate) item: TokenStream,
    /// The law, or what is wrong with it.
    pub(crate) model: Result<Model, Refused>,
}

/// A law that is wrong.
pub(crate) struct Refused {
    /// What is wrong with it.
    pub(crate) mistakes: Mistakes,
    /// What could be read of it: what its author calls need not look missing.
    pub(crate) model: Option<Box<Model>>,
    /// What of it is wrong.
    pub(crate) refusal: Refusal,
    /// Whether the bodies of its methods can be read.
    pub(crate) has_bodies: bool,
}

/// What of a law is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// Where the attribute stands, which roles there are, what their methods take and return.
    Signature,
    /// Its formulas alone.
    Formulas,
}

/// A law that has been checked.
pub struct Model {
    /// The type that the law is stated for.
    pub self_ty: Type,
    /// The generics of the impl block, or of the struct.
    pub generics: Generics,
    /// The path of the facade crate, `::dmech` unless the user says otherwise.
    pub krate: Path,
    /// The last name in the path of the type: `Kepler`.
    pub name: String,
    /// The number of coordinates.
    pub dimension: usize,
    /// What only a law between two bodies has.
    pub pair: Option<PairSignature>,
    /// The potential, if the law has one.
    pub(crate) potential: Option<Formula>,
    /// The force, if the law has one, and how its value is written.
    pub(crate) force: Option<(Formula, Shape)>,
    /// What the law says it keeps, in order.
    pub(crate) invariants: Vec<Formula>,
    /// The other methods of the block, by name.
    pub(crate) methods: BTreeMap<String, Sibling<ImplItemFn>>,
    /// The constants of the block, by name.
    pub(crate) constants: BTreeMap<String, Sibling<ImplItemConst>>,
    /// The fields of the struct; only the derive sees them.
    pub(crate) fields: Option<Vec<(String, Type)>>,
}

/// A method, or closure, with a role.
pub(crate) struct Formula {
    /// What it is.
    pub(crate) role: Role,
    /// Its name; that of the attribute for the derive.
    pub(crate) ident: Ident,
    /// Its arguments in order.
    pub(crate) arguments: Vec<Argument>,
    /// What it computes.
    pub(crate) body: Block,
    /// The whole of it, for the derive, where it is no method that can be called.
    pub(crate) closure: Option<Box<ExprClosure>>,
}

/// Something else in the block.
pub(crate) enum Sibling<T> {
    /// The only one of its name.
    One(Box<T>),
    /// Several of one name, or one under `#[cfg]`: which one holds is not known while macros run.
    Conditional,
}

impl Model {
    /// A law of which nothing but its type can be read.
    fn unread(self_ty: Type, generics: Generics, krate: Path, name: String) -> Self {
        Self {
            self_ty,
            generics,
            krate,
            name,
            dimension: 0,
            pair: None,
            potential: None,
            force: None,
            invariants: vec![],
            methods: BTreeMap::new(),
            constants: BTreeMap::new(),
            fields: None,
        }
    }

    /// Likewise for the type that an item declares.
    fn of_declared(item: Item, krate: Path) -> Option<Self> {
        let (ident, generics) = match item {
            Item::Struct(item) => (item.ident, item.generics),
            Item::Enum(item) => (item.ident, item.generics),
            Item::Union(item) => (item.ident, item.generics),
            _ => return None,
        };
        let (_, arguments, _) = generics.split_for_impl();
        let self_ty = parse_quote!(#ident #arguments);
        Some(Self::unread(self_ty, generics, krate, ident.to_string()))
    }

    /// What can be relied on where the signature is wrong: not what it says of coordinates and data.
    pub(crate) fn without_signature(self) -> Self {
        let pair = self.pair.map(|_| PairSignature { data: None });
        Self { dimension: 0, pair, ..self }
    }

    /// The methods with a role.
    pub(crate) fn formulas(&self) -> impl Iterator<Item = &Formula> {
        self.potential.iter().chain(self.force.iter().map(|(force, _)| force)).chain(&self.invariants)
    }

    /// The names under which the body may call the law's own type: `Self`, `Kepler`.
    pub(crate) fn is_own_type(&self, ident: &Ident) -> bool {
        ident == "Self" || *ident == self.name
    }
}

fn finish(item: TokenStream, model: Option<Model>, mistakes: Mistakes, has_bodies: bool) -> Parsed {
    // Where a body cannot be read there is one mistake at least.
    let refusal = if mistakes.errors.len() > usize::from(!has_bodies) { Refusal::Signature } else { Refusal::Formulas };
    let model = match model {
        Some(model) if mistakes.errors.is_empty() => Ok(model),
        model => Err(Refused { mistakes, model: model.map(Box::new), refusal, has_bodies }),
    };
    Parsed { item, model }
}
