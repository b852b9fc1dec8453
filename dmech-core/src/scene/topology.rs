//! Which bodies are linked.

/// Which bodies a Jacobian links.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Topology {
    /// Consecutive bodies at most.
    Chain,
    /// The pairs of a list, beside consecutive bodies where `chain` says so.
    Sparse {
        /// The listed pairs.
        bonds: Vec<(usize, usize)>,
        /// Consecutive bodies are linked too.
        chain: bool,
    },
    /// Those within reach of each other, which change.
    Near,
    /// Any two.
    Dense,
}

impl Topology {
    /// Both together.
    pub fn and(self, other: Topology) -> Topology {
        match (self, other) {
            (Topology::Dense, _) | (_, Topology::Dense) => Topology::Dense,
            (Topology::Near, _) | (_, Topology::Near) => Topology::Near,
            (Topology::Chain, Topology::Chain) => Topology::Chain,
            (Topology::Chain, Topology::Sparse { bonds, .. }) | (Topology::Sparse { bonds, .. }, Topology::Chain) => {
                Topology::Sparse { bonds, chain: true }
            }
            (Topology::Sparse { bonds: mut all, chain }, Topology::Sparse { bonds, chain: other }) => {
                all.extend(bonds);
                Topology::Sparse { bonds: all, chain: chain || other }
            }
        }
    }
}
