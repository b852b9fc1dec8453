//! Conditions through the real macro, with the argument exactly at the threshold and one place before and after: the
//! generated potential is the user's own method to the bit, and the gradient that of the branch that is taken.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use dmech::prelude::*;

const EDGE: f64 = 0.5;

/// The threshold, its neighbours, both zeros, and values far from either.
fn around() -> [f64; 7] {
    [EDGE.next_down(), EDGE, EDGE.next_up(), -0.0, 0.0, -2.0, 3.0]
}

/// Laws of two coordinates that add a slope of their own in each branch: the potential bends or jumps at the edge, and the
/// gradient tells which branch was taken.
macro_rules! edges {
    ($($test:ident: $law:ident($x:ident, $y:ident, $edge:ident) $condition:expr;)*) => {$(
        struct $law {
            edge: f64,
        }

        #[dmech::law]
        #[allow(clippy::nonminimal_bool, clippy::overly_complex_bool_expr)]
        impl $law {
            #[potential]
            fn energy(&self, q: [f64; 2]) -> f64 {
                let [$x, $y] = q;
                let $edge = self.edge;
                if $condition { 2.0 * $x + 8.0 * $y } else { 4.0 * $x + 16.0 * $y }
            }
        }

        #[test]
        fn $test() {
            let (law, $edge) = ($law { edge: EDGE }, EDGE);
            let mut taken = [0, 0];
            for $x in around() {
                for $y in around() {
                    let q = [$x, $y];
                    assert_eq!(law.potential(q), law.energy(q), "{} at {q:?}", stringify!($condition));
                    #[allow(clippy::nonminimal_bool, clippy::overly_complex_bool_expr)]
                    let holds = $condition;
                    taken[usize::from(holds)] += 1;
                    let slope = if holds { [2.0, 8.0] } else { [4.0, 16.0] };
                    assert_eq!(law.gradient(q), slope, "{} at {q:?}", stringify!($condition));
                    assert_eq!(law.hessian(q), [[0.0; 2]; 2]);
                    assert_eq!(law.discrete_gradient(q, q), slope, "{} at {q:?}", stringify!($condition));
                }
            }
            assert!(taken[0] > 0 && taken[1] > 0, "{}: {taken:?}", stringify!($condition));
        }
    )*};
}

edges! {
    less: Less(x, y, edge) x < edge;
    less_or_equal: LessOrEqual(x, y, edge) x <= edge;
    greater: Greater(x, y, edge) x > edge;
    greater_or_equal: GreaterOrEqual(x, y, edge) x >= edge;
    range: Range(x, y, edge) (0.0..edge).contains(&x);
    closed_range: ClosedRange(x, y, edge) (0.0..=edge).contains(&x);
    range_from: RangeFrom(x, y, edge) (edge..).contains(&x);
    range_to: RangeTo(x, y, edge) (..edge).contains(&x);
    closed_range_to: ClosedRangeTo(x, y, edge) (..=edge).contains(&x);
    beside_a_range: BesideARange(x, y, edge) !(0.0..=edge).contains(&x);
    between_others: BetweenOthers(x, y, edge) (-edge..=y).contains(&(x - edge));
    equal: Equal(x, y, edge) x == edge;
    unequal: Unequal(x, y, edge) x != edge;
    less_than_zero: LessThanZero(x, y, _edge) x < 0.0;
    at_most_zero: AtMostZero(x, y, _edge) x <= 0.0;
    more_than_zero: MoreThanZero(x, y, _edge) x > 0.0;
    at_least_zero: AtLeastZero(x, y, _edge) x >= 0.0;
    less_than_another: LessThanAnother(x, y, _edge) x < y;
    at_most_another: AtMostAnother(x, y, _edge) x <= y;
    not_less: NotLess(x, y, edge) !(x < edge);
    not_at_most: NotAtMost(x, y, edge) !(x <= edge);
    not_equal: NotEqual(x, y, edge) !(x == edge);
    both: Both(x, y, edge) x >= edge && y <= edge;
    either: Either(x, y, edge) x > edge || y < edge;
    neither: Neither(x, y, edge) !(x > edge || y < edge);
    not_both: NotBoth(x, y, edge) !(x >= edge && y <= edge);
    and_before_or: AndBeforeOr(x, y, edge) x < edge || y < edge && x >= y;
    or_before_and: OrBeforeAnd(x, y, edge) (x < edge || y < edge) && x >= y;
    with_constants: WithConstants(x, y, edge) (x > edge || 1.0 > 2.0) && !(false || y > edge && true);
}

/// What variables hold after branches that set them, by every pair of a known and an unknown truth.
struct Merged {
    edge: f64,
}

#[dmech::law]
#[allow(clippy::needless_bool)]
impl Merged {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        let (right, above) = (x > self.edge, y >= self.edge);
        let either = if right { true } else { above };
        let only_above = if right { false } else { above };
        let not_only_right = if right { above } else { true };
        let both = if right { above } else { false };
        let same = if right { above } else { y < self.edge };
        let left = if right { false } else { true };
        let mut near = above;
        if right {
            near = x <= 1.0;
        }
        let weigh = [either, only_above, not_only_right, both, same, left, near];
        let mut sum = x;
        if weigh[0] {
            sum += 1.0;
        }
        if weigh[1] {
            sum += 2.0;
        }
        if weigh[2] {
            sum += 4.0;
        }
        if weigh[3] {
            sum += 8.0;
        }
        if weigh[4] {
            sum += 16.0;
        }
        if weigh[5] {
            sum += 32.0;
        }
        if weigh[6] {
            sum += 64.0;
        }
        sum
    }
}

#[test]
fn merged_conditions() {
    let law = Merged { edge: EDGE };
    for x in around() {
        for y in around() {
            let (declared, generated) = (law.energy([x, y]), law.potential([x, y]));
            assert!((generated - declared).abs() < 1e-12, "{generated} for {declared} at {x}, {y}");
        }
    }
}

/// The functions that choose, on the edge of their choice.
struct Choosing {
    k: f64,
}

#[dmech::law]
impl Choosing {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        self.k * x.min(0.5) + 4.0 * x.max(y) + 16.0 * y.clamp(0.0, 0.5) + 64.0 * (x - 0.5).abs() + 256.0 * y.max(0.5)
    }
}

#[test]
fn functions_that_choose() {
    let law = Choosing { k: 1.0 };
    for x in around() {
        for y in around() {
            let (declared, generated) = (law.energy([x, y]), law.potential([x, y]));
            assert!((generated - declared).abs() < 1e-12, "{generated} for {declared} at {x}, {y}");
        }
    }
}

/// Between two walls: the same law in both spellings.
#[derive(Clone, Copy, Debug)]
struct Trough {
    low: f64,
    high: f64,
}

#[derive(Clone, Copy, Debug)]
struct ByComparisons {
    low: f64,
    high: f64,
}

#[dmech::law]
impl Trough {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        let wall = if (self.low..=self.high).contains(&x) { 0.0 } else { (x - self.low) * (x - self.high) };
        wall * wall.abs() + 0.5 * y * y * (1.0 + x * x)
    }
}

#[dmech::law]
#[allow(clippy::manual_range_contains)]
impl ByComparisons {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        let wall = if self.low <= x && x <= self.high { 0.0 } else { (x - self.low) * (x - self.high) };
        wall * wall.abs() + 0.5 * y * y * (1.0 + x * x)
    }
}

#[test]
fn a_range_is_what_its_comparisons_are() {
    let (range, other) = (Trough { low: -0.5, high: 1.0 }, ByComparisons { low: -0.5, high: 1.0 });
    let places = [-2.0, -0.5_f64.next_up(), -0.5, 0.3, 1.0, 1.0_f64.next_up(), 4.0, f64::NAN];
    let mut taken = [0, 0];
    for a in places.into_iter().flat_map(|x| [[x, 0.7], [x, -1.1]]) {
        taken[usize::from(a[0] < -0.5 || a[0] > 1.0)] += 1;
        let bits = |q: [f64; 2]| q.map(f64::to_bits);
        assert_eq!(range.potential(a).to_bits(), range.energy(a).to_bits());
        assert_eq!(range.potential(a).to_bits(), other.potential(a).to_bits());
        assert_eq!(bits(range.gradient(a)), bits(other.gradient(a)));
        assert_eq!(range.hessian(a).map(bits), other.hessian(a).map(bits));
        for b in places.map(|x| [x, 0.4]) {
            assert_eq!(bits(range.discrete_gradient(a, b)), bits(other.discrete_gradient(a, b)), "{a:?} {b:?}");
        }
    }
    assert!(taken[0] > 4 && taken[1] > 4);
    assert!(range.derivation() == other.derivation().replace("ByComparisons", "Trough"), "{}", range.derivation());
    verify(range, State::new([0.3, 0.7], [0.9, 0.2])).assert();
}
