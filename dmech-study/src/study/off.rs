//! Pictures where their feature is off: their names say so.

use std::io;
use std::path::Path;

use dmech_core::off::FeaturePlot;

use super::StudyReport;

// Bounds that name no lifetime would be refused here, and not where they are asked for.
impl StudyReport {
    #[doc(hidden)]
    pub fn plot<'a>(&'a self, _: impl AsRef<Path>) -> io::Result<()>
    where
        &'a Self: FeaturePlot,
    {
        <&Self as FeaturePlot>::nothing()
    }

    #[doc(hidden)]
    pub fn plot_titled<'a>(&'a self, _: impl AsRef<Path>, _: &str) -> io::Result<()>
    where
        &'a Self: FeaturePlot,
    {
        <&Self as FeaturePlot>::nothing()
    }
}
