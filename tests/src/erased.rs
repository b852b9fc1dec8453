//! Laws behind a pointer: a scheme is compiled once for all laws of a table, and not once for each.
//!
//! What a law says of itself in constants must be known to the compiler, so laws of one type of these are of one kind. What
//! it computes is computed by the functions that were generated for it, so that a motion is the same to the bit.

use dmech::extend::newton::{Equation, Increment, NotConverged};
use dmech::extend::{Field, VelocityIndependent};
use dmech::prelude::*;
use dmech_core::written::Written;

/// A conservative law that does not name the time.
pub struct Erased<const D: usize, const CENTRAL: bool = false, const PIECEWISE: bool = false> {
    law: &'static (dyn AnyLaw<D> + Sync),
}

impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> Copy for Erased<D, CENTRAL, PIECEWISE> {}
impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> Clone for Erased<D, CENTRAL, PIECEWISE> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> Erased<D, CENTRAL, PIECEWISE> {
    /// Refuses, when compiled, laws of another kind.
    pub fn new<L: Law<D> + VelocityIndependent + Sync + 'static>(law: L) -> Self {
        const {
            assert!(L::AUTONOMOUS && L::INVARIANTS.is_empty());
            assert!(!L::Field::<'static>::FORCED && L::Field::<'static>::CONSERVES_ENERGY);
            assert!(!<L::Field<'static> as Potential<D>>::LINEAR);
            assert!(<L::Field<'static> as Potential<D>>::CENTRAL == CENTRAL);
            assert!(<L::Field<'static> as Potential<D>>::PIECEWISE == PIECEWISE);
        }
        // Some bytes for each law of a suite, until it ends.
        Erased { law: Box::leak(Box::new(law)) }
    }
}

impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> VelocityIndependent for Erased<D, CENTRAL, PIECEWISE> {}

impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> Law<D> for Erased<D, CENTRAL, PIECEWISE> {
    type Field<'a> = ErasedField<D, CENTRAL, PIECEWISE>;

    fn field(&self, mass: f64, t: f64) -> Self::Field<'_> {
        ErasedField { law: self.law, at: [mass, t] }
    }

    fn written(&self) -> Option<&dyn Written<D>> {
        self.law.written()
    }
}

/// What it is at one moment, for one mass.
#[derive(Clone, Copy)]
pub struct ErasedField<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> {
    law: &'static (dyn AnyLaw<D> + Sync),
    at: [f64; 2],
}

/// Every function of a field, asked of the law.
macro_rules! ask {
    (
        potential { $(fn $p:ident($($x:ident: $y:ty),*) -> $z:ty;)* }
        field { $(fn $f:ident($($a:ident: $b:ty),*) -> $c:ty;)* }
    ) => {
        trait AnyLaw<const D: usize> {
            fn written(&self) -> Option<&dyn Written<D>>;
            $(fn $p(&self, at: [f64; 2], $($x: $y),*) -> $z;)*
            $(fn $f(&self, at: [f64; 2], $($a: $b),*) -> $c;)*
        }

        impl<const D: usize, L: Law<D>> AnyLaw<D> for L {
            fn written(&self) -> Option<&dyn Written<D>> {
                Law::written(self)
            }
            $(fn $p(&self, [m, t]: [f64; 2], $($x: $y),*) -> $z {
                Potential::$p(&self.field(m, t), $($x),*)
            })*
            $(fn $f(&self, [m, t]: [f64; 2], $($a: $b),*) -> $c {
                Field::$f(&self.field(m, t), $($a),*)
            })*
        }

        impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> Potential<D> for ErasedField<D, CENTRAL, PIECEWISE> {
            const CENTRAL: bool = CENTRAL;
            const PIECEWISE: bool = PIECEWISE;
            $(fn $p(&self, $($x: $y),*) -> $z {
                self.law.$p(self.at, $($x),*)
            })*
        }

        impl<const D: usize, const CENTRAL: bool, const PIECEWISE: bool> Field<D> for ErasedField<D, CENTRAL, PIECEWISE> {
            $(fn $f(&self, $($a: $b),*) -> $c {
                self.law.$f(self.at, $($a),*)
            })*
        }
    };
}

ask! {
    potential {
        fn potential(q: [f64; D]) -> f64;
        fn gradient(q: [f64; D]) -> [f64; D];
        fn hessian(q: [f64; D]) -> [[f64; D]; D];
        fn discrete_gradient(a: [f64; D], b: [f64; D]) -> [f64; D];
        fn discrete_gradient_jacobian(a: [f64; D], b: [f64; D]) -> [[f64; D]; D];
    }
    field {
        fn slope(q: [f64; D], v: [f64; D]) -> [f64; D];
        fn kick(c: f64, q: [f64; D], v: [f64; D]) -> [f64; D];
        fn kick_by_mean(c: f64, q: [f64; D], v: [f64; D]) -> [f64; D];
        fn gradient_kick(c: f64, e: f64, q: [f64; D], v: [f64; D]) -> [f64; D];
        fn implicit_increment(equation: &Equation<D, f64>) -> Result<Increment<D, f64>, NotConverged>;
        fn discrete_increment(equation: &Equation<D, f64>) -> Result<Increment<D, f64>, NotConverged>;
        fn potential_increment(equation: &Equation<D, f64>) -> Result<Increment<D, f64>, NotConverged>;
    }
}
