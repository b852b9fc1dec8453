//! Every lane of an operation on `Lanes` is the `f64` operation on that lane, to the bit.

use dmech_scalar::{Lanes, LanesMask, Mask, Real, Rows};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Zeros, subnormals, the ends of the range, what is not a number, and where the functions change their form or sign.
fn hard() -> Vec<f64> {
    let positive = [
        0.0,
        f64::from_bits(1),
        1e-310,
        f64::MIN_POSITIVE,
        1e-200,
        1e-16,
        0.25,
        0.7,
        FRAC_PI_4.next_down(),
        FRAC_PI_4,
        FRAC_PI_4.next_up(),
        0.8,
        1.0_f64.next_down(),
        1.0,
        1.0_f64.next_up(),
        1.25,
        FRAC_PI_2,
        2.0,
        3.0,
        PI,
        4.493409457909064,
        17.3,
        700.5,
        709.9,
        720.0,
        745.2,
        1e16,
        1e100,
        1.5e154,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    positive.iter().flat_map(|&x| [x, -x]).collect()
}

/// Equal to the bit; every NaN is the same NaN.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

type Unary = (&'static str, fn(Lanes) -> Lanes, fn(f64) -> f64);
type Binary = (&'static str, fn(Lanes, Lanes) -> Lanes, fn(f64, f64) -> f64);
type Comparison = (&'static str, fn(Lanes, Lanes) -> LanesMask, fn(f64, f64) -> bool);

macro_rules! unary {
    ($($name:ident)*) => { [$((stringify!($name), <Lanes as Real>::$name, <f64 as Real>::$name)),*] };
}

const UNARY: [Unary; 35] = unary! {
    recip abs signum round floor trunc sqrt cbrt exp exp2 exp_m1 ln ln_1p log2 log10 sin cos tan asin acos atan sinh cosh tanh asinh acosh
    atanh sinc sinc_slope sinhc sinhc_slope atanc atanc_slope atanhc atanhc_slope
};

const BINARY: [Binary; 13] = [
    ("negated", |a, _| -a, |a, _| -a),
    ("+", |a, b| a + b, |a, b| a + b),
    ("-", |a, b| a - b, |a, b| a - b),
    ("×", |a, b| a * b, |a, b| a * b),
    ("÷", |a, b| a / b, |a, b| a / b),
    ("+=", |a, b| assigned(a, |x| *x += b), |a, b| a + b),
    ("-=", |a, b| assigned(a, |x| *x -= b), |a, b| a - b),
    ("×=", |a, b| assigned(a, |x| *x *= b), |a, b| a * b),
    ("÷=", |a, b| assigned(a, |x| *x /= b), |a, b| a / b),
    ("min", Real::min, Real::min),
    ("max", Real::max, Real::max),
    ("powf", Real::powf, Real::powf),
    ("atan2", Real::atan2, Real::atan2),
];

const COMPARISONS: [Comparison; 3] = [
    ("less", Real::less, Real::less),
    ("less_or_equal", Real::less_or_equal, Real::less_or_equal),
    ("equal", Real::equal, Real::equal),
];

fn assigned(mut x: Lanes, change: impl Fn(&mut Lanes)) -> Lanes {
    change(&mut x);
    x
}

/// All laws of the trait on eight triples at once.
fn check(a: [f64; 8], b: [f64; 8], c: [f64; 8]) {
    let (x, y, z) = (Lanes::from_array(a), Lanes::from_array(b), Lanes::from_array(c));
    for (name, lanes, single) in UNARY {
        let result = lanes(x).to_array();
        for i in 0..8 {
            let expected = single(a[i]);
            assert!(same(result[i], expected), "{name} {:e}: {:e}, not {expected:e}", a[i], result[i]);
        }
    }
    for (name, lanes, single) in BINARY {
        let result = lanes(x, y).to_array();
        for i in 0..8 {
            let expected = single(a[i], b[i]);
            assert!(same(result[i], expected), "{:e} {name} {:e}: {:e}, not {expected:e}", a[i], b[i], result[i]);
        }
    }
    for (name, lanes, single) in COMPARISONS {
        let mask = lanes(x, y);
        let expected: [bool; 8] = std::array::from_fn(|i| single(a[i], b[i]));
        assert_eq!(mask.to_array(), expected, "{name} {a:?} {b:?}");
        let chosen = Lanes::select(mask, || y, || z).to_array();
        let expected: [f64; 8] = std::array::from_fn(|i| if expected[i] { b[i] } else { c[i] });
        assert!((0..8).all(|i| same(chosen[i], expected[i])), "{chosen:?}, not {expected:?}");
    }
    assert_eq!(x.finite().to_array(), a.map(f64::is_finite));
    let fused = x.mul_add(y, z).to_array();
    for i in 0..8 {
        let expected = Real::mul_add(a[i], b[i], c[i]);
        assert!(same(fused[i], expected), "{:e} × {:e} + {:e}: {:e}, not {expected:e}", a[i], b[i], c[i], fused[i]);
    }
}

/// Every pair of hard arguments, each with several third ones, every argument in every lane.
#[test]
fn hard_arguments() {
    let hard = hard();
    let n = hard.len();
    for first in 0..n {
        for shift in 0..n {
            let a = std::array::from_fn(|i| hard[(first + i) % n]);
            let b = std::array::from_fn(|i| hard[(first + i + shift) % n]);
            let c = std::array::from_fn(|i| hard[(7 * (first + i) + 3 * shift) % n]);
            check(a, b, c);
        }
    }
}

fn assert_for(numbers: impl Strategy<Value = f64> + Clone) {
    let eight = || prop::array::uniform8(numbers.clone());
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(3_000) });
    runner
        .run(&(eight(), eight(), eight()), |(a, b, c)| {
            check(a, b, c);
            Ok(())
        })
        .unwrap();
}

#[test]
fn any_bits() {
    assert_for(any::<u64>().prop_map(f64::from_bits));
}

/// Where the functions are neither 0 nor infinite, and a product is of the size of what is added to it.
#[test]
fn moderate_arguments() {
    assert_for(-9.0..9.0);
    assert_for(-1.0..1.0);
}

/// Seven everyday arguments, and one that takes a longer way: none of the seven may notice.
#[test]
fn one_lane_out_of_the_ordinary() {
    let hard = hard();
    for reach in [0.7, 2.0, 40.0, 720.0, 1e5, 1e18] {
        let numbers = prop::array::uniform8(-reach..reach);
        let strategy = (numbers.clone(), numbers.clone(), numbers, 0..8_usize, 0..hard.len(), 0..hard.len());
        let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(3_000) });
        runner
            .run(&strategy, |(mut a, mut b, c, lane, first, second)| {
                (a[lane], b[lane]) = (hard[first], hard[second]);
                check(a, b, c);
                check(a.map(f64::abs), b, c);
                Ok(())
            })
            .unwrap();
    }
}

/// Angles within π/4 of 0 take a way of their own where all are: seven of them, and one at either end of that way or beyond
/// it, in each lane.
#[test]
fn small_angles_beside_one_that_is_not() {
    let hard = hard();
    let small: Vec<f64> = hard.iter().copied().filter(|x| x.abs() < FRAC_PI_4).collect();
    assert!(small.len() > 12 && [1.0, -1.0].iter().all(|sign| small.contains(&(sign * FRAC_PI_4.next_down()))));
    for (n, &other) in hard.iter().enumerate() {
        for lane in 0..8 {
            let x = std::array::from_fn(|i| if i == lane { other } else { small[(n + 5 * i) % small.len()] });
            check(x, x, x);
        }
    }
}

#[test]
fn powers() {
    let hard = hard();
    for n in (-40..40).chain([i32::MIN, i32::MIN + 1, -1075, -1023, 1000, 1023, i32::MAX]) {
        for eight in hard.chunks_exact(8).chain([[1.1, -1.1, 0.9, -0.9, 1.0 + 1e-9, 1.7, -2.3, 0.31].as_slice()]) {
            let result = Lanes::from_slice(eight).powi(n).to_array();
            for (&x, result) in eight.iter().zip(result) {
                let expected = Real::powi(x, n);
                assert!(same(result, expected), "{x:e}^{n}: {result:e}, not {expected:e}");
            }
        }
    }
}

/// Two lanes that disagree, in every one of the 256 ways to distribute them.
#[test]
fn masks() {
    let mask = |bits: u32| Lanes::from_fn(|i| f64::from(bits >> i & 1)).less(Lanes::splat(0.5));
    for bits in 0..256 {
        let (a, b) = (mask(bits), mask(bits.wrapping_mul(0x9d) ^ 0x35));
        let (p, q) = (a.to_array(), b.to_array());
        assert_eq!(p, std::array::from_fn(|i| bits >> i & 1 == 0));
        assert_eq!(Mask::not(a).to_array(), p.map(|p| !p));
        assert_eq!(a.and(b).to_array(), std::array::from_fn(|i| p[i] && q[i]));
        assert_eq!(a.or(b).to_array(), std::array::from_fn(|i| p[i] || q[i]));
        assert_eq!((a.all(), a.any()), (bits == 0, bits != 255));
    }
}

#[test]
fn both_sides_of_a_choice_are_evaluated() {
    let (mut yes, mut no) = (0, 0);
    let everywhere = Lanes::ONE.less(Lanes::splat(2.0));
    let chosen = Lanes::select(
        everywhere,
        || {
            yes += 1;
            Lanes::ONE
        },
        || {
            no += 1;
            Lanes::splat(f64::NAN)
        },
    );
    assert_eq!((yes, no, chosen), (1, 1, Lanes::ONE));
}

/// a₀ … a₇ in memory is lane 0 … lane 7, whichever way it gets there.
#[test]
fn loading_and_storing() {
    let numbers: Vec<f64> = (0..11).map(|i| 1.3 * f64::from(i) - 0.7).collect();
    let lanes = Lanes::from_slice(&numbers[2..]);
    assert_eq!(lanes, Lanes::from_fn(|i| numbers[i + 2]));
    assert_eq!(lanes, Lanes::from(<[f64; 8]>::from(lanes)));
    assert_eq!((lanes.to_f64(), Lanes::from_f64(-3.5).to_array()), (numbers[2], [-3.5; 8]));
    assert_eq!((Lanes::COUNT, Lanes::default(), Lanes::EPSILON), (8, Lanes::ZERO, Lanes::splat(f64::EPSILON)));

    let mut one_changed = lanes;
    one_changed[5] += 100.0;
    assert_eq!(one_changed, Lanes::from_fn(|i| numbers[i + 2] + if i == 5 { 100.0 } else { 0.0 }));
    assert!((0..8).all(|i| lanes[i] == numbers[i + 2]));

    let mut stored = [9.0; 11];
    lanes.store(&mut stored[1..]);
    assert_eq!((stored[0], &stored[1..9], &stored[9..]), (9.0, &numbers[2..10], &[9.0, 9.0][..]));
    assert_eq!(format!("{:.1}", Lanes::from_fn(|i| i as f64)), "[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]");
    assert_eq!(format!("{lanes:?}"), format!("{:?}", &numbers[2..10]));
}

/// Wherever it stands, with neighbours of either sign.
#[test]
fn the_largest_lane() {
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(2_000) });
    runner
        .run(&(prop::array::uniform8(-1e3..1e3), 0..8_usize), |(mut x, lane)| {
            prop_assert_eq!(Lanes::from_array(x).largest_number(), x.into_iter().fold(f64::MIN, f64::max));
            x[lane] = 2e3;
            prop_assert_eq!(Lanes::from_array(x).largest_number(), 2e3);
            x[lane] = f64::INFINITY;
            prop_assert_eq!(Lanes::from_array(x).largest_number(), f64::INFINITY);
            Ok(())
        })
        .unwrap();
}

/// Numbers of very different size: another order of summation gives another sum.
#[test]
fn the_sum_has_a_fixed_order() {
    let differs = Cell::new(0);
    let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(2_000) });
    runner
        .run(&prop::array::uniform8(-1e3..1e3), |x| {
            let sum = ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
            prop_assert_eq!(Lanes::from_array(x).sum().to_bits(), sum.to_bits());
            differs.set(differs.get() + u32::from(sum != x.iter().sum()));
            Ok(())
        })
        .unwrap();
    assert!(differs.get() > 500, "{differs:?}");
}

/// Those for whom the mask does not hold have the number of the first for whom it does, in one row and in several.
#[test]
fn numbers_are_lent_by_the_first_for_whom_it_holds() {
    fn check<const N: usize>() {
        let numbers = Rows::<N>::from_fn(|lane| 1.5 + lane as f64);
        for first in 0..Rows::<N>::COUNT {
            let holds = |lane: usize| lane == first || lane > first && lane % 3 == 1;
            let by = Rows::<N>::from_fn(|lane| f64::from(holds(lane))).equal(Rows::ONE);
            let lent = numbers.lent(by);
            for lane in 0..Rows::<N>::COUNT {
                assert_eq!(lent[lane], numbers[if holds(lane) { lane } else { first }], "{lane} of {N} rows");
            }
            if N == 1 {
                let lanes = Lanes::from_fn(|lane| numbers[lane]);
                let by = Lanes::from_fn(|lane| f64::from(holds(lane))).equal(Lanes::ONE);
                assert!((0..8).all(|lane| lanes.lent(by)[lane] == lent[lane]));
            }
        }
        let nobody = Rows::<N>::ONE.less(Rows::ZERO);
        assert_eq!(numbers.lent(nobody).to_f64(), 1.5);
        assert!(numbers.lent(nobody).equal(numbers).all());
    }
    check::<1>();
    check::<2>();
    check::<4>();
    assert_eq!((1.5_f64.lent(true), 1.5_f64.lent(false)), (1.5, 1.5));
}
