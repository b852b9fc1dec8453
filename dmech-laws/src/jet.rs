//! Values with two derivatives: how much a node moves what comes from below.

use dmech_symbolic::expression::Unary;

/// f, f′, f″ of a function at a point.
pub(crate) fn of_unary(f: Unary, x: f64) -> [f64; 3] {
    use Unary::*;
    let value = f.apply(x);
    let [first, second] = match f {
        Sqrt => [0.5 / value, -0.25 / (value * x)],
        Cbrt => [1.0 / (3.0 * value * value), -2.0 / (9.0 * value * value * x)],
        Exp => [value, value],
        ExpM1 => [x.exp(), x.exp()],
        Exp2 => [value * std::f64::consts::LN_2, value * std::f64::consts::LN_2.powi(2)],
        Ln => [1.0 / x, -1.0 / (x * x)],
        Log2 => [1.0 / (x * std::f64::consts::LN_2), -1.0 / (x * x * std::f64::consts::LN_2)],
        Log10 => [1.0 / (x * std::f64::consts::LN_10), -1.0 / (x * x * std::f64::consts::LN_10)],
        Ln1p => [1.0 / (1.0 + x), -1.0 / ((1.0 + x) * (1.0 + x))],
        Sin => [x.cos(), -value],
        Cos => [-x.sin(), -value],
        Tan => [1.0 + value * value, 2.0 * value * (1.0 + value * value)],
        Asin | Acos => {
            let leg2 = (1.0 - x) * (1.0 + x);
            let slope = 1.0 / leg2.sqrt();
            if f == Asin { [slope, slope * x / leg2] } else { [-slope, -slope * x / leg2] }
        }
        Atan => {
            let slope = 1.0 / (1.0 + x * x);
            [slope, -2.0 * x * slope * slope]
        }
        Sinh => [x.cosh(), value],
        Cosh => [x.sinh(), value],
        Tanh => {
            let slope = 1.0 / x.cosh().powi(2);
            [slope, -2.0 * value * slope]
        }
        Asinh => {
            let r2 = 1.0 + x * x;
            [1.0 / r2.sqrt(), -x / (r2 * r2.sqrt())]
        }
        Acosh => {
            let r2 = (x - 1.0) * (x + 1.0);
            [1.0 / r2.sqrt(), -x / (r2 * r2.sqrt())]
        }
        Atanh => {
            let below = (1.0 - x) * (1.0 + x);
            [1.0 / below, 2.0 * x / (below * below)]
        }
        _ => [0.0, 0.0],
    };
    [value, first, second]
}

/// xᵖ with its derivatives.
pub(crate) fn of_power(x: f64, p: f64) -> [f64; 3] {
    let times = |c: f64, power: f64| if c == 0.0 { 0.0 } else { c * power };
    [x.powf(p), times(p, x.powf(p - 1.0)), times(p * (p - 1.0), x.powf(p - 2.0))]
}

/// xⁿ with its derivatives.
pub(crate) fn of_integer_power(x: f64, n: i32) -> [f64; 3] {
    let (c, e) = (f64::from(n), f64::from(n) * f64::from(n - 1));
    let times = |c: f64, power: f64| if c == 0.0 { 0.0 } else { c * power };
    [x.powi(n), times(c, x.powi(n - 1)), times(e, x.powi(n - 2))]
}
