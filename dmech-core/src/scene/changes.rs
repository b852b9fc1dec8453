//! Scenes that change between steps.

use core::any::TypeId;

use super::system::SceneSystem;
use super::terms::{Acts, Laws};
use crate::changes::{Holds, LawMut};
use crate::error::{Error, SceneError};
use crate::scheme::Scheme;
use crate::stepper::Stepper;

impl<X: 'static, const D: usize, A: Laws> Holds<X> for SceneSystem<D, A> {
    fn law_mut(&mut self) -> Option<&mut X> {
        self.acts.terms.law(TypeId::of::<X>(), None)?.downcast_mut()
    }

    fn law_of_mut(&mut self, body: usize) -> Option<&mut X> {
        self.acts.terms.law(TypeId::of::<X>(), Some(body))?.downcast_mut()
    }
}

impl<const D: usize, A: Acts<D>, S: Scheme<SceneSystem<D, A>>> Stepper<SceneSystem<D, A>, S> {
    /// Puts body i, counted from 0, to another place with another velocity: the hand of a player, a pin that is carried along.
    /// What the scheme carries of all bodies is begun anew, which costs an evaluation of the forces, and laws on each body are compared with
    /// their methods as at a start: of 1000 bodies that takes the time of some twelve leap-frog steps of a chain. A pinned body is put there at
    /// rest, v = 0; a hand whose velocity laws feel is a [driven](crate::Scene::drive) body.
    ///
    /// # Errors
    /// [`Error::Scene`] for a body that is not there or that moves along a given path, a state that is not finite, a pinned
    /// body with a velocity; [`Error::NotAsWritten`]; the stepper then stays as it was.
    pub fn set_body(&mut self, i: usize, q: [f64; D], v: [f64; D]) -> Result<(), Error> {
        let mut state = self.state();
        let bodies = state.q.len();
        let (Some(place), Some(velocity)) = (state.q.get_mut(i), state.v.get_mut(i)) else {
            return Err(SceneError::NoBody { body: i, bodies }.into());
        };
        if self.system.acts.drives.moves(i) {
            return Err(SceneError::Driven { body: i }.into());
        }
        (*place, *velocity) = (q, v);
        self.set_state(state)
    }

    /// The first law of the type X, to be changed: `stepper.law_mut::<Wind>()`; `None` if no law of the scene is one. Laws that each body
    /// has of its own are reached body by body: [`law_of_mut`](Stepper::law_of_mut).
    ///
    /// The change counts when what this returns goes out of scope.
    pub fn law_mut<X: Clone + 'static>(&mut self) -> Option<LawMut<'_, SceneSystem<D, A>, S, X>>
    where
        A: Laws,
    {
        let law = Holds::<X>::law_mut(&mut self.system)?.clone();
        Some(LawMut { stepper: self, law, on: None, changed: false })
    }

    /// The law of body i, to be changed, of the first [`field_of`](crate::Scene::field_of) with laws of the type X:
    /// `stepper.law_of_mut::<Drag>(3)`; `None` if there is none, or no body i. A law that is one for all is changed for all:
    /// [`law_mut`](Stepper::law_mut).
    ///
    /// The change counts when what this returns goes out of scope. What the scheme carries of all bodies is begun anew then, as by
    /// [`set_body`](Stepper::set_body).
    pub fn law_of_mut<X: Clone + 'static>(&mut self, i: usize) -> Option<LawMut<'_, SceneSystem<D, A>, S, X>>
    where
        A: Laws,
    {
        let law = Holds::<X>::law_of_mut(&mut self.system, i)?.clone();
        Some(LawMut { stepper: self, law, on: Some(i), changed: false })
    }
}
