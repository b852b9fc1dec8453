//! Members of one law: their numbers stand in columns.

use super::{Named, Said, SetUp, Told, acts, whole};
use crate::ensemble::members::OneLaw;
use crate::ensemble::rides::Rides;
use crate::error::Error;
use crate::flat::Flat;
use crate::law::{Fields, Numbers};
use crate::run::{Attend, Restored, Run, Simulation};
use crate::state::State;
use crate::system::Particle;

impl<L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> Told<State<D>>
    for OneLaw<'_, L, S, O, D>
{
    fn whole(&self) -> Vec<(&'static str, Said)> {
        let number = |x: Option<f64>| x.map_or(Said::Nothing, Said::Number);
        let scheme = &self.common.scheme;
        let work = if self.work { ", and the work of each step" } else { "" };
        let mut whole = whole::<_, S, O>(self.members, self.span, self.columns().numbers[1..].join(", "));
        whole.extend([
            ("tolerance", number(scheme.tolerance())),
            ("dt", number(self.common.settings.dt)),
            ("options", Said::Words(format!("{scheme:?}"))),
            ("looks", Said::Words(format!("{}{work}", self.common.due()))),
            ("invariants", Said::Words(L::INVARIANTS.join(", "))),
        ]);
        whole
    }

    /// The mass, and the numbers of the law, by their places where they have no names.
    fn columns(&self) -> Named {
        let (mut names, count) = (Vec::new(), <L::Numbers as Numbers>::COUNT);
        L::names(&mut |name| names.push(name));
        let places: Vec<String> = (0..count).map(|i| i.to_string()).collect();
        if names.len() != count {
            names = places.iter().map(String::as_str).collect();
        }
        Named { words: &[], numbers: named("mass", &names) }
    }

    fn set_up(&self, k: usize) -> SetUp {
        let Simulation { law, start, settings, .. } = (self.bare)(k);
        let numbers = [&[settings.mass], law.numbers().list().as_slice()].concat();
        let acts = acts(&Particle::with_mass(law, settings.mass), &start);
        SetUp { words: Vec::new(), numbers, start: start.flat(), list: Vec::new(), acts }
    }

    fn restore(&self, k: usize, run: Restored<State<D>>) -> Result<Run<State<D>>, Error> {
        (self.bare)(k).restore(run)
    }
}

/// Names of columns: one, then those of a law's fields, none twice; SQLite does not tell large letters from small ones.
fn named(first: &str, fields: &[&str]) -> Vec<String> {
    let mut names = vec![first.to_owned()];
    for (i, name) in fields.iter().enumerate() {
        let is_list = fields.iter().filter(|other| *other == name).count() > 1;
        let place = fields[..i].iter().filter(|other| *other == name).count();
        let mut column = if is_list { format!("law_{name}_{place}") } else { format!("law_{name}") };
        while names.iter().any(|other| other.eq_ignore_ascii_case(&column)) {
            column.push('_');
        }
        names.push(column);
    }
    names
}
