//! Conditions on their edge: with x exactly at the threshold and one place before and after it, the lowered law takes the
//! branch that Rust takes. And whole numbers, signs and all, as Rust computes them.

use super::{body, lower_text, value};

/// The threshold and its neighbours, both zeros, and values far from either.
fn around(threshold: f64) -> [f64; 7] {
    [threshold.next_down(), threshold, threshold.next_up(), -0.0, 0.0, -2.0, 3.0]
}

/// Compares a lowered body with what Rust makes of the same text, at all pairs of edges.
fn assert_same_branches(name: &str, text: &str, rust: fn(f64, f64) -> f64) {
    let lowered = lower_text(&body("[f64; 2]", &format!("let [x, y] = q; {text}")));
    let lowered = lowered.unwrap_or_else(|errors| panic!("{name}: {errors:?}"));
    let points: Vec<_> = around(0.5).into_iter().flat_map(|x| around(0.5).map(|y| [x, y])).collect();
    for q in &points {
        let (found, expected) = (value(&lowered, q, 1.0, 0.0, &|_| None), rust(q[0], q[1]));
        assert_eq!(found, expected, "{name} at {q:?}: {text}");
    }
    let first = rust(points[0][0], points[0][1]);
    assert!(points.iter().any(|q| rust(q[0], q[1]) != first), "{name}: always {first}");
}

/// Bodies that are compiled as they stand and lowered from the same tokens.
macro_rules! branches {
    ($($name:ident($x:ident, $y:ident) $body:block)*) => { $(
        #[test]
        #[allow(clippy::all, unused)]
        fn $name() {
            assert_same_branches(stringify!($name), stringify!($body), |$x: f64, $y: f64| $body);
        }
    )* };
}

branches! {
    less(x, y) { if x < 0.5 { 1.0 } else { 2.0 } }
    less_or_equal(x, y) { if x <= 0.5 { 1.0 } else { 2.0 } }
    greater(x, y) { if x > 0.5 { 1.0 } else { 2.0 } }
    greater_or_equal(x, y) { if x >= 0.5 { 1.0 } else { 2.0 } }
    equal(x, y) { if x == 0.5 { 1.0 } else { 2.0 } }
    unequal(x, y) { if x != 0.5 { 1.0 } else { 2.0 } }
    less_than_another(x, y) { if x < y { 1.0 } else { 2.0 } }
    at_most_another(x, y) { if x <= y { 1.0 } else { 2.0 } }
    more_than_another(x, y) { if x > y { 1.0 } else { 2.0 } }
    at_least_another(x, y) { if x >= y { 1.0 } else { 2.0 } }
    equal_to_another(x, y) { if x == y { 1.0 } else { 2.0 } }
    not_equal_to_another(x, y) { if x != y { 1.0 } else { 2.0 } }
    the_constant_first(x, y) {
        (if 0.5 < x { 1.0 } else { 0.0 }) + (if 0.5 <= x { 2.0 } else { 0.0 }) + (if 0.5 > x { 4.0 } else { 0.0 })
            + (if 0.5 >= x { 8.0 } else { 0.0 })
    }
    zeros_of_both_signs(x, y) {
        (if x < 0.0 { 1.0 } else { 0.0 }) + (if x <= 0.0 { 2.0 } else { 0.0 }) + (if x > -0.0 { 4.0 } else { 0.0 })
            + (if x == 0.0 { 8.0 } else { 0.0 })
    }
    negated(x, y) {
        (if !(x < 0.5) { 1.0 } else { 0.0 }) + (if !(x <= 0.5) { 2.0 } else { 0.0 }) + (if !(x > 0.5) { 4.0 } else { 0.0 })
            + (if !(x >= 0.5) { 8.0 } else { 0.0 }) + (if !(x == 0.5) { 16.0 } else { 0.0 })
            + (if !!(x != 0.5) { 32.0 } else { 0.0 })
    }
    both(x, y) { if x > 0.5 && y <= 0.5 { 1.0 } else { 2.0 } }
    either(x, y) { if x > 0.5 || y <= 0.5 { 1.0 } else { 2.0 } }
    neither(x, y) { if !(x > 0.5 || y <= 0.5) { 1.0 } else { 2.0 } }
    not_both(x, y) { if !(x > 0.5 && y <= 0.5) { 1.0 } else { 2.0 } }
    both_before_either(x, y) { if x < 0.5 || y < 0.5 && x >= y { 1.0 } else { 2.0 } }
    either_in_both(x, y) { if (x < 0.5 || y < 0.5) && x >= y { 1.0 } else { 2.0 } }
    nested(x, y) { if x >= 0.5 { if y > x { 1.0 } else { 2.0 } } else if y <= 0.0 { 3.0 } else { 4.0 } }
    least_and_greatest(x, y) { x.min(0.5) + 3.0 * x.max(y) + 7.0 * y.clamp(0.0, 0.5) + 11.0 * (x - 0.5).abs() }

    // Ranges: each form, with ends that are known and that are not, negated, joined, and of no number at all.
    within_a_range(x, y) { if (0.0..0.5).contains(&x) { 1.0 } else { 2.0 } }
    within_a_closed_range(x, y) { if (0.0..=0.5).contains(&x) { 1.0 } else { 2.0 } }
    within_a_range_from(x, y) { if (0.5..).contains(&x) { 1.0 } else { 2.0 } }
    within_a_range_to(x, y) { if (..0.5).contains(&x) { 1.0 } else { 2.0 } }
    within_a_closed_range_to(x, y) { if (..=0.5).contains(&x) { 1.0 } else { 2.0 } }
    beside_a_range(x, y) { if !(0.0..=0.5).contains(&x) { 1.0 } else { 2.0 } }
    within_another(x, y) { if (y..=0.5).contains(&x) { 1.0 } else { 2.0 } }
    within_turned_round(x, y) { if (0.5..y).contains(&x) { 1.0 } else { if (0.5..=y).contains(&x) { 2.0 } else { 3.0 } } }
    within_two_ranges(x, y) { if (0.0..0.5).contains(&x) && (0.0..=0.5).contains(&y) { 1.0 } else { 2.0 } }
    a_range_of_computed_ends(x, y) { let c = (x - 1.0..=x + 0.5).contains(&(2.0 * y)); if c { 1.0 } else { 2.0 } }
    a_range_that_is_known(x, y) {
        (if (0.0..0.5).contains(&0.5) { 1.0 } else { 2.0 }) + (if (0.0..=0.5).contains(&0.5) { 4.0 } else { 8.0 })
            + (if (0.5..=0.0).contains(&0.25) { 16.0 } else { 32.0 }) + (if (0.5..).contains(&0.5) { 64.0 } else { 128.0 })
            + (if (1.0..x).contains(&0.5) { 256.0 } else { 512.0 }) + (if (x..0.5).contains(&1.0) { 1024.0 } else { 2048.0 })
            + (if (0.0..x).contains(&0.5) { 4096.0 } else { 8192.0 })
    }

    // A condition joined with one that is known: each way round, both values.
    or_true(x, y) { (if x > 0.5 || true { 1.0 } else { 2.0 }) + (if true || x > 0.5 { 4.0 } else { 8.0 }) + x }
    or_false(x, y) { (if x > 0.5 || false { 1.0 } else { 2.0 }) + (if false || x > 0.5 { 4.0 } else { 8.0 }) }
    and_true(x, y) { (if x > 0.5 && true { 1.0 } else { 2.0 }) + (if true && x > 0.5 { 4.0 } else { 8.0 }) }
    and_false(x, y) { (if x > 0.5 && false { 1.0 } else { 2.0 }) + (if false && x > 0.5 { 4.0 } else { 8.0 }) + x }
    known_with_known(x, y) {
        (if false || false { 1.0 } else { 2.0 }) + (if false || true { 4.0 } else { 8.0 })
            + (if true || false { 16.0 } else { 32.0 }) + (if true || true { 64.0 } else { 128.0 })
            + (if false && false { 256.0 } else { 512.0 }) + (if false && true { 1024.0 } else { 2048.0 })
            + (if true && false { 4096.0 } else { 8192.0 }) + (if true && true { 16384.0 } else { 32768.0 })
            + (if !true { 65536.0 } else { 131072.0 }) + (if !false { 262144.0 } else { 524288.0 }) + x
    }
    numbers_that_are_known(x, y) {
        (if 2.0 < 2.0 { 1.0 } else { 2.0 }) + (if 2.0 <= 2.0 { 4.0 } else { 8.0 }) + (if 2.0 > 2.0 { 16.0 } else { 32.0 })
            + (if 2.0 >= 2.0 { 64.0 } else { 128.0 }) + (if 2.0 == 2.0 { 256.0 } else { 512.0 })
            + (if 2.0 != 2.0 { 1024.0 } else { 2048.0 }) + x
    }

    // What a variable holds after branches that set it: every pair of a known and an unknown truth.
    set_true_or_false(x, y) { let c = if x > 0.5 { true } else { false }; if c { 1.0 } else { 2.0 } }
    set_false_or_true(x, y) { let c = if x > 0.5 { false } else { true }; if c { 1.0 } else { 2.0 } }
    set_true_in_both(x, y) { let c = if x > 0.5 { true } else { true }; if c { x } else { 2.0 } }
    set_false_in_both(x, y) { let c = if x > 0.5 { false } else { false }; if c { 1.0 } else { x } }
    set_true_or_a_condition(x, y) { let c = if x > 0.5 { true } else { y > 0.5 }; if c { 1.0 } else { 2.0 } }
    set_false_or_a_condition(x, y) { let c = if x > 0.5 { false } else { y > 0.5 }; if c { 1.0 } else { 2.0 } }
    set_a_condition_or_true(x, y) { let c = if x > 0.5 { y > 0.5 } else { true }; if c { 1.0 } else { 2.0 } }
    set_a_condition_or_false(x, y) { let c = if x > 0.5 { y > 0.5 } else { false }; if c { 1.0 } else { 2.0 } }
    set_to_two_conditions(x, y) { let c = if x > 0.5 { y > 0.5 } else { y < 0.0 }; if c { 1.0 } else { 2.0 } }
    kept_through_many_branches(x, y) {
        let (a, b) = (x > 0.5, y >= 0.5);
        (if a { 1.0 } else { 2.0 }) + (if b { 4.0 } else { 8.0 }) + (if a { 16.0 } else { 32.0 })
            + (if b { 64.0 } else { 128.0 }) + (if a { 256.0 } else { 512.0 }) + (if b { 1024.0 } else { 2048.0 })
            + (if a && b { 4096.0 } else { 8192.0 })
    }
    set_on_the_way(x, y) {
        let mut near = y > 0.5;
        if x > 0.5 { near = false; }
        let mut far = x < 0.0;
        if y >= 0.5 { far = true; } else { far = far && y < 0.0; }
        let mut side = true;
        if x == y { side = near; }
        (if near { 1.0 } else { 2.0 }) + (if far { 4.0 } else { 8.0 }) + (if side { 16.0 } else { 32.0 })
    }
    truths_compared(x, y) {
        (if true == false { 1.0 } else { 2.0 }) + (if true != false { 4.0 } else { 8.0 })
            + (if false < true { 16.0 } else { 32.0 }) + (if true <= true { 64.0 } else { 128.0 }) + x
    }
}

/// Whole numbers, as `i64` in Rust and as the lowered law has them.
/// No number lies within no range, and a range whose end is none has nothing in it.
#[test]
fn no_number_lies_in_a_range() {
    fn check(text: &str, rust: fn(f64, f64) -> f64) {
        let lowered = lower_text(&body("[f64; 2]", &format!("let [x, y] = q; {text}"))).unwrap();
        let numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.25];
        for q in numbers.into_iter().flat_map(|x| numbers.map(|y| [x, y])) {
            assert_eq!(value(&lowered, &q, 1.0, 0.0, &|_| None), rust(q[0], q[1]), "{text} at {q:?}");
        }
    }
    macro_rules! check {
        ($($range:expr, $x:ident, $y:ident;)*) => { $(
            check(
                concat!("if ", stringify!($range), ".contains(&x) { 1.0 } else { 2.0 }"),
                |$x, $y| if $range.contains(&$x) { 1.0 } else { 2.0 },
            );
            check(
                concat!("if !", stringify!($range), ".contains(&x) { 1.0 } else { 2.0 }"),
                |$x, $y| if !$range.contains(&$x) { 1.0 } else { 2.0 },
            );
        )* };
    }
    check! {
        (0.0..1.0), x, _y;
        (0.0..=1.0), x, _y;
        (0.0..), x, _y;
        (..1.0), x, _y;
        (..=1.0), x, _y;
        (y..1.0), x, y;
        (0.0..=y), x, y;
    }
}

macro_rules! whole_numbers {
    ($($e:expr),* $(,)?) => { [$((stringify!($e), $e as i64)),*] };
}

#[test]
#[allow(clippy::all)]
fn integers_are_those_of_rust() {
    let expressions = whole_numbers![
        7 % 3,
        -7 % 3,
        7 % -3,
        -7 % -3,
        7 / 2,
        -7 / 2,
        7 / -2,
        -7 / -2,
        7 - 9,
        3 * -4,
        7_i64.rem_euclid(3),
        (-7_i64).rem_euclid(3),
        7_i64.rem_euclid(-3),
        (-7_i64).rem_euclid(-3),
        7_i64.abs_diff(3),
        3_i64.abs_diff(7),
        (-7_i64).abs_diff(3),
        (-3_i64).abs_diff(-7),
        7_i64.max(3),
        3_i64.max(7),
        (-7_i64).max(-3),
        7_i64.min(3),
        3_i64.min(7),
        (-7_i64).min(-3),
        7_i64.signum(),
        0_i64.signum(),
        (-7_i64).signum(),
        7_i64.abs(),
        (-7_i64).abs(),
        2_i64.pow(5),
        (-2_i64).pow(3),
        (1..5).sum::<i64>(),
        (1..=5).product::<i64>(),
        [4, 5, 6].len(),
        if 3 < 3 { 1 } else { 2 },
        if 3 <= 3 { 1 } else { 2 },
        if 3 > 3 { 1 } else { 2 },
        if 3 >= 3 { 1 } else { 2 },
        if 3 == 3 { 1 } else { 2 },
        if 3 != 3 { 1 } else { 2 },
        if (0..3).contains(&3) { 1 } else { 2 },
        if (0..=3).contains(&3) { 1 } else { 2 },
        if (-1..).contains(&-1) { 1 } else { 2 },
        if (..3).contains(&3) { 1 } else { 2 },
    ];
    let mut wrong = vec![];
    for (text, rust) in expressions {
        let lowered = lower_text(&body("f64", &format!("let n = {text}; q + n as f64")));
        let lowered = lowered.unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        let found = value(&lowered, &[0.0], 1.0, 0.0, &|_| None);
        if found != rust as f64 {
            wrong.push(format!("{text} is {rust}, not {found}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
