//! Saving a simulation and going on with it, bit for bit.

mod carried;
mod digits;
mod fields;
mod fingerprint;
mod seal;

pub use carried::{Carried, Saved};
pub(crate) use carried::{load, save};
pub(crate) use digits::Digits;
pub(crate) use fields::Fingerprints;
pub(crate) use fingerprint::Fingerprint;

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use crate::error::Difference;
use crate::method::Method;
use crate::name::{Name, options_apart};

/// Where a simulation stands: everything that the next step needs, and what shows that it is the same simulation.
///
/// [`Stepper::checkpoint`](crate::Stepper::checkpoint) makes one, [`Simulation::resume`](crate::Simulation::resume) goes on from
/// it. The motion is then that of a simulation which never stopped, equal to the bit, as long as the program does
/// the same arithmetic: another build may round otherwise, and is then refused as if the laws differed. What was changed in a
/// checkpoint after it was written is noticed by fingerprints of its parts.
///
/// Saved are the time of the start, dt, the counts of steps, evaluations and corrections, the masses, the pins, and the
/// memory of the scheme in full, with the low parts of its sums and the forces of the last steps. Laws are not saved: the
/// program has them. Fingerprints of every field that they read, and of what they read of the bodies, tell whether they are
/// the same, and one of the potential and of every force, at the saved positions and velocities and at displaced ones. Of a
/// law written by hand no fields are known: parameters that matter at neither are not noticed.
///
/// Numbers are written as text in Rust's shortest form that reads back as the same `f64`. This keeps them exact in every
/// format of serde: JSON numbers do not survive `serde_json` without its feature `float_roundtrip`, and bits as integers
/// do not fit into formats whose integers have 63 bits or are `f64` themselves.
///
/// ```
/// use dmech_core::prelude::*;
#[doc = include_str!("../examples/spring.md")]
/// let spring = |k| Simulation::new(Spring { k }, State::new([1.0], [0.0])).scheme(DiscreteGradient).dt(0.01);
/// let mut whole = spring(4.0).stepper()?;
/// whole.advance(1000)?;
///
/// let mut first = spring(4.0).stepper()?;
/// first.advance(400)?;
/// let saved = serde_json::to_string(&first.checkpoint())?;
///
/// let checkpoint: Checkpoint = serde_json::from_str(&saved)?;
/// let mut second = spring(4.0).resume(&checkpoint)?;
/// second.advance(600)?;
/// assert_eq!(second.state(), whole.state());
///
/// let refused = spring(4.5).resume(&checkpoint).err();
/// assert_eq!(refused, Some(Error::Checkpoint(dmech_core::Difference::Laws)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    pub(crate) format: u32,
    pub(crate) scheme: String,
    pub(crate) options: String,
    pub(crate) dimension: usize,
    pub(crate) bodies: usize,
    /// t₀, dt, the time now, and that of the last change of the stepper, from which it counts its steps.
    pub(crate) times: Digits,
    pub(crate) masses: Digits,
    pub(crate) pins: Vec<usize>,
    pub(crate) laws: Fingerprint,
    pub(crate) fields: Fingerprints,
    pub(crate) steps: u64,
    /// Those before the last change.
    pub(crate) steps_before: u64,
    pub(crate) evaluations: u64,
    pub(crate) iterations: u64,
    /// The positions and velocities of the start: a scheme may hold those only to rounding.
    pub(crate) start: Vec<Digits>,
    pub(crate) memory: Vec<Digits>,
    /// What was written, part by part.
    pub(crate) seals: Vec<Fingerprint>,
}

/// The form of a checkpoint, to be raised when what a scheme carries changes.
pub(crate) const FORMAT: u32 = 4;

impl Checkpoint {
    /// Steps made.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The time.
    pub fn t(&self) -> f64 {
        self.times.0.get(2).copied().unwrap_or(f64::NAN)
    }

    /// The number of bodies; 1 for a law without a scene.
    pub fn bodies(&self) -> usize {
        self.bodies
    }

    /// The name of the scheme.
    pub fn scheme(&self) -> &str {
        &self.scheme
    }

    /// The time of the last change, or of the start.
    pub(crate) fn begun_at(&self) -> f64 {
        self.times.0.get(3).copied().unwrap_or(f64::NAN)
    }

    fn times(&self) -> [f64; 2] {
        core::array::from_fn(|i| self.times.0.get(i).copied().unwrap_or(f64::NAN))
    }

    /// The options of a scheme, as it shows them.
    pub(crate) fn options<S: Method>(scheme: &S) -> String {
        format!("{scheme:?}")
    }

    /// Compares what must be known before any number of the memory is looked at with a simulation that is to go on.
    pub(crate) fn fits<S: Method>(&self, here: &Checkpoint) -> Result<(), Difference> {
        if self.format != FORMAT {
            return Err(Difference::Format { checkpoint: self.format, here: FORMAT });
        }
        if self.dimension != here.dimension {
            return Err(Difference::Dimension { checkpoint: self.dimension, here: here.dimension });
        }
        if self.bodies != here.bodies {
            return Err(Difference::Bodies { checkpoint: self.bodies, here: here.bodies });
        }
        if self.scheme != here.scheme {
            return Err(Difference::Scheme { checkpoint: Name::of(&[&self.scheme]), here: S::NAME });
        }
        if self.options != here.options {
            let (checkpoint, here) = options_apart(&self.options, &here.options);
            return Err(Difference::Options { checkpoint, here });
        }
        let ([start, dt], [start_here, dt_here]) = (self.times(), here.times());
        if !same(dt, dt_here) {
            return Err(Difference::TimeStep { checkpoint: dt, here: dt_here });
        }
        if !same(start, start_here) {
            return Err(Difference::Start { checkpoint: start, here: start_here });
        }
        Digits::fit([&self.masses], [&here.masses])?;
        for (body, (&mass, &mass_here)) in self.masses.0.iter().zip(&here.masses.0).enumerate() {
            if !same(mass, mass_here) {
                return Err(Difference::Mass { body, checkpoint: mass, here: mass_here });
            }
        }
        let [pins, pins_here] = [&self.pins, &here.pins].map(|pins| pins.iter().copied().collect::<BTreeSet<_>>());
        if let Some(&body) = pins.symmetric_difference(&pins_here).next() {
            return Err(Difference::Pin { body, pinned: pins.contains(&body) });
        }
        Digits::fit(&self.start, &here.start)?;
        Digits::fit(&self.memory, &here.memory)?;
        self.check_seals()
    }
}

fn same(x: f64, y: f64) -> bool {
    x.to_bits() == y.to_bits()
}
