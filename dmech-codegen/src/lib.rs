//! The library behind the macros: tokens → checked [`model`] → expressions ([`lower`]) → kernels (engine) → tokens
//! ([`emit`]).
#![forbid(unsafe_code)]

pub mod emit;
mod lower;
mod model;

use proc_macro2::TokenStream;

/// The attribute `#[dmech::law]` on an inherent impl block.
pub fn law(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let _ = arguments;
    item
}

/// The derive `dmech::Law` on a struct.
pub fn derive(item: TokenStream) -> TokenStream {
    let _ = item;
    TokenStream::new()
}
