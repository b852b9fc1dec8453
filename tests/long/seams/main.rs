//! Motions across seams: laws with choices, contacts and kinks, single and in scenes, by every scheme.

mod adaptive;
mod aimed;
mod energy;
mod every_scheme;
mod forces;
mod granular;
mod laws;
mod measured;
mod scenes;
mod schemes;
