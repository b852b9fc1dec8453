//! What a method of a law can be, and which arguments it then knows.

/// What a method can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Potential,
    Force,
    Pair,
    PairForce,
    Invariant,
}

/// An argument that a role knows by its name.
pub(crate) struct KnownArgument {
    pub(crate) name: &'static str,
    pub(crate) meaning: &'static str,
    pub(crate) kind: Kind,
}

/// How an argument is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// `f64`
    Number,
    /// Like a position.
    Vector,
    /// A reference to what a body carries.
    Data,
}

const fn known(name: &'static str, meaning: &'static str, kind: Kind) -> KnownArgument {
    KnownArgument { name, meaning, kind }
}

const Q: KnownArgument = known("q", "position", Kind::Vector);
const V: KnownArgument = known("v", "velocity", Kind::Vector);
const M: KnownArgument = known("m", "mass", Kind::Number);
const T: KnownArgument = known("t", "time", Kind::Number);
const R: KnownArgument = known("r", "distance", Kind::Number);
const D: KnownArgument = known("d", "separation q_a − q_b", Kind::Vector);
const VA: KnownArgument = known("va", "velocity of a", Kind::Vector);
const VB: KnownArgument = known("vb", "velocity of b", Kind::Vector);
const MA: KnownArgument = known("ma", "mass of a", Kind::Number);
const MB: KnownArgument = known("mb", "mass of b", Kind::Number);
const A: KnownArgument = known("a", "data of a", Kind::Data);
const B: KnownArgument = known("b", "data of b", Kind::Data);

impl Role {
    pub(crate) const ALL: [Self; 5] = [Self::Potential, Self::Force, Self::Pair, Self::PairForce, Self::Invariant];

    /// The attribute that gives it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Potential => "potential",
            Self::Force => "force",
            Self::Pair => "pair",
            Self::PairForce => "pair_force",
            Self::Invariant => "invariant",
        }
    }

    /// What a method with this role is called in a sentence.
    pub(crate) fn noun(self) -> &'static str {
        match self {
            Self::Potential => "potential",
            Self::Force => "force",
            Self::Pair => "pair potential",
            Self::PairForce => "pair force",
            Self::Invariant => "conserved quantity",
        }
    }

    /// The arguments that it can have.
    pub(crate) fn arguments(self) -> &'static [KnownArgument] {
        match self {
            Self::Potential => &[Q, M, T],
            Self::Force => &[Q, V, M, T],
            Self::Invariant => &[Q, V, T],
            Self::Pair => &[R, D, MA, MB, A, B, T],
            Self::PairForce => &[D, VA, VB, MA, MB, A, B, T],
        }
    }

    /// The signature of a method with this role.
    pub(crate) fn example(self) -> &'static str {
        match self {
            Self::Potential => "energy(&self, q: [f64; 2]) -> f64",
            Self::Force => "force(&self, v: [f64; 2]) -> [f64; 2]",
            Self::Pair => "energy(&self, r: f64) -> f64",
            Self::PairForce => "force(&self, d: [f64; 2]) -> [f64; 2]",
            Self::Invariant => "momentum(&self, q: [f64; 2], v: [f64; 2]) -> f64",
        }
    }

    /// Whether it knows an argument of this name.
    pub(crate) fn knows(self, name: &str) -> bool {
        self.arguments().iter().any(|known| known.name == name)
    }

    /// The argument that says where.
    pub(crate) fn place(self) -> &'static KnownArgument {
        if self.is_of_two() { &D } else { &Q }
    }

    /// The role with the same bodies that knows velocities.
    pub(crate) fn force(self) -> Self {
        if self.is_of_two() { Self::PairForce } else { Self::Force }
    }

    /// Whether the law is one between two bodies.
    pub(crate) fn is_of_two(self) -> bool {
        matches!(self, Self::Pair | Self::PairForce)
    }

    /// Whether the method's value is a vector like the position, rather than one number.
    pub(crate) fn is_force(self) -> bool {
        matches!(self, Self::Force | Self::PairForce)
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|role| role.name() == name)
    }
}
