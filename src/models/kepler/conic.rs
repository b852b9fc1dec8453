//! The motion along a conic section: where the planet is how long after its pericentre.

use core::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

use super::stumpff::Functions;

/// A conic with pericentre distance 1 under strength 1.
///
/// With dt = r ds, the time and the distance after the pericentre are
///
/// - t = s + e G₃(b, s), r = 1 + e G₂(b, s), b = 1 − e,
///
/// sums of positive terms for every e, which the parabola divides into ellipses (b > 0) and hyperbolas (b < 0) without a
/// trace; for an ellipse √b s is the eccentric anomaly.
#[derive(Clone, Copy, Debug)]
pub(super) struct Conic {
    e: f64,
    b: f64,
}

/// Where it is: along the pericentre and across, and how fast.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) q: [f64; 2],
    pub(super) v: [f64; 2],
}

impl Place {
    pub(super) fn true_anomaly(self) -> f64 {
        self.q[1].atan2(self.q[0])
    }
}

/// Newton's method has this relative accuracy when it stops; its last correction brings the square of that.
const CLOSE: f64 = 1e-11;

impl Conic {
    pub(super) fn new(eccentricity: f64) -> Self {
        Conic { e: eccentricity, b: 1.0 - eccentricity }
    }

    /// The square root of |b|, which takes s to the eccentric anomaly, or to tan ν/2 for the parabola.
    pub(super) fn rate(self) -> f64 {
        if self.b == 0.0 { FRAC_1_SQRT_2 } else { self.b.abs().sqrt() }
    }

    /// What takes the time to the mean anomaly.
    pub(super) fn mean_motion(self) -> f64 {
        if self.b == 0.0 { FRAC_1_SQRT_2 } else { self.rate() * self.b.abs() }
    }

    /// The time that a revolution takes.
    pub(super) fn period(self) -> Option<f64> {
        (self.b > 0.0).then(|| TAU / self.mean_motion())
    }

    /// The time at s.
    pub(super) fn time(self, s: f64) -> f64 {
        s + self.e * Functions::at(self.b, s).g3
    }

    /// The same time within half a revolution of the pericentre.
    pub(super) fn reduced(self, time: f64) -> f64 {
        match self.period() {
            Some(period) if time.abs() > 0.5 * period => (-(time / period).round()).mul_add(period, time),
            _ => time,
        }
    }

    /// s at a time that is [`reduced`](Conic::reduced), and what is left over.
    ///
    /// t(s) is convex for s ≥ 0, as far as the apocentre: Newton's method comes down to the root without overshooting,
    /// from wherever its first step leads.
    fn solve(self, time: f64) -> (f64, f64) {
        let Conic { e, b } = self;
        let (goal, end) = (time.abs(), if b > 0.0 { PI / self.rate() } else { f64::INFINITY });
        let mut s = self.guess(goal).min(end);
        let mut rest = 0.0;
        for _ in 0..64 {
            let Functions { g2, g3, .. } = Functions::at(b, s);
            rest = (goal - (s + e * g3)) / (1.0 + e * g2);
            if rest.abs() <= CLOSE * s {
                break;
            }
            s = (s + rest).min(end);
        }
        let sign = 1.0_f64.copysign(time);
        (sign * s, sign * rest)
    }

    /// The root for G₃ = s³/6. Above b = 0 it is less than the root sought; below it is more, far out by much: there
    /// sinh x = (M + x)/e with x at most that of the cubic comes closer.
    fn guess(self, goal: f64) -> f64 {
        let Conic { e, b } = self;
        if e == 0.0 {
            return goal;
        }
        let root = (2.0 / e).sqrt();
        let cubic = 2.0 * root * ((1.5 * goal / root).asinh() / 3.0).sinh();
        if b >= 0.0 {
            return cubic;
        }
        let (rate, mean) = (self.rate(), self.mean_motion() * goal);
        cubic.min(((mean + rate * cubic) / e).asinh() / rate)
    }

    /// Where it is at a time that is [`reduced`](Conic::reduced).
    pub(super) fn place(self, time: f64) -> Place {
        let (s, rest) = self.solve(time);
        self.place_at(s, rest)
    }

    /// Where it is at s and a little more.
    pub(super) fn place_at(self, s: f64, rest: f64) -> Place {
        let Conic { e, b } = self;
        let Functions { g0, g1, g2, .. } = Functions::at(b, s).moved(b, rest);
        let (r, across) = (1.0 + e * g2, (1.0 + e).sqrt());
        Place { q: [1.0 - g2, across * g1], v: [-g1 / r, across * g0 / r] }
    }

    /// s at a time that is [`reduced`](Conic::reduced).
    pub(super) fn argument(self, time: f64) -> f64 {
        let (s, rest) = self.solve(time);
        s + rest
    }

    /// s where the true anomaly is ν; NaN where the conic does not come.
    pub(super) fn at_true(self, anomaly: f64) -> f64 {
        let half = 0.5 * (anomaly - TAU * (anomaly / TAU).round());
        let ([sin, cos], rate) = ([half.sin(), (1.0 + self.e).sqrt() * half.cos()], self.rate());
        if self.b > 0.0 {
            2.0 * (rate * sin).atan2(cos) / rate
        } else if self.b < 0.0 {
            // 1 + e cos ν > 0 inside the asymptotes.
            if rate * sin.abs() < cos { 2.0 * (rate * sin / cos).atanh() / rate } else { f64::NAN }
        } else {
            2.0 * sin / cos
        }
    }

    /// s where the distance is r and r dr/dt is σ.
    ///
    /// For ellipses that are nearly circles the direction of the pericentre is lost in rounding: there s must come from the
    /// true anomaly, which has the same rounding.
    pub(super) fn at_radius(self, r: f64, sigma: f64) -> f64 {
        let Conic { e, b } = self;
        let rate = self.rate();
        if b > 0.0 {
            (rate * sigma).atan2(1.0 - b * r) / rate
        } else if b < 0.0 {
            (rate * sigma / e).asinh() / rate
        } else {
            sigma
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (e, time, [x, y, vx, vy]), with 60 digits by bisection of t = s + e G₃(1 − e, s).
    #[rustfmt::skip]
    #[allow(clippy::approx_constant)]
    const EXACT: [(f64, f64, [f64; 4]); 25] = [
        (0.0, 0.3, [0.955336489125606, 0.29552020666133955, -0.29552020666133955, 0.955336489125606]),
        (1e-09, 2.9, [-0.9709581661370543, 0.23924933344459867, -0.23924933285342356, -0.9709581627378573]),
        (0.1, 2.9, [-1.0228638213216332, 0.6318561131236701, -0.5010879060121675, -0.7158268542511983]),
        (0.6, 0.3, [0.9559142654663103, 0.3739391357354926, -0.2880066528937097, 1.210583571146622]),
        (0.6, 2.9, [-0.8649665545140807, 1.9344014099439497, -0.7217050843710874, 0.15163160704806386]),
        (0.99, 500.0, [-90.57868130076082, 14.056625472999562, -0.10870786548184032, 0.0012960240908240284]),
        (0.9999999, 2.9, [-0.7076530284608541, 2.613543798962831, -0.6825301050404554, 0.5223022890470432]),
        (0.9999999, 1000000000.0, [-1623508.3596191145, 2442.719920960181, -0.0010639070002383798, 7.296625788803701e-07]),
        (0.9999999999, 500.0, [-101.0138676780753, 20.200382882770622, -0.1386592702778739, 0.013728380264979006]),
        (0.9999999999, 1000000000.0, [-1650933.367609005, 2569.6677515203255, -0.0011006060736072805, 8.564721023151379e-07]),
        (1.0, 1e-09, [1.0, 1.4142135623730951e-09, -1e-09, 1.4142135623730951]),
        (1.0, 2.9, [-0.7076529930030484, 2.613543948743199, -0.6825300929849625, 0.5223023651951042]),
        (1.0, 1000000000.0, [-1650960.624447919, 2569.795030307218, -0.001100642416297805, 8.56599381131361e-07]),
        (1.0000000001, 500.0, [-101.01386787408907, 20.200383006223547, -0.13865927082704313, 0.013728380516921233]),
        (1.0000000001, 1000000000.0, [-1650987.8809011134, 2569.922309494347, -0.0011006787582168937, 8.567266606146563e-07]),
        (1.0000001, 2.9, [-0.7076529575452445, 2.613544098523559, -0.6825300809294693, 0.5223024413431591]),
        (1.0000001, 1000000000.0, [-1678027.0737505686, 2697.2705282106, -0.0011366060771058459, 9.842037128417159e-07]),
        (1.01, 500.0, [-110.2783574312048, 26.386260455177077, -0.16413480776295167, 0.026416417213460976]),
        (1.01, 1000000000.0, [-99011235.50716998, 14037279.637245024, -0.09900999999861305, 0.014037090154468655]),
        (1.5, 2.9, [-0.5528047708691087, 3.282990584038869, -0.6236756858336105, 0.8436659713849795]),
        (1.5, 1000000000.0, [-471404544.4193346, 527046306.4660776, -0.47140452212436496, 0.5270462781854418]),
        (7.0, 0.3, [0.960693951287972, 0.838483823176905, -0.23248290729095938, 2.7412413331914314]),
        (7.0, 1000000000.0, [-349927105.4727907, 2424366110.5804515, -0.3499271061356921, 2.424366107090263]),
        (1000000.0, 2.9, [0.9971010012699205, 2899.9985586638077, -0.0009999994408915278, 999.9995003442029]),
        (1000000.0, 500.0, [0.500001249986247, 499999.750013503, -0.000999999499999875, 999.999500001375]),
    ];

    /// Every conic, near the pericentre and far out, to a few units in the last place.
    #[test]
    fn places_are_exact_to_rounding() {
        let mut worst = 0.0_f64;
        for (e, time, [x, y, vx, vy]) in EXACT {
            for sign in [1.0, -1.0] {
                let Place { q, v } = Conic::new(e).place(sign * time);
                let far = (q[0] - x).hypot(q[1] - sign * y) / x.hypot(y);
                let fast = (v[0] - sign * vx).hypot(v[1] - vy) / vx.hypot(vy);
                worst = worst.max(far).max(fast);
                assert!(far.max(fast) < 4.0 * f64::EPSILON, "e = {e}, t = {time}: {far:e} {fast:e}");
            }
        }
        println!("{:.2} ulp", worst / f64::EPSILON);
    }

    /// The three ways to s agree, and every time has one, also where the numbers are at their ends.
    #[test]
    fn there_and_back() {
        for e in [
            0.0,
            1e-300,
            1e-16,
            0.3,
            0.7,
            0.999,
            1.0 - 1e-10,
            1.0 - 1e-16,
            1.0,
            1.0 + 1e-15,
            1.0 + 1e-10,
            1.7,
            40.0,
            1e12,
        ] {
            let conic = Conic::new(e);
            for time in [0.0, 1e-300, 1e-12, 0.02, 0.7, 2.0, 17.0, 1e5, 1e15] {
                let time = conic.reduced(time);
                let s = conic.argument(time);
                assert!((conic.time(s) - time).abs() <= 1e-14 * time.abs(), "{e} {time} {}", conic.time(s));
                let place = conic.place(time);
                let [r, sigma] = [place.q[0].hypot(place.q[1]), place.q[0] * place.v[0] + place.q[1] * place.v[1]];
                let [of_true, of_radius] = [conic.at_true(place.true_anomaly()), conic.at_radius(r, sigma)];
                // Far out the true anomaly hardly changes, and near a circle the distance.
                let [far, round] = [1e-15 * (1.0 + r * r), 1e-15 * (1.0 + 1.0 / e)];
                assert!(of_true.is_nan() || (of_true - s).abs() <= far * (1.0 + s.abs()), "{e} {time}: {of_true} {s}");
                assert!((of_radius - s).abs() <= round * (1.0 + s.abs()), "{e} {time}: {of_radius} {s}");
            }
        }
    }
}
