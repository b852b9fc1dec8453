//! Motions across seams: laws with choices, contacts and kinks, single and in scenes, by every scheme.

mod energy;
mod every_scheme;
mod forces;
mod granular;
mod laws;
mod scenes;
mod schemes;
