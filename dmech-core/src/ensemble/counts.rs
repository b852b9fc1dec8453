//! The steps of members side by side.

use core::mem::take;

use super::rows::LANES;

/// After so many steps at the latest somebody looks whether all are still finite.
const ROW: u64 = 64;

/// How many steps there are, for each lane: the same whatever moves.
pub(super) struct Counts {
    /// Until each has ended.
    pub(super) left: [u64; LANES],
    /// Until its invariants are to be looked at, and how many there are from one look to the next.
    pub(super) until_look: [u64; LANES],
    every: [u64; LANES],
    /// Those that were made since each was seated or landed, and how many there were at the last look.
    made: [u64; LANES],
    looked_at: [Option<u64>; LANES],
}

impl Default for Counts {
    /// No lane has a member.
    fn default() -> Self {
        let none = [u64::MAX; LANES];
        Counts { left: none, until_look: none, every: none, made: [0; LANES], looked_at: [None; LANES] }
    }
}

impl Counts {
    /// So many are before a member; of looks, how many until the next and between two, if they are counted.
    pub(super) fn seat(&mut self, lane: usize, left: u64, looks: Option<[u64; 2]>) {
        self.left[lane] = left;
        [self.until_look[lane], self.every[lane]] = looks.unwrap_or([u64::MAX; 2]);
    }

    /// Leaves a lane without a member.
    pub(super) fn leave(&mut self, lane: usize) {
        self.seat(lane, u64::MAX, None);
    }

    /// A member makes no more steps.
    pub(super) fn dismiss(&mut self, lane: usize) {
        (self.left[lane], self.until_look[lane]) = (0, u64::MAX);
    }

    #[inline]
    pub(super) fn has_ended(&self) -> bool {
        self.left.contains(&0)
    }

    /// Steps until one ends, or is to be looked at.
    pub(super) fn row(&self) -> u64 {
        let mut row = ROW;
        for lane in 0..LANES {
            row = row.min(self.left[lane]).min(self.until_look[lane]);
        }
        row
    }

    /// Counts the steps that all have made.
    pub(super) fn have_made(&mut self, made: u64) {
        for lane in 0..LANES {
            self.made[lane] += made;
            self.left[lane] -= made;
            self.until_look[lane] -= made;
        }
    }

    /// Whether it is time to look at somebody.
    #[inline]
    pub(super) fn is_due(&self) -> bool {
        self.until_look.contains(&0)
    }

    /// Whether a member has been looked at, which then waits for the next look.
    #[inline]
    pub(super) fn look(&mut self, lane: usize) -> bool {
        let due = self.until_look[lane] == 0;
        if due {
            self.until_look[lane] = self.every[lane];
            self.looked_at[lane] = Some(self.made[lane]);
        }
        due
    }

    /// The steps that a member has made since it was asked before, and how many there were at a look, if there was one.
    pub(super) fn land(&mut self, lane: usize) -> (u64, Option<u64>) {
        (take(&mut self.made[lane]), self.looked_at[lane].take())
    }
}
