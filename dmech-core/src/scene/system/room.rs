//! What explicit steps work in, kicks with a force gradient, and kicks by the mean velocity.

use super::{SceneStride, SceneSystem};
use crate::law::rotation;
use crate::scene::terms::Acts;
use crate::scene::vectors::Vectors;
use crate::system::{Kick, System};

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
        self.acts.at(kick.t, q, |terms, q| terms.add_turned(1.0, q, fall, kick.t, turned));
        let c = kick.e * stride.dt;
        for (slope, turned) in slope.flat_mut().iter_mut().zip(turned.flat()) {
            *slope = kick.b * *slope - c * turned;
        }
        1.0
    }

    /// A kick with the force on each body at its mean velocity.
    pub(super) fn kick_by_mean(
        &self,
        room: &mut SceneRoom<D>,
        stride: &SceneStride<D>,
        kick: Kick<f64>,
        q: &Vectors<D>,
        v: &Vectors<D>,
        to: &mut Vectors<D>,
    ) {
        let SceneRoom { slope, still, by_velocity, .. } = room;
        if still.bodies() != q.bodies() {
            *still = self.zero();
        }
        by_velocity.clear();
        by_velocity.resize(q.bodies(), [[0.0; D]; D]);
        self.slope(kick.t, q, still, slope);
        self.acts.at(kick.t, q, |terms, q| terms.add_force_dv(q, kick.t, by_velocity));
        // The first column of h/m: a body has one mass.
        for (i, (&by_velocity, c)) in by_velocity.iter().zip(stride.kick.flat()).enumerate() {
            let push = slope.get(i).map(|s| -s);
            to.set(i, rotation::kick_by_mean(kick.b * c, push, by_velocity, v.get(i)));
        }
    }
}
