//! Showing how far a run is.

/// Whether a run is to be shown.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shown {
    #[cfg(feature = "progress")]
    pub(crate) bar: Option<indicatif::ProgressBar>,
}

/// Follows a run, if it is shown.
pub(crate) struct Follow {
    #[cfg(feature = "progress")]
    bar: Option<Bar>,
}

impl Follow {
    #[cfg_attr(not(feature = "progress"), expect(unused_variables, reason = "nothing is shown"))]
    pub(crate) fn new(shown: Shown, steps: u64) -> Self {
        Follow {
            #[cfg(feature = "progress")]
            bar: shown.bar.map(|bar| Bar::new(bar, steps)),
        }
    }

    /// Nobody looks.
    pub(crate) fn nobody() -> Self {
        Follow::new(Shown::default(), 0)
    }

    /// So many steps are made; how many more until it wants to know again.
    #[cfg_attr(not(feature = "progress"), expect(unused_variables, reason = "nothing is shown"))]
    pub(crate) fn look(&mut self, steps: u64) -> u64 {
        #[cfg(feature = "progress")]
        if let Some(bar) = &mut self.bar {
            return bar.glance(steps);
        }
        u64::MAX
    }

    /// So many were made before, at no cost: nothing is learned from them of the time that is left.
    #[cfg_attr(not(feature = "progress"), expect(unused_variables, reason = "nothing is shown"))]
    pub(crate) fn pass(&mut self, steps: u64) {
        #[cfg(feature = "progress")]
        if let Some(bar) = &mut self.bar {
            bar.pass(steps);
        }
    }

    /// The run ended after its last step, or before.
    #[cfg_attr(not(feature = "progress"), expect(unused_variables, reason = "nothing is shown"))]
    pub(crate) fn end(self, steps: u64, complete: bool) {
        #[cfg(feature = "progress")]
        if let Some(bar) = self.bar {
            bar.end(steps, complete);
        }
    }
}

#[cfg(feature = "progress")]
use bar::Bar;

#[cfg(feature = "progress")]
mod bar {
    use std::time::{Duration, Instant};

    use indicatif::ProgressBar;

    /// The clock is read about this often; a step of the smallest laws takes less time than that.
    const GLANCE: Duration = Duration::from_millis(50);

    /// A bar, and how many steps go by until the clock is read again.
    pub(super) struct Bar {
        bar: ProgressBar,
        stride: u64,
        glanced: Instant,
    }

    impl Bar {
        pub(super) fn new(bar: ProgressBar, steps: u64) -> Self {
            if steps != crate::span::UNCOUNTED {
                bar.set_length(steps);
            }
            bar.set_position(0);
            bar.reset_eta();
            Bar { bar, stride: 1, glanced: Instant::now() }
        }

        #[cold]
        pub(super) fn glance(&mut self, steps: u64) -> u64 {
            let now = Instant::now();
            let passed = now - self.glanced;
            // Twice as many steps, or half as many, until about GLANCE goes by between two looks at the clock.
            if passed < GLANCE / 2 {
                self.stride = self.stride.saturating_mul(2);
            } else if passed > GLANCE * 2 {
                self.stride = (self.stride / 2).max(1);
            }
            self.glanced = now;
            self.bar.set_position(steps);
            self.stride
        }

        pub(super) fn pass(&mut self, steps: u64) {
            self.bar.set_position(steps);
            self.bar.reset_eta();
        }

        pub(super) fn end(self, steps: u64, complete: bool) {
            self.bar.set_position(steps);
            if complete {
                self.bar.finish();
            } else {
                self.bar.abandon();
            }
        }
    }
}
