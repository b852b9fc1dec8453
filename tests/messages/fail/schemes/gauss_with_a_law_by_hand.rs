use dmech::prelude::*;
use dmech::{Conservative, Potential};

#[derive(Clone, Copy)]
struct Quartic {
    k: f64,
}

impl Conservative for Quartic {}

impl Potential<1> for Quartic {
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        0.25 * self.k * x.powi(4)
    }
    fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] {
        [self.k * x.powi(3)]
    }
    fn hessian(&self, [x]: [f64; 1]) -> [[f64; 1]; 1] {
        [[3.0 * self.k * x * x]]
    }
    fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
        [0.25 * self.k * (a + b) * (a * a + b * b)]
    }
    fn discrete_gradient_jacobian(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [[f64; 1]; 1] {
        [[0.25 * self.k * (a * a + 2.0 * a * b + 3.0 * b * b)]]
    }
}

fn main() {
    let bowl = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.0])).dt(0.01);
    let _ = bowl.scheme(Gauss::order16()).run(10);
}
