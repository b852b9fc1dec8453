//! Fingerprints of what a checkpoint holds: nothing of it was changed after it was written.

use super::{Checkpoint, Digits, Fingerprint};
use crate::error::Difference;

impl Checkpoint {
    /// The same with fingerprints of its parts.
    pub(crate) fn sealed(self) -> Self {
        let seals = self.parts().map(|(_, seal)| seal).into();
        Checkpoint { seals, ..self }
    }

    /// Whether every part is what was written.
    ///
    /// # Errors
    /// [`Difference::Edited`] with the first part that is not.
    pub(super) fn check_seals(&self) -> Result<(), Difference> {
        let parts = self.parts();
        if self.seals.len() != parts.len() {
            return Err(Difference::Damaged { found: self.seals.len(), expected: parts.len() });
        }
        let edited = parts.iter().zip(&self.seals).find(|((_, seal), saved)| seal != *saved);
        edited.map_or(Ok(()), |(&(part, _), _)| Err(Difference::Edited { part }))
    }

    /// The parts by name. Each fingerprint is one of all parts so far, so that parts of several checkpoints do not fit
    /// together.
    fn parts(&self) -> [(&'static str, Fingerprint); 6] {
        let mut seal = Fingerprint::new();
        let lists = |seal: &mut Fingerprint, lists: &[Digits]| {
            seal.add_bits(lists.len() as u64);
            lists.iter().for_each(|list| seal.add_list(&list.0));
        };
        let mut named = |part: &'static str, add: &dyn Fn(&mut Fingerprint)| {
            add(&mut seal);
            (part, seal)
        };
        [
            named("scheme, time step or time", &|seal| {
                seal.add_text(&self.scheme);
                seal.add_text(&self.options);
                [self.dimension, self.bodies].into_iter().for_each(|n| seal.add_bits(n as u64));
                seal.add_list(&self.times.0);
            }),
            named("list of masses or of pins", &|seal| {
                seal.add_list(&self.masses.0);
                seal.add_bits(self.pins.len() as u64);
                self.pins.iter().for_each(|&body| seal.add_bits(body as u64));
            }),
            named("fingerprint of the laws", &|seal| {
                seal.add_bits(self.laws.bits());
                self.fields.add_to(seal);
            }),
            named("count of steps, evaluations or iterations", &|seal| {
                [self.steps, self.steps_before, self.evaluations, self.iterations]
                    .into_iter()
                    .for_each(|n| seal.add_bits(n));
            }),
            named("start", &|seal| lists(seal, &self.start)),
            named("memory of the scheme", &|seal| lists(seal, &self.memory)),
        ]
    }
}
