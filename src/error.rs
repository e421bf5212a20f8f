//! One error type. Bad input names field, value and allowed range.

use std::fmt;

/// What can go wrong. Nothing in this crate panics on bad input, and nothing
/// is created or changed when a call returns an error.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// An input is outside what the library promises to handle.
    #[error("{field} = {value} is not allowed: must be {allowed}")]
    Invalid {
        /// Path of the field, for example `atmosphere.mie_asymmetry[1]`.
        field: String,
        /// The value that was given.
        value: String,
        /// What would have been accepted, in words.
        allowed: String,
    },
    /// No adapter, driver or context for a backend on this machine.
    #[error("{backend}: {reason}")]
    Unavailable {
        /// `webgpu` or `webgl2`.
        backend: &'static str,
        /// What was tried and what it answered.
        reason: String,
    },
    /// The device or context was lost; make a new backend and a new renderer.
    #[error("{backend}: device lost: {reason}")]
    Lost {
        /// `webgpu` or `webgl2`.
        backend: &'static str,
        /// What the driver said.
        reason: String,
    },
    /// A shader, pipeline or resource was refused by the driver.
    #[error("{backend}: {what}: {reason}")]
    Driver {
        /// `webgpu` or `webgl2`.
        backend: &'static str,
        /// The operation that failed, and on what.
        what: String,
        /// The driver's message.
        reason: String,
    },
}

/// `Result` with this crate's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// An [`Error::Invalid`] from anything printable.
    pub fn invalid(field: impl fmt::Display, value: impl fmt::Display, allowed: impl fmt::Display) -> Self {
        Self::Invalid { field: field.to_string(), value: value.to_string(), allowed: allowed.to_string() }
    }
}

/// `value` if it is finite and within `lo..=hi`, else an [`Error::Invalid`].
pub fn in_range(field: impl fmt::Display, value: f64, lo: f64, hi: f64, unit: &str) -> Result<f64> {
    if value.is_finite() && (lo..=hi).contains(&value) {
        return Ok(value);
    }
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    Err(Error::invalid(field, short(value), format_args!("from {} to {}{unit}", short(lo), short(hi))))
}

/// A number as people write it: 0.3, 6360000, 1e15.
pub fn short(v: f64) -> String {
    if v == 0.0 || !v.is_finite() || (1e-3..1e7).contains(&v.abs()) { v.to_string() } else { format!("{v:e}") }
}

/// `v` scaled to length 1, or an [`Error::Invalid`] if it has no direction.
pub fn direction(field: &str, v: glam::DVec3) -> Result<glam::DVec3> {
    let scale = v.abs().max_element();
    if !v.is_finite() || scale < 1e-150 {
        return Err(Error::invalid(field, v, "a finite vector that is not zero"));
    }
    Ok((v / scale).normalize())
}
