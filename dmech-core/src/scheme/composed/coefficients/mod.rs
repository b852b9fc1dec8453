//! Sets of stage lengths: of compositions, of Nyström splittings and of force-gradient schemes.
//!
//! All but one are published, with the digits of the sources; a test holds them to every order condition.

mod order4;
mod order6;
mod order8;

pub use order4::{McLachlan4, Suzuki4, Suzuki4S7, TripleJump4};
pub use order6::{KahanLi6, McLachlan6, SofroniouSpaletta6, SofroniouSpaletta6S11, Yoshida6};
pub use order8::{KahanLi8, McLachlan8, Morales8, SofroniouSpaletta8, SuzukiUmeno8, Yoshida8};

use crate::scheme::set::set;
use crate::scheme::splitting::palindrome;

pub use crate::scheme::First;
pub use crate::scheme::force_gradient::coefficients::{
    Chin4A, Chin4C, ForceGradientCoefficients, Omelyan4S3, Omelyan4S4, Omelyan4S5, Omelyan6S5, Omelyan8S11, Smooth8S14,
};
pub use crate::scheme::nystrom::coefficients::{
    Blanes8S19, BlanesMoan4S6, BlanesMoan6S11, BlanesMoan6S14, McLachlan4S4, McLachlan4S5, NystromCoefficients,
    OkunborSkeel6S7,
};

/// The lengths of the stages of a composition, in units of the step: Σγ = 1, and a palindrome, γ_k = γ_{N+1−k}.
///
/// A composition of a symmetric scheme of order 2 has order 4 if Σγ³ = 0; order 6 and 8 ask for Σγ⁵ = 0, Σγ⁷ = 0 and
/// for conditions on products. With an implementation of your own, [`Composed::new`](crate::Composed::new) takes other sets.
pub trait Coefficients<const STAGES: usize>: Copy + core::fmt::Debug {
    /// The name in reports.
    const NAME: &'static str;
    /// The order that the composition of a symmetric scheme of order 2 has.
    const ORDER: u32;
    /// γ₁, …, γ_N.
    const GAMMA: [f64; STAGES];
    /// What rounding to `f64` leaves out of them, for scalars with more digits. Where it is not known, the order of a
    /// composition shows down to errors of 10⁻¹⁶ only.
    const LOW: [f64; STAGES] = [0.0; STAGES];
}
