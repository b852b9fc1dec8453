//! Functions of one and two arguments.

use dmech_scalar::Real;

use super::Number;

/// Functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Unary {
    Sqrt,
    Cbrt,
    Exp,
    Exp2,
    ExpM1,
    Ln,
    Ln1p,
    Log2,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Abs,
    Signum,
    /// sin(u)/u
    Sinc,
    /// sinc′(u)/u
    SincSlope,
    /// sinh(u)/u
    Sinhc,
    /// sinhc′(u)/u
    SinhcSlope,
    /// arctan(u)/u
    Atanc,
    /// atanc′(u)/u
    AtancSlope,
    /// artanh(u)/u
    Atanhc,
    /// atanhc′(u)/u
    AtanhcSlope,
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
}

pub(super) enum Parity {
    Even,
    Odd,
    Neither,
}

impl Unary {
    /// All of them.
    pub const ALL: [Self; 31] = {
        use Unary::*;
        [
            Sqrt,
            Cbrt,
            Exp,
            Exp2,
            ExpM1,
            Ln,
            Ln1p,
            Log2,
            Log10,
            Sin,
            Cos,
            Tan,
            Asin,
            Acos,
            Atan,
            Sinh,
            Cosh,
            Tanh,
            Asinh,
            Acosh,
            Atanh,
            Abs,
            Signum,
            Sinc,
            SincSlope,
            Sinhc,
            SinhcSlope,
            Atanc,
            AtancSlope,
            Atanhc,
            AtanhcSlope,
        ]
    };

    /// The method of the scalar trait that computes it.
    pub fn method(self) -> &'static str {
        use Unary::*;
        match self {
            Sqrt => "sqrt",
            Cbrt => "cbrt",
            Exp => "exp",
            Exp2 => "exp2",
            ExpM1 => "exp_m1",
            Ln => "ln",
            Ln1p => "ln_1p",
            Log2 => "log2",
            Log10 => "log10",
            Sin => "sin",
            Cos => "cos",
            Tan => "tan",
            Asin => "asin",
            Acos => "acos",
            Atan => "atan",
            Sinh => "sinh",
            Cosh => "cosh",
            Tanh => "tanh",
            Asinh => "asinh",
            Acosh => "acosh",
            Atanh => "atanh",
            Abs => "abs",
            Signum => "signum",
            Sinc => "sinc",
            SincSlope => "sinc_slope",
            Sinhc => "sinhc",
            SinhcSlope => "sinhc_slope",
            Atanc => "atanc",
            AtancSlope => "atanc_slope",
            Atanhc => "atanhc",
            AtanhcSlope => "atanhc_slope",
        }
    }

    /// Its value.
    pub fn apply<R: Real>(self, x: R) -> R {
        use Unary::*;
        match self {
            Sqrt => x.sqrt(),
            Cbrt => x.cbrt(),
            Exp => x.exp(),
            Exp2 => x.exp2(),
            ExpM1 => x.exp_m1(),
            Ln => x.ln(),
            Ln1p => x.ln_1p(),
            Log2 => x.log2(),
            Log10 => x.log10(),
            Sin => x.sin(),
            Cos => x.cos(),
            Tan => x.tan(),
            Asin => x.asin(),
            Acos => x.acos(),
            Atan => x.atan(),
            Sinh => x.sinh(),
            Cosh => x.cosh(),
            Tanh => x.tanh(),
            Asinh => x.asinh(),
            Acosh => x.acosh(),
            Atanh => x.atanh(),
            Abs => x.abs(),
            Signum => x.signum(),
            Sinc => x.sinc(),
            SincSlope => x.sinc_slope(),
            Sinhc => x.sinhc(),
            SinhcSlope => x.sinhc_slope(),
            Atanc => x.atanc(),
            AtancSlope => x.atanc_slope(),
            Atanhc => x.atanhc(),
            AtanhcSlope => x.atanhc_slope(),
        }
    }

    pub(super) fn parity(self) -> Parity {
        use Unary::*;
        match self {
            Cos | Cosh | Abs | Sinc | SincSlope | Sinhc | SinhcSlope | Atanc | AtancSlope | Atanhc | AtanhcSlope => {
                Parity::Even
            }
            Cbrt | Sin | Tan | Asin | Atan | Sinh | Tanh | Asinh | Atanh => Parity::Odd,
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
        }
    }

    /// Its value.
    pub fn apply<R: Real>(self, x: R, y: R) -> R {
        match self {
            Self::Powf => x.powf(y),
            Self::Atan2 => x.atan2(y),
            Self::Min => x.min(y),
            Self::Max => x.max(y),
        }
    }
}
