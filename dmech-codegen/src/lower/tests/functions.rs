//! Every function of `f64`, as a method and by its path.

use super::{assert_same, body, laws, lower_text, points, value};

/// A function that lowering must know, with the same in Rust.
macro_rules! functions {
    ($y:ident: $($f:ident($($argument:expr),*)),* $(,)?) => { [$((
        stringify!($f),
        stringify!($($argument),*),
        (|x: f64, $y: f64| { let _ = $y; x.$f($($argument),*) }) as fn(f64, f64) -> f64,
    )),*] };
}

#[test]
fn every_function() {
    let functions = functions![y:
        sqrt(), cbrt(), exp(), exp2(), exp_m1(), ln(), ln_1p(), log2(), log10(), sin(), cos(), tan(), asin(), acos(),
        atan(), sinh(), cosh(), tanh(), asinh(), atanh(), abs(), recip(), to_radians(), to_degrees(), powi(3), powi(-2),
        powf(y), powf(1.5), powf(0.25), powf(-1.0 / 3.0), atan2(y), hypot(y), min(y), max(y), log(y + 2.0),
        mul_add(y, 0.5), clamp(0.3, 0.6), rem_euclid(0.75), rem_euclid(-y),
    ];
    for (name, arguments, rust) in functions {
        let arguments = arguments.trim();
        let comma = if arguments.is_empty() { "" } else { ", " };
        for text in [
            body("[f64; 2]", &format!("let [x, y] = q; x.{name}({arguments}) + 0.0 * y")),
            body("[f64; 2]", &format!("let [x, y] = q; f64::{name}(x{comma}{arguments})")),
        ] {
            let lowered = lower_text(&text).unwrap_or_else(|errors| panic!("{name}: {errors:?}"));
            let pairs: Vec<_> = points(2, false)
                .into_iter()
                .map(|q| (value(&lowered, &q, 1.0, 0.0, &|_| None), rust(q[0], q[1])))
                .collect();
            assert_same(name, &pairs);
        }
    }
}

laws! {
    functions_with_other_domains [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 {
            let (s, c) = (3.0 * q).sin_cos();
            (1.0 + q * q).acosh() + s * c * c + q.signum() * q + std::f64::consts::E.powf(q) + q.abs().sqrt()
        }
    }
    steps [] (f64; signed) {
        fn energy(&self, q: f64) -> f64 {
            let x = 4.3 * q;
            x.floor() + 10.0 * x.ceil() + 100.0 * x.round() + 1e3 * x.trunc() + 0.1 * x.fract() + 0.01 * x.rem_euclid(-1.7)
        }
    }
    known_exponents [] (f64) {
        const P: f64 = 1.5;
        const Q: f64 = -2.0 * Self::P / 4.5;
        const N: i32 = 4;
        fn energy(&self, q: f64) -> f64 { q.powf(Self::P) + q.powf(Law::Q) * 0.1 + q.powi(Self::N) }
    }
}

/// x^1.5 is a root and a product, not a power function.
#[test]
fn known_exponents_become_roots() {
    let text = "impl Law { const P: f64 = 1.5; #[potential] fn energy(&self, q: f64) -> f64 { q.powf(Self::P) } }";
    let lowered = lower_text(text).unwrap();
    assert_eq!(lowered.graph.display(lowered.potential).to_string(), "(√x)³");
    assert!(lowered.parameters.is_empty());
}
