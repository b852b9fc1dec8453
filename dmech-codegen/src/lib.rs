//! The library behind the macros: tokens → checked model → expressions → kernels (engine) → tokens.
//!
//! ```
//! let law: proc_macro2::TokenStream = "impl Spring {
//!     #[potential]
//!     fn energy(&self, q: f64) -> f64 { 0.5 * self.k * q * q }
//! }".parse().unwrap();
//! let code = dmech_codegen::law(Default::default(), law).to_string();
//! assert!(code.contains("discrete_gradient"));
//! ```
#![forbid(unsafe_code)]

mod diagnostics;
mod emit;
mod lower;
mod model;

pub use lower::{Lowered, Parameter, Source};
pub use model::Model;

use dmech_symbolic::kernel::Kernels;
use proc_macro2::TokenStream;

use model::Parsed;

/// A law with everything that follows from it, before it is printed.
pub struct Derivation {
    /// What was declared.
    pub model: Model,
    /// The declared potential as an expression.
    pub lowered: Lowered,
    /// The programs derived from it.
    pub kernels: Kernels,
}

/// The attribute `#[dmech::law]` on an inherent impl block: the block as it was, and what is derived from it.
pub fn law(arguments: TokenStream, item: TokenStream) -> TokenStream {
    expand(model::from_impl(arguments, item))
}

/// The derive `dmech::Law` on a struct.
pub fn derive(item: TokenStream) -> TokenStream {
    expand(model::from_derive(item))
}

/// What the attribute would derive from an impl block.
///
/// # Errors
/// Everything that is wrong with the law, each with its span.
pub fn derivation_of_impl(item: TokenStream) -> Result<Derivation, Vec<syn::Error>> {
    model::from_impl(TokenStream::new(), item).model.and_then(|model| derivation(model).map_err(|(_, errors)| errors))
}

fn derivation(model: Model) -> Result<Derivation, (Model, Vec<syn::Error>)> {
    match lower::lower(&model) {
        Ok(mut lowered) => {
            let kernels = Kernels::new(&mut lowered.graph, lowered.potential, &lowered.variables);
            Ok(Derivation { model, lowered, kernels })
        }
        Err(errors) => Err((model, errors)),
    }
}

fn expand(parsed: Parsed) -> TokenStream {
    let Parsed { item, model } = parsed;
    let mut tokens = item;
    tokens.extend(match model.map(derivation) {
        Ok(Ok(derivation)) => emit::implementation(&derivation),
        Ok(Err((model, errors))) => {
            let mut tokens: TokenStream = errors.iter().map(syn::Error::to_compile_error).collect();
            tokens.extend(emit::stub(&model));
            tokens
        }
        Err(errors) => errors.iter().map(syn::Error::to_compile_error).collect(),
    });
    tokens
}
