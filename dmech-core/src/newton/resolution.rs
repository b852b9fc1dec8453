//! Whether what is left of an equation is rounding, told by how its force changes.
//!
//! Forces that cancel, as those that hold a body at rest, and forces with a quotient that cancels are known to many more roundings than
//! their own size tells, and no number in the equation says to how many. It shows along a line: far out such a force changes as its Jacobian
//! says, and nearby it does not, however near one looks: it stands still, or jumps by more. What is smooth does so the better the nearer one
//! looks, what bends or jumps by itself does so on one side at least, and what has a wrong Jacobian does so nowhere.

/// Corrections to where they no longer shrink.
pub(crate) const PATIENCE: usize = 8;

/// By how much of itself a change may be another than foreseen.
const OFF: f64 = 1.0 / 1024.0;
/// What is nearby, in units of the last correction: powers of 4.
const NEARBY: core::ops::RangeInclusive<i32> = -8..=-3;
/// Where the force is off by this part, at least, of what the last correction changes in it: a root is known nearly as well as the force.
const SHOWS: f64 = 1.0 / 64.0;
/// And what is far out: of 8. What dies away moves by less and less beside what its position is added to.
const FAR: core::ops::RangeInclusive<i32> = 1..=319;

/// How long the correction may be that led nowhere, in units of the distance from which on the force is known.
const WITHIN: f64 = 524_288.0;
/// So many roundings of a position are seen in it.
const SEEN: f64 = 64.0;

/// What is known of a last correction δ of a root.
pub(crate) struct Last {
    /// Its length.
    pub(crate) length: f64,
    /// The length of one that led no nearer, from the guess or on the way from a shorter step.
    pub(crate) astray: f64,
    /// The rounding of the position.
    pub(crate) rounding: f64,
}

/// The part of a correction to take for the last, where nothing is left by one form of the equation: what was left before tells no length, and
/// the correction that by the other form led nowhere does.
pub(crate) fn shorter(length: f64, astray: f64) -> f64 {
    if 0.0 < astray && astray < length { astray / length } else { 1.0 }
}

/// Where the force is not known: what stands still does so for long where other forces move the body.
fn beside(known_from: f64) -> impl Iterator<Item = f64> {
    let near = [1.0, 2.0, 4.0].into_iter();
    near.chain(FAR.map(|k| 8.0_f64.powi(k)).take_while(move |&s| s <= known_from))
}

impl Last {
    /// Whether the force is not known as well as to this. `off`(s) says by how much of itself its change from there to s δ further is
    /// another than its Jacobian foresees.
    ///
    /// A correction that is longer by far than what is not known has led elsewhere.
    pub(crate) fn is_rounding(&self, mut off: impl FnMut(f64) -> f64) -> bool {
        let foreseen = |off: f64| off <= OFF;
        let mut nearby = NEARBY.map(|k| 4.0_f64.powi(k)).filter(|s| s * self.length >= SEEN * self.rounding);
        if nearby.any(|s| foreseen(off(s)) || foreseen(off(-s))) {
            return false;
        }
        // Twice, as one may be by chance.
        let known_from = FAR.map(|k| 8.0_f64.powi(k)).find(|&s| foreseen(off(s)) && foreseen(off(8.0 * s)));
        let Some(known_from) = known_from.filter(|s| self.astray <= WITHIN * s * self.length) else {
            return false;
        };
        let mut shows = |s: f64| off(s) * s.abs() >= SHOWS;
        beside(known_from).any(|s| shows(s) || shows(-s))
    }
}

/// What is nearby of a change that may be a large one, in units of it: powers of 4.
const NEARER: core::ops::RangeInclusive<i32> = -40..=-2;
/// How much nearer a sweep must come, at least.
const CONTRACTS: f64 = 0.9;

/// What is known of a last change δ of sweeps.
pub(crate) struct Swept {
    /// Its length.
    pub(crate) length: f64,
    /// What the rounding of a position makes of a change.
    pub(crate) rounding: f64,
}

impl Swept {
    /// Whether the force is not known as well as to this, where no Jacobian says how it changes. `change`(s) is what the next sweep makes
    /// of s δ, and `length`(x, c, y) is |x + c y|.
    ///
    /// What is smooth is in proportion to s where one looks near enough. What is not must be so far out, and there sweeps must come nearer.
    pub(crate) fn is_rounding<V>(&self, mut change: impl FnMut(f64) -> V, length: impl Fn(&V, f64, &V) -> f64) -> bool {
        let size = |x: &V| length(x, 0.0, x);
        let in_proportion = |far: &V, times: f64, near: &V| length(far, -times, near) <= OFF * times * size(near);
        for side in [1.0, -1.0] {
            let mut farther = None;
            let nearer = NEARER.rev().map(|k| 4.0_f64.powi(k));
            for s in nearer.take_while(|s| s * self.length >= SEEN * self.rounding) {
                let near = change(side * s);
                if size(&near) == 0.0 {
                    break;
                }
                if farther.is_some_and(|farther| in_proportion(&farther, 4.0, &near)) {
                    return false;
                }
                farther = Some(near);
            }
        }
        // Twice, as one may be by chance.
        let known = FAR.map(|k| 8.0_f64.powi(k)).find_map(|s| {
            let near = change(s);
            let known = size(&near) > 0.0 && [8.0, 64.0].iter().all(|&n| in_proportion(&change(n * s), n, &near));
            known.then_some((s, near))
        });
        let Some((far, foreseen)) = known.filter(|(s, near)| size(near) <= CONTRACTS * s * self.length) else {
            return false;
        };
        let mut shows = |s: f64| length(&change(s), -s / far, &foreseen) >= SHOWS * self.length;
        beside(far).any(|s| shows(s) || shows(-s))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a force with the Jacobian 1, after a correction so long, which was looked for from `astray` away.
    fn is_rounding([length, astray]: [f64; 2], force: impl Fn(f64) -> f64) -> bool {
        let last = Last { length, astray, rounding: 1e-300 };
        last.is_rounding(|s| ((force(s * length) - force(0.0)) / (s * length) - 1.0).abs())
    }

    /// A force that is known to 1.
    fn stairs(from: f64) -> impl Fn(f64) -> f64 {
        move |x| (x + from).floor()
    }

    #[test]
    fn what_stands_still_nearby_and_moves_far_out_is_not_known() {
        for k in 0..1000 {
            let from = 0.618 * f64::from(k);
            for length in [1e-200, 1e-40, 1e-12, 1e-3, 0.1, 1.3, 7.3] {
                assert!(is_rounding([length, length], stairs(from)), "{k} {length:e}");
                // With a part that is known, such as a drag, the root is known better.
                let length = 0.03 * length;
                assert!(is_rounding([length, length], |x| 0.97 * x + 0.03 * stairs(from)(x)), "{k} {length:e}");
            }
            assert!(!is_rounding([1e6, 1e6], stairs(from)));
            assert!(!is_rounding([1e3, 1e3], stairs(from)), "a root that is known better");
            assert!(!is_rounding([0.1, 1e16], stairs(from)), "another root");
        }
    }

    /// Beside a drag, a force that stands still for long is hardly seen, and not known all the same.
    #[test]
    fn what_stands_still_for_long_is_not_known() {
        let wide = |x: f64| 0.998 * x + 0.002 * 1e5 * (1e-5 * x).round();
        assert!(is_rounding([1.0, 1e-3], wide));
        assert!(!is_rounding([1.0, 1e-3], |x| 0.998 * x), "another Jacobian");
    }

    #[test]
    fn what_is_smooth_or_breaks_is_known() {
        for k in 1..400 {
            let at = 0.09 * f64::from(k);
            for length in [1e-12, 1e-6, 1e-3, 0.1, 1.0, 30.0, 1e6] {
                let curved = |x: f64| x + x * x / at;
                let cubic = |x: f64| x + (x / at).powi(3);
                let waves = |x: f64| at * (x / at).sin();
                let bends = |x: f64| x + 10.0 * (x - 0.01 * at).max(0.0);
                let bends_here = |x: f64| x + 10.0 * x.max(0.0);
                let jumps = |x: f64| if x < 1e-3 * at { x } else { x + 1.0 };
                let pole = |x: f64| x / (1.0 - x / at);
                let other_slope = |x: f64| 1.2 * x;
                let other =
                    [&curved as &dyn Fn(f64) -> f64, &cubic, &waves, &bends, &bends_here, &jumps, &pole, &other_slope];
                for (i, force) in other.into_iter().enumerate() {
                    assert!(!is_rounding([length, length], force), "{i} {k} {length:e}");
                    assert!(!is_rounding([length, length], |x| -force(-x)), "{i} {k} {length:e}, from the other side");
                }
            }
        }
    }

    /// Of a Jacobian that is another one, one change may be as it says by chance.
    #[test]
    fn once_is_not_enough() {
        let crosses = |x: f64| if x == 4096.0 { x } else { 1.2 * x };
        assert!(!is_rounding([1.0, 1.0], crosses));
        assert!(is_rounding([1.0, 1.0], |x: f64| if x.abs() >= 4096.0 { x } else { 1.2 * x }));
    }

    /// Of sweeps of eight numbers after a change so long, which are multiplied by `map`.
    fn are_rounding([length, rounding]: [f64; 2], map: impl Fn(usize, f64) -> f64) -> bool {
        let next = |s: f64| core::array::from_fn::<_, 8, _>(|i| map(i, s * length * SHARES[i]) - map(i, 0.0));
        let size = |x: &[f64; 8], c: f64, y: &[f64; 8]| {
            (0..8).map(|i| (x[i] + c * y[i]).abs()).fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
        };
        Swept { length, rounding }.is_rounding(next, size)
    }

    const SHARES: [f64; 8] = [0.9, -0.3, 0.2, 1.0, -0.8, 0.5, 0.1, -0.6];

    const LEAST: f64 = 1e-300;

    #[test]
    fn sweeps_end_where_the_force_is_not_known() {
        for k in 0..300 {
            let known_to_1 = |i: usize, x: f64| (0.6 * x + 0.618 * (k + 29 * i) as f64).floor();
            for length in [0.5, 1.0, 3.3, 9.7, 30.0] {
                assert!(are_rounding([length, LEAST], known_to_1), "{k} {length}");
                assert!(
                    !are_rounding([100.0 + 30.0 * length, LEAST], known_to_1),
                    "{k} {length}: it is known to a part"
                );
                assert!(!are_rounding([1e6 * length, LEAST], known_to_1), "{k} {length}: it is known to less");
            }
            assert!(!are_rounding([1.0, LEAST], |i, x| 2.0 * known_to_1(i, x)), "{k}: sweeps come no nearer");
        }
    }

    #[test]
    fn sweeps_go_on_where_it_is_smooth_or_breaks() {
        for k in 1..300 {
            let at = 0.09 * f64::from(k);
            for length in [1e-12, 1e-3, 0.1, 1.0, 30.0, 1e6] {
                let curved = |x: f64| 0.6 * x + x * x / at;
                let waves = |x: f64| at * (x / at).sin();
                let fast = |x: f64| 0.5 * x + (40.0 * x / at + 1.0).sin();
                let breaks = |x: f64| if x < 1e-3 * at { 0.6 * x } else { 0.5 * x + 1.0 };
                let jumps = |x: f64| if x < 1e-3 * at { 0.0 } else { 1.0 };
                let flat = |x: f64| if x < 1e-3 * at { 0.0 } else { x.sqrt() };
                for (n, map) in
                    [&curved as &dyn Fn(f64) -> f64, &waves, &fast, &breaks, &jumps, &flat].into_iter().enumerate()
                {
                    assert!(!are_rounding([length, LEAST], |_, x| map(x)), "{n} {k} {length:e}");
                    assert!(!are_rounding([length, LEAST], |_, x| -map(-x)), "{n} {k} {length:e}, from the other side");
                }
            }
        }
    }

    #[test]
    fn one_side_is_enough_to_go_on() {
        let stairs = |x: f64| (0.6 * x + 0.3).floor();
        for side in [1.0, -1.0] {
            assert!(!are_rounding([1.0, LEAST], |i, x| if side * SHARES[i] * x > 0.0 {
                0.6 * x + x.sin()
            } else {
                stairs(x)
            }));
            assert!(are_rounding([1.0, LEAST], |_, x| stairs(side * x)));
        }
    }

    #[test]
    fn one_side_shows_it() {
        for side in [1.0, -1.0] {
            let by_change = |i: usize, x: f64| SHARES[i] * (x / SHARES[i]).round();
            let map = |i: usize, x: f64| {
                if side * x / SHARES[i] > 0.0 { 0.6 * by_change(i, x) } else { 0.6 * by_change(i, x + 0.3) }
            };
            assert!(are_rounding([1.0, LEAST], map));
        }
        assert!(!are_rounding([1.0, LEAST], |i, x| 0.6 * SHARES[i] * (x / SHARES[i]).round()));
    }

    /// Far out as nearby, and on as far again.
    #[test]
    fn sweeps_end_only_where_the_force_is_known_far_out() {
        let known = |x: f64| (0.6 * x + 0.3).floor();
        let bends_from = |far: f64| move |_: usize, x: f64| if x.abs() < far { known(x) } else { x * x.abs().ln() };
        assert!(are_rounding([1.0, LEAST], bends_from(1e7)));
        assert!(!are_rounding([1.0, LEAST], bends_from(1e5)));
        assert!(!are_rounding([1.0, LEAST], |_, x| (x.abs() > 0.01).into()));
        // What stands still for long is foreseen from farther out.
        let wide = |slope: f64| move |i: usize, x: f64| 1e3 * (1e-3 * (slope * SHARES[i].signum() * x + 3.0)).floor();
        assert!(are_rounding([1.0, LEAST], wide(0.6)) && !are_rounding([1.0, LEAST], wide(2.0)));
    }

    #[test]
    fn sweeps_do_not_look_where_no_position_shows() {
        let smooth_nearby = |_: usize, x: f64| if x.abs() < 0.6 { 0.6 * x } else { (0.6 * x + 0.3).floor() };
        assert!(!are_rounding([10.0, LEAST], smooth_nearby));
        assert!(are_rounding([10.0, 1.0], smooth_nearby));
    }

    /// Where positions differ by 1, nothing tells of a correction that is less.
    #[test]
    fn what_no_position_shows_is_no_evidence() {
        let of = |length: f64| Last { length, astray: 1.0, rounding: 1.0 };
        let as_foreseen_nearby = |s: f64| if (0.5..64.0).contains(&s.abs()) { 1.0 } else { 0.0 };
        assert!(of(1e-3).is_rounding(as_foreseen_nearby));
        assert!(!of(1e5).is_rounding(as_foreseen_nearby));
        assert!(!of(1e-3).is_rounding(|_| f64::NAN));
    }
}
