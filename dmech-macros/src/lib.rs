//! The macros of dmech. All work is done by `dmech-codegen`, where it can be tested as a library.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

/// Turns a declared potential into gradients, discrete gradients and time steps made for it.
///
/// See the `dmech` crate for the language of the body and for what is generated.
#[proc_macro_attribute]
pub fn law(arguments: TokenStream, item: TokenStream) -> TokenStream {
    dmech_codegen::law(arguments.into(), item.into()).into()
}

/// The short form for a law of one line: `#[derive(dmech::Law)] #[potential(|q: [f64; 1]| …)] struct …`.
#[proc_macro_derive(Law, attributes(potential, force, pair, pair_force, dmech))]
pub fn derive_law(item: TokenStream) -> TokenStream {
    dmech_codegen::derive(item.into()).into()
}
