//! Why a checkpoint is refused.

use thiserror::Error;

use crate::name::Name;
use crate::text::{Longest, Number};

/// What differs between a checkpoint and the simulation that was to go on from it.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Difference {
    /// It was written by another version of this crate.
    #[error("the checkpoint has the format {checkpoint}, this version reads {here}")]
    Format {
        /// That of the checkpoint.
        checkpoint: u32,
        /// That which is understood.
        here: u32,
    },
    /// The number of coordinates of a body.
    #[error("the dimension is {checkpoint} in the checkpoint against {here}")]
    Dimension {
        /// In the checkpoint.
        checkpoint: usize,
        /// In the simulation.
        here: usize,
    },
    /// The number of bodies.
    #[error("the checkpoint has {checkpoint} bodies, this scene {here}")]
    Bodies {
        /// In the checkpoint.
        checkpoint: usize,
        /// In the scene.
        here: usize,
    },
    /// The scheme.
    #[error("the checkpoint is of {checkpoint}, this simulation of {here}")]
    Scheme {
        /// In the checkpoint.
        checkpoint: Name,
        /// In the simulation.
        here: &'static str,
    },
    /// The options of the scheme.
    #[error("the scheme has other options: `{checkpoint}` in the checkpoint against `{here}`")]
    Options {
        /// The first that differs, in the checkpoint.
        checkpoint: Name,
        /// In the simulation.
        here: &'static str,
    },
    /// The time step.
    #[error("dt is {} in the checkpoint against {}", Longest(*checkpoint), Longest(*here))]
    TimeStep {
        /// In the checkpoint.
        checkpoint: f64,
        /// In the simulation.
        here: f64,
    },
    /// The time of the start.
    #[error("the start is at t = {} in the checkpoint against {}", Number(*checkpoint), Number(*here))]
    Start {
        /// In the checkpoint.
        checkpoint: f64,
        /// In the simulation.
        here: f64,
    },
    /// A mass.
    #[error("body {body} has another mass: {} in the checkpoint against {}", Number(*checkpoint), Number(*here))]
    Mass {
        /// The body, counted from 0.
        body: usize,
        /// In the checkpoint.
        checkpoint: f64,
        /// In the simulation.
        here: f64,
    },
    /// A pin.
    #[error("body {body} is {} in the checkpoint and {} in this scene", pin(*pinned), pin(!pinned))]
    Pin {
        /// The body, counted from 0.
        body: usize,
        /// Whether it is pinned in the checkpoint.
        pinned: bool,
    },
    /// What acts.
    #[error(
        "the laws differ: at the positions of the checkpoint they do not give the same forces and energy to the bit"
    )]
    Laws,
    /// A number that the laws read.
    #[error("the laws differ: `{name}` is not what it is in the checkpoint")]
    Field {
        /// The field of the law, or what it reads of the bodies.
        name: &'static str,
    },
    /// It is not as it was written.
    #[error("the checkpoint was changed after it was written: its {part}")]
    Edited {
        /// The first part that was changed.
        part: &'static str,
    },
    /// Numbers are missing or too many.
    #[error("the checkpoint is damaged: {found} numbers or lists where {expected} belong")]
    Damaged {
        /// What the checkpoint has.
        found: usize,
        /// What belongs there.
        expected: usize,
    },
}

fn pin(pinned: bool) -> &'static str {
    if pinned { "pinned" } else { "free" }
}
