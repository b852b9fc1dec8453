//! Where what acts on the bodies of a scene is not finite.

use super::SceneSystem;
use crate::error::Error;
use crate::scene::terms::{Acts, Fault};
use crate::scene::vectors::Vectors;
use crate::system::{PARTS, System};

impl Fault {
    /// In words.
    pub(super) fn told(self, step: u64, time: f64) -> Error {
        match self {
            Fault::Link { a, b, distance } => Error::Link { a, b, distance, step, time },
            Fault::Body { body, value, place } => Error::Body { body, value, place, step, time },
            Fault::Path { body, at } => Error::Path { body, at, step, time },
        }
    }
}

impl<const D: usize, A: Acts<D>> SceneSystem<D, A> {
    /// Refuses a start where something that acts is not finite.
    pub(super) fn refuse(&self, [q, v]: [&Vectors<D>; 2], t: f64) -> Result<(), Error> {
        self.acts.fault(None, q, v, t).map_or(Ok(()), |fault| Err(fault.told(0, t)))
    }

    /// The first path that is not finite within a step.
    fn lost(&self, t: f64, dt: f64) -> Option<Fault> {
        self.acts.lost(PARTS.map(|part| t + part * dt))
    }

    /// That, or the first link or body, on the way of freely falling bodies, on which what acts is not finite.
    pub(super) fn fault_on_the_way(&self, [q, v]: [&Vectors<D>; 2], t: f64, dt: f64) -> Option<Fault> {
        let mut slope = self.zero();
        System::slope(self, t, q, v, &mut slope);
        let kick = self.stride(dt.abs(), 0.0).kick;
        let fault = |part: &f64| {
            let passed = part * dt;
            let mut b = q.clone();
            for (i, b) in b.flat_mut().iter_mut().enumerate() {
                let fall = 0.5 * part * passed * dt.signum() * kick.flat()[i] * slope.flat()[i];
                *b += passed * v.flat()[i] - fall;
            }
            if b.is_finite() { self.acts.fault(Some(q), &b, v, t + passed) } else { None }
        };
        self.lost(t, dt).or_else(|| PARTS.iter().find_map(fault))
    }

    /// That, or the first link or body where a step has ended.
    pub(super) fn fault_at_the_end(&self, [q, v]: [&Vectors<D>; 2], t: f64, dt: f64) -> Option<Fault> {
        let at_the_end = || if q.is_finite() { self.acts.fault(None, q, v, t + dt) } else { None };
        self.lost(t, dt).or_else(at_the_end)
    }
}
