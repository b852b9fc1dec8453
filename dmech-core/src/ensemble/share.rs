//! Work in blocks, over threads.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Condvar, Mutex};
use std::thread;

/// A thread is at most so many blocks ahead of the first that is not done, so that what is done needs bounded room.
const AHEAD: usize = 4;

/// Does `work` for every number below `blocks` on so many threads, and hands what it gives to `take` in their order.
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
    let (next, done, taken) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()), Mutex::new(0_usize));
    let (came, went) = (Condvar::new(), Condvar::new());
    let room = AHEAD * threads;
    thread::scope(|scope| {
        for _ in 0..threads.min(blocks) {
            scope.spawn(|| {
                loop {
                    let block = next.fetch_add(1, Ordering::Relaxed);
                    if block >= blocks {
                        return;
                    }
                    let Ok(waited) = taken.lock() else { return };
                    let Ok(waited) = went.wait_while(waited, |taken| block >= *taken + room) else { return };
                    drop(waited);
                    let result = work(block);
                    let Ok(mut done) = done.lock() else { return };
                    done.insert(block, result);
                    came.notify_one();
                }
            });
        }
        for block in 0..blocks {
            let Ok(waiting) = done.lock() else { return };
            let Ok(mut waiting) = came.wait_while(waiting, |done| !done.contains_key(&block)) else { return };
            let Some(result) = waiting.remove(&block) else { return };
            drop(waiting);
            take(result);
            if let Ok(mut taken) = taken.lock() {
                *taken = block + 1;
            }
            went.notify_all();
        }
    });
}
