//! The length of a step of many bodies.

use crate::scene::vectors::Vectors;

/// The length of a step, and what follows from it for each coordinate.
#[derive(Clone, Debug)]
pub struct SceneStride<const D: usize> {
    /// h.
    pub dt: f64,
    /// h/m, and 0 for pinned bodies.
    pub kick: Vectors<D>,
    /// The coefficient of the unknown force, a share of h²/m; of no bodies where there is none.
    pub g: Vectors<D>,
}

impl<const D: usize> SceneStride<D> {
    pub(super) fn new(dt: f64, kick: Vectors<D>, share: f64) -> Self {
        let g = Vectors::zeros(if share == 0.0 { 0 } else { kick.bodies() });
        let mut stride = SceneStride { dt, kick, g };
        stride.couple(share);
        stride
    }

    /// g = share h²/m, where there is one.
    pub(super) fn couple(&mut self, share: f64) {
        for (g, kick) in self.g.flat_mut().iter_mut().zip(self.kick.flat()) {
            *g = kick * (share * self.dt);
        }
    }
}
