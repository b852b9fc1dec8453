//! Work in blocks, over threads.

use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

/// A thread is at most so many blocks ahead of the first that is not done, so that what is done needs bounded room.
const AHEAD: usize = 4;

/// Does `work` for every number below `blocks` on so many threads, and hands what it gives to `take` in their order. Where one of
/// them panics all end, and the panic goes on.
pub(super) fn in_order<T: Send>(
    blocks: usize,
    threads: usize,
    work: impl Fn(usize) -> T + Sync,
    mut take: impl FnMut(T),
) {
    if threads <= 1 || blocks <= 1 {
        (0..blocks).for_each(|block| take(work(block)));
        return;
    }
    let board = Board { blocks, room: AHEAD * threads, ..Board::default() };
    thread::scope(|scope| {
        for _ in 0..threads.min(blocks) {
            scope.spawn(|| {
                let _end = EndsAll(&board);
                while let Some(block) = board.next() {
                    let result = work(block);
                    board.look().done.insert(block, result);
                    board.changed.notify_all();
                }
            });
        }
        let _end = EndsAll(&board);
        while let Some(result) = board.first() {
            take(result);
        }
    });
}

/// What the threads know of one another.
struct Board<T> {
    blocks: usize,
    room: usize,
    state: Mutex<State<T>>,
    changed: Condvar,
}

impl<T> Default for Board<T> {
    fn default() -> Self {
        let state = State { next: 0, taken: 0, done: BTreeMap::new(), lost: false };
        Board { blocks: 0, room: 0, state: Mutex::new(state), changed: Condvar::new() }
    }
}

struct State<T> {
    /// The next block to be begun, and the first that is not taken.
    next: usize,
    taken: usize,
    done: BTreeMap<usize, T>,
    /// Somebody has panicked.
    lost: bool,
}

impl<T> Board<T> {
    fn look(&self) -> MutexGuard<'_, State<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits while this holds and nothing is lost.
    fn wait_while(&self, holds: impl Fn(&State<T>) -> bool) -> MutexGuard<'_, State<T>> {
        let waits = |state: &mut State<T>| !state.lost && holds(state);
        self.changed.wait_while(self.look(), waits).unwrap_or_else(PoisonError::into_inner)
    }

    /// A block to work on, as soon as there is room for what comes of it.
    fn next(&self) -> Option<usize> {
        let mut state = self.wait_while(|state| state.next < self.blocks && state.next >= state.taken + self.room);
        let block = state.next;
        state.next += 1;
        (block < self.blocks && !state.lost).then_some(block)
    }

    /// What has come of the first block that is not taken.
    fn first(&self) -> Option<T> {
        let mut state = self.wait_while(|state| state.taken < self.blocks && !state.done.contains_key(&state.taken));
        let block = state.taken;
        state.taken += 1;
        self.changed.notify_all();
        state.done.remove(&block)
    }
}

/// Tells the others where its thread panics, who would wait for ever.
struct EndsAll<'a, T>(&'a Board<T>);

impl<T> Drop for EndsAll<'_, T> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.look().lost = true;
            self.0.changed.notify_all();
        }
    }
}
