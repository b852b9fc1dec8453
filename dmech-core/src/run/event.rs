//! What happened in a run.

/// The directions in which a function of the state may pass through zero to be an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Crossing {
    /// From below.
    Rising,
    /// From above.
    Falling,
    /// Either.
    Any,
}

impl Crossing {
    pub(super) fn admits(self, rising: bool) -> bool {
        match self {
            Crossing::Rising => rising,
            Crossing::Falling => !rising,
            Crossing::Any => true,
        }
    }
}

impl core::fmt::Display for Crossing {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(match self {
            Crossing::Rising => "rising",
            Crossing::Falling => "falling",
            Crossing::Any => "either way",
        })
    }
}

/// Something that happened in a run.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Event<X> {
    which: usize,
    state: X,
    crossing: Crossing,
    bodies: Option<[usize; 2]>,
    after: Option<X>,
}

impl<X> Event<X> {
    pub(crate) fn new(which: usize, state: X, crossing: Crossing, bodies: Option<[usize; 2]>) -> Self {
        Event { which, state, crossing, bodies, after: None }
    }

    /// The same in another state.
    pub(super) fn at(self, state: X) -> Self {
        Event { state, ..self }
    }

    /// The same, from which the motion has gone on in another state.
    pub(crate) fn changed_to(self, after: X) -> Self {
        Event { after: Some(after), ..self }
    }

    /// Which of the events of the simulation it is, counted from 0 in the order in which they were asked for.
    pub fn which(&self) -> usize {
        self.which
    }

    /// When and where: the state at the event.
    pub fn state(&self) -> &X {
        &self.state
    }

    /// The state from which the motion went on, where the event changed it: of several at one time each has what it left to the next.
    pub fn after(&self) -> Option<&X> {
        self.after.as_ref()
    }

    /// Whether the function was [`Rising`](Crossing::Rising) or [`Falling`](Crossing::Falling).
    pub fn crossing(&self) -> Crossing {
        self.crossing
    }

    /// The two bodies of an encounter.
    pub fn bodies(&self) -> Option<[usize; 2]> {
        self.bodies
    }
}

#[cfg(test)]
mod tests {
    use super::Crossing;

    /// Words that stand in a line, as wide as they are asked for.
    #[test]
    fn directions_have_words() {
        let words = [Crossing::Rising, Crossing::Falling, Crossing::Any].map(|crossing| format!("{crossing:>10}"));
        assert_eq!(words, ["    rising", "   falling", "either way"]);
    }
}
