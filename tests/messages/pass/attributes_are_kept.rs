//! What the author wrote around the potential stays: visibility, docs, attributes, other members.
#![deny(missing_docs)]
use dmech::prelude::*;

/// A law.
#[derive(Debug)]
pub struct Spring {
    /// Stiffness.
    pub k: f64,
}

/// The block.
#[dmech::law]
#[allow(clippy::missing_const_for_fn)]
impl Spring {
    /// The equilibrium.
    pub const REST: f64 = 0.5;

    /// Not part of the law, and not readable as a formula.
    pub fn describe(&self) -> String {
        format!("{:?}", self.k)
    }

    /// A constructor.
    #[must_use]
    pub fn new(k: f64) -> Self {
        Self { k }
    }

    /// The energy of the spring.
    #[inline]
    #[must_use]
    #[potential]
    pub fn energy(&self, q: f64) -> f64 {
        let x = q - Self::REST;
        0.5 * self.k * x * x
    }
}

fn main() {
    let spring = Spring::new(4.0);
    assert_eq!(spring.describe(), "4.0");
    assert_eq!(spring.energy(1.0), 0.5);
    assert_eq!(spring.gradient([1.0]), [2.0]);
}
