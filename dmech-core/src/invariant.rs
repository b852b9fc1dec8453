//! What a motion must keep, and how well it was kept.

/// A quantity that a motion, or a scheme, keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Invariant {
    /// m v²/2 + Φ(q).
    Energy,
    /// The scheme's own energy; for `Kanatani` m z²/2 + (Φ(q) + Φ(q₋))/2 (3.9)–(3.10).
    DiscreteEnergy,
    /// Kinetic energy less accumulated work, each by the scheme's own definition (Greenspan (2.7)–(2.9), Kanatani (3.3)–(3.6)).
    WorkEnergy,
    /// m v.
    LinearMomentum,
    /// m (q v − v q), the antisymmetric product about the origin.
    AngularMomentum,
}

impl Invariant {
    /// All of them, in the order of reports.
    pub const ALL: [Invariant; 5] = [
        Invariant::Energy,
        Invariant::DiscreteEnergy,
        Invariant::WorkEnergy,
        Invariant::LinearMomentum,
        Invariant::AngularMomentum,
    ];

    /// Something of each, in this order; compiled once, whatever asks.
    pub(crate) fn each<T>(of: &mut dyn FnMut(Invariant) -> T) -> [T; Self::ALL.len()] {
        Self::ALL.map(of)
    }
}

impl core::fmt::Display for Invariant {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(match self {
            Invariant::Energy => "energy",
            Invariant::DiscreteEnergy => "discrete energy",
            Invariant::WorkEnergy => "kinetic energy - work",
            Invariant::LinearMomentum => "linear momentum",
            Invariant::AngularMomentum => "angular momentum",
        })
    }
}

/// How well a scheme keeps an invariant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Kept {
    /// To round-off.
    Exact,
    /// It deviates by a power of the step and does not drift.
    Bounded,
    /// The same while nothing bends or jumps, and the law of the run does: what each crossing of a kink, a cut-off or the image in a box
    /// leaves adds up as a walk.
    BetweenSeams,
    /// Not at all, or there is none: the energy under a drag, the angular momentum where the law has none.
    No,
}

impl core::fmt::Display for Kept {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(match self {
            Kept::Exact => "exact",
            Kept::Bounded => "bounded",
            Kept::BetweenSeams => "bounded between seams",
            Kept::No => "not kept",
        })
    }
}
