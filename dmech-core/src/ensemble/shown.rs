//! Ensembles that are shown.

use std::borrow::Cow;

use indicatif::ProgressBar;

use super::{Beside, EachAlone, Ensemble};
use crate::run::{Shown, bar};

impl<L, X, S, M> Ensemble<L, X, S, M> {
    /// Shows a bar on the standard error: a title, the members that are done, their rate and the time left, as
    /// [`Simulation::with_progress`](crate::Simulation::with_progress) does of steps (feature `progress`). Members that a store has are
    /// done from the beginning, and do not count for the rate.
    pub fn with_progress(self, title: impl Into<Cow<'static, str>>) -> Self {
        self.with_progress_bar(bar("members").with_message(title))
    }

    /// The same with a bar of one's own: [`Simulation::with_progress_bar`](crate::Simulation::with_progress_bar). Its length becomes the
    /// number of members.
    pub fn with_progress_bar(self, bar: ProgressBar) -> Self {
        Ensemble { beside: Beside { shown: Shown { bar: Some(bar) }, ..self.beside }, ..self }
    }
}

impl<F, K> EachAlone<F, K> {
    /// Shows a bar on the standard error, as [`Ensemble::with_progress`].
    pub fn with_progress(self, title: impl Into<Cow<'static, str>>) -> Self {
        self.with_progress_bar(bar("members").with_message(title))
    }

    /// The same with a bar of one's own.
    pub fn with_progress_bar(self, bar: ProgressBar) -> Self {
        EachAlone { shown: Shown { bar: Some(bar) }, ..self }
    }
}
