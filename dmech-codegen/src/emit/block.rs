//! The block that holds what is written for a law.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::quote;

use super::names::{ident, runtime, temporary};

/// The items by themselves, in sight of the hidden module that they refer to.
///
/// A pattern that is one name is a new variable, but where a constant of that name is in sight it is the constant: `const c: f64` beside
/// a law would get into its functions. A function in between, which no pattern can be, gives the names back to the variables.
pub(super) fn block(module: &TokenStream, items: TokenStream) -> TokenStream {
    let mut names = BTreeSet::new();
    bound(items.clone(), &mut names);
    let (runtime, names) = (runtime(), names.iter().map(|name| ident(name)));
    quote! {
        #[allow(clippy::approx_constant)]
        const _: () = {
            use #module as #runtime;
            #[allow(unused_imports)]
            use #runtime::{#(fresh as #names),*};

            #items
        };
    }
}

/// Finds what is bound by `let`, and as the argument of a function or of a closure.
fn bound(tokens: TokenStream, names: &mut BTreeSet<String>) {
    let mut tokens = tokens.into_iter();
    let (mut declares, mut begins) = (false, true);
    while let Some(token) = tokens.next() {
        let begun = core::mem::take(&mut begins);
        match token {
            TokenTree::Ident(word) if word == "let" => pattern(&mut tokens, &['=', ':', ';'], names),
            TokenTree::Ident(word) => declares |= word == "fn",
            TokenTree::Punct(mark) if mark.as_char() == '|' && begun => pattern(&mut tokens, &['|'], names),
            TokenTree::Punct(mark) => begins = matches!(mark.as_char(), ',' | '='),
            TokenTree::Group(group) if declares && group.delimiter() == Delimiter::Parenthesis => {
                declares = false;
                let arguments: Vec<_> = group.stream().into_iter().collect();
                for argument in arguments.split(|token| is_mark(token, &[','])) {
                    pattern(&mut argument.iter().cloned(), &[':'], names);
                }
            }
            TokenTree::Group(group) => bound(group.stream(), names),
            TokenTree::Literal(_) => {}
        }
    }
}

/// The names in a pattern, which ends at one of these marks.
fn pattern(tokens: &mut dyn Iterator<Item = TokenTree>, ends: &[char], names: &mut BTreeSet<String>) {
    for token in tokens.take_while(|token| !is_mark(token, ends)) {
        match token {
            TokenTree::Group(group) => pattern(&mut group.stream().into_iter(), &[], names),
            TokenTree::Ident(word) => {
                let word = word.to_string();
                if !names.contains(&word) && is_name(&word) {
                    names.insert(word);
                }
            }
            _ => {}
        }
    }
}

fn is_mark(token: &TokenTree, marks: &[char]) -> bool {
    matches!(token, TokenTree::Punct(mark) if marks.contains(&mark.as_char()))
}

/// Not a type, `_` or a keyword; nor t10, t11 and so on, of which large laws have thousands, and nobody a constant.
fn is_name(word: &str) -> bool {
    let many = temporary(word).is_some_and(|digits| digits.len() > 1);
    !many && !word.starts_with(|c: char| c.is_uppercase() || c == '_') && syn::parse_str::<Ident>(word).is_ok()
}
