//! The guide, from a first motion to a scheme of one's own.
//!
// A chapter ends with its links as the book has them, `[scenes]: scenes.md`. What stands first counts: here that is the list of the
// same names as items of this crate.
#![doc = include_str!("guide/links.md")]
#![doc = include_str!("../docs/guide/introduction.md")]

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/first-motion.md")]
pub mod first_motion {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/language.md")]
pub mod language {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/choices.md")]
pub mod choices {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/schemes.md")]
pub mod schemes {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/scenes.md")]
pub mod scenes {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/loops.md")]
pub mod loops {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/ensembles.md")]
pub mod ensembles {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/own-scheme.md")]
pub mod own_scheme {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/derivation.md")]
pub mod derivation {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/rounding.md")]
pub mod rounding {}

#[doc = include_str!("guide/links.md")]
#[doc = include_str!("../docs/guide/performance.md")]
pub mod performance {}
