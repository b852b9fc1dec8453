//! Which bodies act on others.

/// Which bodies act on others: all, but for test bodies.
#[derive(Clone, Debug, Default)]
pub(super) struct Acting {
    /// Of each body; empty where all do, so that a scene without test bodies has none of this.
    acts: Vec<bool>,
}

impl Acting {
    pub(super) fn new(bodies: usize, tests: &[usize]) -> Self {
        let mut acts = vec![true; if tests.is_empty() { 0 } else { bodies }];
        for &test in tests {
            acts[test] = false;
        }
        Acting { acts }
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
