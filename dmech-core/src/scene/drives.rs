//! Bodies that move along given paths.

use core::ops::Deref;
use std::sync::{Arc, Mutex, PoisonError};

use super::state::SceneState;
use super::vectors::Vectors;

type Path<const D: usize> = Arc<dyn Fn(f64) -> [[f64; D]; 2] + Send + Sync>;

/// Which bodies move along given paths, t ↦ (q, v): to what acts on the others they are where their paths are at the time
/// that is asked for, whatever a scheme carries of them.
pub(super) struct Drives<const D: usize> {
    paths: Vec<(usize, Path<D>)>,
    /// Vectors that are not in use.
    #[expect(clippy::vec_box, reason = "a box is one word, which is handed out and taken back")]
    room: Mutex<Vec<Box<Vectors<D>>>>,
}

impl<const D: usize> Drives<D> {
    pub(super) const fn none() -> Self {
        Drives { paths: Vec::new(), room: Mutex::new(Vec::new()) }
    }

    pub(super) fn push(&mut self, body: usize, path: impl Fn(f64) -> ([f64; D], [f64; D]) + Send + Sync + 'static) {
        self.paths.push((body, Arc::new(move |t| path(t).into())));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.paths.is_empty()
    }

    /// The bodies.
    pub(super) fn bodies(&self) -> impl Iterator<Item = usize> {
        self.paths.iter().map(|&(body, _)| body)
    }

    /// Whether a body is one of them.
    pub(super) fn moves(&self, body: usize) -> bool {
        self.bodies().any(|driven| driven == body)
    }

    /// Bodies, places and velocities at t.
    pub(super) fn at(&self, t: f64) -> impl Iterator<Item = (usize, [[f64; D]; 2])> {
        self.paths.iter().map(move |(body, path)| (*body, path(t)))
    }

    /// Puts them where they are.
    pub(super) fn place(&self, state: &mut SceneState<D>) {
        for (body, [q, v]) in self.at(state.t) {
            if let (Some(place), Some(velocity)) = (state.q.get_mut(body), state.v.get_mut(body)) {
                (*place, *velocity) = (q, v);
            }
        }
    }

    /// Positions as laws see them at t.
    #[inline(always)]
    pub(super) fn positions<'a>(&'a self, q: &'a Vectors<D>, t: f64) -> Seen<'a, D> {
        self.seen(q, 0, t)
    }

    /// Velocities likewise.
    #[inline(always)]
    pub(super) fn velocities<'a>(&'a self, v: &'a Vectors<D>, t: f64) -> Seen<'a, D> {
        self.seen(v, 1, t)
    }

    #[inline(always)]
    fn seen<'a>(&'a self, given: &'a Vectors<D>, which: usize, t: f64) -> Seen<'a, D> {
        Seen { given, driven: if self.is_empty() { None } else { Some(self.placed(given, which, t)) } }
    }

    /// Keeps the memory for the next time. By hand: what has something to do when it is dropped costs scenes without driven
    /// bodies some twenty instructions a pass.
    #[inline(always)]
    pub(super) fn back(&self, seen: Seen<'_, D>) {
        if let Some(driven) = seen.driven {
            self.keep(driven);
        }
    }

    #[inline(never)]
    fn keep(&self, driven: Box<Vectors<D>>) {
        self.room.lock().unwrap_or_else(PoisonError::into_inner).push(driven);
    }

    #[inline(never)]
    fn placed(&self, given: &Vectors<D>, which: usize, t: f64) -> Box<Vectors<D>> {
        let spare = self.room.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut placed = spare.unwrap_or_else(|| Box::new(Vectors::zeros(given.bodies())));
        (*placed).clone_from(given);
        for (body, at) in self.at(t) {
            placed.set(body, at[which]);
        }
        placed
    }
}

impl<const D: usize> Clone for Drives<D> {
    fn clone(&self) -> Self {
        Drives { paths: self.paths.clone(), ..Drives::none() }
    }
}

impl<const D: usize> core::fmt::Debug for Drives<D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.bodies()).finish()
    }
}

/// A vector of each body, in which those of driven bodies are replaced by what their paths say.
#[derive(Debug)]
pub struct Seen<'a, const D: usize> {
    given: &'a Vectors<D>,
    driven: Option<Box<Vectors<D>>>,
}

impl<const D: usize> Deref for Seen<'_, D> {
    type Target = Vectors<D>;

    #[inline(always)]
    fn deref(&self) -> &Vectors<D> {
        match &self.driven {
            Some(driven) => driven,
            None => self.given,
        }
    }
}
