//! What code that is refused without being run could have changed: after it, nobody knows those variables.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::ToTokens;
use syn::Pat;

use super::interpreter::Interpreter;
use super::value::Value;

impl<'m> Interpreter<'m> {
    /// Forgets the value of every variable that the code assigns to.
    pub(super) fn abandon(&mut self, code: &dyn ToTokens) {
        let mut assigned = vec![];
        collect_assigned(code.to_token_stream(), &mut assigned);
        for name in assigned {
            if let Some(found) = self.scope.find(&name) {
                self.scope.locals[found].value = Value::Unknown;
            }
        }
    }

    /// Binds every name in a pattern that is not read.
    pub(super) fn bind_names(&mut self, pattern: &Pat) {
        self.bind_words(pattern.to_token_stream());
    }

    fn bind_words(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Ident(name) => self.scope.bind(name.to_string(), Value::Unknown),
                TokenTree::Group(group) => self.bind_words(group.stream()),
                _ => {}
            }
        }
    }
}

/// The names left of `=`, `+=` and the like, with `a` for `a[i].x`.
fn collect_assigned(tokens: TokenStream, assigned: &mut Vec<String>) {
    let mut place: Option<String> = None;
    let mut tokens = tokens.into_iter().peekable();
    let mut sign_before = false;
    while let Some(token) = tokens.next() {
        let mut sign = false;
        match token {
            TokenTree::Group(group) => {
                collect_assigned(group.stream(), assigned);
                if group.delimiter() == Delimiter::Brace {
                    place = None;
                }
            }
            // The first name of a path of fields is the variable.
            TokenTree::Ident(name) => place = place.or(Some(name.to_string())),
            TokenTree::Literal(_) => {}
            TokenTree::Punct(punct) => match punct.as_char() {
                '.' => {}
                '+' | '-' | '*' | '/' | '%' if punct.spacing() == Spacing::Joint => sign = true,
                '=' if punct.spacing() == Spacing::Alone && (sign_before || place.is_some()) => {
                    assigned.extend(place.take());
                }
                '=' => {
                    // `==` and `=>`.
                    tokens.next();
                    place = None;
                }
                '<' | '>' | '!' if punct.spacing() == Spacing::Joint => {
                    // `<=`, `>=`, `!=`.
                    tokens.next_if(|next| matches!(next, TokenTree::Punct(next) if next.as_char() == '='));
                    place = None;
                }
                _ => place = None,
            },
        }
        sign_before = sign;
    }
}

#[cfg(test)]
mod tests {
    use super::collect_assigned;

    #[test]
    fn assignments_are_told_from_comparisons() {
        let code = "while a < 2 && b == 1 && c >= 3 && d != 4 && e <= k { f = 1; g += q[0]; h[i] *= 2.0; p.x -= s; *r /= u; \
                    match w { 0 => { z = 0 } _ => y } }";
        let mut assigned = vec![];
        collect_assigned(code.parse().unwrap(), &mut assigned);
        assert_eq!(assigned, ["f", "g", "h", "p", "r", "z"]);
    }
}
