//! The cardinal functions and their slopes against 120-digit values.

mod exact;
mod reference;
mod ulps;
mod uniform;

use dmech_scalar::Real;
use exact::{Big, big};
use reference::Exact;
use ulps::error_in_ulps;
use uniform::Uniform;

/// What every function must keep, in units of the last place.
const TOLERANCE: f64 = 4.0;

#[derive(Clone, Copy)]
struct Cardinal {
    name: &'static str,
    double: fn(f64) -> f64,
    single: fn(f32) -> f32,
    exact: Exact,
    /// Where the form near 0 hands over to the closed form.
    switch: f64,
    /// The largest argument.
    reach: f64,
}

macro_rules! cardinal {
    ($name:ident, $exact:ident, $switch:expr, $reach:expr) => {
        Cardinal {
            name: stringify!($name),
            double: <f64 as Real>::$name,
            single: <f32 as Real>::$name,
            exact: reference::$exact,
            switch: $switch,
            reach: $reach,
        }
    };
}

const CARDINALS: [Cardinal; 8] = [
    cardinal!(sinc, SINC, 1.25, 1e300),
    cardinal!(sinc_slope, SINC_SLOPE, 1.5, 1e300),
    cardinal!(sinhc, SINHC, 1.25, 730.0),
    cardinal!(sinhc_slope, SINHC_SLOPE, 1.25, 730.0),
    cardinal!(atanc, ATANC, 0.25, 1e300),
    cardinal!(atanc_slope, ATANC_SLOPE, 0.7, 1e300),
    cardinal!(atanhc, ATANHC, 0.25, 1.0f64.next_down()),
    cardinal!(atanhc_slope, ATANHC_SLOPE, 0.8, 1.0f64.next_down()),
];

/// Where some of the closed forms change once more: close to overflow.
const LARGE: [f64; 2] = [700.0, 1e100];

/// `count` arguments of each kind: over all magnitudes, over the everyday ones, towards the far end, and on both
/// sides of each switch-over, close to it and about it.
fn arguments(cardinal: &Cardinal, count: usize) -> Vec<f64> {
    let Cardinal { switch, reach, .. } = *cardinal;
    let mut uniform = Uniform(cardinal.name.bytes().map(u64::from).sum());
    let mut list = vec![0.0, f64::from_bits(1), 1e-300, f64::MIN_POSITIVE, 1e-8, switch, switch.next_down(), reach];
    for seam in LARGE.into_iter().chain([switch]).filter(|&seam| seam < reach) {
        let (mut below, mut above) = (seam, seam);
        for _ in 0..if seam == switch { count } else { 20 } {
            (below, above) = (below.next_down(), above.next_up());
            list.extend([below, above]);
        }
    }
    for k in 0..count {
        list.push(10f64.powf(-300.0 + (300.0 + reach.log10()) * k as f64 / count as f64));
        list.push(10f64.powf(uniform.between(-3.0, reach.log10().min(3.0))));
        list.push(uniform.between(0.0, switch));
        list.push(uniform.between(0.9 * switch, 1.1 * switch));
        list.push(uniform.between(switch, reach.min(10.0)));
        list.push(uniform.between(0.9 * reach, reach));
        // Towards the end of the domain, ever closer.
        list.push(reach - reach * 10f64.powf(uniform.between(-16.0, -1.0)));
    }
    list
}

/// The magnitude whose last place counts: the value itself, but for the slope of sinc beyond |x| = 4. There the value
/// passes through 0 at every solution of tan x = x, and the larger term of the difference counts.
fn scale(cardinal: &Cardinal, x: f64, value: &Big) -> f64 {
    let value = value.to_f64().value();
    if cardinal.name == "sinc_slope" && x.abs() > 4.0 {
        let term = x.cos().abs().max((x.sin() / x).abs()) / x / x;
        return term.max(value.abs());
    }
    value
}

#[test]
fn within_four_ulps_everywhere() {
    let mut failures = Vec::new();
    for cardinal in &CARDINALS {
        let (mut checked, mut worst) = (0, [(0.0, 0.0); 2]);
        for x in arguments(cardinal, 500) {
            let value = cardinal.exact.at(&big(x));
            let error = error_in_ulps((cardinal.double)(x), &value, scale(cardinal, x, &value));
            let side = usize::from(x >= cardinal.switch);
            if error > worst[side].0 {
                worst[side] = (error, x);
            }
            checked += 1;
            // Even, to the bit.
            assert_eq!((cardinal.double)(x).to_bits(), (cardinal.double)(-x).to_bits(), "{} {x}", cardinal.name);
        }
        let [(near, at), (far, far_at)] = worst;
        println!(
            "{:>12}: {near:.2} ulp at {at:e}; beyond {}: {far:.2} ulp at {far_at:e}; {checked} arguments",
            cardinal.name, cardinal.switch
        );
        assert!(checked > 4000 && near > 0.0 && far > 0.0, "{}: nothing was measured", cardinal.name);
        if near.max(far) > TOLERANCE {
            failures.push(cardinal.name);
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// The closed forms of the reference, which rest on a library, agree with the series, which do not.
#[test]
fn the_reference_agrees_with_the_series() {
    for cardinal in &CARDINALS {
        for x in [1e-5, 0.01, 0.1, 0.3, 0.5] {
            let (closed, series) = (cardinal.exact.at(&big(x)), cardinal.exact.series(&big(x), 170));
            let error = ((&closed - &series) / &series).to_f64().value().abs();
            assert!(error < 1e-90, "{} {x}: {error:e}", cardinal.name);
        }
    }
}

/// The plain closed forms fail the same test near 0, so the test can fail.
#[test]
fn the_closed_forms_fail_near_zero() {
    let closed: [fn(f64) -> f64; 4] = [
        |x| (x.cos() - x.sin() / x) / (x * x),
        |x| (x.cosh() - x.sinh() / x) / (x * x),
        |x| (1.0 / (1.0 + x * x) - x.atan() / x) / (x * x),
        |x| (1.0 / (1.0 - x * x) - x.atanh() / x) / (x * x),
    ];
    for (cardinal, closed) in CARDINALS.iter().skip(1).step_by(2).zip(closed) {
        let x = 1e-3;
        let value = cardinal.exact.at(&big(x));
        let error = |computed| error_in_ulps(computed, &value, value.to_f64().value());
        assert!(error(closed(x)) > 1e4 && error((cardinal.double)(x)) < TOLERANCE, "{}", cardinal.name);
        assert!(closed(0.0).is_nan());
    }
}

#[test]
fn values_at_zero_and_at_the_ends() {
    let at_zero = [1.0, -1.0 / 3.0, 1.0, 1.0 / 3.0, 1.0, -2.0 / 3.0, 1.0, 2.0 / 3.0];
    for (cardinal, expected) in CARDINALS.iter().zip(at_zero) {
        assert_eq!((cardinal.double)(0.0), expected, "{}", cardinal.name);
        assert!((cardinal.double)(f64::NAN).is_nan() && (cardinal.single)(f32::NAN).is_nan(), "{}", cardinal.name);
    }
    assert_eq!([Real::sinhc(720.0), Real::sinhc_slope(-730.0), Real::sinhc(f64::INFINITY)], [f64::INFINITY; 3]);
    assert_eq!([Real::atanc(f64::INFINITY), Real::atanc_slope(f64::INFINITY).abs()], [0.0; 2]);
    assert_eq!([Real::atanhc(1.0), Real::atanhc_slope(-1.0)], [f64::INFINITY; 2]);
    assert!(Real::atanhc(1.5_f64).is_nan() && Real::atanhc_slope(1.5_f64).is_nan());
}

/// Single precision is the double value rounded once: half an ulp, and a rare tie that falls to the other side.
#[test]
fn single_precision_is_rounded_once() {
    for cardinal in &CARDINALS {
        let (mut worst, mut checked) = (0.0_f64, 0);
        for x in arguments(cardinal, 100) {
            let x = x as f32;
            if f64::from(x) > cardinal.reach || x.is_infinite() {
                continue;
            }
            let value = cardinal.exact.at(&big(x.into()));
            let rounded = value.to_f64().value() as f32;
            if rounded.is_infinite() {
                continue;
            }
            let last_place = f64::from(rounded.abs().next_up() - rounded.abs());
            let error = (big((cardinal.single)(x).into()) - value) / big(last_place);
            worst = worst.max(error.to_f64().value().abs());
            checked += 1;
        }
        println!("{:>12}: {worst:.6} ulp of f32, {checked} arguments", cardinal.name);
        assert!(worst <= 0.5 + 1e-6 && checked > 500, "{}: {worst}", cardinal.name);
    }
}
