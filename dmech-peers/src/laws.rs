//! The laws and scenes of the motions that no model of the library is.

use dmech::prelude::*;
use dmech::scene::{Chain, Linked};

/// Three bodies of mass 1 in the plane as one law of six coordinates, g = 1.
#[derive(Clone, Copy, Debug)]
pub struct ThreeBodies {
    g: f64,
}

#[dmech::law]
impl ThreeBodies {
    /// −g Σ 1/rᵢⱼ.
    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let (x, y) = (q[2 * i] - q[2 * j], q[2 * i + 1] - q[2 * j + 1]);
                sum -= self.g / (x * x + y * y).sqrt();
            }
        }
        sum
    }
}

/// g = 1.
pub fn three_bodies() -> ThreeBodies {
    ThreeBodies { g: 1.0 }
}

/// A spring of energy r²/2 + β r⁴/4, where r is by how much it is longer than at rest: as the others get it, without the terms
/// that the library's spring has besides. The force is derived term by term: of a sum it is r + β r³, as by hand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spring {
    beta: f64,
}

#[dmech::law]
impl Spring {
    #[pair]
    fn energy(&self, d: [f64; 1]) -> f64 {
        // d is the position of a body less that of the next.
        let r = -d[0];
        0.5 * r * r + 0.25 * self.beta * r.powi(4)
    }
}

/// 64 masses between pinned bodies 0 and 65.
pub(crate) fn chain(start: &State<64>, beta: f64) -> Scene<1, (), ((), Linked<Spring, Chain>)> {
    let mut scene = Scene::new().body(1.0, [0.0], [0.0]);
    for (q, v) in start.q.into_iter().zip(start.v) {
        scene = scene.body(1.0, [q], [v]);
    }
    scene.body(1.0, [0.0], [0.0]).pin(0).pin(65).chain(Spring { beta })
}
