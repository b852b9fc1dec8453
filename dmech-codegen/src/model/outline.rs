//! What is left of a block whose bodies cannot be read: the type, the signatures.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// The item with an empty block in the place of every body.
pub(super) fn without_bodies(item: TokenStream) -> TokenStream {
    let mut tokens: Vec<_> = item.into_iter().collect();
    let block = tokens.iter_mut().rev().find_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    });
    if let Some(block) = block {
        let members = block.stream().into_iter().map(|token| match token {
            TokenTree::Group(body) if body.delimiter() == Delimiter::Brace => braced(TokenStream::new(), &body).into(),
            token => token,
        });
        *block = braced(members.collect(), block);
    }
    tokens.into_iter().collect()
}

/// In the braces of a group.
fn braced(content: TokenStream, of: &Group) -> Group {
    let mut group = Group::new(Delimiter::Brace, content);
    group.set_span(of.span());
    group
}
