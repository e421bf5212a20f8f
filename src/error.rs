//! One error type. Bad input names field, value and allowed range.

use std::fmt;

/// What went wrong. Nothing in this crate panics on bad input, and nothing is created or changed when a call
/// returns an error.
///
/// It is one pointer, so that handing it on costs next to no code; [`Error::kind`] tells what it points to.
#[derive(Clone, PartialEq)]
pub struct Error(Box<ErrorKind>);

/// The kinds of errors, with what they tell.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ErrorKind {
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

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.0, f)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl std::error::Error for Error {}

impl Error {
    /// An error of a kind.
    pub fn new(kind: ErrorKind) -> Self {
        Self(Box::new(kind))
    }

    /// What went wrong.
    pub fn kind(&self) -> &ErrorKind {
        &self.0
    }

    /// What went wrong, to be taken apart.
    pub fn into_kind(self) -> ErrorKind {
        *self.0
    }

    /// An [`ErrorKind::Unavailable`].
    #[cold]
    pub fn unavailable(backend: &'static str, reason: impl Into<String>) -> Self {
        Self::new(ErrorKind::Unavailable { backend, reason: reason.into() })
    }

    /// An [`ErrorKind::Lost`].
    #[cold]
    pub fn lost(backend: &'static str, reason: impl Into<String>) -> Self {
        Self::new(ErrorKind::Lost { backend, reason: reason.into() })
    }

    /// An [`ErrorKind::Driver`].
    #[cold]
    pub fn driver(backend: &'static str, what: impl Into<String>, reason: impl Into<String>) -> Self {
        Self::new(ErrorKind::Driver { backend, what: what.into(), reason: reason.into() })
    }

    /// An [`ErrorKind::Invalid`] from anything printable.
    pub fn invalid(field: impl fmt::Display, value: impl fmt::Display, allowed: impl fmt::Display) -> Self {
        Self::invalid_dyn(&field, &value, &allowed)
    }

    /// One copy in the program, however many kinds of values there are.
    #[cold]
    fn invalid_dyn(field: &dyn fmt::Display, value: &dyn fmt::Display, allowed: &dyn fmt::Display) -> Self {
        let [field, value, allowed] = [field, value, allowed].map(ToString::to_string);
        Self::new(ErrorKind::Invalid { field, value, allowed })
    }
}

/// `value` if it is finite and within `lo..=hi`, else an [`ErrorKind::Invalid`].
pub fn in_range(field: impl fmt::Display, value: f64, lo: f64, hi: f64, unit: &str) -> Result<f64> {
    check_range(&field, value, lo, hi, unit)?;
    Ok(value)
}

/// One copy in the program, however many fields are checked.
#[inline(never)]
fn check_range(field: &dyn fmt::Display, value: f64, lo: f64, hi: f64, unit: &str) -> Result<()> {
    if value.is_finite() && (lo..=hi).contains(&value) {
        return Ok(());
    }
    let (lo, hi, space) = (short(round(lo)), short(round(hi)), if unit.is_empty() { "" } else { " " });
    Err(Error::invalid_dyn(field, &short(value), &format_args!("from {lo} to {hi}{space}{unit}")))
}

/// A limit without the last digits that a product leaves: 1001 for 1000.9999999999999.
fn round(v: f64) -> f64 {
    let scaled = v * 1e6;
    if scaled.abs() < 1e15 && (scaled - scaled.round()).abs() < 1e-9 * scaled.abs() {
        scaled.round() / 1e6
    } else {
        v
    }
}

/// A number as people write it: 0.3, 6360000, 1e15.
pub fn short(v: f64) -> String {
    if v == 0.0 || !v.is_finite() || (1e-3..1e7).contains(&v.abs()) {
        text::decimal(v)
    } else {
        text::exponential(v)
    }
}

/// A number as `{}` writes it, by `text::decimal`.
#[derive(Clone, Copy, Debug)]
pub struct Decimal(pub f64);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&text::decimal(self.0))
    }
}

/// A vector as glam writes it: `[1, 0, 0.5]`.
#[derive(Clone, Copy, Debug)]
pub struct Vector(pub glam::DVec3);

impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.to_array().map(Decimal);
        write!(f, "[{x}, {y}, {z}]")
    }
}

/// A text in quotation marks, with quotation marks, backslashes and control characters escaped. It does what
/// `{:?}` does for a text, without the tables of all printable characters, which are 4 kB in a browser's
/// module.
#[derive(Clone, Copy, Debug)]
pub struct Quoted<'a>(pub &'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"")?;
        for c in self.0.chars() {
            if c.is_ascii_control() || matches!(c, '"' | '\\') {
                write!(f, "{}", c.escape_default())?;
            } else {
                fmt::Write::write_char(f, c)?;
            }
        }
        f.write_str("\"")
    }
}

/// Floating-point numbers as texts. Rust's own conversion is 8 kB of a browser's module, gzipped, and every
/// browser has one that gives the same digits: the fewest that name the number.
#[cfg(not(all(target_arch = "wasm32", any(feature = "wgpu", feature = "webgl"))))]
mod text {
    /// The digits of a number without an exponent.
    pub fn decimal(v: f64) -> String {
        v.to_string()
    }

    /// A number's digits with an exponent of ten: `1e15`.
    pub fn exponential(v: f64) -> String {
        format!("{v:e}")
    }
}

#[cfg(all(target_arch = "wasm32", any(feature = "wgpu", feature = "webgl")))]
mod text {
    use wasm_bindgen::prelude::*;

    #[wasm_bindgen]
    extern "C" {
        type Number;
        #[wasm_bindgen(method, js_name = toString)]
        fn decimal(this: &Number) -> String;
        #[wasm_bindgen(method, js_name = toExponential)]
        fn exponential(this: &Number) -> String;
    }

    fn number(v: f64) -> Number {
        JsValue::from_f64(v).unchecked_into()
    }

    /// The digits of a number, without an exponent from 1e-6 to 1e21.
    pub fn decimal(v: f64) -> String {
        if v.is_infinite() { if v > 0.0 { "inf" } else { "-inf" }.into() } else { number(v).decimal() }
    }

    /// A number's digits with an exponent of ten: `1e15`.
    pub fn exponential(v: f64) -> String {
        number(v).exponential().chars().filter(|c| *c != '+').collect()
    }
}

/// `v` scaled to length 1, or an [`ErrorKind::Invalid`] if it has no direction.
pub fn direction(field: &str, v: glam::DVec3) -> Result<glam::DVec3> {
    let scale = v.abs().max_element();
    if !v.is_finite() || scale < 1e-150 {
        return Err(Error::invalid(field, Vector(v), "a finite vector that is not zero"));
    }
    Ok((v / scale).normalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_vectors_and_texts_read_as_rust_writes_them() {
        for v in [
            0.0,
            -0.0,
            0.3,
            6_360_000.0,
            1e15,
            -1.5e-7,
            0.1 + 0.2,
            f64::MIN_POSITIVE,
            f64::INFINITY,
            f64::NAN,
        ] {
            assert_eq!(Decimal(v).to_string(), v.to_string());
            assert_eq!(
                Vector(glam::DVec3::new(v, 1.0, -2.5)).to_string(),
                glam::DVec3::new(v, 1.0, -2.5).to_string()
            );
        }
        for (v, text) in [(0.3, "0.3"), (6_360_000.0, "6360000"), (1e15, "1e15"), (-1.5e-7, "-1.5e-7")] {
            assert_eq!(short(v), text);
        }
        for (v, rounded) in
            [(1000.0 * 1.001, 1001.0), (1e-4, 1e-4), (1e-9, 1e-9), (1e300, 1e300), (2.0 / 3.0, 2.0 / 3.0)]
        {
            assert_eq!(round(v), rounded);
        }
        for text in ["mars", "", "a \"b\" \\ c", "tab\tline\n", "Größe", "火星"] {
            assert_eq!(Quoted(text).to_string(), format!("{text:?}"));
        }
    }
}
