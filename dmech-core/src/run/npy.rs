//! Trajectories as tables of NumPy.

use std::io::{self, Seek, SeekFrom, Write};

use super::csv::Columns;
use super::stream::Sink;

/// A table of NumPy, `numpy.load("motion.npy")`: a row of `f64` for each state, with the columns of [`Csv`](crate::Csv). The number of rows
/// is put into its head when the run ends, also where it ends early. Each state is written at once: behind a `BufWriter` little is
/// gained, and a disk that is full may keep the number of rows from the head.
#[derive(Clone, Debug)]
pub struct Npy<W> {
    out: W,
    columns: u64,
    /// Where in the writer the table begins.
    origin: u64,
    /// The bytes of a state.
    row: Vec<u8>,
}

impl<W: Write + Seek> Npy<W> {
    /// The bytes of the head, whatever the numbers (NumPy, format 1.0).
    const HEAD: u64 = 128;

    /// A table to a writer, from where that stands.
    pub fn new(out: W) -> Self {
        Npy { out, columns: 0, origin: 0, row: Vec::new() }
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
        self.row.clear();
        state.numbers(&mut |x| self.row.extend(x.to_le_bytes()));
        self.out.write_all(&self.row)
    }

    fn end(&mut self, rows: u64) -> io::Result<()> {
        self.out.seek(SeekFrom::Start(self.origin))?;
        self.head(rows)?;
        // Past the last whole row: a part of one, which a full disk has left, is none.
        self.out.seek(SeekFrom::Start(self.origin + Self::HEAD + 8 * rows * self.columns))?;
        self.out.flush()
    }
}
