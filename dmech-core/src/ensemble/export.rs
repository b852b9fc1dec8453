//! The ends of all members as one table.

use std::io::{self, Write};

use super::EnsembleRun;
use crate::run::{Columns, Interrupted, Run, Sink};

/// The last state of a member with its number, as a row of a table; NaN of one that failed.
#[derive(Clone, Debug)]
pub struct End<X> {
    k: usize,
    last: X,
    failed: bool,
}

impl<X> End<X> {
    /// The number of the member.
    pub fn k(&self) -> usize {
        self.k
    }

    /// Where it ended; `None` if it failed.
    pub fn last(&self) -> Option<&X> {
        (!self.failed).then_some(&self.last)
    }
}

impl<X: Columns> Columns for End<X> {
    fn write_names(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "k,")?;
        self.last.write_names(out)
    }

    fn write_values(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{}", self.k)?;
        if !self.failed {
            write!(out, ",")?;
            return self.last.write_values(out);
        }
        let mut columns = 0;
        self.last.numbers(&mut |_| columns += 1);
        (0..columns).try_for_each(|_| write!(out, ",NaN"))
    }

    fn numbers(&self, see: &mut dyn FnMut(f64)) {
        see(self.k as f64);
        self.last.numbers(&mut |x| see(if self.failed { f64::NAN } else { x }));
    }
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
    pub fn write(&self, mut sink: impl Sink<End<X>>) -> io::Result<()> {
        let mut rows = self.members().enumerate().map(|(k, member)| End {
            k,
            last: last(member).clone(),
            failed: member.is_err(),
        });
        let Some(first) = rows.next() else { return Ok(()) };
        let columns = |state: &X| {
            let mut columns = 0;
            state.numbers(&mut |_| columns += 1);
            columns
        };
        let width = columns(&first.last);
        if self.members().any(|member| columns(last(member)) != width) {
            let why = "members of unequal numbers of bodies have no common columns";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, why));
        }
        sink.begin(&first)?;
        sink.write(&first)?;
        rows.try_for_each(|row| sink.write(&row))?;
        sink.end(self.len() as u64)
    }
}

/// The last state of a member, also of one that failed.
fn last<'a, X: Clone>(member: Result<&'a Run<X>, &'a Interrupted<X>>) -> &'a X {
    member.unwrap_or_else(Interrupted::run).last()
}
