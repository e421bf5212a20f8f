//! Counts what a thread allocates, for tests that a steady frame allocates nothing.
//!
//! Each thread has its own count, so that tests beside it do not matter; what a driver's C or C++ code takes
//! from the system does not pass through Rust's allocator and is not counted.
#![allow(unsafe_code)] // An allocator is an unsafe trait; every call is handed on to the system's as it came.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    // Initialised at compile time and without a destructor: reading it allocates nothing, at any time of a
    // thread.
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

impl Counting {
    fn count() {
        ALLOCATIONS.with(|n| n.set(n.get() + 1));
    }
}

// SAFETY: each method passes its arguments on to `System`, whose contract is the same; counting neither
// allocates nor touches the memory.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        Self::count();
        // SAFETY: as the caller promised.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        Self::count();
        // SAFETY: as the caller promised.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, ptr: *mut u8, layout: Layout, new_size: usize) -> *mut u8 {
        Self::count();
        // SAFETY: as the caller promised.
        unsafe { System.realloc(ptr, layout, new_size) }
    }

    unsafe fn dealloc(&self, ptr: *mut u8, layout: Layout) {
        // SAFETY: as the caller promised.
        unsafe { System.dealloc(ptr, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often this thread has asked for memory so far: allocations and reallocations.
pub fn so_far() -> u64 {
    ALLOCATIONS.with(Cell::get)
}

/// How often this thread asks for memory while `work` runs.
pub fn during<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let before = so_far();
    let result = work();
    (result, so_far() - before)
}
