//! Compositions: every set of stages on every scheme that can be composed.

#![allow(unused)]
use std::hint::black_box;

use dmech::prelude::coefficients::*;
use dmech::prelude::*;

#[path = "../dmech-core/tests/common/counting.rs"]
mod counting;
mod laws;
mod motion;
use counting::allocations;
use laws::{HenonHeiles, Kepler};
use motion::*;

/// A pendulum whose pivot is shaken: time and position, no velocity.
#[derive(Clone, Copy, Debug)]
struct Shaken {
    k: f64,
    a: f64,
    omega: f64,
}

#[dmech::law]
impl Shaken {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -self.k * q.cos()
    }
    #[force]
    fn shake(&self, q: f64, t: f64) -> f64 {
        self.a * q.cos() * (self.omega * t).sin()
    }
}

const SHAKEN: Shaken = Shaken { k: 1.4, a: 0.6, omega: 1.7 };

/// A quartic bowl that pulsates, with air drag and a wind that turns: velocity and time, nonlinear in both.
#[derive(Clone, Copy, Debug)]
struct Wind {
    k: f64,
    drag: f64,
    gust: f64,
    omega: f64,
}

#[dmech::law]
impl Wind {
    #[potential]
    fn bowl(&self, q: [f64; 2], t: f64) -> f64 {
        0.25 * self.k * (1.3 + (0.7 * t).sin()) * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }

    #[force]
    fn drag(&self, q: [f64; 2], v: [f64; 2], t: f64, m: f64) -> [f64; 2] {
        let u = [v[0] - self.gust * (self.omega * t).cos(), v[1] - self.gust * (self.omega * t).sin()];
        let c = self.drag * m * (1.0 + q[0] * q[0]) * (0.1 + u[0] * u[0] + u[1] * u[1]).sqrt();
        [-c * u[0], -c * u[1]]
    }
}

const WIND: Wind = Wind { k: 1.7, drag: 0.3, gust: 0.8, omega: 2.3 };

/// Runs a macro for every set of stages.
macro_rules! for_each_set {
    ($run:ident, $($rest:tt)*) => {
        $run! { TripleJump4, $($rest)* }
        $run! { Suzuki4, $($rest)* }
        $run! { McLachlan4, $($rest)* }
        $run! { Yoshida6, $($rest)* }
        $run! { McLachlan6, $($rest)* }
        $run! { KahanLi6, $($rest)* }
        $run! { SofroniouSpaletta6S11, $($rest)* }
        $run! { SofroniouSpaletta6, $($rest)* }
        $run! { Yoshida8, $($rest)* }
        $run! { SuzukiUmeno8, $($rest)* }
        $run! { McLachlan8, $($rest)* }
        $run! { KahanLi8, $($rest)* }
        $run! { Morales8, $($rest)* }
        $run! { SofroniouSpaletta8, $($rest)* }
    };
}

/// The state at time `SPAN` after a number of steps; `None` where a large step has no solution.
const SPAN: f64 = 4.0;

fn arrive<L: Law<D>, S: Scheme<L, D>, const D: usize>(
    law: L,
    scheme: S,
    start: State<D>,
    steps: u64,
) -> Option<State<D>> {
    let run =
        Simulation::new(law, start).mass(MASS).scheme(scheme).dt(SPAN / steps as f64).record_every(steps).run(steps);
    run.ok().map(|run| *run.last())
}

fn slopes<L: Law<D> + Copy, S: Scheme<L, D>, const D: usize>(
    law: L,
    scheme: S,
    start: State<D>,
    exact: &State<D>,
    name: &str,
) {
    let mut line = String::new();
    let mut last: Option<(f64, f64)> = None;
    for level in 0..40 {
        let steps = (4.0 * 2.0_f64.powf(level as f64 / 3.0)).round() as u64;
        let Some(state) = arrive(law, scheme, start, steps) else { continue };
        let error = distance(state.q, exact.q) + distance(state.v, exact.v);
        if error < 2e-13 {
            break;
        }
        if let Some((n, e)) = last {
            if error < 1e-4 {
                line += &format!(" {steps}:{:.2}({error:.0e})", (e / error).ln() / (steps as f64 / n).ln());
            }
        }
        last = Some((steps as f64, error));
        if steps > 6000 {
            break;
        }
    }
    println!("{name:<12}{:<50}{line}", S::NAME);
}

#[test]
fn zz() {
    macro_rules! one {
        ($set:ident, $base:expr, $law:expr, $start:expr, $exact:expr, $name:literal) => {
            slopes($law, Composed::new($base, $set), $start, &$exact, $name);
        };
    }
    macro_rules! law { ($law:expr, $start:expr, $name:literal, $($base:expr),*) => {{
        let exact = arrive($law, Composed::order8(DiscreteGradient), $start, 1500).unwrap();
        $( for_each_set!(one, $base, $law, $start, exact, $name); )*
    }} }
    law!(HenonHeiles::new(), State::new([0.2, -0.1], [0.25, 0.3]), "henon", Leapfrog, DiscreteGradient, Implicit);
    law!(Kepler::new(), State::new([0.9, 0.2], [-0.1, 1.1]), "kepler", Leapfrog, DiscreteGradient, Implicit);
    law!(SHAKEN, State::<1>::new([0.9], [0.4]), "shaken", Leapfrog, DiscreteGradient, Implicit);
    law!(WIND, State::new([0.7, -0.4], [0.3, 0.8]), "wind", DiscreteGradient, Implicit);
}
