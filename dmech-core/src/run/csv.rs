//! Trajectories as comma-separated values.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use dmech_scalar::{Exact, Real as _};
use fs_err::File;

use super::Run;
use super::stream::Sink;
use crate::snapshot::Snapshot;

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

/// Those of one body are `t,q0,q1,v0,v1`; of a scene `q3_0` is component 0 of the position of body 3, and `v3_0` that of its velocity.
impl<X: Snapshot<Scalar: Exact>> Columns for X {
    fn write_names(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "t")?;
        for (name, list) in ["q", "v"].iter().zip(self.lists()) {
            for i in 0..list.len() {
                match X::LISTED {
                    true => write!(out, ",{name}{}_{}", i / X::DIMENSION, i % X::DIMENSION)?,
                    false => write!(out, ",{name}{i}")?,
                }
            }
        }
        Ok(())
    }

    fn write_values(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{}", self.time())?;
        self.lists().into_iter().flatten().try_for_each(|x| write!(out, ",{x}"))
    }

    fn numbers(&self, see: &mut dyn FnMut(f64)) {
        see(self.time());
        self.lists().into_iter().flatten().for_each(|x| see(x.to_f64()));
    }

    fn parts(&self, see: &mut dyn FnMut(f64)) {
        see(self.time());
        self.lists().into_iter().flatten().for_each(|x| x.parts(see));
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
