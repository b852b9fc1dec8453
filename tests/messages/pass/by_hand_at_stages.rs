//! A potential by hand that holds for every scalar can be asked for eight positions at once.
use dmech::extend::Real;
use dmech::prelude::*;
use dmech::{Conservative, Potential};

#[derive(Clone, Copy)]
struct Quartic {
    k: f64,
}

impl Conservative for Quartic {}

impl<R: Real> Potential<1, R> for Quartic {
    fn potential(&self, [x]: [R; 1]) -> R {
        R::from_f64(0.25 * self.k) * x.powi(4)
    }
    fn gradient(&self, [x]: [R; 1]) -> [R; 1] {
        [R::from_f64(self.k) * x.powi(3)]
    }
    fn hessian(&self, [x]: [R; 1]) -> [[R; 1]; 1] {
        [[R::from_f64(3.0 * self.k) * x * x]]
    }
    fn discrete_gradient(&self, [a]: [R; 1], [b]: [R; 1]) -> [R; 1] {
        [R::from_f64(0.25 * self.k) * (a + b) * (a * a + b * b)]
    }
    fn discrete_gradient_jacobian(&self, [a]: [R; 1], [b]: [R; 1]) -> [[R; 1]; 1] {
        let [two, three] = [2.0, 3.0].map(R::from_f64);
        [[R::from_f64(0.25 * self.k) * (a * a + two * a * b + three * b * b)]]
    }
}

fn main() {
    let bowl = Simulation::new(Quartic { k: 1.7 }, State::new([1.0], [0.0])).dt(0.1);
    let fine = bowl.clone().scheme(DiscreteGradient).dt(0.0001).run(10_000).unwrap();
    let run = bowl.scheme(Gauss::order16()).run(10).unwrap();
    assert!((run.last().q[0] - fine.last().q[0]).abs() < 1e-7 && run.last().q[0] < 0.9);
}
