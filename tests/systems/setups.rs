//! The systems: nonlinear laws, pairwise distinct parameters, none of them 1.

use dmech::models::pairs::{FermiPastaUlamTsingou, Morse};
use dmech::prelude::*;

/// x² + y² and the cubic term of Hénon and Heiles, with frequencies of their own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Well {
    pub(crate) k: f64,
    pub(crate) l: f64,
    pub(crate) c: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        0.5 * (self.k * x * x + self.l * y * y) + self.c * (x * x * y - y.powi(3) / 3.0)
    }
}

pub(crate) const WELL: Well = Well { k: 1.3, l: 0.8, c: 0.3 };
pub(crate) const START: State<2> = State { t: 0.0, q: [0.4, -0.3], v: [0.25, 0.35] };
pub(crate) const MORSE: Morse = Morse { depth: 1.4, width: 0.9, length: 1.2 };

/// Three bodies, any two linked, in the well.
pub(crate) fn cluster() -> Scene<2> {
    Scene::new().body(1.3, [0.9, 0.1], [0.1, 0.4]).body(0.7, [-0.8, 0.3], [0.2, -0.3]).body(
        2.1,
        [0.2, -1.1],
        [-0.3, 0.1],
    )
}

/// Nine masses on a line, the ends pinned, one of them struck: more than the eight that are treated at once.
pub(crate) fn line() -> Scene<1> {
    let at = |i: u32| 0.03 * f64::from(i * i % 7);
    (0..9)
        .fold(Scene::new(), |scene, i| {
            let speed = if i == 4 { 0.8 } else { 0.0 };
            scene.body(0.9 + 0.1 * f64::from(i % 3), [if i % 8 == 0 { 0.0 } else { at(i) }], [speed])
        })
        .pin(0)
        .pin(8)
}

pub(crate) const SPRING: FermiPastaUlamTsingou = FermiPastaUlamTsingou { k: 1.2, alpha: 0.4, beta: 0.7 };

/// Where everything is.
pub(crate) trait Places {
    fn places(&self) -> Vec<f64>;
}

impl<const D: usize> Places for State<D> {
    fn places(&self) -> Vec<f64> {
        self.q.to_vec()
    }
}

impl<const D: usize> Places for SceneState<D> {
    fn places(&self) -> Vec<f64> {
        self.q.as_flattened().to_vec()
    }
}

pub(crate) fn apart(a: &impl Places, b: &impl Places) -> f64 {
    a.places().iter().zip(b.places()).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}
