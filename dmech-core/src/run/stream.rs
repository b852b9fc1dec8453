//! Recorded states that are written as they come.

use std::io::{self, Seek, SeekFrom, Write};

use super::attend::Attend;
use super::csv::Columns;
use super::simulation::{Attended, Simulation};
use crate::error::Error;
use crate::setup::Setup;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// Writes the recorded states as they come, as [`Csv`] or [`Npy`], and keeps none of them: however long the run,
    /// [`Run::states`](crate::Run::states) stays empty and memory does not grow.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    /// # #[derive(Clone, Copy)]
    /// # struct Spring { k: f64 }
    /// # impl Conservative for Spring {}
    /// # impl Potential<1> for Spring {
    /// #     fn potential(&self, [x]: [f64; 1]) -> f64 { 0.5 * self.k * x * x }
    /// #     fn gradient(&self, [x]: [f64; 1]) -> [f64; 1] { [self.k * x] }
    /// #     fn hessian(&self, _: [f64; 1]) -> [[f64; 1]; 1] { [[self.k]] }
    /// #     fn discrete_gradient(&self, [a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] { [0.5 * self.k * (a + b)] }
    /// #     fn discrete_gradient_jacobian(&self, _: [f64; 1], _: [f64; 1]) -> [[f64; 1]; 1] { [[0.5 * self.k]] }
    /// # }
    /// let mut table = Vec::new();
    /// let spring = Simulation::new(Spring { k: 4.0 }, State::new([1.0], [0.0])).scheme(Leapfrog).dt(0.01);
    /// let run = spring.record_every(10).stream(Csv(&mut table)).run(1_000_000)?;
    /// assert!(run.states().is_empty());
    /// let table = String::from_utf8(table)?;
    /// assert!(table.starts_with("t,q0,v0\n0,1,0\n0.1,"));
    /// assert_eq!(table.lines().count(), 1 + 100_001);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When run: [`Error::Stream`] where nothing more can be written; what was written stays.
    pub fn stream<W: Sink<X::State>>(self, sink: W) -> Attended<L, X, S, O, Stream<W>> {
        self.attended(Stream { sink, rows: 0 })
    }
}

/// Where recorded states go.
pub trait Sink<X> {
    /// Writes a state; `row` counts them from 0.
    ///
    /// # Errors
    /// Those of the writer.
    fn write(&mut self, row: u64, state: &X) -> io::Result<()>;
    /// Ends the table, which has so many rows.
    ///
    /// # Errors
    /// Those of the writer.
    fn end(&mut self, rows: u64) -> io::Result<()>;
}

/// Comma-separated values: a row of names, then a row for each state, in digits that read back as the same numbers. Give it a
/// [`BufWriter`](std::io::BufWriter) for a file.
#[derive(Clone, Debug)]
pub struct Csv<W>(pub W);

impl<X: Columns, W: Write> Sink<X> for Csv<W> {
    fn write(&mut self, row: u64, state: &X) -> io::Result<()> {
        if row == 0 {
            state.write_names(&mut self.0)?;
            writeln!(self.0)?;
        }
        state.write_values(&mut self.0)?;
        writeln!(self.0)
    }

    fn end(&mut self, _: u64) -> io::Result<()> {
        self.0.flush()
    }
}

/// A table of NumPy, `numpy.load("motion.npy")`: a row of `f64` for each state, with the columns of [`Csv`]. The number of rows
/// is put into its head when the run ends.
#[derive(Clone, Debug)]
pub struct Npy<W>(pub W);

impl<W: Write> Npy<W> {
    /// The head, of 128 bytes whatever the numbers (NumPy, format 1.0).
    fn head(&mut self, rows: u64, columns: usize) -> io::Result<()> {
        const HEAD: usize = 128;
        let magic = b"\x93NUMPY\x01\x00";
        let shape = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
        let length = HEAD - magic.len() - 2;
        self.0.write_all(magic)?;
        self.0.write_all(&(length as u16).to_le_bytes())?;
        writeln!(self.0, "{shape:<width$}", width = length - 1)
    }
}

impl<X: Columns, W: Write + Seek> Sink<X> for Npy<W> {
    fn write(&mut self, row: u64, state: &X) -> io::Result<()> {
        if row == 0 {
            let mut columns = 0;
            state.numbers(&mut |_| columns += 1);
            self.head(0, columns)?;
        }
        let mut written = Ok(());
        state.numbers(&mut |x| {
            if written.is_ok() {
                written = self.0.write_all(&x.to_le_bytes());
            }
        });
        written
    }

    fn end(&mut self, rows: u64) -> io::Result<()> {
        let end = self.0.stream_position()?;
        let columns = end.saturating_sub(128).checked_div(8 * rows).unwrap_or(0);
        self.0.seek(SeekFrom::Start(0))?;
        self.head(rows, columns as usize)?;
        self.0.seek(SeekFrom::Start(end.max(128)))?;
        self.0.flush()
    }
}

/// A sink, and how much it has taken.
#[derive(Clone, Debug)]
pub struct Stream<W> {
    sink: W,
    rows: u64,
}

fn told(error: &io::Error) -> Error {
    Error::Stream(error.kind())
}

impl<X, W: Sink<X>> Attend<X> for Stream<W> {
    const STREAMS: bool = true;

    fn take(&mut self, state: &X) -> Result<bool, Error> {
        self.sink.write(self.rows, state).map_err(|error| told(&error))?;
        self.rows += 1;
        Ok(true)
    }

    fn end(&mut self) -> Result<(), Error> {
        self.sink.end(self.rows).map_err(|error| told(&error))
    }
}
