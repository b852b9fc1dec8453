//! Recorded states that are written as they come.

use std::io;

use super::Run;
use super::attend::Attend;
use super::simulation::{Attended, Simulation};
use crate::error::Error;
use crate::setup::Setup;

impl<L, X: Setup<L>, S, O> Simulation<L, X, S, O> {
    /// Writes the recorded states as they come, as [`Csv`](crate::Csv) or [`Npy`](crate::Npy), and keeps none of them: however long the
    /// run, [`Run::states`](crate::Run::states) stays empty and memory does not grow.
    ///
    /// ```
    /// use dmech_core::prelude::*;
    #[doc = include_str!("../examples/spring.md")]
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

impl<X> Run<X> {
    /// Writes the recorded states to what [`stream`](crate::Simulation::stream) would have written them to: `Csv::new(file)`,
    /// `Csv::long(file)` for scenes, `Npy::new(file)`.
    ///
    /// # Errors
    /// Those of the writer, and where nothing was recorded because the states went to a stream.
    pub fn write(&self, mut sink: impl Sink<X>) -> io::Result<()> {
        if self.states().is_empty() && self.steps() > 0 {
            let nothing = "no states were recorded: they went to a stream, or none was due";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, nothing));
        }
        sink.begin(self.last())?;
        self.states().iter().try_for_each(|state| sink.write(state))?;
        sink.end(self.states().len() as u64)
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
