//! The user's block where its law is refused. What is wrong with a method has been said in the words of mechanics; the
//! compiler, which would say it again in its own, is shown the signature without the body. An editor still sees the body.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
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
    let mut mentioned = Mentioned { has_law: method.sig.receiver().is_some(), list: vec![] };
    mentioned.collect(body.to_token_stream());
    let mentioned = mentioned.list;
    let stand_in: Block = parse_quote!({
        #[cfg(rust_analyzer)]
        return #body;
        #(let _ = &#mentioned;)*
        ::core::unreachable!()
    });
    method.block = stand_in;
    method.attrs.push(parse_quote!(#[allow(unused, unexpected_cfgs)]));
}

/// What the compiler still has to see of a body: every `self.k`, since only the compiler knows the fields, and every
/// constant from elsewhere, since an import of it is not unused.
struct Mentioned {
    has_law: bool,
    list: Vec<TokenStream>,
}

impl Mentioned {
    fn collect(&mut self, tokens: TokenStream) {
        let tokens: Vec<_> = tokens.into_iter().collect();
        let is = |i: usize, c: char| matches!(tokens.get(i), Some(TokenTree::Punct(punct)) if punct.as_char() == c);
        let mut i = 0;
        while i < tokens.len() {
            match &tokens[i] {
                TokenTree::Group(group) => self.collect(group.stream()),
                TokenTree::Ident(law)
                    if law == "self"
                        && self.has_law
                        && is(i + 1, '.')
                        && is_field(tokens.get(i + 2), tokens.get(i + 3)) =>
                {
                    self.add(&tokens[i..i + 3]);
                    i += 2;
                }
                TokenTree::Ident(_) if i == 0 || !is(i - 1, '.') => {
                    let start = i;
                    while is(i + 1, ':') && is(i + 2, ':') && matches!(tokens.get(i + 3), Some(TokenTree::Ident(_))) {
                        i += 3;
                    }
                    if is_constant(&tokens[i]) && (start == i || !is_type(&tokens[start])) {
                        self.add(&tokens[start..=i]);
                    }
                }
                _ => {}
            }
            i += 1;
        }
    }

    fn add(&mut self, tokens: &[TokenTree]) {
        let tokens: TokenStream = tokens.iter().cloned().collect();
        if self.list.iter().all(|other| other.to_string() != tokens.to_string()) {
            self.list.push(tokens);
        }
    }
}

/// Whether `self.member` is no call.
fn is_field(member: Option<&TokenTree>, after: Option<&TokenTree>) -> bool {
    let is_name = match member {
        Some(TokenTree::Ident(_)) => true,
        Some(TokenTree::Literal(index)) => index.to_string().bytes().all(|b| b.is_ascii_digit()),
        _ => false,
    };
    let is_call = match after {
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Parenthesis,
        Some(TokenTree::Punct(punct)) => punct.as_char() == ':',
        _ => false,
    };
    is_name && !is_call
}

/// `PI`
fn is_constant(token: &TokenTree) -> bool {
    let name = token.to_string();
    name.starts_with(|c: char| c.is_ascii_uppercase()) && !name.contains(|c: char| c.is_ascii_lowercase())
}

/// `Self`, `Kepler`: what is wrong with a constant of theirs has been said.
fn is_type(token: &TokenTree) -> bool {
    token.to_string().starts_with(|c: char| c.is_ascii_uppercase())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::withheld;

    fn text(law: &str) -> String {
        let item: proc_macro2::TokenStream = law.parse().unwrap();
        item.to_string()
    }

    #[test]
    fn fields_and_constants_are_still_mentioned() {
        let law = "impl K { const S: f64 = 1.0; fn ok(&self) -> f64 { 1 } /// Doc.
            fn bad(&self, q: f64) -> f64 { self.a + self.b.c + self.a * self.f(self.0) / consts::PI - Self::S.ln(x.Y) } }";
        let said = withheld(law.parse().unwrap(), &BTreeSet::from(["bad".to_owned()])).to_string();
        let expected = text(
            "impl K { const S: f64 = 1.0; fn ok(&self) -> f64 { 1 } /// Doc.
                #[allow(unused, unexpected_cfgs)] fn bad(&self, q: f64) -> f64 {
                    #[cfg(rust_analyzer)]
                    return { self.a + self.b.c + self.a * self.f(self.0) / consts::PI - Self::S.ln(x.Y) };
                    let _ = &self.a; let _ = &self.b; let _ = &self.0; let _ = &consts::PI;
                    ::core::unreachable!()
                } }",
        );
        assert_eq!(said, expected);
    }

    #[test]
    fn what_is_right_or_unreadable_stays() {
        for (law, method) in [("impl K { fn ok(&self) -> f64 { 1 } }", "other"), ("impl K { fn ok(", "ok")] {
            let Ok(item) = law.parse::<proc_macro2::TokenStream>() else { continue };
            assert_eq!(withheld(item, &BTreeSet::from([method.to_owned()])).to_string(), text(law));
        }
    }
}
