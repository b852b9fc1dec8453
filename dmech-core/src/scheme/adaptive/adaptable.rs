//! Which schemes may change their step, and how long a step they may take.

use super::Adaptive;
use crate::scheme::composed::Coefficients;
use crate::scheme::force_gradient::coefficients::ForceGradientCoefficients;
use crate::scheme::nystrom::coefficients::NystromCoefficients;
use crate::scheme::{
    Boris, Composed, DiscreteGradient, ForceGradient, Gauss, Implicit, Leapfrog, LineIntegral, Method, Nystrom,
    RungeKuttaNystrom,
};

/// A scheme whose steps may differ: [`Simulation::adaptive`](crate::Simulation::adaptive) takes it.
///
/// Energy-exact schemes keep the energy whatever the steps. Splittings are no longer symplectic when the steps differ, but stay
/// reversible: on regular motions their energy error goes to and fro and does not drift, once the steps are as short as it takes to
/// see the motion change.
#[diagnostic::on_unimplemented(
    message = "`.adaptive(tolerance)` makes steps that differ, and `{Self}` cannot take such",
    label = "cannot follow the time scale of the motion",
    note = "`Leapfrog` and `Kanatani` join positions at equal distances in time, and `Explicit` is not symmetric",
    note = "call `.scheme(...)` before `.adaptive(tolerance)`, with `DiscreteGradient`, `Implicit`, `Boris`, a composition of these or of `Leapfrog`, a `Nystrom`, `RungeKuttaNystrom`, `ForceGradient`, `Gauss` or `LineIntegral` scheme; or give the step with `.dt(h)`"
)]
pub trait Adaptable: Method {
    /// ε, the angle in radians by which the linearised motion turns in a step, for a tolerance.
    ///
    /// The error per unit of time is in proportion to ε^p, with a factor that a Kepler orbit of eccentricity 0.9 has shown.
    fn angle(&self, tolerance: f64) -> f64;
}

/// Steps that follow the motion twice. Nothing implements it: it has the words for a second `.adaptive(tolerance)`, and stands on the
/// scheme within, as the compiler would say those of [`Adaptable`] of the other.
#[diagnostic::on_unimplemented(
    message = "the steps follow the motion already: `.adaptive(tolerance)` is called twice",
    label = "this is adaptive",
    note = "call it once, with the tolerance that is meant; for another one begin with the scheme, `.scheme(...).adaptive(tolerance)`"
)]
pub trait AdaptiveTwice {}

impl<S: Adaptable + AdaptiveTwice> Adaptable for Adaptive<S> {
    fn angle(&self, tolerance: f64) -> f64 {
        self.scheme.angle(tolerance)
    }
}

/// `Scheme<N> { const N: usize } => |tolerance| ε, …`
macro_rules! adaptable {
    ($($scheme:ty { $($generics:tt)* } => |$tolerance:ident| $angle:expr,)*) => {$(
        impl<$($generics)*> Adaptable for $scheme {
            fn angle(&self, $tolerance: f64) -> f64 {
                $angle
            }
        }
    )*};
}

adaptable! {
    DiscreteGradient {} => |tolerance| angle::<Self>(tolerance, 1.0),
    Boris {} => |tolerance| angle::<Self>(tolerance, 1.0),
    Implicit {} => |tolerance| TRAPEZOID * angle::<Self>(tolerance, 1.0),
    Composed<DiscreteGradient, C, N> { C: Coefficients<N>, const N: usize }
        => |tolerance| angle::<Self>(tolerance, longest(C::GAMMA)),
    Composed<Implicit, C, N> { C: Coefficients<N>, const N: usize }
        => |tolerance| TRAPEZOID * angle::<Self>(tolerance, longest(C::GAMMA)),
    Composed<Leapfrog, C, N> { C: Coefficients<N>, const N: usize }
        => |tolerance| angle::<Self>(tolerance, longest(C::GAMMA)),
    Composed<Boris, C, N> { C: Coefficients<N>, const N: usize }
        => |tolerance| angle::<Self>(tolerance, longest(C::GAMMA)),
    Nystrom<C, N> { C: NystromCoefficients<N>, const N: usize } => |tolerance| turn::<Self>(C::TURN, tolerance, MOST[0]),
    ForceGradient<C, N> { C: ForceGradientCoefficients<N>, const N: usize }
        => |tolerance| turn::<Self>(C::TURN, tolerance, MOST[0]),
    Gauss {} => |tolerance| turn::<Self>(1.59, tolerance, LONG),
    RungeKuttaNystrom {} => |tolerance| turn::<Self>(1.0, tolerance, LONG),
    LineIntegral<S> { const S: usize } => |tolerance| turn::<Self>([0.086, 0.35, 0.70, 1.06][S - 2], tolerance, LONG),
}

/// What the steps of the trapezoidal rule are to those of the energy-exact step at the same error.
const TRAPEZOID: f64 = 0.6;

/// The longest step, and the longest stage: beyond, the steps do not see ω change, and Newton finds no solution at a
/// pericentre.
const MOST: [f64; 2] = [1.0, 0.55];
/// The longest step of eight stages, which see more of ω.
const LONG: f64 = 1.25;

/// (tolerance/10)^(1/p)/(0.16 + 0.13 γ), with the longest stage γ.
///
/// Fitted to the errors of the fourteen sets of stages and of the single step on the orbit of eccentricity 0.9.
fn angle<M: Method>(tolerance: f64, stage: f64) -> f64 {
    let wanted = (0.1 * tolerance).powf(1.0 / f64::from(M::ORDER)) / 0.13_f64.mul_add(stage, 0.16);
    wanted.min(MOST[0]).min(MOST[1] / stage)
}

/// ε, from that at a tolerance of 10⁻⁶, and at most so much.
fn turn<M: Method>(at_a_millionth: f64, tolerance: f64, most: f64) -> f64 {
    (at_a_millionth * (1e6 * tolerance).powf(1.0 / f64::from(M::ORDER))).min(most)
}

fn longest<const N: usize>(gamma: [f64; N]) -> f64 {
    gamma.iter().fold(0.0, |most, x| most.max(x.abs()))
}
