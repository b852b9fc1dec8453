//! An allocator that counts, for the suites that show that steps do not allocate and how much memory a scene takes.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
    static LIVE: Cell<isize> = const { Cell::new(0) };
    static PEAK: Cell<isize> = const { Cell::new(0) };
}

fn note(allocations: usize, bytes: isize) {
    ALLOCATIONS.with(|n| n.set(n.get() + allocations));
    let live = LIVE.with(|n| {
        n.set(n.get() + bytes);
        n.get()
    });
    PEAK.with(|n| n.set(n.get().max(live)));
}

// SAFETY: every request goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        note(1, layout.size() as isize);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        note(0, -(layout.size() as isize));
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// How often this thread allocates while it does some work.
pub fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.with(Cell::get);
    work();
    ALLOCATIONS.with(Cell::get) - before
}

/// How many more bytes this thread has asked for than given back.
pub fn bytes() -> isize {
    LIVE.with(Cell::get)
}

/// How many more bytes than before this thread has had at once while it did some work.
pub fn peak(work: impl FnOnce()) -> isize {
    let before = bytes();
    PEAK.with(|n| n.set(before));
    work();
    PEAK.with(Cell::get) - before
}

#[test]
fn the_counter_counts() {
    let (before, mut kept) = (bytes(), None);
    assert_eq!(allocations(|| kept = Some(std::hint::black_box(Box::new(1_u64)))), 1);
    assert_eq!(bytes() - before, 8);
    drop(kept);
    assert_eq!(bytes(), before);
    let some = || drop(std::hint::black_box(Vec::<u8>::with_capacity(1000)));
    let twice = || {
        some();
        some();
    };
    assert_eq!([peak(some), peak(twice), peak(|| ())], [1000, 1000, 0]);
}
