//! Statements, loops, sums, helpers, constants, fields, choices, arguments of any shape.

use super::oracle::agrees;
use dmech::prelude::*;

struct Inner {
    k: f64,
    pair: (f64, f64),
}

/// One law for each construct, all with the same parameters, pairwise distinct and not 1.
macro_rules! constructs {
    ($($test:ident: $law:ident near $centre:expr; { $($block:tt)* })*) => {$(
        #[allow(dead_code)]
        struct $law {
            k: f64,
            l: f64,
            n: usize,
            weights: [f64; 3],
            rows: [[f64; 2]; 2],
            inner: Inner,
        }

        #[dmech::law]
        #[allow(clippy::all, clippy::pedantic)]
        impl $law {
            $($block)*
        }

        #[test]
        fn $test() {
            let law = $law {
                k: 1.7,
                l: 0.6,
                n: 3,
                weights: [0.8, 1.4, 2.1],
                rows: [[0.9, 0.3], [0.3, 1.2]],
                inner: Inner { k: 2.3, pair: (0.7, 1.9) },
            };
            agrees(stringify!($test), &law, |q| law.energy(q), $centre, 0.7);
        }
    )*};
}

constructs! {
    patterns_blocks_and_shadowing: Patterns near [0.9, 0.4, -0.3]; {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            let [x, _, z] = q;
            let (s, (c, w)) = (x.sin(), (z.cos(), q[1]));
            let x = {
                let x = x * x + s;
                let y: f64 = x + c;
                y * w
            };
            let [first, .., last] = q;
            let late;
            late = first - last;
            x + self.k * late * late
        }
    }
    operators: Operators near [0.9, 0.4]; {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let (x, y) = (q[0], q[1]);
            -(x - 2.0 * y) / (3.0 + x * x) + 1e-1 * -y * 2_f64 - 1_000.5e-3 * x
        }
    }
    loops_and_accumulators: Loops near [0.9, 0.4, -0.3]; {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            let mut sum = 0.0;
            let mut product = 1.0;
            for i in 0..3 {
                for j in i + 1..3 {
                    let d = q[i] - q[j];
                    sum += self.k * d * d / (1 + i + j) as f64;
                }
                product *= 2.0 + q[i];
            }
            for x in q {
                sum -= 0.1 * x;
            }
            for (i, x) in q.iter().enumerate() {
                sum += self.weights[i] * x.powi(2);
            }
            for i in (1..=2).rev() {
                sum /= 1.0 + 0.1 * i as f64;
            }
            sum + product
        }
    }
    arrays_that_change: Arrays near [0.9, 0.4]; {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let mut r = [q[0], q[1], 0.0];
            r[2] = r[0] * r[1];
            r[0] += self.k * r[2];
            let mut table = [[0.0; 2]; 2];
            for i in 0..2 {
                for j in 0..2 {
                    table[i][j] = self.rows[i][j] * q[i] * q[j];
                }
            }
            r[0] * r[0] + r[1] + table[0][0] + table[0][1] + table[1][0] + table[1][1]
        }
    }
    sums_over_ranges: Sums near [0.9, 0.4, -0.3]; {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            let square: f64 = q.iter().map(|x| x * x).sum();
            let bonds = (0..2).map(|i| (q[i + 1] - q[i]).powi(4)).sum::<f64>();
            let weights: [f64; 3] = self.weights;
            let weighted: f64 = q.iter().zip(weights).map(|(x, w)| w * x * x).sum();
            let folded = q.iter().fold(0.0, |sum, &x| sum + x.sin());
            square + self.k * bonds + weighted + folded
        }
    }
    helpers: Helpers near [0.9, 0.4]; {
        fn square(x: f64) -> f64 {
            x * x
        }

        fn distance(&self, q: [f64; 2]) -> f64 {
            (Self::square(q[0]) + Helpers::square(q[1]) + self.l).sqrt()
        }

        fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
            let (s, c) = self.l.sin_cos();
            [c * x - s * y, s * x + c * y]
        }

        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let turned = self.turned(q);
            -self.k / self.distance(turned) + turned[0]
        }
    }
    constants_of_the_block: Constants near [0.9, 0.4]; {
        const D: usize = 2;
        const STIFF: f64 = 1.9;
        const TWICE: f64 = 2.0 * Self::STIFF;
        const TABLE: [f64; 2] = [0.5, 0.25];

        #[potential]
        fn energy(&self, q: [f64; Self::D]) -> f64 {
            let mut sum = 0.0;
            for i in 0..Self::D {
                sum += Self::TABLE[i] * q[i].powi(4);
            }
            Self::STIFF * q[0].cos() + Constants::TWICE * sum
        }
    }
    fields_of_any_depth: Fields near [0.9, 0.4]; {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let weights: [f64; 3] = self.weights;
            let inner = self.inner.k * q[0] * q[0] + self.inner.pair.1 * q[1] + self.inner.pair.0;
            inner + weights[0] * q[0] + self.weights[2] * q[1].powi(2) + self.rows[1][0] * q[0] * q[1] + self.n as f64
        }
    }
    choices: Choices near [0.9, 0.4]; {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let [x, y] = q;
            let wall = if x < -5.0 || !(y >= -5.0) { 1e3 } else if x > 5.0 && y > 5.0 { x * y } else { x * x };
            let mut sum = wall;
            if y > -4.0 {
                sum += self.k * y.powi(3);
            }
            if self.l > 0.5 { sum } else { -sum }
        }
    }
    a_result_by_return: Returned near [0.9, 0.4]; {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            return self.k * q[0].sin() * q[1].cos();
        }
    }
    one_coordinate: OneCoordinate near [0.9]; {
        #[potential]
        fn energy(&self, q: [f64; 1]) -> f64 {
            self.k * q[0].sin()
        }
    }
    many_coordinates: ManyCoordinates near [0.3, 0.1, -0.2, 0.5, 0.4, -0.3, 0.2, 0.1, -0.4, 0.6, -0.5, 0.2, 0.3]; {
        #[potential]
        fn energy(&self, q: [f64; 13]) -> f64 {
            (1..13).map(|i| 1.0 - (q[i] - q[i - 1]).cos()).sum::<f64>() + self.k * q[0] * q[0]
        }
    }
}

struct Pendulum {
    k: f64,
}

#[dmech::law]
impl Pendulum {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
}

#[derive(dmech::Law)]
#[potential(|q: f64| -self.k * q.cos())]
struct Short {
    k: f64,
}

#[derive(dmech::Law)]
#[potential(|q: [f64; 2]| -> f64 {
    let [x, y] = q;
    self.0 * x * x + self.1[1] * y.powi(4)
})]
struct Unnamed(f64, [f64; 2]);

#[test]
fn a_single_number_as_position() {
    let law = Pendulum { k: 1.7 };
    agrees("pendulum", &law, |[q]| law.energy(q), [0.8], 0.9);
}

/// The short form means the same, to the bit.
#[test]
fn short_form() {
    let (long, short) = (Pendulum { k: 1.7 }, Short { k: 1.7 });
    agrees("short", &short, |[q]| long.energy(q), [0.8], 0.9);
    assert_eq!(long.gradient([0.8]), short.gradient([0.8]));
    assert_eq!(long.discrete_gradient([0.8], [0.3]), short.discrete_gradient([0.8], [0.3]));
    let unnamed = Unnamed(0.7, [1.3, 1.9]);
    agrees("unnamed", &unnamed, |[x, y]| 0.7 * x * x + 1.9 * y.powi(4), [0.8, 0.4], 0.9);
}

#[test]
#[should_panic(expected = "the potential at")]
fn the_judge_notices_another_potential() {
    agrees("pendulum", &Pendulum { k: 1.7 }, |[q]| -1.7 * q.cos() + 1e-12 * q, [0.8], 0.9);
}
