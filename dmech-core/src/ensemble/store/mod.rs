//! Ensembles that are kept in a database, member by member, and go on from it.

mod kept;
mod layout;
mod moving;
mod places;
mod record;
mod set_up;
mod settings;
mod table;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

pub(super) use moving::Stored;

use super::each::OneByOne;
use super::plan::Opened;
use super::{Beside, EachAlone, Ensemble, Keeps, Nowhere};
use crate::checkpoint::Saved;
use crate::flat::Flat;
use crate::run::{Attend, Columns};
use crate::scheme::Scheme;
use crate::setup::Setup;

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
    /// The fields of a [small scene](Ensemble::scene) are `law_mass_0` … and `law_inertia_0` …, infinite where a body is pinned; those of
    /// its laws; what these read of the bodies, `law_bodies_0` …; `law_bonds_0` …, for each body those that it is bound to as bits;
    /// `law_cutoff`; `law_box_0` ….
    ///
    /// NaN and −0, which SQLite does not keep in a number, stand beside in `bits`; `seal` is a checksum of the row, and in `last` of all
    /// that belongs to the member.
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
    /// **What must be the same.** The set-ups of all members are written before the first is moved. A sweep goes on from a store if the
    /// set-ups are the same to the bit, and if what acts on each member is, at its start and at a place displaced from it. Another
    /// build, or another machine, may round what acts differently, and is then refused. Threads, lanes and the progress bar may change.
    ///
    /// **What accompanies members** ([`with`](Ensemble::with)) is compared by how many events and watched quantities there are, not by
    /// what they do: a program that watches something else begins another store. It accompanies members that are moved; those that are
    /// in the store are not seen again.
    ///
    /// **Members that failed** are in the store with the reason, and are moved again: the [error](crate::Error) with all its numbers is
    /// not in the database, and comes out the same.
    ///
    /// **What is lost** when the process is killed are the members that were on their way, a block of 512 at most on each thread; when
    /// the machine loses power perhaps a few blocks more, of which nothing is left. Blocks are transactions (WAL), so that others may
    /// read while the sweep goes on.
    ///
    /// # Errors
    /// When run: [`StoreError`](crate::StoreError), in [`Error::Store`](crate::Error::Store): a store of another sweep, with what
    /// differs; a damaged one; a full disk, where what was written stays and is gone on from.
    pub fn store(self, path: impl AsRef<Path>) -> Self {
        let path = Some(path.as_ref().to_owned());
        Ensemble { beside: Beside { path, ..self.beside }, ..self }
    }
}

/// In the type of simulations that are kept in a [store](EachAlone::store).
#[derive(Clone, Debug)]
pub struct InFile(PathBuf);

impl<F> EachAlone<F, Nowhere> {
    /// Keeps the members in a file, as they come, and goes on from it: [`Ensemble::store`], of simulations of any kind (feature
    /// `store`).
    ///
    /// The tables are those of an ensemble of one law, with what each member has of its own:
    ///
    /// | table | what | columns |
    /// |---|---|---|
    /// | `member` | set-ups | `k`, `options` of the scheme, `looks`, `invariants`, `dt`, `tolerance`, `mass`, the start |
    /// | `number` | what else there is | `k`, `n`, `name`, `value`: fields of laws, masses, pins, bonds, data of the bodies, box, cut-off |
    /// | `body` | bodies of a scene | `k`, `what` (`start`, `last`, `event`, `state`), `n`, `body`, `q0` …, `v0` … |
    ///
    /// Where bodies have rows of their own, the other tables tell the time and how many there are.
    ///
    /// Numbers of another scalar than `f64`, which `sweep` names by the key `scalar`, are kept to the last bit
    /// ([`Exact`](crate::extend::Exact)): an `f32` in one column, a [`DoubleDouble`](crate::DoubleDouble) in two, `q0` and `q0_low`.
    /// Drifts, fields of laws and times are `f64` in a run of any scalar. CSV has all digits, a table of NumPy those of `f64`.
    ///
    /// ```no_run
    /// # #[cfg(feature = "scene")] {
    /// use dmech_core::prelude::*;
    /// # fn sweep<L>(moon: impl Fn(usize) -> Scene<2, (), L> + Sync) -> Result<(), Error>
    /// # where L: dmech_core::scene::Term<2, (), Ready: dmech_core::scheme::WithoutVelocities> {
    /// let sweep = Ensemble::each(10_000, |k| Simulation::scene(moon(k)).scheme(Nystrom::order6()).dt(0.01).record_every(1000))
    ///     .store("moons.sqlite");
    /// // Killed and started again, it goes on.
    /// let run = sweep.run_until(1e4)?;
    /// println!("{run}");
    /// # Ok(())
    /// # }
    /// # }
    /// ```
    ///
    /// ```sql
    /// SELECT k, q0, q1 FROM body WHERE what = 'last' AND body = 2;
    /// ```
    ///
    /// **What is the same**: schemes with their options, steps, starts, masses, pins, every number of the laws that can be had, and what
    /// acts on all bodies where they start and displaced from there. Of a law written by hand no fields are known, nor of a function that
    /// drives a body: what matters at neither place is not noticed. So it is with events, watched quantities and observers, of which the
    /// number is compared, and with a scheme of one's own beyond what its `Debug` shows.
    ///
    /// **The function is asked for every member before the first is moved**, again when that is moved, and once when it is read. A stream
    /// to a file that the function creates would be emptied each time: open such files to be appended to.
    ///
    /// **What is lost** when the process is killed are the members on their way, eight at most on each thread, and those that are done
    /// and wait for one of a smaller number, up to four times as many.
    ///
    /// # Errors
    /// As [`Ensemble::store`].
    pub fn store(self, path: impl AsRef<Path>) -> EachAlone<F, InFile> {
        let EachAlone { member, members, hands, shown, .. } = self;
        EachAlone { member, members, hands, shown, keep: InFile(path.as_ref().to_owned()) }
    }
}

#[diagnostic::do_not_recommend]
impl<L, X, S, O> Keeps<L, X, S, O> for InFile
where
    X: Setup<L, State: Flat + Columns, System: Saved>,
    S: Scheme<X::System>,
    O: Attend<X::State>,
{
    fn open<'a>(&self, plan: &'a OneByOne<'a, L, X, S, O>) -> Opened<'a, X::State> {
        Stored::open(&self.0, plan)
    }
}
