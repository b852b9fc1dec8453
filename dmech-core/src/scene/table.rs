//! States of many bodies as a long table.

use std::collections::BTreeSet;
use std::io::{self, Write};

use super::state::SceneState;
use crate::run::{Csv, Sink};

impl<W: Write> Csv<W> {
    /// A table of the states of a scene with a row for each body, `t,body,q0,q1,v0,v1`, which plots and databases group by
    /// the body. Bodies are named by their numbers, or by [names](LongCsv::names).
    ///
    /// ```
    /// use dmech_core::Scene;
    /// use dmech_core::prelude::*;
    ///
    /// let scene = Scene::<1>::new().body(1.0, [0.0], [0.0]).body(1.0, [3.0], [-1.0]);
    /// let mut table = Vec::new();
    /// let long = Csv::long(&mut table).names(["anvil", "hammer"]);
    /// Simulation::scene(scene).scheme(Leapfrog).dt(0.5).stream(long).run(1)?;
    /// assert_eq!(String::from_utf8(table)?, "t,body,q0,v0\n0,anvil,0,0\n0,hammer,3,-1\n0.5,anvil,0,0\n0.5,hammer,2.5,-1\n");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn long(out: W) -> LongCsv<W> {
        LongCsv { out, names: Vec::new() }
    }
}

/// Comma-separated values with a row for each state of each body: [`Csv::long`].
#[derive(Clone, Debug)]
pub struct LongCsv<W> {
    out: W,
    /// As they stand in the table; bodies without one are named by their number.
    names: Vec<String>,
}

impl<W> LongCsv<W> {
    /// Names of the bodies, in their order. Later bodies, if there are more, are named by their numbers.
    ///
    /// # Errors
    /// When written, of the kind [`InvalidInput`](io::ErrorKind::InvalidInput): more names than bodies, or two bodies of one name, whose
    /// rows nothing would tell apart.
    #[must_use]
    pub fn names<N: AsRef<str>>(mut self, names: impl IntoIterator<Item = N>) -> Self {
        self.names = names.into_iter().map(|name| quoted(name.as_ref())).collect();
        self
    }
}

/// A field as it stands in a table: in quotes, with its quotes doubled, where it would end the field (RFC 4180).
fn quoted(name: &str) -> String {
    if name.contains([',', '"', '\n', '\r']) { format!("\"{}\"", name.replace('"', "\"\"")) } else { name.to_owned() }
}

/// Refuses names that are not those of so many bodies.
fn check(names: &[String], bodies: usize) -> io::Result<()> {
    let refused = |why: String| Err(io::Error::new(io::ErrorKind::InvalidInput, why));
    if names.is_empty() {
        return Ok(());
    }
    if names.len() > bodies {
        return refused(format!("{} names for {bodies} bodies", names.len()));
    }
    let mut seen: BTreeSet<String> = (names.len()..bodies).map(|number| number.to_string()).collect();
    match names.iter().find(|&name| !seen.insert(name.clone())) {
        Some(twice) => refused(format!("two bodies are called {twice}")),
        None => Ok(()),
    }
}

impl<const D: usize, W: Write> Sink<SceneState<D>> for LongCsv<W> {
    fn begin(&mut self, like: &SceneState<D>) -> io::Result<()> {
        check(&self.names, like.q.len())?;
        write!(self.out, "t,body")?;
        for name in ["q", "v"] {
            (0..D).try_for_each(|k| write!(self.out, ",{name}{k}"))?;
        }
        writeln!(self.out)
    }

    fn write(&mut self, state: &SceneState<D>) -> io::Result<()> {
        for (i, (q, v)) in state.q.iter().zip(&state.v).enumerate() {
            write!(self.out, "{},", state.t)?;
            match self.names.get(i) {
                Some(name) => write!(self.out, "{name}")?,
                None => write!(self.out, "{i}")?,
            }
            q.iter().chain(v).try_for_each(|x| write!(self.out, ",{x}"))?;
            writeln!(self.out)?;
        }
        Ok(())
    }

    fn end(&mut self, _: u64) -> io::Result<()> {
        self.out.flush()
    }
}
