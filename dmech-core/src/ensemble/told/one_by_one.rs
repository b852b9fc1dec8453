//! Members of any kind: each has a list of its own numbers.

use super::{Named, Said, SetUp, Told, acts, company, whole};
use crate::checkpoint::Saved;
use crate::ensemble::each::OneByOne;
use crate::error::Error;
use crate::flat::Flat;
use crate::run::{Attend, Restored, Run, Simulation};
use crate::scheme::Scheme;
use crate::setup::Setup;
use crate::snapshot::Snapshot as _;
use crate::system::System;

impl<L, X, S, O> Told<X::State> for OneByOne<'_, L, X, S, O>
where
    X: Setup<L, State: Flat, System: Saved>,
    S: Scheme<X::System>,
    O: Attend<X::State>,
{
    fn whole(&self) -> Vec<(&'static str, Said)> {
        let bodies = if X::State::LISTED { ", of as many bodies as it has" } else { "" };
        let (fields, company) = (format!("each its own{bodies}"), company::<X::State, O>());
        whole::<X::State>(self.members, self.span, fields, (S::NAME, S::ORDER), company)
    }

    fn columns(&self) -> Named {
        let numbers = ["dt", "tolerance", "mass"].map(str::to_owned).into();
        Named { words: &["options", "looks", "invariants"], numbers }
    }

    /// As far as it can be set up: what is refused is moved, and refused, again.
    fn set_up(&self, k: usize) -> SetUp {
        let simulation = (self.member)(k);
        let length = simulation.step_length::<<X::System as System>::Scalar>();
        let Simulation { law, start, scheme, settings, .. } = simulation;
        let numbers = [settings.dt, scheme.tolerance(), Some(start.whole_mass(settings.mass))];
        let numbers = numbers.map(|x| x.unwrap_or(f64::NAN)).into();
        let first = start.start();
        let (mut invariants, mut list, mut acting) = (String::new(), Vec::new(), 0);
        if let Ok(system) = length.and_then(|length| start.system(law, settings.mass, length)) {
            invariants = system.own_invariants().join(", ");
            if X::State::LISTED {
                let (masses, pins) = system.bodies();
                list.extend(masses.into_iter().map(|mass| ("masses of the bodies", mass)));
                list.extend(pins.into_iter().map(|body| ("pinned bodies", body as f64)));
            }
            system.fields(&mut |name, x| list.push((name, x)));
            acting = acts(&system, &first);
        }
        let words = vec![format!("{scheme:?}"), settings.due.to_string(), invariants];
        SetUp { words, numbers, start: first.flat(), list, acts: acting }
    }

    fn restore(&self, k: usize, run: Restored<X::State>) -> Result<Run<X::State>, Error> {
        (self.member)(k).accompanied(()).restore(run)
    }
}
