//! What explicit steps work in, and kicks with a force gradient.

use super::{SceneStride, SceneSystem};
use crate::scene::terms::Acts;
use crate::scene::vectors::Vectors;
use crate::system::Kick;

/// Where explicit steps work.
#[derive(Clone, Debug)]
pub struct SceneRoom<const D: usize> {
    pub(super) slope: Vectors<D>,
    pub(super) watched: bool,
    /// (h/m) ∇Φ and H (h/m) ∇Φ, where a scheme asks for them.
    pub(super) fall: Vectors<D>,
    pub(super) turned: Vectors<D>,
    /// Bodies at rest and ∂F/∂v of each, likewise.
    pub(super) still: Vectors<D>,
    pub(super) by_velocity: Vec<[[f64; D]; D]>,
}

impl<const D: usize, A: Acts<D>> SceneSystem<D, A> {
    /// The length of a kick by the slope in the room.
    #[inline(always)]
    pub(super) fn length(
        &self,
        room: &mut SceneRoom<D>,
        stride: &SceneStride<D>,
        kick: Kick<f64>,
        q: &Vectors<D>,
    ) -> f64 {
        if kick.e == 0.0 { kick.b } else { self.turned(room, stride, kick, q) }
    }

    /// With a force gradient the slope becomes b ∇Φ − e h H (h/m) ∇Φ, and the length 1.
    fn turned(&self, room: &mut SceneRoom<D>, stride: &SceneStride<D>, kick: Kick<f64>, q: &Vectors<D>) -> f64 {
        let SceneRoom { slope, fall, turned, .. } = room;
        fall.clone_from(slope);
        for (fall, kick) in fall.flat_mut().iter_mut().zip(stride.kick.flat()) {
            *fall *= kick;
        }
        turned.clone_from(slope);
        turned.clear();
        self.acts.add_turned(1.0, q, fall, kick.t, turned);
        let c = kick.e * stride.dt;
        for (slope, turned) in slope.flat_mut().iter_mut().zip(turned.flat()) {
            *slope = kick.b * *slope - c * turned;
        }
        1.0
    }
}
