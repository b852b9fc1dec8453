//! Ensembles that are kept in a database, member by member, and go on from it.

mod kept;
mod layout;
mod moving;
mod record;
mod set_up;
mod settings;
mod table;
#[cfg(test)]
mod tests;

use std::path::Path;

pub(super) use moving::Stored;

use super::{Beside, Ensemble};

impl<L, X, S, M, C> Ensemble<L, X, S, M, C> {
    /// Keeps the members in a file, as they come, and goes on from it: a sweep that was killed, at whatever moment, moves those that are
    /// not in it and gives the same as one that was not, to the bit, with the same [checksum](crate::EnsembleRun::checksum)
    /// (feature `store`).
    ///
    /// The file is a database of SQLite, for any tool that opens one:
    ///
    /// | table | what | columns |
    /// |---|---|---|
    /// | `sweep` | the whole | `key`, `value`: members, scheme, dt, how far, a checksum of the set-up, at the end one of the results |
    /// | `member` | set-ups, all from the beginning | `k`, `mass`, each field of the law as `law_…`, the start as `t`, `q0` …, `v0` … |
    /// | `last` | ends | `k`, `failed` (why, else NULL), `t`, `q0` …, `v0` …, stopped, steps, evaluations, iterations |
    /// | `drift` | invariants | `k`, `invariant`, `start`, `last`, `max_abs`, `max_relative`, `slope`, and the moments of the line |
    /// | `event` | what happened | `k`, `n`, `which`, `rising`, the state there |
    /// | `state` | recorded states | `k`, `n`, `t`, `q0` …, `v0` … |
    ///
    /// NaN and −0, which SQLite does not keep in a number, stand beside in `bits`; `seal` is a checksum of the row, and in `last` of all that
    /// belongs to the member.
    ///
    /// ```no_run
    /// use dmech_core::prelude::*;
    /// # fn sweep<L: dmech_core::extend::Fields<2>>(law: impl Fn(f64) -> L + Sync) -> Result<(), Error>
    /// # where Leapfrog: dmech_core::extend::Rides<L, 2> {
    /// let sweep = Ensemble::of(1_000_000)
    ///     .law(|k| law(1.0 + 1e-6 * k as f64))
    ///     .start(|_| State::new([0.5, 0.0], [0.0, 1.63]))
    ///     .scheme(Leapfrog)
    ///     .dt(1e-3)
    ///     .look_every(100)
    ///     .store("sweep.sqlite");
    /// // Killed and started again, it goes on.
    /// let run = sweep.run_until(100.0)?;
    /// println!("{run}");
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// ```sql
    /// SELECT law_gm, max_relative FROM member JOIN drift USING (k) WHERE invariant = 'energy' ORDER BY max_relative DESC LIMIT 10;
    /// ```
    ///
    /// **What is the same.** The set-ups of all members are written before the first is moved; a store is gone on from where they are
    /// the same to the bit, and the same acts on every member where it starts and beside it. Another build, or another machine, may
    /// round what acts otherwise, and is then refused. Threads, lanes and the progress bar may change.
    ///
    /// **What accompanies members** ([`with`](Ensemble::with)) is compared by how many events and watched quantities there are, not by
    /// what they do: a program that watches something else begins another store. It accompanies members that are moved; those that are
    /// in the store are not seen again.
    ///
    /// **Members that failed** are in the store with the reason, and are moved again: the [error](crate::Error) with all its numbers is not in
    /// the database, and comes out the same.
    ///
    /// **What is lost** when the process is killed are the members that were on their way, a block of 512 at most on each thread; when the machine
    /// loses power perhaps a few blocks more, of which nothing is left. Blocks are transactions (WAL), so that others may read while the
    /// sweep goes on.
    ///
    /// # Errors
    /// When run: [`StoreError`](crate::StoreError), in [`Error::Store`](crate::Error::Store): a store of another sweep, with what differs; a
    /// damaged one; a full disk, where what was written stays and is gone on from.
    pub fn store(self, path: impl AsRef<Path>) -> Self {
        let path = Some(path.as_ref().to_owned());
        Ensemble { beside: Beside { path, ..self.beside }, ..self }
    }
}
