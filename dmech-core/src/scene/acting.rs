//! Which bodies act on others.

use core::ops::Range;

/// Which bodies act on others: all, but for test bodies.
#[derive(Clone, Debug, Default)]
pub struct Acting {
    /// Of each body; empty where all do, so that a scene without test bodies has none of this.
    acts: Vec<bool>,
    groups: Vec<Group>,
}

/// Consecutive bodies that all act on others, or all do not.
#[derive(Clone, Debug)]
pub(super) struct Group {
    pub(super) bodies: Range<usize>,
    pub(super) acts: bool,
}

impl Acting {
    pub(super) fn new(bodies: usize, tests: &[usize]) -> Self {
        let mut acts = vec![true; if tests.is_empty() { 0 } else { bodies }];
        for &test in tests {
            acts[test] = false;
        }
        let mut groups: Vec<Group> = Vec::new();
        for (i, &acts) in acts.iter().enumerate() {
            match groups.last_mut() {
                Some(group) if group.acts == acts => group.bodies.end = i + 1,
                _ => groups.push(Group { bodies: i..i + 1, acts }),
            }
        }
        Acting { acts, groups }
    }

    /// All bodies in groups, where some are test bodies.
    pub(super) fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// There are no test bodies.
    #[inline(always)]
    pub(super) fn all(&self) -> bool {
        self.acts.is_empty()
    }

    /// Whether body i acts on others.
    #[inline(always)]
    pub(super) fn acts(&self, i: usize) -> bool {
        self.all() || self.acts[i]
    }
}
