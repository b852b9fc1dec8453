//! Boris's scheme: forces linear in the velocity, without an equation.

use super::Method;
use super::splitting::{First, Splitting};
use crate::invariant::{Invariant, Kept};

/// Boris's scheme: an explicit step for forces that are linear in the velocity, F = f(q, t) + S(q, t) v.
///
/// ```text
/// q½ = q + (h/2) v;   m (v′ − v)/h = −∇Φ(q½) + F(q½, (v + v′)/2);   q′ = q½ + (h/2) v′
/// ```
///
/// | order | energy | angular momentum | volume | reversible | per step |
/// |---|---|---|---|---|---|
/// | 2 | exact in a magnetic field, else bounded | exact (central laws) | kept where S is antisymmetric | yes | 1 force |
///
/// The kick is linear in v′: half a kick by f − ∇Φ, the Cayley map (1 − hS/2m)⁻¹(1 + hS/2m), the other half, all in closed
/// form up to three coordinates.
///
/// - **A magnetic field**, F = b v × B: the map is the rotation that J. P. Boris made of two cross products. It turns v about
///   B by the angle 2 atan(hω/2), ω = b|B|/m, and keeps the speed to rounding, for any step and any field. (In a uniform field,
///   where each step rounds as the one before, the energy moves by up to 10⁻¹⁶ (hω)⁴ a step. A law of more than three coordinates,
///   such as one of two charges, is solved by elimination: it loses digits where hω is large. The bodies of a scene turn one by one.)
/// - **Friction**, F = −c v: it is v′ = v (1 − hc/2m)/(1 + hc/2m), damped leap-frog. The energy falls for any step, and the
///   velocity does not change its sign while hc < 2m.
/// - **No velocity**: it is leap-frog, as drift, kick, drift.
///
/// With an electric field or a potential beside a magnetic field the energy error is O(h²) and, while the magnetic field is
/// uniform or the potential quadratic, it stays so over very long times; in other fields it may walk or drift slowly
/// (Hairer and Lubich), where [`DiscreteGradient`](struct@crate::DiscreteGradient) keeps the energy. The scheme is symmetric:
/// [`Composed::order4(Boris)`](crate::Composed::order4) and its like have orders 4, 6 and 8. Work is F·h (v + v′)/2, by
/// which the kinetic energy changes exactly.
///
/// ```
/// use dmech_core::extend::*;
/// use dmech_core::prelude::*;
///
/// /// A charge in a uniform magnetic field along z; `#[dmech::law]` writes all this from the force alone.
/// #[derive(Clone, Copy)]
/// struct Gyration { b: f64 }
/// # impl LinearInVelocity for Gyration {}
/// # impl Law<2> for Gyration {
/// #     type Field<'a> = Gyration;
/// #     fn field(&self, _mass: f64, _t: f64) -> Gyration { *self }
/// # }
/// # impl Potential<2> for Gyration {
/// #     fn potential(&self, _: [f64; 2]) -> f64 { 0.0 }
/// #     fn gradient(&self, _: [f64; 2]) -> [f64; 2] { [0.0; 2] }
/// #     fn hessian(&self, _: [f64; 2]) -> [[f64; 2]; 2] { [[0.0; 2]; 2] }
/// #     fn discrete_gradient(&self, _: [f64; 2], _: [f64; 2]) -> [f64; 2] { [0.0; 2] }
/// #     fn discrete_gradient_jacobian(&self, _: [f64; 2], _: [f64; 2]) -> [[f64; 2]; 2] { [[0.0; 2]; 2] }
/// # }
/// impl Field<2> for Gyration {
///     const FORCED: bool = true;
///     fn slope(&self, _: [f64; 2], v: [f64; 2]) -> [f64; 2] {
///         self.force([0.0; 2], v, 0.0).map(|f| -f)
///     }
///     fn force(&self, _: [f64; 2], v: [f64; 2], _: f64) -> [f64; 2] {
///         [self.b * v[1], -self.b * v[0]]
///     }
///     fn force_dv(&self, _: [f64; 2], _: [f64; 2], _: f64) -> [[f64; 2]; 2] {
///         [[0.0, self.b], [-self.b, 0.0]]
///     }
/// }
///
/// let start = State::new([0.4, 0.0], [0.0, 1.5]);
/// let run = Simulation::new(Gyration { b: 2.1 }, start).mass(1.3).scheme(Boris).dt(0.05).run(10_000)?;
/// assert!(run.drift(Invariant::Energy).unwrap().max_relative() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Requires
/// A force on each body that is linear in the velocity of that body
/// ([`LinearInVelocity`](crate::extend::LinearInVelocity)); another one does not compile.
/// # Errors
/// None but of laws that are not finite.
/// # Reference
/// J. P. Boris, Proc. Fourth Conf. on Numerical Simulation of Plasmas (Naval Research Laboratory, 1970), 3–67; H. Qin et
/// al., Phys. Plasmas 20 (2013) 084503 (volume); E. Hairer and C. Lubich, BIT Numer. Math. 58 (2018) 969–979 (energy).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Boris;

impl Method for Boris {
    const NAME: &'static str = "Boris";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;

    fn keeps(invariant: Invariant) -> Kept {
        super::Leapfrog::keeps(invariant)
    }
}

/// Half a drift, a kick, half a drift.
impl Splitting<1> for Boris {
    const FIRST: First = First::Drift;
    const BY_MEAN: bool = true;
    const DRIFTS: [f64; 1] = [0.5];
    const KICKS: [f64; 1] = [1.0];
}
