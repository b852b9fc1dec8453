//! The attributes that give a method its role.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::Attribute;

use crate::diagnostics::nearest;

/// What a method can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Potential,
    Force,
    Pair,
    PairForce,
}

/// An argument that a role knows by its name.
pub(crate) struct KnownArgument {
    pub(crate) name: &'static str,
    pub(crate) meaning: &'static str,
    pub(crate) kind: Kind,
}

/// How an argument is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// `f64`
    Number,
    /// Like a position.
    Vector,
    /// A reference to what a body carries.
    Data,
}

const fn known(name: &'static str, meaning: &'static str, kind: Kind) -> KnownArgument {
    KnownArgument { name, meaning, kind }
}

const Q: KnownArgument = known("q", "position", Kind::Vector);
const V: KnownArgument = known("v", "velocity", Kind::Vector);
const M: KnownArgument = known("m", "mass", Kind::Number);
const T: KnownArgument = known("t", "time", Kind::Number);
const R: KnownArgument = known("r", "distance", Kind::Number);
const D: KnownArgument = known("d", "separation q_a − q_b", Kind::Vector);
const VA: KnownArgument = known("va", "velocity of a", Kind::Vector);
const VB: KnownArgument = known("vb", "velocity of b", Kind::Vector);
const MA: KnownArgument = known("ma", "mass of a", Kind::Number);
const MB: KnownArgument = known("mb", "mass of b", Kind::Number);
const A: KnownArgument = known("a", "data of a", Kind::Data);
const B: KnownArgument = known("b", "data of b", Kind::Data);

impl Role {
    const ALL: [Self; 4] = [Self::Potential, Self::Force, Self::Pair, Self::PairForce];

    /// The attribute that gives it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Potential => "potential",
            Self::Force => "force",
            Self::Pair => "pair",
            Self::PairForce => "pair_force",
        }
    }

    /// What a method with this role is called in a sentence.
    pub(crate) fn noun(self) -> &'static str {
        match self {
            Self::Potential => "potential",
            Self::Force => "force",
            Self::Pair => "pair potential",
            Self::PairForce => "pair force",
        }
    }

    /// The arguments that it can have.
    pub(crate) fn arguments(self) -> &'static [KnownArgument] {
        match self {
            Self::Potential => &[Q, M, T],
            Self::Force => &[Q, V, M, T],
            Self::Pair => &[R, D, MA, MB, A, B, T],
            Self::PairForce => &[D, VA, VB, MA, MB, A, B, T],
        }
    }

    /// The signature of a method with this role.
    pub(crate) fn example(self) -> &'static str {
        match self {
            Self::Potential => "energy(&self, q: [f64; 2]) -> f64",
            Self::Force => "force(&self, v: [f64; 2]) -> [f64; 2]",
            Self::Pair => "energy(&self, r: f64) -> f64",
            Self::PairForce => "force(&self, d: [f64; 2]) -> [f64; 2]",
        }
    }

    /// Whether it knows an argument of this name.
    pub(crate) fn knows(self, name: &str) -> bool {
        self.arguments().iter().any(|known| known.name == name)
    }

    /// The argument that says where.
    pub(crate) fn place(self) -> &'static KnownArgument {
        if self.is_of_two() { &D } else { &Q }
    }

    /// The role with the same bodies that knows velocities.
    pub(crate) fn force(self) -> Self {
        if self.is_of_two() { Self::PairForce } else { Self::Force }
    }

    /// Whether the law is one between two bodies.
    pub(crate) fn is_of_two(self) -> bool {
        matches!(self, Self::Pair | Self::PairForce)
    }

    /// Whether the method's value is a vector like the position, rather than one number.
    pub(crate) fn is_force(self) -> bool {
        matches!(self, Self::Force | Self::PairForce)
    }

    /// The role that an attribute gives.
    pub(super) fn of(attribute: &Attribute) -> Option<Self> {
        Self::named(&attribute.path().get_ident()?.to_string())
    }

    /// The role that an attribute of an unknown name was probably meant to give.
    pub(super) fn meant_by(attribute: &Attribute) -> Option<Self> {
        let name = attribute.path().get_ident()?.to_string();
        nearest(&name, Self::ALL.map(Self::name)).and_then(Self::named)
    }

    fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.name() == name)
    }
}

/// The item without the attributes of roles on the members of its block, and without a misspelt one; every other token
/// as it was.
pub(super) fn strip(item: TokenStream, misspelt: Option<&str>) -> TokenStream {
    let mut tokens: Vec<_> = item.into_iter().collect();
    let block = tokens.iter().rposition(|t| matches!(t, TokenTree::Group(g) if g.delimiter() == Delimiter::Brace));
    if let Some(i) = block
        && let TokenTree::Group(group) = &tokens[i]
        && let Some(members) = without_roles(group.stream(), misspelt)
    {
        let mut stripped = Group::new(Delimiter::Brace, members);
        stripped.set_span(group.span());
        tokens[i] = TokenTree::Group(stripped);
    }
    tokens.into_iter().collect()
}

/// `None` where there was nothing to remove.
fn without_roles(members: TokenStream, misspelt: Option<&str>) -> Option<TokenStream> {
    let mut kept: Vec<TokenTree> = vec![];
    let mut removed = false;
    for token in members {
        let hash = matches!(kept.last(), Some(TokenTree::Punct(p)) if p.as_char() == '#');
        match &token {
            TokenTree::Group(g) if hash && g.delimiter() == Delimiter::Bracket && gives_role(g.stream(), misspelt) => {
                kept.pop();
                removed = true;
            }
            _ => kept.push(token),
        }
    }
    removed.then(|| kept.into_iter().collect())
}

/// Whether the tokens between the brackets of an attribute are a role, with or without arguments.
fn gives_role(attribute: TokenStream, misspelt: Option<&str>) -> bool {
    let mut tokens = attribute.into_iter();
    let Some(TokenTree::Ident(name)) = tokens.next() else { return false };
    let is_path = matches!(tokens.next(), Some(TokenTree::Punct(p)) if p.as_char() == ':');
    let name = name.to_string();
    !is_path && (Role::named(&name).is_some() || misspelt == Some(name.as_str()))
}
