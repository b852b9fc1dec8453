//! Trajectories as comma-separated values.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use dmech_scalar::Exact;
use fs_err::File;

use super::Run;
use super::stream::Sink;
use crate::state::State;

/// A state that can be written as a row of numbers.
pub trait Columns {
    /// Writes the names of the columns, separated by commas.
    ///
    /// # Errors
    /// Those of the writer.
    fn write_names(&self, out: &mut dyn Write) -> io::Result<()>;
    /// Writes the numbers in the same order, with as many digits as it takes to read the same numbers back.
    ///
    /// # Errors
    /// Those of the writer.
    fn write_values(&self, out: &mut dyn Write) -> io::Result<()>;
    /// Shows the numbers in the same order, rounded to `f64`.
    fn numbers(&self, see: &mut dyn FnMut(f64));
    /// Shows all that tells them from others, [part](Exact::parts) by part: of states whose numbers are `f64` the numbers themselves.
    fn parts(&self, see: &mut dyn FnMut(f64)) {
        self.numbers(see);
    }
}

impl<const D: usize, R: Exact> Columns for State<D, R> {
    fn write_names(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "t")?;
        for name in ["q", "v"] {
            for i in 0..D {
                write!(out, ",{name}{i}")?;
            }
        }
        Ok(())
    }

    fn write_values(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{}", self.t)?;
        for x in self.q.iter().chain(&self.v) {
            write!(out, ",{x}")?;
        }
        Ok(())
    }

    fn numbers(&self, see: &mut dyn FnMut(f64)) {
        see(self.t);
        self.q.iter().chain(&self.v).for_each(|x| see(x.to_f64()));
    }

    fn parts(&self, see: &mut dyn FnMut(f64)) {
        see(self.t);
        self.q.iter().chain(&self.v).for_each(|x| x.parts(see));
    }
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

impl<X: Columns> Run<X> {
    /// Writes the recorded states: a row of names (`t,q0,q1,v0,v1`), then a row for each state, in digits that read
    /// back as the same numbers.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, out: impl Write) -> io::Result<()> {
        self.write(Csv::new(out))
    }

    /// As [`write_csv`](Run::write_csv), into a file that is created or replaced.
    ///
    /// # Errors
    /// Those of the file.
    pub fn save_csv(&self, path: impl AsRef<Path>) -> io::Result<()> {
        self.write_csv(BufWriter::new(File::create(path.as_ref())?))
    }
}
