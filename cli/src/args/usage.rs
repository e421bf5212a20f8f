//! The error of a request that cannot be carried out as it was put.

use std::fmt;

/// A request that cannot be carried out as it was put. It ends in exit status 2.
#[derive(Debug)]
pub struct UsageError(String);

impl UsageError {
    /// An error in plain words.
    pub fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }

    /// An error that names option, value and what is allowed, in clap's own form.
    pub fn value(option: &str, value: impl fmt::Display, allowed: impl fmt::Display) -> Self {
        Self(format!("invalid value '{value}' for '{option}': must be {allowed}"))
    }
}

impl fmt::Display for UsageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for UsageError {}
