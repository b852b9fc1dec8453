//! The workshop of the suites: laws, motions and meters that they share.
//!
//! | suite | what it holds |
//! |---|---|
//! | `papers` | what Greenspan and Kanatani computed |
//! | `laws` | the language of a law; what is generated from one, against the law itself |
//! | `schemes` | order, invariants, reversal, work of every scheme |
//! | `scenes` | many bodies |
//! | `runs` | what is saved, resumed, shown |
//! | `messages` | a package of its own: laws that are refused, with every word |
//!
//! These compile many laws for many schemes and compute little: they are not optimised. A test that takes more than some seconds so
//! belongs to those in `long/`, which are:
//!
//! | suite | what it holds |
//! |---|---|
//! | `seams` | motions across seams: choices, contacts, kinks |
//! | `stages` | Gauss's method and line integrals: orders to 16, exact energies, published ends, where steps break |
//! | `systems` | every scheme on every system |
//! | `ensembles` | members that are, to the bit, what they are alone |
//! | `by_hand` | the core alone, with laws that no macro wrote |
//! | `many_steps` | motions of many steps or of many bodies |
#![allow(missing_docs, clippy::new_without_default)]

pub mod erased;
pub mod few;
pub mod laws;
pub mod measured;
pub mod memory;
pub mod motion;
pub mod published;
pub mod restricted;
