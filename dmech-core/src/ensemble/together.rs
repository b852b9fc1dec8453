//! What moves side by side.

use dmech_scalar::Rows;

use crate::law::{Fields, Numbered, Numbers};
use crate::system::Particle;

/// Particles side by side, under laws of one kind.
pub type Together<L, const D: usize, const W: usize> = Particle<Numbered<L, D, Rows<W>>, D, Rows<W>>;

/// What acts on each, by lanes.
pub(super) fn together<L: Fields<D>, const D: usize, const W: usize>(
    numbers: &[(L::Numbers, f64)],
) -> Together<L, D, W> {
    let of = |lane: usize| numbers.get(lane).unwrap_or(&numbers[0]);
    let mut laws: Vec<L::Numbers> = (0..Rows::<W>::COUNT).map(|lane| of(lane).0).collect();
    L::lend(&mut laws);
    let law = Numbered::new(|n| Rows::from_fn(|lane| laws[lane].at(n)));
    Particle::with_mass(law, Rows::from_fn(|lane| of(lane).1))
}
