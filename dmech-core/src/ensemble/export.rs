//! Members as tables: their ends, with numbers of one's own beside them, and their paths.

use std::io::{self, Write};

use super::EnsembleRun;
use crate::run::{Columns, Interrupted, Run, Sink};

/// A state of a member with its number and others, as a row of a table; the last of a member that failed is NaN.
#[derive(Clone, Debug)]
pub struct End<X, const N: usize = 0> {
    k: usize,
    names: [&'static str; N],
    beside: [f64; N],
    state: X,
    failed: bool,
}

impl<X, const N: usize> End<X, N> {
    /// The number of the member.
    pub fn k(&self) -> usize {
        self.k
    }

    /// Where it ended; `None` if it failed.
    pub fn last(&self) -> Option<&X> {
        (!self.failed).then_some(&self.state)
    }

    /// The numbers beside it.
    pub fn beside(&self) -> [f64; N] {
        self.beside
    }
}

impl<X: Columns, const N: usize> Columns for End<X, N> {
    fn write_names(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "k,")?;
        self.names.iter().try_for_each(|name| write!(out, "{name},"))?;
        self.state.write_names(out)
    }

    fn write_values(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{}", self.k)?;
        self.beside.iter().try_for_each(|x| write!(out, ",{x}"))?;
        if !self.failed {
            write!(out, ",")?;
            return self.state.write_values(out);
        }
        (0..columns(&self.state)).try_for_each(|_| write!(out, ",NaN"))
    }

    fn numbers(&self, see: &mut dyn FnMut(f64)) {
        see(self.k as f64);
        self.beside.into_iter().for_each(&mut *see);
        self.state.numbers(&mut |x| see(if self.failed { f64::NAN } else { x }));
    }
}

/// How many numbers a state has.
fn columns(state: &impl Columns) -> usize {
    let mut columns = 0;
    state.numbers(&mut |_| columns += 1);
    columns
}

impl<X: Clone + Columns> EnsembleRun<X> {
    /// Writes a row for each member, as [`Run::write`](crate::Run::write) does for each state: its number, then its last state; NaN of a
    /// member that failed. `Csv::new(file)`, `Npy::new(file)`. Of no members nothing is written.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let member = |k| Simulation::new(Spring { k: 4.0 }, State::new([k as f64], [0.0])).scheme(Leapfrog).dt(0.01);
    /// let run = Ensemble::each(3, member).run(0)?;
    /// let mut table = Vec::new();
    /// run.write(Csv::new(&mut table))?;
    /// assert_eq!(String::from_utf8(table)?, "k,t,q0,v0\n0,0,0,0\n1,0,1,0\n2,0,2,0\n");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of the writer; [`InvalidInput`](io::ErrorKind::InvalidInput) where members have unequal numbers of bodies.
    pub fn write(&self, sink: impl Sink<End<X>>) -> io::Result<()> {
        self.write_with([], |_, _| [], sink)
    }

    /// As [`write`](EnsembleRun::write), with columns of one's own after the number of the member: its parameters, drifts, how often
    /// something has happened. Of a member that failed the function is given the run up to there.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let stiffness = |k: usize| 1.0 + k as f64;
    /// let member = |k| Simulation::new(Spring { k: stiffness(k) }, State::new([1.0], [0.0])).scheme(Leapfrog).dt(0.01);
    /// let run = Ensemble::each(3, member).run(100)?;
    /// let mut table = Vec::new();
    /// let error = |run: &Run<State<1>>| run.drift(Invariant::Energy).map_or(f64::NAN, |drift| drift.max_relative());
    /// run.write_with(["stiffness", "energy error"], |k, run| [stiffness(k), error(run)], Csv::new(&mut table))?;
    /// assert!(String::from_utf8(table)?.starts_with("k,stiffness,energy error,t,q0,v0\n0,1,"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`write`](EnsembleRun::write), and for a name that has a comma, a quote or the end of a line in it.
    pub fn write_with<const N: usize>(
        &self,
        names: [&'static str; N],
        mut beside: impl FnMut(usize, &Run<X>) -> [f64; N],
        sink: impl Sink<End<X, N>>,
    ) -> io::Result<()> {
        if let Some(name) = names.iter().find(|name| name.contains([',', '"', '\n', '\r'])) {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, format!("{name:?} is no name of a column")));
        }
        let runs = self.members().enumerate();
        let rows = runs.map(|(k, member)| {
            let run = member.unwrap_or_else(Interrupted::run);
            End { k, names, beside: beside(k, run), state: run.last().clone(), failed: member.is_err() }
        });
        self.write_rows(rows, sink)
    }

    /// Writes a row for each recorded state of each member, with the number of the member before it: their paths, of those that failed up to
    /// there. Members that have recorded nothing have no row.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
    /// let member = |k| Simulation::new(Spring { k: 4.0 }, State::new([k as f64], [0.0])).scheme(Leapfrog).dt(0.25).record_every(2);
    /// let run = Ensemble::each(3, member).run(4)?;
    /// let mut table = Vec::new();
    /// run.write_states(Csv::new(&mut table))?;
    /// let table = String::from_utf8(table)?;
    /// assert_eq!(table.lines().count(), 1 + 3 * 3);
    /// assert!(table.starts_with("k,t,q0,v0\n0,0,0,0\n0,0.5,"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`write`](EnsembleRun::write).
    pub fn write_states(&self, sink: impl Sink<End<X>>) -> io::Result<()> {
        let runs = self.members().map(|member| member.unwrap_or_else(Interrupted::run)).enumerate();
        let rows = runs.flat_map(|(k, run)| {
            let row = move |state: &X| End { k, names: [], beside: [], state: state.clone(), failed: false };
            run.states().iter().map(row)
        });
        self.write_rows(rows, sink)
    }

    fn write_rows<const N: usize>(
        &self,
        rows: impl Iterator<Item = End<X, N>>,
        mut sink: impl Sink<End<X, N>>,
    ) -> io::Result<()> {
        let mut widths = self.members().map(|member| columns(member.unwrap_or_else(Interrupted::run).last()));
        let width = widths.next();
        if widths.any(|other| Some(other) != width) {
            let why = "members of unequal numbers of bodies have no common columns";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, why));
        }
        let mut written = 0;
        for row in rows {
            if written == 0 {
                sink.begin(&row)?;
            }
            sink.write(&row)?;
            written += 1;
        }
        if written > 0 { sink.end(written) } else { Ok(()) }
    }
}
