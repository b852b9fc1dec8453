//! Ensembles of [dmech](https://docs.rs/dmech) over the ranks of MPI.
//!
//! Every rank runs the same program. The first hands out blocks of members and takes what comes back in their order, so that the results
//! are, to the bit, those of one process, for any number of ranks and threads; a rank that is done asks for more.
//!
//! ```no_run
//! use dmech::models::Kepler;
//! use dmech::prelude::*;
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let sweep = || {
//!         Ensemble::of(1_000_000)
//!             .law(|k| Kepler { gm: 1.0 + 1e-6 * k as f64 })
//!             .start(|_| State::new([0.5, 0.0], [0.0, 1.63]))
//!             .scheme(Nystrom::order6())
//!             .dt(0.01)
//!             .look_every(100)
//!     };
//!     let world = dmech_mpi::World::start()?;
//!     let run = sweep().store("sweep.sqlite").ranks(&world).run_until(100.0)?;
//!     // The first rank has the results, the others have nothing.
//!     if let Some(run) = run {
//!         println!("{run}checksum {:016x}", run.checksum());
//!     }
//!     Ok(())
//! }
//! ```
//!
//! `mpirun -n 4 target/release/sweep` runs it on four ranks, and without `mpirun` it is one rank. `scripts/local.sh` and
//! `scripts/slurm.sh` of the repository are such runs, on one machine and on many.
//!
//! Simulations of any kind, [`Ensemble::each`](dmech_core::Ensemble::each), are moved in the same way.
//!
//! # Ranks and threads
//! One rank for each machine with a thread for each core, or one rank for each core with `.threads(1)`: both work. The main thread of
//! each rank sends and receives, and sleeps between; it needs no core. Open MPI binds ranks to single cores unless told otherwise: where
//! ranks have threads, say `--bind-to none` or `--map-by numa`.
//!
//! # What is lost
//! When a rank dies MPI ends the job and names the rank; so does a rank that panics. What is in the [store] is whole, and the same program
//! goes on from there, with any number of ranks.
//!
//! # How far it scales
//! Measured: a member of two coordinates that is not recorded on its way comes home in some 190 bytes, in a message with at most 511 others,
//! and costs the first rank 0.5 µs to read. An order takes about ten bytes, and is there before the last block is done. So n members of
//! τ each on P threads, in blocks of b = n/8P (a multiple of the lanes, 32 with AVX-512, and 512 at most), take about
//!
//! ```text
//! T = max(n τ/P, 0.5 µs n) + b τ
//! ```
//!
//! and the first rank keeps up with P = τ/0.5 µs threads: 200 where a member takes 0.1 ms, 20 000 where it takes 10 ms, of 10⁴ steps.
//! On 1000 ranks of one thread 10⁶ members of 10 ms take 10 s, and one more at the end for the last block of each (1.3 s); with 64 threads
//! each 0.5 s of reading, 0.16 s of motion and 0.3 s at the end. Members shorter than 0.5 ms do not keep a thousand threads busy.
//!
//! [store]: https://docs.rs/dmech-core/latest/dmech_core/struct.Ensemble.html#method.store
#![forbid(unsafe_code)]

use std::thread::panicking;

use dmech_core::extend::Ranks;
use mpi::Threading;
use mpi::environment::{Universe, initialize_with_threading, processor_name};
use mpi::point_to_point::MatchedReceiveVec as _;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, Destination, Source};

/// Room for what the first rank has sent and nobody has received yet, in bytes for each rank: a message has half a kilobyte at most, and
/// a rank is sent one more than it has threads.
const ROOM: usize = 1 << 17;

/// Why there are no ranks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// MPI is started once in a program, and never again.
    #[error("MPI has been started before, by this program or a library: there is one World")]
    Started,
    /// The library has no threads.
    #[error(
        "this MPI works for programs without threads only (MPI_THREAD_SINGLE): it was built without --enable-mpi-threads"
    )]
    Threads,
}

/// All ranks of a run of MPI.
///
/// It ends MPI when it goes. A rank that panics ends all of them: they would wait for it.
pub struct World {
    world: SimpleCommunicator,
    _universe: Universe,
}

impl World {
    /// Starts MPI.
    ///
    /// # Errors
    /// [`Refused`]
    pub fn start() -> Result<Self, Refused> {
        // The main thread alone speaks with the others.
        let (mut universe, threading) = initialize_with_threading(Threading::Funneled).ok_or(Refused::Started)?;
        if threading < Threading::Funneled {
            return Err(Refused::Threads);
        }
        let world = universe.world();
        if world.rank() == 0 {
            universe.set_buffer_size(ROOM * world.size() as usize);
        }
        Ok(World { world, _universe: universe })
    }

    /// Which rank this is, from 0.
    pub fn rank(&self) -> usize {
        self.world.rank() as usize
    }

    /// How many ranks there are.
    pub fn count(&self) -> usize {
        self.world.size() as usize
    }

    /// All ranks as rsmpi has them, for messages of one's own before and after an ensemble.
    pub fn communicator(&self) -> &SimpleCommunicator {
        &self.world
    }
}

impl core::fmt::Debug for World {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("World").field("rank", &self.rank()).field("count", &self.count()).finish()
    }
}

impl Ranks for World {
    fn rank(&self) -> usize {
        World::rank(self)
    }

    fn count(&self) -> usize {
        World::count(self)
    }

    fn send(&self, to: usize, message: &[u8]) {
        let to = self.world.process_at_rank(to as i32);
        // The first must not wait for one who waits for it.
        if self.rank() == 0 { to.buffered_send(message) } else { to.send(message) }
    }

    fn receive(&self) -> Option<(usize, Vec<u8>)> {
        let (message, status) = self.world.any_process().immediate_matched_probe()?.matched_receive_vec();
        Some((status.source_rank() as usize, message))
    }
}

impl Drop for World {
    fn drop(&mut self) {
        if panicking() {
            let host = processor_name().unwrap_or_default();
            eprintln!("rank {} of {} on {host} has panicked: the job ends", self.rank(), self.count());
            self.world.abort(101);
        }
    }
}
