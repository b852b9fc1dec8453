use dmech::extend::{Between, PairLaw, Reads, Real};
use dmech::prelude::*;

#[derive(Clone, Copy)]
struct Loose;

impl<P> Reads<P> for Loose {
    type Numbers = [f64; 0];

    fn numbers(_: f64, _: &P) -> [f64; 0] {
        []
    }
}

impl<P, R: Real> PairLaw<2, P, R> for Loose {
    type Between<'a> = Loose;

    fn between(&self, _: [R; 0], _: [R; 0], _: R) -> Loose {
        Loose
    }
}

impl<R: Real> Potential<2, R> for Loose {
    fn potential(&self, _: [R; 2]) -> R {
        R::ZERO
    }
    fn gradient(&self, _: [R; 2]) -> [R; 2] {
        [R::ZERO; 2]
    }
    fn hessian(&self, _: [R; 2]) -> [[R; 2]; 2] {
        [[R::ZERO; 2]; 2]
    }
    fn discrete_gradient(&self, _: [R; 2], _: [R; 2]) -> [R; 2] {
        [R::ZERO; 2]
    }
    fn discrete_gradient_jacobian(&self, _: [R; 2], _: [R; 2]) -> [[R; 2]; 2] {
        [[R::ZERO; 2]; 2]
    }
}

impl<R: Real> Between<2, R> for Loose {}

fn main() {
    let bodies = Scene::new().body(1.0, [0.0; 2], [0.0; 2]).body(1.0, [1.0; 2], [0.0; 2]);
    let _ = bodies.chain(Loose).as_law::<2, 4>();
}
