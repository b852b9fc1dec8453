//! Double-double numbers against 120 digits: every operation and function, where it is defined.

mod exact;
mod reference;

use dashu_float::ops::CubicRoot;
use dmech_scalar::{DoubleDouble, Real};
use exact::{Big, big};

/// A fixed sequence of numbers in 0 ≤ u < 1 (Steele, Lea and Flood's SplitMix64).
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 2f64.powi(-53)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// x with a low part of its own.
    fn filled(&mut self, x: f64) -> DoubleDouble {
        DoubleDouble::new(x, x * self.between(-1.0, 1.0) * 2f64.powi(-54))
    }

    /// Of either sign, evenly in the logarithm.
    fn magnitude(&mut self, least: f64, most: f64) -> f64 {
        let sign = if self.next() < 0.5 { -1.0 } else { 1.0 };
        sign * 10f64.powf(self.between(least.log10(), most.log10()))
    }
}

fn exact_value(x: DoubleDouble) -> Big {
    big(x.hi()) + big(x.lo())
}

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
        let a = uniform.magnitude(1e-60, 1e60);
        // Every other sum cancels.
        let b = if k % 2 == 0 { uniform.magnitude(1e-60, 1e60) } else { -a * (1.0 + uniform.magnitude(1e-16, 1.0)) };
        let (a, b) = (uniform.filled(a), uniform.filled(b));
        let (x, y) = (exact_value(a), exact_value(b));
        let (sum, difference, product, quotient) = (&x + &y, &x - &y, &x * &y, &x / &y);
        worst[0].take(error(a + b, &sum, &sum), a);
        worst[1].take(error(a - b, &difference, &difference), a);
        worst[2].take(error(a * b, &product, &product), a);
        worst[3].take(error(a / b, &quotient, &quotient), a);
        let c = uniform.filled(1.0);
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
            let small = uniform.magnitude(1e-30, 1.0);
            let x = match self {
                Reach::Odd(most) => [small, uniform.between(-1.7, 1.7), uniform.magnitude(0.1, most)],
                Reach::Positive(least, most) => {
                    [1.0 + 0.5 * small, uniform.between(0.3, 4.0), uniform.magnitude(least, most).abs()]
                }
                Reach::Unit => [small, uniform.between(-1.0, 1.0), small.signum() - small],
                Reach::Above(most) => {
                    [1.0 + small.abs(), uniform.between(1.0, 4.0), uniform.magnitude(1.0, most).abs()]
                }
                Reach::Angle => {
                    let k = uniform.magnitude(1.0, 7e14).round();
                    [small, uniform.magnitude(0.1, 1e15), k * std::f64::consts::FRAC_PI_2]
                }
            };
            list.extend(x.map(|x| uniform.filled(x)));
            // Neighbours of the numbers where logarithms and the like are 0 or 1, with nothing but a low part.
            let low = small * 2f64.powi(-54);
            match self {
                Reach::Positive(..) => list.push(DoubleDouble::new(1.0, low)),
                Reach::Above(_) => list.push(DoubleDouble::new(1.0, low.abs())),
                Reach::Unit => list.push(DoubleDouble::new(low.signum(), -low)),
                // The nearest double-double number to a multiple of π/2: the result is as small as it gets.
                Reach::Angle => {
                    let k = uniform.magnitude(1.0, 7e14).round();
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
        let x = uniform.magnitude(1e-3, 1e3);
        let x = uniform.filled(x);
        let exact = exact_value(x).powi((n as i64).into());
        if n != 0.0 {
            worst[0].take(error(x.powi(n as i32), &exact, &exact) / n.abs(), x);
            assert_eq!(x.powf(n.into()), x.powi(n as i32));
        }
        let p = uniform.magnitude(1e-3, 30.0);
        let (x, p) = (x.abs(), uniform.filled(p));
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
            let x = uniform.magnitude(1e-140, 1e140).powf(1.0);
            uniform.filled(x)
        });
        // Angles of all sizes: half of the points have coordinates of like size.
        let y = if uniform.next() < 0.5 { y } else { x * uniform.filled(1.3) * DoubleDouble::from(y.hi().signum()) };
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

/// Where `f64` gives an infinity, a NaN or an exact zero, so do double-double numbers, with nothing in their low part.
#[test]
fn what_is_not_finite_is_what_it_is_in_f64() {
    // f64::MAX itself is too much for the standard library's arsinh.
    let edges =
        [0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 1e-310, 1e300, -1e300, 8e307, f64::INFINITY, -f64::INFINITY, f64::NAN];
    macro_rules! both {
        ($($name:ident)*) => { [$((stringify!($name), DoubleDouble::$name as fn(DoubleDouble) -> DoubleDouble, <f64 as Real>::$name as fn(f64) -> f64)),*] };
    }
    let functions = both!(
        recip abs signum sqrt cbrt exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin acos atan sinh cosh tanh asinh
        acosh atanh sinc sinc_slope sinhc sinhc_slope atanc atanc_slope atanhc atanhc_slope
    );
    let mut checked = 0;
    let mut agree = |name: &str, x: &[f64], double: DoubleDouble, plain: f64| {
        assert_eq!(double.hi().is_nan(), plain.is_nan(), "{name} {x:?}: {double:?}, {plain:e}");
        if plain.is_infinite() || double.hi().is_infinite() {
            assert_eq!(double.hi(), plain, "{name} {x:?}");
        }
        assert_eq!(double.finite(), plain.is_finite());
        if !double.finite() {
            assert_eq!(double.lo(), 0.0, "{name} {x:?}");
            checked += 1;
        }
        if plain == 0.0 {
            assert!(double.hi().abs() < 1e-300, "{name} {x:?}: {double:?}");
        }
        assert!(double.lo().abs() <= 0.5 * (double.hi().abs().next_up() - double.hi().abs()) || !double.finite());
    };
    for x in edges {
        for (name, double, plain) in functions {
            agree(name, &[x], double(x.into()), plain(x));
        }
        for y in edges {
            let (a, b) = (DoubleDouble::from(x), DoubleDouble::from(y));
            agree("+", &[x, y], a + b, x + y);
            agree("−", &[x, y], a - b, x - y);
            agree("×", &[x, y], a * b, x * y);
            agree("÷", &[x, y], a / b, x / y);
            agree("min", &[x, y], Real::min(a, b), Real::min(x, y));
            agree("max", &[x, y], Real::max(a, b), Real::max(x, y));
            agree("atan2", &[x, y], Real::atan2(a, b), Real::atan2(x, y));
            agree("powf", &[x, y], a.powf(b), x.powf(y));
            assert_eq!((a.less(b), a.less_or_equal(b), a.equal(b)), (x < y, x <= y, x == y));
        }
        agree("powi", &[x], DoubleDouble::from(x).powi(-3), x.powi(-3));
    }
    assert!(checked > 200);
}

#[test]
fn the_low_part_decides_where_the_high_parts_are_equal() {
    let (less, more) = (DoubleDouble::new(1.0, -1e-20), DoubleDouble::new(1.0, 1e-20));
    assert!(less.less(more) && less.less_or_equal(more) && !more.less(less) && !less.equal(more));
    assert_eq!((Real::min(less, more), Real::max(less, more)), (less, more));
    assert_eq!(less + more, DoubleDouble::from(2.0));
    assert_eq!(DoubleDouble::new(1e-20, 1.0), more);
    // ε is the smallest number that counts beside 1, but for what lo can hold besides.
    let one = DoubleDouble::ONE;
    assert_eq!(DoubleDouble::EPSILON.to_f64(), 2f64.powi(-104));
    assert!(one.less(one + DoubleDouble::EPSILON));
}

/// Angles beyond 2⁵⁰ have the digits of `f64`, and are never outside of ±1.
#[test]
fn large_angles_keep_the_accuracy_of_f64() {
    for x in [1.2e15, 1e22, 1e100, 1e300, f64::MAX] {
        for x in [x, -x] {
            let y = DoubleDouble::from(x);
            assert!((y.sin().hi() - x.sin()).abs() <= f64::EPSILON && (y.cos().hi() - x.cos()).abs() <= f64::EPSILON);
        }
    }
}

#[test]
fn digits_are_written_and_read() {
    let read = |text: &str| text.parse::<DoubleDouble>();
    let mut uniform = Uniform(5);
    for _ in 0..1000 {
        let x = uniform.magnitude(1e-40, 1e40);
        let x = uniform.filled(x);
        for text in [x.to_string(), format!("{x:e}")] {
            let back = read(&text).unwrap();
            assert!(((back - x) / x).hi().abs() < 1e-30, "{x:?}: {text}, {back:?}");
        }
        // Against the digits of dashu, which rounds half to even where this rounds half up.
        let exact = exact_value(x).to_decimal().value().with_precision(20).value().to_string();
        let ours = read(&exact).unwrap();
        assert!(((ours - x) / x).hi().abs() < 1e-19, "{exact}");
    }
    let shown = [("1", "1"), ("-0.5", "-0.5"), ("0.1", "0.1"), ("1e40", "1e40"), ("123456789e-30", "1.23456789e-22")];
    for (text, expected) in shown {
        assert_eq!(read(text).unwrap().to_string(), expected);
    }
    let x = read("2.99999999999999999999999999").unwrap();
    assert_eq!((format!("{x:.3}"), format!("{x:.26}")), ("3.000".into(), "2.99999999999999999999999999".into()));
    assert_eq!((format!("{x:.4e}"), format!("{:9.2}|", -x)), ("3.0000e0".into(), "    -3.00|".into()));
    assert_eq!(
        format!("{:.1} {:.1} {:.0}", read("0.04").unwrap(), read("0.06").unwrap(), read("9.7").unwrap()),
        "0.0 0.1 10"
    );
    assert_eq!(format!("{} {}", DoubleDouble::from(f64::NAN), DoubleDouble::from(-f64::INFINITY)), "NaN -inf");
    for text in ["", "x", "1e", "1.2.3", "0x10", "--1"] {
        assert!(read(text).is_err(), "{text}");
    }
    assert_eq!(read("inf").unwrap().hi(), f64::INFINITY);
    assert_eq!(read("1e999").unwrap().hi(), f64::INFINITY);
    assert_eq!(read(&format!("{}", DoubleDouble::from(1e-320))).unwrap().hi(), 1e-320);
}
