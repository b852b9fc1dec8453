//! The attributes that give a method its role.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::role::Role;

/// The role that an attribute gives.
pub(super) fn role(attribute: &Attribute) -> Option<Role> {
    Role::named(&attribute.path().get_ident()?.to_string())
}

/// The role that an attribute of an unknown name was probably meant to give.
pub(super) fn meant_role(attribute: &Attribute) -> Option<Role> {
    let name = attribute.path().get_ident()?.to_string();
    nearest(&name, Role::ALL.map(Role::name)).and_then(Role::named)
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
