//! Work that threads share.

use std::collections::{BTreeMap, VecDeque};
use std::panic::resume_unwind;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, Builder};
use std::time::Duration;

use super::plan::{Moved, Ranges};

/// Bytes of the stack of a thread. Members side by side are arrays of registers, of which a build without optimisations keeps every
/// copy; what is not used takes no memory.
const STACK: usize = 1 << 25;

/// Jobs, each with the number of its block: those that wait for a thread, and what has come of the others.
pub(super) struct Board<X> {
    state: Mutex<State<X>>,
    /// There is a job, or there will be none any more.
    to_do: Condvar,
    /// Something has come of one, or somebody has panicked.
    done: Condvar,
}

struct State<X> {
    jobs: VecDeque<(usize, Ranges)>,
    done: BTreeMap<usize, Moved<X>>,
    /// No more jobs will come, or somebody has panicked.
    closed: bool,
    lost: bool,
}

/// Runs `direct`, which puts jobs on the board and takes what comes of them, while so many threads work. Where one of them panics all
/// end, and the panic goes on.
pub(super) fn with_hands<X: Send, O>(
    threads: usize,
    work: impl Fn(Ranges) -> Moved<X> + Sync,
    direct: impl FnOnce(&Board<X>) -> O,
) -> O {
    let state = State { jobs: VecDeque::new(), done: BTreeMap::new(), closed: false, lost: false };
    let board = Board { state: Mutex::new(state), to_do: Condvar::new(), done: Condvar::new() };
    thread::scope(|scope| {
        let hand = || {
            let _end = EndsAll(&board);
            while let Some((block, job)) = board.job() {
                let result = work(job);
                board.put(block, result);
            }
        };
        let begin = || Builder::new().stack_size(STACK).spawn_scoped(scope, hand);
        let hands: Vec<_> = (0..threads).map(|_| begin().expect("a thread is begun")).collect();
        let _end = EndsAll(&board);
        let outcome = direct(&board);
        board.look().closed = true;
        board.to_do.notify_all();
        // With the words of the one that panicked, which the end of the scope would replace by its own.
        for hand in hands {
            hand.join().unwrap_or_else(|panic| resume_unwind(panic));
        }
        outcome
    })
}

impl<X> Board<X> {
    fn look(&self) -> MutexGuard<'_, State<X>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A job, as soon as there is one; none at the end.
    fn job(&self) -> Option<(usize, Ranges)> {
        let waits = |state: &mut State<X>| !state.lost && !state.closed && state.jobs.is_empty();
        let mut state = self.to_do.wait_while(self.look(), waits).unwrap_or_else(PoisonError::into_inner);
        if state.lost { None } else { state.jobs.pop_front() }
    }

    /// Adds a job, for which one thread wakes: if all did, many threads would do little else.
    pub(super) fn add(&self, block: usize, job: Ranges) {
        self.look().jobs.push_back((block, job));
        self.to_do.notify_one();
    }

    /// A job for somebody who is no thread of this board.
    #[cfg(feature = "ranks")]
    pub(super) fn give(&self) -> Option<(usize, Ranges)> {
        self.look().jobs.pop_front()
    }

    /// What has come of a block.
    pub(super) fn put(&self, block: usize, result: Moved<X>) {
        self.look().done.insert(block, result);
        self.done.notify_one();
    }

    /// What has come of this block, if it is done.
    pub(super) fn take(&self, block: usize) -> Option<Moved<X>> {
        self.look().done.remove(&block)
    }

    /// What has come of any block.
    #[cfg(feature = "ranks")]
    pub(super) fn take_any(&self) -> Option<(usize, Moved<X>)> {
        self.look().done.pop_first()
    }

    /// Waits until this block is done, or any if none is named; no longer than a while, if one is given. Whether the threads are still
    /// there.
    pub(super) fn wait(&self, block: Option<usize>, a_while: Option<Duration>) -> bool {
        let waits = |state: &mut State<X>| {
            !state.lost && block.map_or(state.done.is_empty(), |block| !state.done.contains_key(&block))
        };
        let (state, done) = (self.look(), &self.done);
        let state = match a_while {
            None => done.wait_while(state, waits).unwrap_or_else(PoisonError::into_inner),
            Some(a_while) => done.wait_timeout_while(state, a_while, waits).unwrap_or_else(PoisonError::into_inner).0,
        };
        !state.lost
    }
}

/// Tells the others where its thread panics, who would wait for ever.
struct EndsAll<'a, X>(&'a Board<X>);

impl<X> Drop for EndsAll<'_, X> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.look().lost = true;
            self.0.to_do.notify_all();
            self.0.done.notify_all();
        }
    }
}
