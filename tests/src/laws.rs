//! The laws that the suites run over: nonlinear, parameters pairwise distinct and not 1.

/// Declares a law, keeps its source for the interpreter and its parameters by name.
macro_rules! declare {
    ($(#[$doc:meta])* $name:ident { $($field:ident = $value:expr),* } $($block:tt)*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name { $(pub $field: f64),* }

        #[dmech::law]
        $($block)*

        impl $name {
            pub const SOURCE: &str = stringify!($($block)*);

            pub fn new() -> Self {
                Self { $($field: $value),* }
            }

            pub fn parameters(&self) -> Vec<(&'static str, f64)> {
                vec![$((stringify!($field), self.$field)),*]
            }
        }
    };
}

declare! {
    /// −gm/|q| in the plane: central.
    Kepler { gm = 1.3 }
    impl Kepler {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let [x, y] = q;
            -self.gm / (x * x + y * y).sqrt()
        }
    }
}

declare! {
    /// A softened centre in space: central, D = 3.
    Plummer { gm = 1.7, eps = 0.3 }
    impl Plummer {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            -self.gm / (q[0].powi(2) + q[1].powi(2) + q[2].powi(2) + self.eps.powi(2)).sqrt()
        }
    }
}

declare! {
    /// k|q|²/2 in space: linear, central.
    Oscillator { k = 2.3 }
    impl Oscillator {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            0.5 * self.k * (0..3).map(|i| q[i] * q[i]).sum::<f64>()
        }
    }
}

declare! {
    /// Two springs that pull on each other: linear, neither diagonal nor central.
    Coupled { k = 1.9, l = 0.7 }
    impl Coupled {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            0.5 * self.k * (q[0] * q[0] + 3.0 * q[1] * q[1]) + self.l * q[0] * q[1]
        }
    }
}

declare! {
    /// −k cos q: D = 1.
    Pendulum { k = 1.4 }
    impl Pendulum {
        #[potential]
        fn energy(&self, q: f64) -> f64 {
            -self.k * q.cos()
        }
    }
}

declare! {
    /// Hénon–Heiles with unequal frequencies: a full 2 × 2 Jacobian.
    HenonHeiles { w = 1.2, l = 0.8 }
    impl HenonHeiles {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let [x, y] = q;
            0.5 * (self.w * x * x + y * y) + self.l * (x * x * y - y.powi(3) / 3.0)
        }
    }
}

declare! {
    /// Quartic wells that do not interact: a diagonal Hessian.
    Wells { a = 0.6, b = 1.8, c = 0.9 }
    impl Wells {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            self.a * q[0].powi(4) + self.b * q[1].powi(4) + self.c * q[2].cosh()
        }
    }
}

declare! {
    /// Three coordinates, all coupled: closed 3 × 3 solves.
    Anharmonic { k = 1.1, c = 0.4 }
    impl Anharmonic {
        #[potential]
        fn energy(&self, q: [f64; 3]) -> f64 {
            let [x, y, z] = q;
            0.5 * self.k * (x * x + 2.0 * y * y + 3.0 * z * z) + self.c * x * y * z + 0.25 * (x + y - z).powi(4)
        }
    }
}

declare! {
    /// A chain of five with anharmonic bonds and fixed ends: unrolled factorisation of a banded matrix.
    Chain { alpha = 0.25, beta = 0.6 }
    impl Chain {
        fn bond(&self, s: f64) -> f64 {
            0.5 * s * s + self.alpha / 3.0 * s.powi(3) + 0.25 * self.beta * s.powi(4)
        }

        #[potential]
        fn energy(&self, q: [f64; 5]) -> f64 {
            let mut sum = self.bond(q[0]) + self.bond(-q[4]);
            for i in 0..4 {
                sum += self.bond(q[i + 1] - q[i]);
            }
            sum
        }
    }
}

declare! {
    /// Morse's molecule in the plane: central through exp and √.
    Morse { depth = 1.5, width = 1.2, length = 0.8 }
    impl Morse {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let r = q[0].hypot(q[1]);
            let e = (-self.width * (r - self.length)).exp();
            self.depth * (1.0 - e) * (1.0 - e)
        }
    }
}

declare! {
    /// A ball on a floor that gives way: piecewise.
    Floor { g = 1.3, k = 40.0 }
    impl Floor {
        #[potential]
        fn energy(&self, q: [f64; 1]) -> f64 {
            let depth = (-q[0]).max(0.0);
            self.g * q[0] + 0.5 * self.k * depth * depth
        }
    }
}

declare! {
    /// A grab-bag of functions in two coordinates.
    Landscape { a = 0.7, b = 1.3, p = 1.6 }
    impl Landscape {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            let [x, y] = q;
            let s = 1.0 + x * x + 0.5 * y * y;
            self.a * s.ln() + self.b * (x.sin() * y).tanh() + 0.3 * s.powf(self.p) + (0.2 * x + 0.1 * y).atan()
        }
    }
}

/// Runs a macro for every law: name, number of coordinates, a typical start.
#[macro_export]
macro_rules! for_each_law {
    ($run:ident) => {
        $run! { Kepler, 2, [0.9, 0.2], [-0.1, 1.1] }
        $run! { Plummer, 3, [0.8, 0.1, -0.3], [0.2, 0.9, 0.4] }
        $run! { Oscillator, 3, [0.7, -0.4, 0.2], [0.3, 0.8, -0.5] }
        $run! { Coupled, 2, [0.7, -0.4], [0.3, 0.8] }
        $run! { Pendulum, 1, [1.9], [0.3] }
        $run! { HenonHeiles, 2, [0.2, -0.1], [0.25, 0.3] }
        $run! { Wells, 3, [0.8, -0.6, 0.5], [0.2, 0.5, -0.7] }
        $run! { Anharmonic, 3, [0.6, -0.3, 0.4], [0.4, 0.5, -0.2] }
        $run! { Chain, 5, [0.4, -0.2, 0.5, 0.1, -0.3], [0.1, 0.6, -0.4, 0.3, 0.2] }
        $run! { Morse, 2, [1.1, 0.3], [-0.2, 0.5] }
        $run! { Floor, 1, [0.5], [0.2] }
        $run! { Landscape, 2, [0.7, -0.5], [0.3, 0.6] }
    };
}
