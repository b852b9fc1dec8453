//! States as lists of numbers.

use dmech_scalar::Exact;

use crate::snapshot::Snapshot;

/// A state as a list of numbers: its time, then position and velocity of one body after another, each number by its
/// [parts](Exact::parts). Where positions or velocities are too few, as in a state that is refused, NaN stands for them.
pub trait Flat: Snapshot<Scalar: Exact> {
    /// How much of the list a body takes.
    const BODY: usize = 2 * Self::DIMENSION * Self::Scalar::PARTS;

    /// All numbers.
    fn flat(&self) -> Vec<f64> {
        let bodies = self.bodies();
        let mut flat = Vec::with_capacity(1 + bodies * Self::BODY);
        flat.push(self.time());
        for (body, list) in (0..bodies).flat_map(|body| [(body, 0), (body, 1)]) {
            let places = body * Self::DIMENSION..(body + 1) * Self::DIMENSION;
            places.for_each(|place| self.number(list, place).parts(&mut |part| flat.push(part)));
        }
        flat
    }

    /// The state of these numbers.
    fn of_flat(flat: &[f64]) -> Self {
        let (time, flat) = flat.split_first().map_or((f64::NAN, flat), |(&time, rest)| (time, rest));
        let bodies = flat.len().checked_div(Self::BODY).unwrap_or(0);
        Self::from_numbers(time, bodies, |list, place| {
            let [body, k] = [place / Self::DIMENSION, place % Self::DIMENSION];
            let first = ((2 * body + list) * Self::DIMENSION + k) * Self::Scalar::PARTS;
            let mut parts = flat.iter().skip(first).copied();
            Self::Scalar::of_parts(&mut || parts.next().unwrap_or(f64::NAN))
        })
    }
}

impl<X: Snapshot<Scalar: Exact>> Flat for X {}
