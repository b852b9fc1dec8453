//! Leap-frog has no velocity where it needs the force: nothing is there to be verified.

use dmech::prelude::*;

#[derive(Clone, Copy, Debug)]
struct Damped {
    alpha: f64,
}

#[dmech::law]
impl Damped {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        -q.cos()
    }
    #[force]
    fn drag(&self, v: f64) -> f64 {
        -self.alpha * v
    }
}

fn main() {
    verify(Damped { alpha: 0.1 }, State::new([0.8], [0.0])).with_half_step_schemes().assert();
}
