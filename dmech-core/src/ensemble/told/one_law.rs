//! Members of one law: their numbers stand in columns.

use super::{Named, Said, SetUp, Told, acts, company, whole};
use crate::ensemble::members::OneLaw;
use crate::ensemble::rides::Rides;
use crate::error::Error;
use crate::flat::Flat;
use crate::law::{Fields, Numbers};
use crate::run::{Attend, Restored, Run, Settings, Simulation};
use crate::state::State;
use crate::system::Particle;

impl<L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> Told<State<D>>
    for OneLaw<'_, L, S, O, D>
{
    fn whole(&self) -> Vec<(&'static str, Said)> {
        let Simulation { scheme, settings, .. } = self.common;
        let (fields, company) = (columns::<L, D>()[1..].join(", "), company::<State<D>, O>());
        let mut whole = whole::<State<D>>(self.members, self.span, fields, (S::NAME, S::ORDER), company);
        whole.extend(common(settings, self.work, (scheme.tolerance(), format!("{scheme:?}")), L::INVARIANTS));
        whole
    }

    fn columns(&self) -> Named {
        Named { words: &[], numbers: columns::<L, D>() }
    }

    fn set_up(&self, k: usize) -> SetUp {
        let Simulation { law, start, settings, .. } = (self.bare)(k);
        set_up(law, settings.mass, &start)
    }

    fn restore(&self, k: usize, run: Restored<State<D>>) -> Result<Run<State<D>>, Error> {
        (self.bare)(k).restore(run)
    }
}

/// What a scheme, with its tolerance and its options, and the settings have in common for all.
fn common(
    settings: &Settings,
    work: bool,
    (tolerance, options): (Option<f64>, String),
    invariants: &[&str],
) -> [(&'static str, Said); 5] {
    let number = |x: Option<f64>| x.map_or(Said::Nothing, Said::Number);
    let work = if work { ", and the work of each step" } else { "" };
    [
        ("tolerance", number(tolerance)),
        ("dt", number(settings.dt)),
        ("options", Said::Words(options)),
        ("looks", Said::Words(format!("{}{work}", settings.due))),
        ("invariants", Said::Words(invariants.join(", "))),
    ]
}

/// The mass, and the numbers of the law, by their places where they have no names.
fn columns<L: Fields<D>, const D: usize>() -> Vec<String> {
    let (mut names, count) = (Vec::new(), <L::Numbers as Numbers>::COUNT);
    L::names(&mut |name| names.push(name));
    let places: Vec<String> = (0..count).map(|i| i.to_string()).collect();
    if names.len() != count {
        names = places.iter().map(String::as_str).collect();
    }
    named("mass", &names)
}

fn set_up<L: Fields<D>, const D: usize>(law: L, mass: f64, start: &State<D>) -> SetUp {
    let numbers = [&[mass], law.numbers().list().as_slice()].concat();
    let acts = acts(&Particle::with_mass(law, mass), start);
    SetUp { words: Vec::new(), numbers, start: start.flat(), list: Vec::new(), acts }
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
