//! The bodies of a scene.

use super::acting::Acting;
use super::drives::Drives;
use crate::error::{Error, SceneError};

/// The bodies of a scene.
#[derive(Clone, Debug)]
pub struct Bodies<const D: usize, P> {
    pub(super) masses: Vec<f64>,
    pub(super) q: Vec<[f64; D]>,
    pub(super) v: Vec<[f64; D]>,
    pub(super) data: Vec<P>,
    /// Those that no force moves; the driven are among them.
    pub(super) pins: Vec<usize>,
    pub(super) drives: Drives<D>,
    /// Those that do not act on others, ascending.
    pub(super) tests: Vec<usize>,
    pub(super) t: f64,
}

impl<const D: usize, P> Bodies<D, P> {
    /// Which of them act on others.
    pub(super) fn acting(&self) -> Acting {
        Acting::new(self.masses.len(), &self.tests)
    }

    /// What counts in energies and momenta: masses, and 0 for test bodies.
    pub(super) fn weights(&self) -> Vec<f64> {
        let mut weights = self.masses.clone();
        self.tests.iter().for_each(|&i| weights[i] = 0.0);
        weights
    }

    /// What can be said to be wrong before any law is looked at.
    pub(super) fn check(&self) -> Result<(), Error> {
        let n = self.masses.len();
        if n == 0 {
            return Err(SceneError::Empty.into());
        }
        for (body, &mass) in self.masses.iter().enumerate() {
            if !(mass > 0.0 && mass.is_finite()) {
                return Err(SceneError::Mass { body, mass }.into());
            }
        }
        let mut driven = vec![false; n];
        for body in self.drives.bodies() {
            if driven.get_mut(body).is_some_and(|driven| core::mem::replace(driven, true)) {
                return Err(SceneError::DrivenTwice { body }.into());
            }
        }
        check_state([&self.q, &self.v], self.t, n, &self.pins, &self.drives)
    }
}

/// What can be said to be wrong with a state of n bodies.
pub(super) fn check_state<const D: usize>(
    [q, v]: [&[[f64; D]]; 2],
    t: f64,
    n: usize,
    pins: &[usize],
    drives: &Drives<D>,
) -> Result<(), Error> {
    if let Some(given) = [q.len(), v.len()].into_iter().find(|&given| given != n) {
        return Err(SceneError::Bodies { given, bodies: n }.into());
    }
    if !t.is_finite() {
        return Err(Error::State { quantity: "t", value: t });
    }
    for (quantity, list) in [("q", q), ("v", v)] {
        for (body, x) in list.iter().enumerate() {
            if let Some(&value) = x.iter().find(|x| !x.is_finite()) {
                return Err(SceneError::State { body, quantity, value }.into());
            }
        }
    }
    for &body in pins {
        if body >= n {
            return Err(SceneError::Pin { body, bodies: n }.into());
        }
        if drives.moves(body) {
            continue;
        }
        if let Some(&speed) = v[body].iter().find(|&&v| v != 0.0) {
            return Err(SceneError::PinnedMoves { body, speed }.into());
        }
    }
    Ok(())
}
