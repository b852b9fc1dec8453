//! The functions of the language for `f64`, over their whole range, against 120 digits.

mod exact;
mod ulps;
mod uniform;

use dashu_float::ops::CubicRoot;
use dmech_scalar::Real;
use exact::{Big, big};
use std::f64::consts::*;
use ulps::error_in_ulps;
use uniform::Uniform;

/// Arguments of each kind.
const COUNT: usize = 150;
/// What every function must keep, in units of the last place.
const TOLERANCE: f64 = 0.9;

struct Function {
    name: &'static str,
    own: fn(f64) -> f64,
    exact: fn(&Big) -> Big,
    /// The smallest and the largest argument.
    domain: (f64, f64),
    /// Where the form changes, the exponent of 2 that is taken out, or the sign of the result.
    seams: &'static [f64],
}

macro_rules! functions {
    ($($name:ident($low:expr, $high:expr) = $exact:expr, at $seams:expr;)*) => {
        vec![$(Function {
            name: stringify!($name),
            own: <f64 as Real>::$name,
            exact: $exact,
            domain: ($low, $high),
            seams: &$seams,
        }),*]
    };
}

/// Where the power of 2 changes.
const HALF_LN_2: f64 = 0.5 * LN_2;
const WIDE: f64 = 1e6;

fn functions() -> Vec<Function> {
    const ANGLES: [f64; 8] = [0.0, FRAC_PI_4, FRAC_PI_2, PI, 3.0 * FRAC_PI_4, 2.0 * PI, 355.0, 2e5];
    const LOGARITHMS: [f64; 8] = [1.0, SQRT_2, FRAC_1_SQRT_2, 2.0 * SQRT_2, 0.25, 1000.0, f64::MIN_POSITIVE, 1e-320];
    const POWERS: [f64; 6] = [0.0, HALF_LN_2, 3.0 * HALF_LN_2, 22.0, 709.0, 710.47];
    functions! {
        exp(-745.2, 709.9) = |x| x.exp(), at [0.0, HALF_LN_2, -HALF_LN_2, 660.0, -660.0, -708.4, 709.782712893384, -745.1332191019411];
        exp2(-1075.0, 1024.0) = |x| (x * big(2.0).ln()).exp(), at [0.0, 0.5, -0.5, 1.0, 950.0, -950.0, -1022.0, 1023.0];
        exp_m1(-60.0, 709.9) = |x| if tiny(x) { x + x * x / big(2.0) } else { x.exp() - big(1.0) },
            at [0.0, HALF_LN_2, -HALF_LN_2, 3.0 * HALF_LN_2, -3.0 * HALF_LN_2, -50.0, 708.0, 37.4];
        ln(0.0, f64::MAX) = |x| x.ln(), at LOGARITHMS;
        ln_1p(-1.0, f64::MAX) = |x| if tiny(x) { x - x * x / big(2.0) } else { (x + big(1.0)).ln() },
            at [0.0, SQRT_2 - 1.0, FRAC_1_SQRT_2 - 1.0, -0.5, -1.0, 1.0, 1e16];
        log2(0.0, f64::MAX) = |x| x.ln() / big(2.0).ln(), at LOGARITHMS;
        log10(0.0, f64::MAX) = |x| x.ln() / big(10.0).ln(), at LOGARITHMS;
        sin(-WIDE, WIDE) = |x| x.sin(), at ANGLES;
        cos(-WIDE, WIDE) = |x| x.cos(), at ANGLES;
        tan(-WIDE, WIDE) = |x| x.tan(), at ANGLES;
        asin(-1.0, 1.0) = |x| x.asin(), at [0.0, 0.5, -0.5, 1.0, -1.0];
        acos(-1.0, 1.0) = |x| x.acos(), at [0.0, 0.5, -0.5, 1.0, -1.0];
        atan(-f64::MAX, f64::MAX) = |x| x.atan(), at [0.0, 0.41421356, 1.0, 2.414213562, 1e16, -1e19];
        sinh(-710.5, 710.5) = |x| if tiny(x) { cubic(x, 6.0) } else { x.sinh() }, at POWERS;
        cosh(-710.5, 710.5) = |x| x.cosh(), at POWERS;
        tanh(-40.0, 40.0) = |x| if tiny(x) { cubic(x, -3.0) } else { x.tanh() }, at [0.0, 0.5 * HALF_LN_2, 0.5, 1.0, 19.0, 22.0];
        asinh(-f64::MAX, f64::MAX) = |x| if tiny(x) { cubic(x, -6.0) } else { asinh(x) }, at [0.0, 0.35, 1.0, 0.75, 1e8, 3.27e150];
        acosh(1.0, f64::MAX) = |x| (x + (x * x - big(1.0)).sqrt()).ln(), at [1.0, 1.0606, 1.4, 2.0, 1e8, 3.27e150];
        atanh(-1.0, 1.0) = |x| if tiny(x) { cubic(x, 3.0) } else { ((big(1.0) + x) / (big(1.0) - x)).ln() / big(2.0) },
            at [0.0, 1e-4, 0.17, 0.333333, 0.5, -0.5, 1.0, -1.0];
        cbrt(-f64::MAX, f64::MAX) = |x| x.cbrt(), at [0.0, 1.0, 2.0, 8.0, 0.5, f64::MIN_POSITIVE, 1e-320];
    }
}

/// So small that two terms of a series have all digits.
fn tiny(x: &Big) -> bool {
    x.to_f64().value().abs() < 1e-30
}

/// x + x³/c.
fn cubic(x: &Big, c: f64) -> Big {
    x + x * x * x / big(c)
}

/// Without the difference of nearly equal numbers for negative x.
fn asinh(x: &Big) -> Big {
    let negative = *x < big(0.0);
    let a = if negative { -x.clone() } else { x.clone() };
    let value = (&a + (&a * &a + big(1.0)).sqrt()).ln();
    if negative { -value } else { value }
}

/// The edges first, what is close to them, then all magnitudes, the everyday ones, and any bits.
fn arguments(f: &Function, count: usize) -> Vec<f64> {
    let (low, high) = f.domain;
    let mut uniform = Uniform(f.name.bytes().map(u64::from).sum());
    let mut list = vec![low, high, f64::from_bits(1), -f64::from_bits(1), f64::MIN_POSITIVE, -1e-310, 1e-17, -1e-8];
    for &seam in f.seams {
        let (mut below, mut above) = (seam, seam);
        list.push(seam);
        for _ in 0..10 {
            (below, above) = (below.next_down(), above.next_up());
            list.extend([below, above, -below]);
        }
        for _ in 0..count / 10 {
            list.push(seam + 10f64.powf(uniform.between(-17.0, -0.5)) * (uniform.next() - 0.5));
        }
    }
    let magnitude = high.log10().min(308.0);
    for _ in 0..count {
        let sign = if low < 0.0 && uniform.next() < 0.5 { -1.0 } else { 1.0 };
        list.push(sign * 10f64.powf(uniform.between(-323.0, magnitude)));
        list.push(sign * 10f64.powf(uniform.between(-4.0, magnitude.min(4.0))));
        for reach in [4.0, 40.0, 1e6] {
            list.push(uniform.between(low.max(-reach), high.min(reach)));
        }
        list.push(f64::from_bits((uniform.next() * 2f64.powi(53)) as u64 * 1021));
        list.push((uniform.next() * 1000.0).floor() * FRAC_PI_2);
        list.push((uniform.next() * 1000.0).floor() * HALF_LN_2 + 1e-9 * uniform.next());
    }
    list.retain(|&x| (low..=high).contains(&x) && x != 0.0);
    list
}

#[test]
fn within_one_ulp_everywhere() {
    let mut failures = Vec::new();
    for f in &functions() {
        let (mut worst, mut checked) = ((0.0, 0.0), 0);
        for x in arguments(f, COUNT) {
            let y = (f.own)(x);
            // The logarithms at 0.
            if y.is_infinite() && x.abs() == 1.0 {
                continue;
            }
            let value = (f.exact)(&big(x));
            let error = error_in_ulps(y, &value, value.to_f64().value());
            checked += 1;
            if error > worst.0 {
                worst = (error, x);
            }
        }
        println!("{:>7}: {:.3} ulp at {:e}; {checked} arguments", f.name, worst.0, worst.1);
        assert!(checked > 6 * COUNT / 2 && worst.0 > 0.45, "{}: nothing was measured", f.name);
        if worst.0 > TOLERANCE {
            failures.push(f.name);
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// Numbers with 460 digits: 2π is known to more than the 308 digits before the point.
fn very_big(x: f64) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(1550).value()
}

/// Angles up to the largest number, and those that come closest to a multiple of π/2.
#[test]
fn angles_of_any_size() {
    let turn = very_big(8.0) * very_big(1.0).atan();
    // 6381956970095103 · 2⁷⁹⁷ is 4.7e−19 from a multiple of π/2, closer than any other double.
    let closest = 6381956970095103.0 * 2f64.powi(797);
    let mut list = vec![f64::MAX, closest, 1e22, 1e300, 2e5, 2e5_f64.next_up(), 1.6e6, PI, 3.0 * FRAC_PI_2, 1e16 * PI];
    let mut uniform = Uniform(3);
    for k in 0..COUNT {
        let large = 10f64.powf(uniform.between(5.0, 308.0));
        list.extend([large, 10f64.powf(uniform.between(4.5, 8.0)), (large / FRAC_PI_2).round() * FRAC_PI_2]);
        list.push(k as f64 * 97.0 * FRAC_PI_2);
    }
    type Angle = (&'static str, fn(f64) -> f64, fn(&Big) -> Big);
    let functions: [Angle; 3] =
        [("sin", Real::sin, |x| x.sin()), ("cos", Real::cos, |x| x.cos()), ("tan", Real::tan, |x| x.tan())];
    for (name, own, exact) in functions {
        let mut worst = (0.0, 0.0);
        for x in list.iter().flat_map(|&x| [x, -x]).filter(|&x| x != 0.0) {
            let wide = very_big(x);
            let turns = (&wide / &turn).floor();
            let value = exact(&(wide - turns * &turn).with_precision(500).value());
            let error = error_in_ulps(own(x), &value, value.to_f64().value());
            if error > worst.0 {
                worst = (error, x);
            }
        }
        println!("{name}: {:.3} ulp at {:e}", worst.0, worst.1);
        assert!(worst.0 < TOLERANCE && worst.0 > 0.45, "{name}: {worst:?}");
    }
    assert_eq!(Real::cos(closest), -4.687165924254628e-19);
}

/// From powers close to 1 to those that vanish or overflow.
#[test]
fn powers_of_any_size() {
    let mut uniform = Uniform(5);
    let mut list =
        vec![(1.0_f64.next_up(), 3e18), (1.0_f64.next_down(), 6e18), (f64::MAX, 0.999), (f64::from_bits(1), 0.5)];
    list.extend([
        (f64::MIN_POSITIVE, 1.0),
        (10.0, -320.0),
        (2.0, -1074.0),
        (2.0, 1023.0),
        (0.5, 1074.0),
        (3.0, 2.0),
        (2.0, 0.5),
    ]);
    for _ in 0..3 * COUNT {
        let x = 10f64.powf(uniform.between(-323.0, 308.0));
        list.push((x, uniform.between(-750.0, 750.0) / x.ln()));
        let x = uniform.between(0.0, 4.0);
        list.push((x, uniform.between(-750.0, 750.0) / x.ln()));
        list.push((x, uniform.between(-9.0, 9.0)));
        let x = 1.0 + 10f64.powf(uniform.between(-15.0, -1.0)) * (uniform.next() - 0.5);
        list.push((x, uniform.between(-750.0, 750.0) / x.ln()));
    }
    let mut worst = (0.0, (0.0, 0.0));
    for (x, p) in list.into_iter().filter(|(x, _)| *x > 0.0 && *x != 1.0) {
        let value = (big(x).ln() * big(p)).exp();
        let error = error_in_ulps(Real::powf(x, p), &value, value.to_f64().value());
        if error > worst.0 {
            worst = (error, (x, p));
        }
    }
    println!("powf: {:.3} ulp at {:?}", worst.0, worst.1);
    assert!(worst.0 < TOLERANCE && worst.0 > 0.45, "{worst:?}");
}

/// Points in all directions, near and far.
#[test]
fn angles_of_points() {
    let pi = big(4.0) * big(1.0).atan();
    let mut uniform = Uniform(7);
    let mut worst = (0.0, (0.0, 0.0));
    for k in 0..8 * COUNT {
        let y = 10f64.powf(uniform.between(-308.0, 308.0));
        let reach = [1.0, 16.0, 300.0][k % 3];
        let x = (y * 10f64.powf(uniform.between(-reach, reach))).clamp(f64::from_bits(1), f64::MAX);
        let (y, x) = if k % 2 == 0 { (x, y) } else { (y, x) };
        let (y, x) = (if uniform.next() < 0.5 { y } else { -y }, if uniform.next() < 0.5 { x } else { -x });
        let first = (big(y) / big(x)).atan();
        let value = match (x < 0.0, y < 0.0) {
            (false, _) => first,
            (true, false) => first + &pi,
            (true, true) => first - &pi,
        };
        let error = error_in_ulps(Real::atan2(y, x), &value, value.to_f64().value());
        if error > worst.0 {
            worst = (error, (y, x));
        }
    }
    println!("atan2: {:.3} ulp at {:?}", worst.0, worst.1);
    assert!(worst.0 < 1.0 && worst.0 > 0.45, "{worst:?}");
}

type Unary = (&'static str, fn(f64) -> f64, fn(f64) -> f64);

macro_rules! beside_std {
    ($($name:ident)*) => { [$((stringify!($name), <f64 as Real>::$name, f64::$name)),*] };
}

/// Zeros and their signs, infinities and what is not a number, where the standard library has them.
#[test]
fn zeros_and_infinities_are_those_of_the_standard_library() {
    let functions: [Unary; 26] = beside_std! {
        exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh cbrt round floor trunc
        abs sqrt signum
    };
    let mut wrong = Vec::new();
    for (name, own, std) in functions {
        for x in edges() {
            let (a, b) = (own(x), std(x));
            let special = |x: f64| x == 0.0 || !x.is_finite();
            // Twice the largest number is too much for the standard library's arsinh and arcosh.
            if x.abs() == f64::MAX && ["asinh", "acosh"].contains(&name) {
                continue;
            }
            if (special(a) || special(b)) && a.to_bits() != b.to_bits() && !(a.is_nan() && b.is_nan()) {
                wrong.push(format!("{name} {x:e}: {a:e}, not {b:e}"));
            }
        }
    }
    for y in edges() {
        for x in edges() {
            for (name, a, b) in [("atan2", Real::atan2(y, x), y.atan2(x)), ("powf", Real::powf(y, x), y.powf(x))] {
                let close = (a - b).abs() <= 2.0 * b.abs() * f64::EPSILON + f64::from_bits(1);
                let same = a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
                if !same && (a == 0.0 || b == 0.0 || !close) {
                    wrong.push(format!("{name} {y:e} {x:e}: {a:e}, not {b:e}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
}

fn edges() -> Vec<f64> {
    let positive = [
        0.0,
        f64::from_bits(1),
        1e-310,
        f64::MIN_POSITIVE,
        1e-200,
        1e-17,
        0.1,
        0.25,
        1.0 / 3.0,
        0.5,
        1.0_f64.next_down(),
        1.0,
        1.0_f64.next_up(),
        1.5,
        2.0,
        2.5,
        3.0,
        17.0,
        700.0,
        709.7,
        709.9,
        711.0,
        1000.0,
        1023.5,
        1024.0,
        1100.0,
        2e5,
        1e15,
        4503599627370497.0,
        9007199254740991.0,
        9007199254740992.0,
        1e17,
        1e22,
        1e100,
        1e160,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    positive.iter().flat_map(|&x| [x, -x]).collect()
}
