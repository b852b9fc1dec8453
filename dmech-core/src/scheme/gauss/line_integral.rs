//! Line integrals: energies exact at high order.

use super::step::Stages;
use crate::invariant::{Invariant, Kept};
use crate::name::Name;
use crate::scheme::Method;
use crate::system::tableau::{STAGES, Tableau};

/// Line integrals over the discrete motion: the energy is exact for a potential that is a polynomial, at order 4 to 10.
///
/// The position and the velocity of a step are polynomials of degree S in the time. The force on the way is projected on the Legendre
/// polynomials P below that degree, with eight points of Gauss's quadrature:
///
/// ```text
/// γⱼ = Σᵢ bᵢ Pⱼ(cᵢ) f(Yᵢ),   Yᵢ = y + h Σ_{j<S} γⱼ ∫₀^{cᵢ} Pⱼ,   y′ = y + h γ₀
/// ```
///
/// | order | energy | angular momentum | symplectic | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 S | exact for a potential of degree ν, ν S ≤ 16; else bounded | bounded, O(h²ˢ) | no | yes | some sweeps of 8 forces side by side |
///
/// Work done along the way is Φ(q) − Φ(q′) to rounding where eight points integrate it: quartic chains at orders 4, 6 and 8,
/// Hénon and Heiles's cubic potential at order 10. [`Run::kept`](crate::Run::kept) says which of the two a run is, as the macro has
/// found the degree in the expression. Sweeps, sums, long steps and laws with choices are as those of
/// [`Gauss`](crate::Gauss), which is S = 8.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../../examples/quartic.md")]
/// let quartic = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.3]));
/// let quartic = quartic.dt(1.0);
/// let moved = |run: Run<State<1>>| run.drift(Invariant::Energy).unwrap().max_relative();
/// assert!(moved(quartic.clone().scheme(LineIntegral::order8()).run_until(1000.0)?) < 1e-13);
/// // Of degree 4, with S = 5, it is bounded only.
/// assert!(moved(quartic.scheme(LineIntegral::order10()).run_until(1000.0)?) > 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Requires, Errors
/// As [`Gauss`](crate::Gauss).
/// # Reference
/// L. Brugnano, F. Iavernaro and D. Trigiante, J. Numer. Anal. Ind. Appl. Math. 5 (2010) 17–37; L. Brugnano and F. Iavernaro, Line
/// Integral Methods for Conservative Problems (CRC Press, 2016).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineIntegral<const S: usize> {
    _made_by_order: (),
}

impl LineIntegral<2> {
    /// S = 2: exact to degree 8.
    pub const fn order4() -> Self {
        LineIntegral { _made_by_order: () }
    }
}

impl LineIntegral<3> {
    /// S = 3: exact to degree 5.
    pub const fn order6() -> Self {
        LineIntegral { _made_by_order: () }
    }
}

impl LineIntegral<4> {
    /// S = 4: exact to degree 4.
    pub const fn order8() -> Self {
        LineIntegral { _made_by_order: () }
    }
}

impl LineIntegral<5> {
    /// S = 5: exact to degree 3.
    pub const fn order10() -> Self {
        LineIntegral { _made_by_order: () }
    }
}

impl<const S: usize> LineIntegral<S> {
    const TITLE: Name = Name::of(&["LineIntegral(", ["4", "6", "8", "10"][S - 2], ")"]);

    /// With a potential of this degree, if it is a polynomial.
    pub(super) const fn kept_by(degree: Option<u32>, invariant: Invariant) -> Kept {
        match (invariant, degree) {
            // 2·8 points of Gauss: the work is a polynomial of degree ν S − 1 in the time.
            (Invariant::Energy, Some(degree)) if degree as usize * S <= 2 * STAGES => Kept::Exact,
            (Invariant::Energy | Invariant::AngularMomentum, _) => Kept::Bounded,
            (Invariant::WorkEnergy | Invariant::LinearMomentum, _) => Kept::Exact,
            (Invariant::DiscreteEnergy, _) => Kept::No,
        }
    }
}

impl<const S: usize> Method for LineIntegral<S> {
    const NAME: &'static str = Self::TITLE.text();
    const ORDER: u32 = 2 * S as u32;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        Self::kept_by(None, invariant)
    }
}

impl<const S: usize> Stages for LineIntegral<S> {
    const TABLEAU: &'static Tableau = &Tableau::of(S);
}
