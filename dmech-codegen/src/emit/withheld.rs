//! The user's block where its law is refused. What is wrong with a method has been said in the words of mechanics; the
//! compiler, which would say it again in its own, is shown the signature without the body. An editor still sees the body.

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{Block, ImplItem, ImplItemFn, ItemImpl, parse_quote};

/// The item with the bodies of these methods out of the compiler's sight; every other token as it was.
pub(crate) fn withheld(item: TokenStream, methods: &BTreeSet<String>) -> TokenStream {
    if methods.is_empty() {
        return item;
    }
    let Ok(mut block) = syn::parse2::<ItemImpl>(item.clone()) else { return item };
    for member in &mut block.items {
        if let ImplItem::Fn(method) = member
            && methods.contains(&method.sig.ident.to_string())
        {
            withhold(method);
        }
    }
    block.into_token_stream()
}

/// `rust_analyzer` is set by the editor's own analysis alone, which completes names in the body; no build sets it.
fn withhold(method: &mut ImplItemFn) {
    let body = &method.block;
    let mut parameters = vec![];
    if method.sig.receiver().is_some() {
        collect_parameters(body.to_token_stream(), &mut parameters);
    }
    // Whether a field exists is what only the compiler can say.
    let stand_in: Block = parse_quote!({
        #[cfg(rust_analyzer)]
        return #body;
        #(let _ = &#parameters;)*
        ::core::unreachable!()
    });
    method.block = stand_in;
    method.attrs.push(parse_quote!(#[allow(unused, unexpected_cfgs)]));
}

/// Every `self.k` that is no call, once.
fn collect_parameters(tokens: TokenStream, parameters: &mut Vec<TokenStream>) {
    let tokens: Vec<_> = tokens.into_iter().collect();
    for (i, token) in tokens.iter().enumerate() {
        match (token, tokens.get(i + 1), tokens.get(i + 2), tokens.get(i + 3)) {
            (TokenTree::Group(group), ..) => collect_parameters(group.stream(), parameters),
            (TokenTree::Ident(law), Some(TokenTree::Punct(dot)), Some(member), after)
                if law == "self" && dot.as_char() == '.' && is_field(member, after) =>
            {
                let parameter = quote!(#law #dot #member);
                let known = |other: &TokenStream| other.to_string() == parameter.to_string();
                if !parameters.iter().any(known) {
                    parameters.push(parameter);
                }
            }
            _ => {}
        }
    }
}

fn is_field(member: &TokenTree, after: Option<&TokenTree>) -> bool {
    let is_name = match member {
        TokenTree::Ident(_) => true,
        TokenTree::Literal(index) => index.to_string().bytes().all(|b| b.is_ascii_digit()),
        _ => false,
    };
    let is_call = match after {
        Some(TokenTree::Group(group)) => group.delimiter() == proc_macro2::Delimiter::Parenthesis,
        Some(TokenTree::Punct(punct)) => punct.as_char() == ':',
        _ => false,
    };
    is_name && !is_call
}
