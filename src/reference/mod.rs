//! f64 ground truth on the CPU.
