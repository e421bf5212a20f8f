//! What one frame costs: how often it allocates, checks, plans and uploads.

use crate::harness::allocations;

#[test]
fn allocations_are_counted_for_this_thread_alone() {
    let (kept, n) = allocations::during(|| vec![Box::new(1), Box::new(2)]);
    assert_eq!((kept.len(), n), (2, 3));
    let (sum, n) = allocations::during(|| kept.iter().map(|v| **v).sum::<i32>());
    assert_eq!((sum, n), (3, 0));
    let other = std::thread::spawn(|| drop(vec![0_u8; 1 << 20]));
    let (_, n) = allocations::during(|| while !other.is_finished() {});
    assert_eq!(n, 0, "another thread's were counted");
}
