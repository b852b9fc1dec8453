//! Laws that have what others have not: degrees, velocities, a seam.

/// Runs a macro for every method with eight stages.
macro_rules! for_each_order {
    ($run:ident! { $($rest:tt)* }) => {
        $run! { LineIntegral::order4(), $($rest)* }
        $run! { LineIntegral::order6(), $($rest)* }
        $run! { LineIntegral::order8(), $($rest)* }
        $run! { LineIntegral::order10(), $($rest)* }
        $run! { Gauss::order16(), $($rest)* }
    };
}
pub(crate) use for_each_order;

/// A test particle about a black hole, in its own time: −(gm/r³)(1 + 3 |q × v|²/(c r)²) q.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Geodesic {
    pub(crate) gm: f64,
    pub(crate) c: f64,
}

#[dmech::law]
impl Geodesic {
    #[force]
    fn pull(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let ([x, y], [u, w]) = (q, v);
        let (r2, turning) = (x * x + y * y, x * w - y * u);
        let k = -self.gm / (r2 * r2.sqrt()) * (1.0 + 3.0 * turning * turning / (self.c * self.c * r2));
        [k * x, k * y]
    }
}

/// A pair that attracts each other and may meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Soft {
    pub(crate) g: f64,
    pub(crate) eps: f64,
}

#[dmech::law]
impl Soft {
    #[pair]
    fn energy(&self, r: f64, ma: f64, mb: f64) -> f64 {
        -self.g * ma * mb / (r * r + self.eps * self.eps).sqrt()
    }
}

/// A body that is pushed about from where it rests, in a unit of length of its own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pushed {
    pub(crate) k: f64,
    pub(crate) push: f64,
    pub(crate) omega: f64,
    pub(crate) unit: f64,
}

#[dmech::law]
impl Pushed {
    #[force]
    fn push(&self, q: f64, t: f64) -> f64 {
        let x = q / self.unit;
        self.unit * (self.push * (self.omega * t).sin() - self.k * x.powi(3) - 0.7 * x)
    }
}

/// The same in a plane, with a potential, in a field that turns it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tugged {
    pub(crate) k: f64,
    pub(crate) push: f64,
    pub(crate) omega: f64,
}

#[dmech::law]
impl Tugged {
    #[potential]
    fn energy(&self, q: [f64; 2], t: f64) -> f64 {
        let [x, y] = q;
        self.k * (x * x + 0.3 * y * y + 0.2 * x * y.sin()) - (self.push * x + 0.1 * y) * (self.omega * t).sin()
    }

    #[force]
    fn turn(&self, v: [f64; 2]) -> [f64; 2] {
        [v[1] - 0.1 * v[0], -v[0]]
    }
}

/// Declares wells that are polynomials.
macro_rules! wells {
    ($($name:ident: $x:ident, $y:ident, $more:expr;)*) => {$(
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name {
            pub(crate) k: f64,
        }

        #[dmech::law]
        impl $name {
            #[potential]
            fn energy(&self, q: [f64; 2]) -> f64 {
                let [$x, $y] = q;
                0.5 * ($x * $x + 1.3 * $y * $y) + 0.2 * $x * $y + self.k * $more
            }
        }
    )*};
}

wells! {
    Cubic: x, y, x * (y * y - x * x / 3.0);
    Quartic: x, y, (x * x + 0.6 * y * y + 0.3 * x).powi(2);
    Quintic: x, y, (x * x + y * y) * x.powi(2) * y;
    Sextic: x, y, (x * x + 0.7 * y * y).powi(3);
    Octic: x, y, (x * x + 0.7 * y * y).powi(4);
    Ninth: x, y, (x * x + 0.7 * y * y).powi(4) * (y + 3.0);
}
