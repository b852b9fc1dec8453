//! The functions of `f64`, one law each. The body comes through a macro, as an expression in an invisible group.

use dmech::prelude::*;

use super::oracle::agrees;

macro_rules! functions {
    ($($test:ident: $law:ident(|$x:ident| $body:expr) near $centre:expr, within $radius:expr;)*) => {$(
        struct $law {
            k: f64,
        }

        #[dmech::law]
        impl $law {
            #[potential]
            fn energy(&self, q: [f64; 2]) -> f64 {
                let $x = self.k * q[0] + 0.3 * q[1] * q[1];
                1.3 * $body
            }
        }

        #[test]
        fn $test() {
            let law = $law { k: 1.0 };
            agrees(stringify!($test), &law, |q| law.energy(q), [$centre, 0.2], $radius);
        }
    )*};
}

functions! {
    sqrt: Sqrt(|x| x.sqrt()) near 1.7, within 0.9;
    cbrt: Cbrt(|x| x.cbrt()) near 1.7, within 0.9;
    cbrt_of_negative: CbrtNegative(|x| x.cbrt()) near -1.7, within 0.9;
    powi: Powi(|x| x.powi(5) + x.powi(-3) + x.powi(0)) near 1.4, within 0.6;
    powf: Powf(|x| x.powf(1.7) + x.powf(-2.5)) near 1.4, within 0.6;
    powf_of_a_function: PowfOfFunction(|x| (1.5 + x.sin()).powf(x)) near 0.4, within 0.9;
    exp: Exp(|x| x.exp()) near 0.3, within 0.9;
    exp2: Exp2(|x| x.exp2()) near 0.3, within 0.9;
    exp_m1: ExpM1(|x| x.exp_m1()) near 0.1, within 0.9;
    ln: Ln(|x| x.ln()) near 1.7, within 0.9;
    ln_1p: Ln1p(|x| x.ln_1p()) near 0.4, within 0.9;
    log2: Log2(|x| x.log2()) near 1.7, within 0.9;
    log10: Log10(|x| x.log10()) near 1.7, within 0.9;
    sin: Sin(|x| x.sin()) near 0.5, within 0.9;
    cos: Cos(|x| x.cos()) near 0.5, within 0.9;
    tan: Tan(|x| x.tan()) near 0.3, within 0.7;
    sin_cos: SinCos(|x| { let (s, c) = x.sin_cos(); s * c + s }) near 0.5, within 0.9;
    asin: Asin(|x| x.asin()) near 0.1, within 0.6;
    acos: Acos(|x| x.acos()) near 0.1, within 0.6;
    atan: Atan(|x| x.atan()) near 0.5, within 0.9;
    atan2: Atan2(|x| x.atan2(1.5 + x * x)) near 0.5, within 0.9;
    sinh: Sinh(|x| x.sinh()) near 0.5, within 0.9;
    cosh: Cosh(|x| x.cosh()) near 0.5, within 0.9;
    tanh: Tanh(|x| x.tanh()) near 0.5, within 0.9;
    asinh: Asinh(|x| x.asinh()) near 0.5, within 0.9;
    acosh: Acosh(|x| x.acosh()) near 2.3, within 0.7;
    atanh: Atanh(|x| x.atanh()) near 0.1, within 0.6;
    hypot: Hypot(|x| x.hypot(0.7 + x * x)) near 0.5, within 0.9;
    recip: Recip(|x| x.recip()) near 1.7, within 0.9;
    mul_add: MulAdd(|x| x.mul_add(1.7 * x, x.sin())) near 0.5, within 0.9;
    abs: Abs(|x| x.abs() * x) near -1.5, within 0.9;
    min: Min(|x| x.min(3.0 - x) * x) near 0.5, within 0.6;
    max: Max(|x| x.max(3.0 - x) * x) near 0.5, within 0.6;
    clamp: Clamp(|x| x.clamp(-1.0, 2.0) * x) near 0.5, within 0.6;
    signum: Signum(|x| x.signum() * x * x) near -1.5, within 0.9;
    by_path: ByPath(|x| f64::sin(x) + f64::powi(x, 3) + f64::from(2)) near 0.5, within 0.9;
    constants: Constants(|x| std::f64::consts::PI * x + core::f64::consts::TAU.sqrt() * x * x + f64::EPSILON) near 0.5, within 0.9;
}

/// A dome of which nothing is known beyond its edge.
#[derive(Clone, Copy, Debug)]
struct Dome {
    k: f64,
}

#[dmech::law]
impl Dome {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        self.k * (1.0 - q * q).sqrt().clamp(0.0, 0.9)
    }
}

/// What is no number is not clamped to one: a motion that leaves the domain of its law is told.
#[test]
fn a_clamp_does_not_hide_where_a_law_ends() {
    let law = Dome { k: 0.7 };
    let outside = [1.5_f64];
    assert!(law.energy(outside[0]).is_nan() && law.potential(outside).is_nan() && law.gradient(outside)[0].is_nan());
    let slide = |x: f64| Simulation::new(law, State::new([x], [0.9])).dt(0.1);
    macro_rules! ends {
        ($($scheme:expr),*) => {$(
            let run = slide(0.2).scheme($scheme).run(100);
            assert!(run.is_err(), "{}: {run:?}", stringify!($scheme));
            assert!(slide(1.5).scheme($scheme).run(1).is_err(), "{}: from outside", stringify!($scheme));
        )*};
    }
    ends!(Leapfrog, Nystrom::order6(), Implicit, DiscreteGradient, Gauss::order16());
}

/// Six hollows about a centre, through which motions go.
#[derive(Clone, Copy, Debug)]
struct Rose {
    k: f64,
    depth: f64,
}

#[dmech::law]
impl Rose {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * self.k * (x * x + y * y) * (1.0 + self.depth * (6.0 * y.atan2(x)).cos())
    }
}

/// Steps from one side of the centre of an angle to the opposite one, along axes and between them.
#[test]
fn angles_are_passed_through_at_their_centre() {
    let law = Rose { k: 1.3, depth: 0.02 };
    let mut passed = 0;
    for start in [[1.0, 0.0], [0.0, 0.7], [-0.3, -0.3], [0.3, -0.4], [0.5, 0.5 * 3_f64.sqrt()]] {
        let run = Simulation::new(law, State::new(start, [0.0; 2])).scheme(DiscreteGradient).dt(0.1).run(500).unwrap();
        let energy = run.drift(Invariant::Energy).unwrap();
        assert!(energy.max_relative() < 1e-13, "from {start:?}: {energy}");
        let ends = run.states().windows(2);
        passed += ends.filter(|ends| ends[0].q[0] * ends[1].q[0] + ends[0].q[1] * ends[1].q[1] < 0.0).count();
    }
    assert!(passed > 50, "{passed} steps through the centre");
}
