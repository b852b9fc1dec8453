//! A private potential that nothing calls, under the strictest lints.
#![deny(warnings, dead_code, missing_docs, unused, unreachable_pub, clippy::all, clippy::pedantic, rust_2018_idioms)]
#![deny(non_camel_case_types, single_use_lifetimes, unused_qualifications, unsafe_code, trivial_numeric_casts)]
// The author's own names.
#![allow(clippy::many_single_char_names)]
use dmech::prelude::*;

/// A planet about a sun whose mass pulsates.
#[derive(Clone, Copy, Debug)]
pub struct Kepler {
    /// The strength.
    gm: f64,
    /// The frequency.
    omega: f64,
}

#[dmech::law]
impl Kepler {
    const SWING: f64 = 0.25;

    fn strength(&self, t: f64) -> f64 {
        self.gm * (1.0 + Self::SWING * (self.omega * t).cos())
    }

    /// Energy per unit mass.
    #[potential]
    fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
        let [x, y] = q;
        -m * self.strength(t) / x.hypot(y)
    }
}

/// A floor that gives way.
#[derive(Clone, Copy, Debug, dmech::Law)]
#[potential(|q: f64| self.g * q + if q < 0.0 { 0.5 * self.k * q * q } else { 0.0 })]
struct Floor {
    g: f64,
    k: f64,
}

fn main() {
    let start = State::new([0.5, 0.0], [0.0, 1.63]);
    let law = Kepler { gm: 1.0, omega: 3.0 };
    assert!(Simulation::new(law, start).scheme(Kanatani).dt(0.01).run(10).is_ok());
    let floor = Floor { g: 9.81, k: 1e3 };
    assert!(Simulation::new(floor, State::new([1.0], [0.0])).scheme(DiscreteGradient).dt(0.01).run(100).is_ok());
}
