//! The workshop of the suites: laws, motions and meters that they share.
//!
//! | suite | what it holds |
//! |---|---|
//! | `papers` | what Greenspan and Kanatani computed |
//! | `laws` | the language of a law; what is generated from one, against the law itself |
//! | `schemes` | order, invariants, reversal, seams, round-off of every scheme |
//! | `stages` | Gauss's method and line integrals: orders to 16, exact energies, published ends, where steps break |
//! | `scenes` | many bodies |
//! | `seams` | motions across seams: choices, contacts, kinks |
//! | `runs` | what is saved, resumed, shown |
//! | `by_hand` | the core alone, with laws that no macro wrote |
//! | `messages` | a package of its own: laws that are refused, with every word |
#![allow(missing_docs, clippy::new_without_default)]

pub mod erased;
pub mod few;
pub mod laws;
pub mod measured;
pub mod memory;
pub mod motion;
pub mod published;
