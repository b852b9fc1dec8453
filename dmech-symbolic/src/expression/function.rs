//! Functions of one and two arguments.

use dmech_scalar::Real;

use super::Number;

/// The functions of one argument: each with the method of the scalar trait that computes it.
macro_rules! unary {
    ($($(#[$doc:meta])* $name:ident $method:ident,)*) => {
        /// Functions of one argument.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[allow(missing_docs)]
        pub enum Unary {
            $($(#[$doc])* $name,)*
        }

        impl Unary {
            /// All of them.
            pub const ALL: [Self; 34] = [$(Self::$name),*];

            /// The method of the scalar trait that computes it.
            pub fn method(self) -> &'static str {
                match self {
                    $(Self::$name => stringify!($method),)*
                }
            }

            /// Its value.
            pub fn apply<R: Real>(self, x: R) -> R {
                match self {
                    $(Self::$name => x.$method(),)*
                }
            }
        }
    };
}

unary! {
    Sqrt sqrt,
    Cbrt cbrt,
    Exp exp,
    Exp2 exp2,
    ExpM1 exp_m1,
    Ln ln,
    Ln1p ln_1p,
    Log2 log2,
    Log10 log10,
    Sin sin,
    Cos cos,
    Tan tan,
    Asin asin,
    Acos acos,
    Atan atan,
    Sinh sinh,
    Cosh cosh,
    Tanh tanh,
    Asinh asinh,
    Acosh acosh,
    Atanh atanh,
    Abs abs,
    Signum signum,
    /// the nearest integer, halves away from 0
    Round round,
    /// the largest integer that is not larger
    Floor floor,
    /// the integer toward 0
    Trunc trunc,
    /// sin(u)/u
    Sinc sinc,
    /// sinc′(u)/u
    SincSlope sinc_slope,
    /// sinh(u)/u
    Sinhc sinhc,
    /// sinhc′(u)/u
    SinhcSlope sinhc_slope,
    /// arctan(u)/u
    Atanc atanc,
    /// atanc′(u)/u
    AtancSlope atanc_slope,
    /// artanh(u)/u
    Atanhc atanhc,
    /// atanhc′(u)/u
    AtanhcSlope atanhc_slope,
}

/// Functions of two arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Binary {
    /// u^p
    Powf,
    /// the angle of the point (second, first)
    Atan2,
    /// the smaller
    Min,
    /// the larger
    Max,
    /// the first, or the second where that is less; no number where the first is none
    AtMost,
    /// the first, or the second where that is larger; no number where the first is none
    AtLeast,
}

pub(super) enum Parity {
    Even,
    Odd,
    Neither,
}

impl Unary {
    /// Constant but for jumps.
    pub fn is_step(self) -> bool {
        matches!(self, Self::Signum | Self::Round | Self::Floor | Self::Trunc)
    }

    pub(super) fn parity(self) -> Parity {
        use Unary::*;
        match self {
            Cos | Cosh | Abs | Sinc | SincSlope | Sinhc | SinhcSlope | Atanc | AtancSlope | Atanhc | AtanhcSlope => {
                Parity::Even
            }
            Cbrt | Sin | Tan | Asin | Atan | Sinh | Tanh | Asinh | Atanh | Round | Trunc => Parity::Odd,
            _ => Parity::Neither,
        }
    }

    /// The value at a point where it is exact for every scalar type.
    pub(super) fn exact_value(self, x: f64) -> Option<f64> {
        use Unary::*;
        match self {
            Sqrt => Number::new(x).exact_sqrt().map(Number::value),
            Abs => Some(x.abs()),
            Signum => Some(x.signum()),
            Cbrt | ExpM1 | Ln1p | Sin | Tan | Asin | Atan | Sinh | Tanh | Asinh | Atanh if x == 0.0 => Some(0.0),
            Exp | Exp2 | Cos | Cosh | Sinc | Sinhc | Atanc | Atanhc if x == 0.0 => Some(1.0),
            Ln | Log2 | Log10 | Acos | Acosh if x == 1.0 => Some(0.0),
            // A fraction next to a step may be beyond it in another scalar.
            Round | Floor | Trunc if x == x.trunc() => Some(x),
            Cbrt if x.abs() == 1.0 => Some(x),
            _ => None,
        }
    }
}

impl Binary {
    /// The method of the scalar trait that computes it.
    pub fn method(self) -> &'static str {
        match self {
            Self::Powf => "powf",
            Self::Atan2 => "atan2",
            Self::Min => "min",
            Self::Max => "max",
            Self::AtMost => "at_most",
            Self::AtLeast => "at_least",
        }
    }

    /// The smaller or the larger of the two.
    pub fn is_extremum(self) -> bool {
        matches!(self, Self::Min | Self::Max | Self::AtMost | Self::AtLeast)
    }

    /// The smaller of the two.
    pub fn is_least(self) -> bool {
        matches!(self, Self::Min | Self::AtMost)
    }

    /// Its value.
    pub fn apply<R: Real>(self, x: R, y: R) -> R {
        match self {
            Self::Powf => x.powf(y),
            Self::Atan2 => x.atan2(y),
            Self::Min => x.min(y),
            Self::Max => x.max(y),
            Self::AtMost => x.at_most(y),
            Self::AtLeast => x.at_least(y),
        }
    }
}
