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

    /// So many steps are made; how many more until it wants to know again.
    #[cfg_attr(not(feature = "progress"), expect(unused_variables, reason = "nothing is shown"))]
    pub(crate) fn look(&mut self, steps: u64) -> u64 {
        #[cfg(feature = "progress")]
        if let Some(bar) = &mut self.bar {
            return bar.glance(steps);
        }
        u64::MAX
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
    use std::borrow::Cow;
    use std::time::{Duration, Instant};

    use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

    use super::Shown;
    use crate::simulation::Simulation;

    /// Drawings per second at most.
    const RATE: u8 = 4;
    /// The clock is read about this often; a step of the smallest laws takes less time than that.
    const GLANCE: Duration = Duration::from_millis(50);

    impl<L, X, S, O> Simulation<L, X, S, O> {
        /// Shows a bar on the standard error while [`run`](Simulation::run) or [`run_until`](Simulation::run_until) is at
        /// work: a title, the steps, their rate and the time left, drawn four times per second at most (feature
        /// `progress`). Where the standard error is not a terminal nothing is written.
        ///
        /// ```
        /// use dmech_core::prelude::*;
        /// # struct Spring { k: f64 }
        /// # impl Conservative for Spring {}
        /// # impl Potential<1> for Spring {
        /// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.5 * self.k * x * x }
        /// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x] }
        /// #     fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] { [[self.k]] }
        /// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.5 * self.k * (a + b)] }
        /// #     fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] { [[0.5 * self.k]] }
        /// # }
        /// let run = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0]))
        ///     .scheme(Leapfrog)
        ///     .dt(0.001)
        ///     .record_every(1000)
        ///     .with_progress("a spring")
        ///     .run(100_000)?;
        /// assert_eq!(run.steps(), 100_000);
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        pub fn with_progress(self, title: impl Into<Cow<'static, str>>) -> Self {
            let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr_with_hz(RATE));
            let template = "{msg} [{bar:40}] {percent:>3} %  {human_pos} of {human_len} steps  {per_sec}  {eta} left";
            let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
            self.with_progress_bar(bar.with_style(style.progress_chars("=> ")).with_message(title))
        }

        /// The same with a bar of one's own: another style or target, or one of several in an
        /// [`indicatif::MultiProgress`]. Its length becomes the number of steps; it is finished at the end of the run, and
        /// abandoned where that ends early.
        pub fn with_progress_bar(self, bar: ProgressBar) -> Self {
            self.with(|settings| settings.shown = Shown { bar: Some(bar) })
        }
    }

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
