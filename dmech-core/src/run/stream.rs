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
    /// let run = spring.record_every(10).stream(Csv::new(&mut table)).run(1_000_000)?;
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
        self.attended(Stream::new(sink))
    }
}

/// Where recorded states go.
pub trait Sink<X> {
    /// Begins the table; the state is one such as will come.
    ///
    /// # Errors
    /// Those of the writer.
    fn begin(&mut self, like: &X) -> io::Result<()>;
    /// Writes a state.
    ///
    /// # Errors
    /// Those of the writer.
    fn write(&mut self, state: &X) -> io::Result<()>;
    /// Ends the table, which has so many whole rows.
    ///
    /// # Errors
    /// Those of the writer.
    fn end(&mut self, rows: u64) -> io::Result<()>;
}

/// Comma-separated values: a row of names, then a row for each state, in digits that read back as the same numbers. Give it a
/// [`BufWriter`](std::io::BufWriter) for a file.
#[derive(Clone, Debug)]
pub struct Csv<W> {
    out: W,
}

impl<W: Write> Csv<W> {
    /// Values to a writer.
    pub fn new(out: W) -> Self {
        Csv { out }
    }
}

impl<X: Columns, W: Write> Sink<X> for Csv<W> {
    fn begin(&mut self, like: &X) -> io::Result<()> {
        like.write_names(&mut self.out)?;
        writeln!(self.out)
    }

    fn write(&mut self, state: &X) -> io::Result<()> {
        state.write_values(&mut self.out)?;
        writeln!(self.out)
    }

    fn end(&mut self, _: u64) -> io::Result<()> {
        self.out.flush()
    }
}

/// A table of NumPy, `numpy.load("motion.npy")`: a row of `f64` for each state, with the columns of [`Csv`]. The number of rows
/// is put into its head when the run ends, also where it ends early.
#[derive(Clone, Debug)]
pub struct Npy<W> {
    out: W,
    columns: u64,
    /// Where in the writer the table begins.
    origin: u64,
}

impl<W: Write + Seek> Npy<W> {
    /// The bytes of the head, whatever the numbers (NumPy, format 1.0).
    const HEAD: u64 = 128;

    /// A table to a writer, from where that stands.
    pub fn new(out: W) -> Self {
        Npy { out, columns: 0, origin: 0 }
    }

    fn head(&mut self, rows: u64) -> io::Result<()> {
        let magic = b"\x93NUMPY\x01\x00";
        let shape = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {}), }}", self.columns);
        let length = Self::HEAD as usize - magic.len() - 2;
        self.out.write_all(magic)?;
        self.out.write_all(&(length as u16).to_le_bytes())?;
        writeln!(self.out, "{shape:<width$}", width = length - 1)
    }
}

impl<X: Columns, W: Write + Seek> Sink<X> for Npy<W> {
    fn begin(&mut self, like: &X) -> io::Result<()> {
        self.origin = self.out.stream_position()?;
        self.columns = 0;
        like.numbers(&mut |_| self.columns += 1);
        self.head(0)
    }

    fn write(&mut self, state: &X) -> io::Result<()> {
        let mut written = Ok(());
        state.numbers(&mut |x| {
            if written.is_ok() {
                written = self.out.write_all(&x.to_le_bytes());
            }
        });
        written
    }

    fn end(&mut self, rows: u64) -> io::Result<()> {
        self.out.seek(SeekFrom::Start(self.origin))?;
        self.head(rows)?;
        // Past the last whole row: a part of one, which a full disk has left, is none.
        self.out.seek(SeekFrom::Start(self.origin + Self::HEAD + 8 * rows * self.columns))?;
        self.out.flush()
    }
}

/// A sink, and how much it has taken.
#[derive(Clone, Debug)]
pub struct Stream<W> {
    sink: W,
    rows: u64,
}

impl<W> Stream<W> {
    pub(crate) fn new(sink: W) -> Self {
        Stream { sink, rows: 0 }
    }
}

fn told(error: &io::Error) -> Error {
    Error::Stream(error.kind())
}

impl<X, W: Sink<X>> Attend<X> for Stream<W> {
    const STREAMS: bool = true;

    fn begin(&mut self, start: &X) -> Result<(), Error> {
        self.sink.begin(start).map_err(|error| told(&error))
    }

    fn take(&mut self, state: &X) -> Result<bool, Error> {
        self.sink.write(state).map_err(|error| told(&error))?;
        self.rows += 1;
        Ok(true)
    }

    fn end(&mut self) -> Result<(), Error> {
        self.sink.end(self.rows).map_err(|error| told(&error))
    }
}
