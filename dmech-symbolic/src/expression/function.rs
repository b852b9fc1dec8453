//! Functions of one and two arguments.
//!
//! | rule | domain |
//! |---|---|
//! | f(−u) = f(u) for even f, −f(u) for odd f | all |
//! | √(a b²) = \|b\| √a, ∛(a bⁿ) = ∛bⁿ ∛a for n ≠ ±1, \|a b²\| = \|a\| b² | a ≥ 0 below a square root |
//! | exact values: √4 = 2, sin 0 = 0, e⁰ = 1, … | the point |
//! | u^p by integer powers and roots where p is n/2, n/3 or n/4 (for n/3 the nearest number) | u ≥ 0, which u^p demands |
//! | a root or power of a choice is the choice of the roots or powers: that of a contact is 0 where it is open | all |
//! | hypot(x, y) = √(x² + y²) | x² and y² within range |

use dmech_scalar::Real;

use super::{Choice, Expr, Graph, Node, Number};

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

enum Parity {
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

    fn parity(self) -> Parity {
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
    fn exact_value(self, x: f64) -> Option<f64> {
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

impl Graph {
    /// f(u) in normal form.
    pub fn unary(&mut self, f: Unary, u: Expr) -> Expr {
        if let Some(exact) = self.as_number(u).and_then(|x| f.exact_value(x)) {
            return self.number(exact);
        }
        if self.leads_with_minus(u) {
            match f.parity() {
                Parity::Even => {
                    let turned = self.neg(u);
                    return self.unary(f, turned);
                }
                Parity::Odd => {
                    let turned = self.neg(u);
                    let value = self.unary(f, turned);
                    return self.neg(value);
                }
                Parity::Neither => {}
            }
        }
        if let Some(product) = self.of_powers(f, u) {
            return product;
        }
        if let (Unary::Sqrt | Unary::Cbrt, Some(choice)) = (f, self.choice(u)) {
            let (yes, no) = (self.unary(f, choice.yes), self.unary(f, choice.no));
            return self.select(choice.condition, yes, no);
        }
        self.intern(Node::Unary(f, u))
    }

    /// f(u, w) in normal form.
    pub fn binary(&mut self, f: Binary, u: Expr, w: Expr) -> Expr {
        match f {
            Binary::Powf => return self.powf(u, w),
            Binary::Min | Binary::Max if u == w => return u,
            Binary::Atan2 if self.leads_with_minus(u) => {
                let turned = self.neg(u);
                let angle = self.binary(f, turned, w);
                return self.neg(angle);
            }
            _ => {}
        }
        if let (Binary::Min | Binary::Max, Some(x), Some(y)) = (f, self.as_number(u), self.as_number(w)) {
            return self.number(f.apply(x, y));
        }
        self.intern(Node::Binary(f, u, w))
    }

    /// √(x² + y²).
    pub fn hypot(&mut self, x: Expr, y: Expr) -> Expr {
        let squares = [self.square(x), self.square(y)];
        let sum = self.add(&squares);
        self.unary(Unary::Sqrt, sum)
    }

    /// u between low and high.
    pub fn clamp(&mut self, u: Expr, low: Expr, high: Expr) -> Expr {
        let raised = self.binary(Binary::Max, u, low);
        self.binary(Binary::Min, raised, high)
    }

    /// u^p.
    fn powf(&mut self, u: Expr, p: Expr) -> Expr {
        let exponent = self.as_number(p).or_else(|| self.quotient_of_numbers(p));
        for (denominator, root) in [(1, None), (2, Some(Unary::Sqrt)), (3, Some(Unary::Cbrt)), (4, None)] {
            let Some(exponent) = exponent else { break };
            let n = (exponent * f64::from(denominator)).round();
            if n.abs() > 64.0 || n / f64::from(denominator) != exponent {
                continue;
            }
            let base = match (denominator, root) {
                (_, Some(root)) => self.unary(root, u),
                (4, None) => {
                    let root = self.unary(Unary::Sqrt, u);
                    self.unary(Unary::Sqrt, root)
                }
                _ => u,
            };
            return self.powi(base, n as i32);
        }
        if let Some(Choice { condition, yes, no }) = self.choice(u) {
            let (yes, no) = (self.powf(yes, p), self.powf(no, p));
            return self.select(condition, yes, no);
        }
        self.intern(Node::Binary(Binary::Powf, u, p))
    }

    /// The value of 1.0/3.0 and its like, which stand as products because they are not exact.
    fn quotient_of_numbers(&self, e: Expr) -> Option<f64> {
        match self.node(e) {
            Node::Product { coefficient, factors } => factors.iter().try_fold(coefficient.value(), |value, &(f, n)| {
                let number = self.as_number(f)?;
                (n == -1).then(|| value / number)
            }),
            _ => None,
        }
    }

    /// Whether −e looks simpler than e.
    pub(super) fn leads_with_minus(&self, e: Expr) -> bool {
        match self.node(e) {
            Node::Number(n) => n.value() < 0.0,
            Node::Sum { terms, .. } => terms[0].0.value() < 0.0,
            Node::Product { coefficient, .. } => coefficient.value() < 0.0,
            _ => false,
        }
    }

    /// What can be taken out of √, ∛ and | | of a product.
    fn of_powers(&mut self, f: Unary, u: Expr) -> Option<Expr> {
        let Node::Product { coefficient, factors } = self.node(u).clone() else { return None };
        let may = |n: i32| match f {
            Unary::Sqrt | Unary::Abs => n % 2 == 0,
            Unary::Cbrt => n.abs() != 1,
            _ => false,
        };
        let (powers, rest): (Vec<_>, Vec<_>) = factors.iter().copied().partition(|&(_, n)| may(n));
        if powers.is_empty() {
            return None;
        }
        let rest = self.product_of(coefficient, rest);
        let mut product = vec![(self.unary(f, rest), 1)];
        for (base, n) in powers {
            product.push(match f {
                Unary::Sqrt => (self.unary(Unary::Abs, base), n / 2),
                Unary::Cbrt => (self.unary(f, base), n),
                _ => (base, n),
            });
        }
        Some(self.product_of(Number::ONE, product))
    }
}
