//! Double-double numbers against 120 digits: every operation and function, where it is defined.

mod exact;
mod reference;
mod uniform;
mod wide;

use dashu_float::ops::CubicRoot;
use dmech_scalar::{DoubleDouble, Real};
use exact::{Big, big};
use uniform::Uniform;
use wide::{exact_value, filled, magnitude};

/// |computed − exact| / |scale|.
fn error(computed: DoubleDouble, exact: &Big, scale: &Big) -> f64 {
    if !computed.finite() {
        return f64::INFINITY;
    }
    let difference = exact_value(computed) - exact;
    if difference == big(0.0) { 0.0 } else { (difference / scale).to_f64().value().abs() }
}

/// The worst of many, which must be within 2^bound but not far below it.
struct Worst {
    name: &'static str,
    error: f64,
    at: DoubleDouble,
    checked: u32,
}

impl Worst {
    fn new(name: &'static str) -> Self {
        Worst { name, error: 0.0, at: DoubleDouble::ZERO, checked: 0 }
    }

    fn take(&mut self, error: f64, at: DoubleDouble) {
        self.checked += 1;
        if error.is_nan() || error > self.error {
            (self.error, self.at) = (error, at);
        }
    }

    fn is_within(&self, bound: f64) -> bool {
        println!("{:>14}: 2^{:.1} at {:e}, {} arguments", self.name, self.error.log2(), self.at, self.checked);
        assert!(self.checked > 500 && self.error > 0.0, "{}: nothing was measured", self.name);
        self.error <= bound.exp2()
    }
}

#[test]
fn arithmetic_keeps_31_digits() {
    let mut uniform = Uniform(1);
    let mut worst = ["+", "−", "×", "÷", "mul_add"].map(Worst::new);
    for k in 0..20_000 {
        let a = magnitude(&mut uniform, 1e-60, 1e60);
        // Every other sum cancels.
        let b = if k % 2 == 0 {
            magnitude(&mut uniform, 1e-60, 1e60)
        } else {
            -a * (1.0 + magnitude(&mut uniform, 1e-16, 1.0))
        };
        let (a, b) = (filled(&mut uniform, a), filled(&mut uniform, b));
        let (x, y) = (exact_value(a), exact_value(b));
        let (sum, difference, product, quotient) = (&x + &y, &x - &y, &x * &y, &x / &y);
        worst[0].take(error(a + b, &sum, &sum), a);
        worst[1].take(error(a - b, &difference, &difference), a);
        worst[2].take(error(a * b, &product, &product), a);
        worst[3].take(error(a / b, &quotient, &quotient), a);
        let c = filled(&mut uniform, 1.0);
        let scale = big(product.to_f64().value().abs()) + big(1.0);
        worst[4].take(error(a.mul_add(b, c), &(product + exact_value(c)), &scale), a);
    }
    // The proven bounds: 3, 3, 5 to 7 and 15 u², u = 2⁻⁵³; a product and a sum.
    let bounds = [3.0_f64, 3.0, 7.0, 15.0, 10.0].map(|bound| bound.log2() - 106.0);
    let within: Vec<_> = worst.iter().zip(bounds).map(|(worst, bound)| worst.is_within(bound)).collect();
    assert!(within.iter().all(|&within| within), "{within:?}");
    assert!(worst[..4].iter().all(|worst| worst.error < 2f64.powi(-104)));
}

/// A function, its 120 digits, the accuracy that is claimed as a power of 2, and its arguments.
struct Function {
    name: &'static str,
    double: fn(DoubleDouble) -> DoubleDouble,
    exact: fn(&Big) -> Big,
    bound: f64,
    reach: Reach,
}

/// Where a function is looked at.
#[derive(Clone, Copy)]
enum Reach {
    /// −x to x, and all magnitudes from 10⁻³⁰ on.
    Odd(f64),
    /// All positive magnitudes between two, and about 1.
    Positive(f64, f64),
    /// −1 to 1, and towards either end.
    Unit,
    /// From 1 on, and towards 1.
    Above(f64),
    /// Angles: all magnitudes to 2⁵⁰, and beside the zeros, k π/2.
    Angle,
}

impl Reach {
    fn arguments(self, seed: u64) -> Vec<DoubleDouble> {
        let mut uniform = Uniform(seed);
        let mut list = Vec::new();
        for _ in 0..500 {
            let small = magnitude(&mut uniform, 1e-30, 1.0);
            let x = match self {
                Reach::Odd(most) => [small, uniform.between(-1.7, 1.7), magnitude(&mut uniform, 0.1, most)],
                Reach::Positive(least, most) => {
                    [1.0 + 0.5 * small, uniform.between(0.3, 4.0), magnitude(&mut uniform, least, most).abs()]
                }
                Reach::Unit => [small, uniform.between(-1.0, 1.0), small.signum() - small],
                Reach::Above(most) => {
                    [1.0 + small.abs(), uniform.between(1.0, 4.0), magnitude(&mut uniform, 1.0, most).abs()]
                }
                Reach::Angle => {
                    let k = magnitude(&mut uniform, 1.0, 7e14).round();
                    [small, magnitude(&mut uniform, 0.1, 1e15), k * std::f64::consts::FRAC_PI_2]
                }
            };
            list.extend(x.map(|x| filled(&mut uniform, x)));
            // Neighbours of the numbers where logarithms and the like are 0 or 1, with nothing but a low part.
            let low = small * 2f64.powi(-54);
            match self {
                Reach::Positive(..) => list.push(DoubleDouble::new(1.0, low)),
                Reach::Above(_) => list.push(DoubleDouble::new(1.0, low.abs())),
                Reach::Unit => list.push(DoubleDouble::new(low.signum(), -low)),
                // The nearest double-double number to a multiple of π/2: the result is as small as it gets.
                Reach::Angle => {
                    let k = magnitude(&mut uniform, 1.0, 7e14).round();
                    let half_pi = big(2.0) * big(1.0).atan();
                    let multiple = half_pi * big(k);
                    let hi = multiple.to_f64().value();
                    list.push(DoubleDouble::new(hi, (multiple - big(hi)).to_f64().value()));
                }
                Reach::Odd(_) => {}
            }
        }
        // A low part may have led beyond the end.
        list.retain(|x| match self {
            Reach::Unit => x.abs() < DoubleDouble::ONE,
            Reach::Above(_) => *x > DoubleDouble::ONE,
            _ => true,
        });
        list
    }
}

macro_rules! function {
    ($name:ident, $bound:expr, $reach:expr, $exact:expr) => {
        Function {
            name: stringify!($name),
            double: <DoubleDouble as Real>::$name,
            exact: $exact,
            bound: $bound,
            reach: $reach,
        }
    };
}

use Reach::{Above, Angle, Odd, Positive, Unit};

const FUNCTIONS: [Function; 31] = [
    function!(recip, -104.0, Odd(1e200), |x| big(1.0) / x),
    function!(sqrt, -104.0, Positive(1e-250, 1e290), |x| x.sqrt()),
    function!(cbrt, -104.0, Odd(1e290), |x| x.cbrt()),
    function!(exp, -103.0, Odd(600.0), |x| x.exp()),
    function!(exp2, -103.0, Odd(800.0), |x| (x * big(2.0).ln()).exp()),
    function!(exp_m1, -103.0, Odd(600.0), |x| x.exp_m1()),
    function!(ln, -103.0, Positive(1e-250, 1e290), |x| x.ln()),
    function!(ln_1p, -103.0, Positive(1e-30, 1e290), |x| x.ln_1p()),
    function!(log2, -103.0, Positive(1e-250, 1e290), |x| x.ln() / big(2.0).ln()),
    function!(log10, -103.0, Positive(1e-250, 1e290), |x| x.ln() / big(10.0).ln()),
    function!(sin, -103.0, Angle, |x| x.sin()),
    function!(cos, -103.0, Angle, |x| x.cos()),
    function!(tan, -103.0, Angle, |x| x.sin() / x.cos()),
    function!(asin, -103.0, Unit, |x| x.asin()),
    function!(acos, -103.0, Unit, |x| x.acos()),
    function!(atan, -103.0, Odd(1e100), |x| x.atan()),
    function!(sinh, -103.0, Odd(705.0), |x| x.sinh()),
    function!(cosh, -103.0, Odd(705.0), |x| x.cosh()),
    function!(tanh, -103.0, Odd(100.0), |x| x.tanh()),
    function!(asinh, -103.0, Odd(1e200), |x| x.asinh()),
    function!(acosh, -103.0, Above(1e200), |x| x.acosh()),
    function!(atanh, -103.0, Unit, |x| x.atanh()),
    function!(sinc, -103.0, Odd(1e15), |x| reference::SINC.at(x)),
    function!(sinc_slope, -101.0, Odd(1e15), |x| reference::SINC_SLOPE.at(x)),
    function!(sinhc, -103.0, Odd(705.0), |x| reference::SINHC.at(x)),
    function!(sinhc_slope, -101.0, Odd(705.0), |x| reference::SINHC_SLOPE.at(x)),
    function!(atanc, -103.0, Odd(1e100), |x| reference::ATANC.at(x)),
    function!(atanc_slope, -101.0, Odd(1e30), |x| reference::ATANC_SLOPE.at(x)),
    function!(atanhc, -103.0, Unit, |x| reference::ATANHC.at(x)),
    function!(atanhc_slope, -101.0, Unit, |x| reference::ATANHC_SLOPE.at(x)),
    function!(abs, -110.0, Odd(1e200), |x| if *x < big(0.0) { -x.clone() } else { x.clone() }),
];

#[test]
fn each_function_has_the_accuracy_that_is_claimed() {
    let mut failures = Vec::new();
    for (seed, f) in FUNCTIONS.iter().enumerate() {
        let mut worst = Worst::new(f.name);
        for x in f.reach.arguments(seed as u64) {
            let value = exact_value(x);
            let exact = (f.exact)(&value);
            let scale = if f.name == "sinc_slope" && x.hi().abs() > 4.0 {
                // Zero wherever tan x = x: the larger term of the difference counts.
                let term = x.hi().cos().abs().max((x.hi().sin() / x.hi()).abs());
                big(term / x.hi() / x.hi())
            } else {
                exact.clone()
            };
            worst.take(error((f.double)(x), &exact, &scale), x);
        }
        if f.name == "abs" {
            assert_eq!(worst.error, 0.0);
        } else if !worst.is_within(f.bound) {
            failures.push(f.name);
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

#[test]
fn powers_keep_their_digits() {
    let mut uniform = Uniform(3);
    let mut worst = ["xⁿ / n", "xᵖ / |p ln x|"].map(Worst::new);
    for _ in 0..2000 {
        let n = uniform.between(-40.0, 40.0).round();
        let x = magnitude(&mut uniform, 1e-3, 1e3);
        let x = filled(&mut uniform, x);
        let exact = exact_value(x).powi((n as i64).into());
        if n != 0.0 {
            worst[0].take(error(x.powi(n as i32), &exact, &exact) / n.abs(), x);
            assert_eq!(x.powf(n.into()), x.powi(n as i32));
        }
        let p = magnitude(&mut uniform, 1e-3, 30.0);
        let (x, p) = (x.abs(), filled(&mut uniform, p));
        let logarithm = exact_value(x).ln() * exact_value(p);
        let condition = logarithm.to_f64().value().abs().max(1.0);
        let exact = logarithm.exp();
        worst[1].take(error(x.powf(p), &exact, &exact) / condition, x);
    }
    assert!(worst[0].is_within(-103.0) & worst[1].is_within(-103.0));
    let two = DoubleDouble::from(2.0);
    assert_eq!((-two).powf(3.0.into()), DoubleDouble::from(-8.0));
    assert_eq!((-two).powf(1e300.into()).hi(), f64::INFINITY);
    assert!((-two).powf(0.5.into()).hi().is_nan());
    assert_eq!(two.powi(i32::MIN), DoubleDouble::ZERO);
}

#[test]
fn the_angle_of_a_point_is_right_in_every_quadrant() {
    let mut uniform = Uniform(4);
    let mut worst = Worst::new("atan2");
    let pi = big(4.0) * big(1.0).atan();
    for _ in 0..2000 {
        let [x, y] = [(); 2].map(|()| {
            let x = magnitude(&mut uniform, 1e-140, 1e140);
            filled(&mut uniform, x)
        });
        // Angles of all sizes: half of the points have coordinates of like size.
        let y =
            if uniform.next() < 0.5 { y } else { x * filled(&mut uniform, 1.3) * DoubleDouble::from(y.hi().signum()) };
        let ratio = (exact_value(y) / exact_value(x)).atan();
        let exact = match (x.hi() < 0.0, y.hi() < 0.0) {
            (false, _) => ratio,
            (true, false) => ratio + &pi,
            (true, true) => ratio - &pi,
        };
        worst.take(error(y.atan2(x), &exact, &exact), y);
    }
    assert!(worst.is_within(-103.0));
}
