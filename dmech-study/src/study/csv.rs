//! Studies as comma-separated values.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use dmech_core::Invariant;
use fs_err::File;

use super::report::StudyReport;

impl StudyReport {
    /// Writes a row of names, then a row for each run: scheme, order, tolerance (empty where steps are equal), dt, steps, evaluations,
    /// iterations, seconds, error, the largest drift of each invariant (empty where there is none), and the cause where the run failed.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, mut out: impl Write) -> io::Result<()> {
        write!(out, "scheme,order,tolerance,dt,steps,evaluations,iterations,seconds,error")?;
        for invariant in Invariant::ALL {
            write!(out, ",{invariant}")?;
        }
        writeln!(out, ",cause")?;
        for row in self.rows() {
            write!(out, "\"{}\",{},", row.scheme(), row.order())?;
            if let Some(tolerance) = row.tolerance() {
                write!(out, "{tolerance:e}")?;
            }
            write!(out, ",{:e},{}", row.dt(), row.steps())?;
            match row.result() {
                Ok(figures) => {
                    let seconds = figures.time().as_secs_f64();
                    write!(out, ",{},{},{seconds:e}", figures.evaluations(), figures.iterations())?;
                    write!(out, ",{:e}", figures.error())?;
                    for invariant in Invariant::ALL {
                        match figures.drift(invariant) {
                            Some(drift) => write!(out, ",{:e}", drift.max_abs())?,
                            None => write!(out, ",")?,
                        }
                    }
                    writeln!(out, ",")?;
                }
                Err(cause) => {
                    // Evaluations, iterations, seconds and error are empty, as the invariants.
                    let empty = ",".repeat(4 + Invariant::ALL.len());
                    writeln!(out, "{empty},\"{}\"", cause.to_string().replace('"', "\"\""))?;
                }
            }
        }
        Ok(())
    }

    /// As [`write_csv`](StudyReport::write_csv), into a file that is created or replaced.
    ///
    /// # Errors
    /// Those of the file.
    pub fn save_csv(&self, path: impl AsRef<Path>) -> io::Result<()> {
        let mut out = BufWriter::new(File::create(path.as_ref())?);
        self.write_csv(&mut out)?;
        out.flush()
    }
}
