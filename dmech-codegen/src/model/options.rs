//! The options of the macro: `crate = path`, nothing else.

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Ident, Path, Token, parse_quote};

use crate::diagnostics::law;

/// Where the facade crate is when nobody says otherwise.
pub(super) fn default_crate() -> Path {
    parse_quote!(::dmech)
}

/// Reads `crate = path`; of several the last one holds.
pub(super) fn parse(options: TokenStream, errors: &mut Vec<syn::Error>) -> Path {
    let parser = |input: ParseStream<'_>| {
        let mut krate = default_crate();
        while !input.is_empty() {
            if input.peek(Token![crate]) {
                input.parse::<Token![crate]>()?;
                input.parse::<Token![=]>()?;
                krate = input.call(Path::parse_mod_style)?;
            } else {
                let unknown = input.parse::<Ident>().map_err(|error| law::unreadable_option(error.span()))?;
                return Err(law::unknown_option(&unknown));
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(krate)
    };
    parser.parse2(options).unwrap_or_else(|error| {
        errors.push(error);
        default_crate()
    })
}
