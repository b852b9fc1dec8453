//! Runs that are shown.

use std::borrow::Cow;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::progress::Shown;
use super::simulation::Simulation;

/// Drawings per second at most.
const RATE: u8 = 4;

/// A bar that counts something.
pub(crate) fn bar(what: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr_with_hz(RATE));
    let template = format!(
        "{{msg}} [{{bar:40}}] {{percent:>3}} %  {{human_pos}} of {{human_len}} {what}  {{per_sec}}  {{eta}} left"
    );
    let style = ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar());
    bar.with_style(style.progress_chars("=> "))
}

impl<L, X, S, O> Simulation<L, X, S, O> {
    /// Shows a bar on the standard error while [`run`](Simulation::run) or [`run_until`](Simulation::run_until) is at
    /// work: a title, the steps, their rate and the time left, drawn four times per second at most (feature
    /// `progress`). Where the standard error is not a terminal nothing is written.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
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
        self.with_progress_bar(bar("steps").with_message(title))
    }

    /// The same with a bar of one's own: another style or target, or one of several in an
    /// [`indicatif::MultiProgress`]. Its length becomes the number of steps; it is finished at the end of the run, and
    /// abandoned where that ends early.
    pub fn with_progress_bar(self, bar: ProgressBar) -> Self {
        self.with(|settings| settings.shown = Shown { bar: Some(bar) })
    }
}
