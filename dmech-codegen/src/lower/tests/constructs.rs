//! The language: statements, patterns, branches, loops, helpers.

use super::laws;

laws! {
    kepler [gm: f64 = 1.3] ([f64; 2]) {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let [x, y] = q;
            -self.gm / (x * x + y * y).sqrt()
        }
    }
    one_coordinate [k: f64 = 2.5] (f64; signed) {
        fn energy(&self, q: f64) -> f64 { 0.5 * self.k * q * q - q / 3.0 + 1e-1 }
    }
    literals [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 { 1.5e-1 * q + 2.0f64 * q * q - 1_000.25 * q * q * q + (-(-q)) + 3f64 }
    }
    shadowing_and_blocks [] ([f64; 2]; signed) {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let x = q[0];
            let y = { ; let x = x * x;; let z = x + q[1]; z * z };
            let x: f64 = x + y;;
            { x * x + y }
        }
    }
    patterns [] ([f64; 4]; signed) {
        fn energy(&self, q: [f64; 4]) -> f64 {
            let [a, .., b] = q;
            let [_, rest @ ..] = q;
            let (s, (c, _)) = (a * b, (b + rest[1], 1.0));
            let [[p, r], _]: [[f64; 2]; 2] = [[s, c], [a, b]];
            let mut w;
            w = p - r;
            w = w * 2.0;
            w * p + r + rest[2] * rest[0]
        }
    }
    compound_assignment [k: f64 = 0.7] ([f64; 3]; signed) {
        fn energy(&self, q: [f64; 3]) -> f64 {
            let mut sum = 0.0;
            sum += q[0] * q[0];
            sum -= self.k * q[1];
            sum *= 1.0 + q[2] * q[2];
            sum /= 3.0 + q[0] * q[0];
            let mut pair = (sum, q[0]);
            pair.0 += pair.1;
            (pair.0, pair.1) = (pair.1, pair.0);
            let mut table = [[0.0; 2], [q[1], 1.0]];
            table[0][1] += q[2];
            table[1][0] *= table[0][1];
            [table[0][0], _] = [pair.0 * 2.0, 0.0];
            table[0][0] + table[1][0] + pair.1
        }
    }
    branches [k: f64 = 0.4] ([f64; 2]; signed) {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let x = q[0];
            let soft = if x < 0.0 { x * x } else if x <= self.k { 2.0 * x * x } else { x.powi(3) };
            let mut penalty = 1.0;
            if q[1] > 0.3 && !(x > 0.2) || q[1] == x {
                penalty += q[1];
                let inner = penalty * x;
                penalty = inner - 1.0;
            }
            if q[1] >= 0.0 { penalty *= 3.0 } else { penalty -= x; }
            let sign = if x != 0.5 && x > q[1] { self.k } else { -1.0 };
            let both = x > 0.0 && q[1] > 0.0;
            let pair = if both { [x, penalty] } else { [q[1], self.k] };
            soft + penalty + sign * x + pair[0] * pair[1]
        }
    }
    declared_before_the_branch [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 {
            let side;
            let mut inside = q > -0.5;
            if q < 0.0 { side = -q; inside = inside && q < -0.1; } else { side = q * q; inside = false; }
            if inside { side * 2.0 } else { side }
        }
    }
    loops [] ([f64; 4]; signed) {
        fn energy(&self, q: [f64; 4]) -> f64 {
            let mut sum = 0.0;
            for i in 0..4 {
                for j in i + 1..4 {
                    let d = q[i] - q[j];
                    sum += d * d * (1.0 + 2.0 * i as f64 + (j * j) as f64 / 3.0);
                }
                if i % 2 == 0 { sum += q[i]; } else { sum -= q[i / 2] * q[i]; }
                if i == 3 { sum *= 1.5; }
            }
            for i in (0..=2).rev() { sum += q[i] * q[i + 1].cos() * i as f64; }
            for (i, &x) in q.iter().enumerate().skip(1).step_by(2) { sum -= x * f64::from(i as u32); }
            for x in q { sum += x.sin(); }
            for _ in 0..3 { sum = sum * 0.5 + 1.0; }
            sum
        }
    }
    sums [w: [f64; 3] = [0.3, -0.7, 1.1]] ([f64; 3]; signed) {
        fn energy(&self, q: [f64; 3]) -> f64 {
            let all: f64 = (0..3).map(|i| self.w[i] * q[i] * q[i]).sum();
            let neighbours = (0..2).map(|i| { let d = q[i + 1] - q[i]; d * d }).sum::<f64>();
            let squares = q.iter().map(|x| x * x).sum::<f64>();
            let product: f64 = q.iter().map(|&x| 2.0 + x).product();
            let pairs: f64 = (0..3).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| q[i] * q[j]).sum();
            let weighted: f64 = q.iter().zip([1.0, 2.0, 4.0]).map(|(x, w)| w * x).sum();
            let largest = q.iter().fold(-10.0_f64, |m, &x| m.max(x));
            let least = q.into_iter().fold(10.0, f64::min);
            let roots: f64 = q.map(|x| x * x + 1.0).iter().copied().map(f64::sqrt).sum();
            let chained: f64 = q.iter().chain(&[1.0]).take(4).map(|x| x.cos()).sum();
            let differences: f64 = q.windows(2).map(|w| (w[1] - w[0]).powi(4)).sum();
            let count = (1..=4).sum::<usize>() as f64 + q.len() as f64;
            all + neighbours * squares + product + pairs + weighted + largest + least + roots + chained + differences
                + count * q[0] + q[..2].iter().sum::<f64>()
        }
    }
    integers [] ([f64; 2]; signed) {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let n = 3;
            let last = q.len() - 1;
            let half = 7 / 2 * 2 - 5 % 3;
            let power = 2usize.pow(3).min(5) as i32;
            let is_odd = n % 2 == 1;
            let k = if is_odd && n > 2 { -n } else { n };
            let scale = if k < 0 { 1.5 } else { 2.5 };
            q[last].powi(n) + q[0].powi(-2) * 0.01 + half as f64 * q[0] + q[0].powi(power) * scale + k as f64 * q[1]
        }
    }
    constants [] ([f64; 2]; signed) {
        const D: usize = 2;
        const N: i32 = 1 + Self::D as i32;
        const ON: bool = Self::D == 2;
        fn energy(&self, q: [f64; Self::D]) -> f64 {
            use std::f64::consts::{FRAC_PI_3 as THIRD, LN_2};
            const HALF: f64 = 0.5;
            let mut sum = std::f64::consts::PI * q[0] + core::f64::consts::TAU * q[1] * LN_2 + THIRD;
            for i in 0..Law::D { sum += q[i].powi(Self::N) * HALF; }
            if Self::ON { sum * 2.0 } else { 0.0 }
        }
    }
    helpers [k: f64 = 0.9, centre: [f64; 2] = [0.1, -0.2]] ([f64; 2]; signed) {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let d = self.from_centre(&q);
            let (near, far) = Self::split(d);
            self.well(near) + Self::square(far) + Law::square(self.depth()) + Self::well(self, d[0] * 0.5)
        }
        fn from_centre(&self, q: &[f64; 2]) -> [f64; 2] { [q[0] - self.centre[0], q[1] - self.centre[1]] }
        fn split(d: [f64; 2]) -> (f64, f64) { return (d[0], d[1] * d[1]); }
        fn well(&self, x: f64) -> f64 { let k = self.k; Self::square(x * x - k) }
        fn square(x: f64) -> f64 { x * x }
        pub(crate) const fn depth(&self) -> f64 { self.k }
    }
    mass_and_time [k: f64 = 0.9] ([f64; 1], m: f64, t: f64) {
        fn energy(&self, q: [f64; 1], m: f64, t: f64) -> f64 {
            m * 9.81 * q[0] + self.k * (2.0 * t).cos() * q[0] * q[0]
        }
    }
    return_comes_last [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 { let x = q * q; return x + q; }
    }
    references [] ([f64; 2]; signed) {
        fn energy(&self, q: [f64; 2]) -> f64 {
            let r = &q;
            let x = &r[0];
            let [_, y] = *r;
            *x * y + (&q)[1] * r.clone()[0] * y
        }
    }
    conditions_of_numbers [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 {
            let flag = 2.0 < 3.0 && true;
            if flag { if 1.0 > 2.0 { q.tan() } else { q } } else { 0.0 }
        }
    }
    a_long_sum [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 {
            let x = q;
            q + x * 0.1 + x * x * 0.2 + x * 0.3 - x * x * 0.4 + x * 0.5 - x * 0.6 + x * x * x * 0.7 - x * 0.8 + x * 0.9
                + q + x * 0.1 + x * x * 0.2 + x * 0.3 - x * x * 0.4 + x * 0.5 - x * 0.6 + x * x * x * 0.7 - x * 0.8
        }
    }
}
