//! What tells an ensemble from another.

mod one_by_one;
mod one_law;

use super::Checksum;
use super::plan::Plan;
use crate::checkpoint::{Fingerprint, Saved};
use crate::error::Error;
use crate::flat::Flat;
use crate::run::{Attend, Restored, Run};
use crate::span::Span;

use dmech_scalar::Exact;

/// Members that can be told from others, and put together from what became of them.
pub(super) trait Told<X>: Plan<X> {
    /// What is said of all of them, in the order in which it is compared.
    fn whole(&self) -> Vec<(&'static str, Said)>;

    /// The names of the words and numbers that each has, beside the numbers of its start.
    fn columns(&self) -> Named;

    /// What a member is set up from.
    fn set_up(&self, k: usize) -> SetUp;

    /// The run of a member that was moved before.
    ///
    /// # Errors
    /// [`Error`] of a member that is refused.
    fn restore(&self, k: usize, run: Restored<X>) -> Result<Run<X>, Error>;
}

/// Something that is said of an ensemble.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Said {
    /// Nothing.
    Nothing,
    /// A count.
    Count(u64),
    /// A number.
    Number(f64),
    /// Words.
    Words(String),
}

/// What each member has by name.
#[derive(Clone, Debug)]
pub(super) struct Named {
    /// Words; where there are any, members have lists of further numbers.
    pub words: &'static [&'static str],
    /// Numbers.
    pub numbers: Vec<String>,
}

/// What a member is set up from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SetUp {
    /// Words, one for each column.
    pub words: Vec<String>,
    /// Numbers, one for each column.
    pub numbers: Vec<f64>,
    /// Where it starts.
    pub start: Vec<f64>,
    /// Further numbers, each by name, as many as this member has.
    pub list: Vec<(&'static str, f64)>,
    /// What acts where it starts and beside.
    pub acts: u64,
}

impl SetUp {
    /// A checksum of all of it.
    pub(super) fn seal(&self, k: usize) -> u64 {
        let mut seal = Checksum::default();
        seal.word(k as u64);
        self.words.iter().for_each(|word| seal.text(word));
        seal.list(&self.numbers);
        seal.list(&self.start);
        seal.word(self.list.len() as u64);
        for (name, x) in &self.list {
            seal.text(name);
            seal.word(x.to_bits());
        }
        seal.word(self.acts);
        seal.value()
    }
}

/// What acts on a system in a state, and beside it.
fn acts<Y: Saved>(system: &Y, state: &Y::State) -> u64 {
    Fingerprint::of(system, Y::time(state), system.vectors(state)).bits()
}

/// What accompanies members, as far as it can be told without having it made: that may open files.
fn company<X, O: Attend<X>>() -> String {
    let observed = if O::OBSERVES { ", observed" } else { "" };
    format!("{} events and {} watched quantities{observed}", O::EVENTS, O::QUANTITIES)
}

/// What is said of all members, with states of a kind, that a scheme of a name and an order moves: they have these numbers by name, and
/// are accompanied by something.
fn whole<X: Flat>(
    members: usize,
    span: Span,
    fields: String,
    (scheme, order): (&str, u32),
    company: String,
) -> Vec<(&'static str, Said)> {
    let [steps, end] = match span {
        Span::Steps(steps) => [Said::Count(steps), Said::Nothing],
        Span::Until(end) => [Said::Nothing, Said::Number(end)],
    };
    vec![
        ("members", Said::Count(members as u64)),
        ("scalar", Said::Words(X::Scalar::name())),
        ("dimension", Said::Count(X::DIMENSION as u64)),
        ("fields", Said::Words(fields)),
        ("scheme", Said::Words(scheme.to_owned())),
        ("order", Said::Count(order.into())),
        ("steps", steps),
        ("end", end),
        ("company", Said::Words(company)),
    ]
}
