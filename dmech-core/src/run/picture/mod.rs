//! Pictures of runs.

mod drift;
mod motion;

use std::io;
use std::path::Path;

use dmech_plot::{count, rough, save, span};

use super::Run;
use crate::invariant::Invariant;
use crate::state::State;
use dmech_scalar::Real;

impl<const D: usize, R: Real> Run<State<D, R>> {
    /// Draws the motion over the recorded states, as SVG into a file.
    ///
    /// | coordinates | what is drawn |
    /// |---|---|
    /// | 1 | the position over time, and the velocity over the position |
    /// | 2 | the path, y over x on one scale |
    /// | 3 | the path from two sides: y over x, z over x |
    /// | more | q₂ over q₁, q₄ over q₃, and q₆ over q₅: those of bodies that one law moves |
    ///
    /// Start and end are marked, the title has scheme, step and times. The numbers are in the units of the law, small and large
    /// ones less what they have in common and by a power of ten that the axis names. States that are not finite are left out,
    /// and how many is said. A million states make a file of less than a megabyte: what would lie on what is drawn is left out.
    ///
    /// ```no_run
    /// # use dmech_core::prelude::*;
    /// # fn show(run: Run<State<2>>) -> std::io::Result<()> {
    /// run.plot("orbit.svg")?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Unsupported`](io::ErrorKind::Unsupported) where no state was recorded, as of a stream;
    /// [`InvalidInput`](io::ErrorKind::InvalidInput) for the name of a picture of another kind; those of the file.
    pub fn plot(&self, path: impl AsRef<Path>) -> io::Result<()> {
        save(path, &motion::svg(self)?)
    }
}

#[cfg(feature = "scene")]
impl<const D: usize> Run<crate::SceneState<D>> {
    /// Draws the paths of the bodies over the recorded states, as SVG into a file: as of a motion under one law, each body in a
    /// colour and with its number where there are six or fewer. A ring is a start, a dot an end, a square a body that stayed
    /// where it was.
    ///
    /// # Errors
    /// Likewise.
    pub fn plot(&self, path: impl AsRef<Path>) -> io::Result<()> {
        save(path, &motion::svg(self)?)
    }
}

impl<X> Run<X> {
    /// Draws how the energy moved, as SVG into a file: [`plot_drift`](Run::plot_drift) of [`Invariant::Energy`].
    ///
    /// ```no_run
    /// # use dmech_core::prelude::*;
    /// # fn show(run: Run<State<2>>) -> std::io::Result<()> {
    /// run.plot_energy("energy.svg")?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Likewise.
    pub fn plot_energy(&self, path: impl AsRef<Path>) -> io::Result<()> {
        self.plot_drift(Invariant::Energy, path)
    }

    /// Draws how an invariant moved over the recorded states, as SVG into a file: (I − I₀)/|I₀| over time, or I − I₀ where
    /// I₀ = 0; on a logarithmic axis where it grows, or has peaks, by more than two powers of ten.
    ///
    /// It is drawn from the [`history`](Run::history) of the invariant, which runs with a stream have as well and members of an ensemble
    /// have not.
    ///
    /// # Errors
    /// [`Unsupported`](io::ErrorKind::Unsupported) where the law, or the scheme, has no such invariant, or the run did not keep
    /// its history; those of the file.
    pub fn plot_drift(&self, invariant: Invariant, path: impl AsRef<Path>) -> io::Result<()> {
        let name = invariant.to_string();
        let (drift, history) = (self.drift(invariant), self.history(invariant));
        let kept = format!("; must be: {}", self.kept(invariant));
        let drift = drift.ok_or_else(|| format!("this law and {} have no invariant \"{name}\"", self.report.scheme()));
        save(path, &drift::svg(self, &name, drift, history, &kept)?)
    }

    /// The same of an invariant that the law declares itself, or of a quantity that was
    /// [watched](crate::Simulation::watch), by its name.
    ///
    /// # Errors
    /// Likewise.
    pub fn plot_drift_of(&self, name: &str, path: impl AsRef<Path>) -> io::Result<()> {
        let none = || {
            let others: Vec<_> = self.report.own_drifts().map(|(own, _)| format!("\"{own}\"")).collect();
            match &*others.join(", ") {
                "" => format!(
                    "this run follows no \"{name}\": `.watch` follows a quantity of your own, `#[invariant]` one of a law alone"
                ),
                others => format!("this run follows no \"{name}\": there is {others}"),
            }
        };
        let drift = self.drift_of(name).ok_or_else(none);
        save(path, &drift::svg(self, &name.replace('_', " "), drift, self.history_of(name), "")?)
    }

    /// The scheme, its steps, and the times from and to.
    fn made(&self, times: [f64; 2]) -> String {
        let report = &self.report;
        let steps = match (report.tolerance(), report.dt_range()) {
            (None, _) => format!("dt = {}", rough(report.dt(), 6)),
            (Some(tolerance), None) => format!("tolerance {}", rough(tolerance, 3)),
            (Some(tolerance), Some([shortest, longest])) => {
                format!("tolerance {}, dt {} … {}", rough(tolerance, 3), rough(shortest, 2), rough(longest, 2))
            }
        };
        let number = match self.steps() {
            1 => "1 step".to_owned(),
            n => format!("{} steps", count(n)),
        };
        format!("{}, {steps}, {number}, t = {}", report.scheme(), span(times))
    }
}
