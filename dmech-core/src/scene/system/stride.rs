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
    /// The part of `kick` by which h times that exceeds h²/m as g has it, in exact arithmetic; of no bodies where there is no g.
    pub(super) excess: Vectors<D>,
}

impl<const D: usize> SceneStride<D> {
    pub(super) fn new(dt: f64, kick: Vectors<D>, share: f64) -> Self {
        let g = Vectors::zeros(if share == 0.0 { 0 } else { kick.bodies() });
        let mut stride = SceneStride { dt, kick, excess: g.clone(), g };
        stride.couple(share);
        stride
    }

    /// g = share h²/m, where there is one; the share is a power of two.
    pub(super) fn couple(&mut self, share: f64) {
        let coupled = self.g.flat_mut().iter_mut().zip(self.excess.flat_mut());
        for ((g, excess), kick) in coupled.zip(self.kick.flat()) {
            let fall;
            (fall, *excess) = crate::system::fall(self.dt, *kick);
            *g = share * fall;
        }
    }
}
