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
#![cfg_attr(docsrs, feature(doc_cfg))]

mod diagnostics;
mod emit;
mod lower;
mod model;
mod role;

pub use lower::{Lowered, LoweredPair, Parameter, Read, Source};
pub use model::{Body, Model, PairSignature};

use dmech_symbolic::kernel::{ForcedKernels, Kernels, PairKernels, PairLaw};
use dmech_symbolic::program::Program;
use proc_macro2::TokenStream;

use model::{Parsed, Refusal, Refused};

/// A law with everything that follows from it, before it is printed.
pub struct Derivation {
    /// What was declared.
    pub model: Model,
    /// The declared potential, force and invariants as expressions.
    pub lowered: Lowered,
    /// The programs derived from its potential.
    pub kernels: Kernels,
    /// The programs derived from its force.
    pub forced: Option<ForcedKernels>,
    /// What the law says it keeps.
    pub invariants: Vec<Program>,
}

/// A law between two bodies with everything that follows from it, before it is printed.
pub(crate) struct PairDerivation {
    /// What was declared.
    pub(crate) model: Model,
    /// The declared potential and force as expressions.
    pub(crate) lowered: Lowered,
    /// What it reads of the bodies.
    pub(crate) pair: LoweredPair,
    /// The programs derived.
    pub(crate) kernels: PairKernels,
}

/// A law of one body or of two.
enum Derived {
    One(Box<Derivation>),
    Pair(Box<PairDerivation>),
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
    let model = model::from_impl(TokenStream::new(), item).model;
    match derive_all(model).map_err(|refused| refused.mistakes.errors)? {
        Derived::One(derivation) => Ok(*derivation),
        Derived::Pair(derivation) => Err(vec![diagnostics::pair::not_of_one_body(&derivation.model.self_ty)]),
    }
}

fn derive_all(model: Result<Model, Refused>) -> Result<Derived, Refused> {
    let model = model.map_err(with_bodies)?;
    let mut lowered = match lower::lower(&model) {
        Ok(lowered) => lowered,
        Err(mistakes) => {
            let (model, refusal) = (Some(Box::new(model)), Refusal::Formulas);
            return Err(Refused { mistakes, model, refusal, has_bodies: true });
        }
    };
    if let Some(pair) = lowered.pair.take() {
        let law = PairLaw {
            potential: model.potential.is_some().then_some(lowered.potential),
            force: lowered.force.clone(),
            exchange: pair.exchange.clone(),
        };
        let kernels = PairKernels::new(&mut lowered.graph, &law, &lowered.variables, &pair.variables);
        return Ok(Derived::Pair(Box::new(PairDerivation { model, lowered, pair, kernels })));
    }
    let Lowered { graph, variables, potential, force, invariants, parameters, .. } = &mut lowered;
    let kernels = Kernels::new(graph, *potential, variables);
    let time = parameters.iter().find(|p| matches!(p.source, Source::Time)).map(|p| p.symbol);
    let forced = force.as_ref().map(|force| ForcedKernels::new(graph, *potential, force, time, variables));
    let invariants = invariants.iter().map(|&invariant| Program::schedule(graph, &[invariant])).collect();
    Ok(Derived::One(Box::new(Derivation { model, lowered, kernels, forced, invariants })))
}

/// The body of a law that is refused for its signature is read all the same, so that its mistakes show in the same run.
fn with_bodies(mut refused: Refused) -> Refused {
    if refused.has_bodies
        && let Some(model) = &refused.model
    {
        refused.mistakes.extend(lower::mistakes(model));
    }
    if refused.refusal == Refusal::Signature {
        refused.model = refused.model.map(|model| Box::new(model.without_signature()));
    }
    refused
}

fn expand(Parsed { item, model }: Parsed) -> TokenStream {
    match derive_all(model) {
        Ok(derived) => {
            let mut tokens = item;
            tokens.extend(match &derived {
                Derived::One(derivation) => emit::implementation(derivation),
                Derived::Pair(derivation) => emit::pair_implementation(derivation),
            });
            tokens
        }
        Err(Refused { mistakes, model, refusal, .. }) => {
            let mut tokens = emit::withheld(item, &mistakes.methods);
            tokens.extend(model.map(|model| emit::stand_in(&model, refusal)));
            tokens.extend(mistakes.errors.iter().map(syn::Error::to_compile_error));
            tokens
        }
    }
}
