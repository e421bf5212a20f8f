//! What JavaScript hands over, of whatever type, checked.

use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlCanvasElement;

use welkin::error::{Error, Quoted, Result, in_range, short};

/// A value as an error shows it.
fn shown(value: &JsValue) -> String {
    if let Some(number) = value.as_f64() {
        return short(number);
    }
    match value.as_string() {
        Some(text) => Quoted(&text).to_string(),
        None if value.is_null() => "null".into(),
        None => value
            .as_bool()
            .map_or_else(|| value.js_typeof().as_string().unwrap_or_default(), |b| b.to_string()),
    }
}

/// The name in a string. Other values give what an error shows of them, which is nobody's name.
pub fn name(value: &JsValue) -> String {
    value.as_string().unwrap_or_else(|| shown(value))
}

/// A number from `lo` to `hi` of a unit.
pub fn number(field: &str, value: &JsValue, lo: f64, hi: f64, unit: &str) -> Result<f64> {
    if let Some(number) = value.as_f64() {
        return in_range(field, number, lo, hi, unit);
    }
    let [lo, hi] = [lo, hi].map(short);
    Err(Error::invalid(
        field,
        shown(value),
        format_args!("a number from {lo} to {hi} {unit}").to_string().trim_end(),
    ))
}

/// A whole number from 1 to `most`.
pub fn whole(field: &str, value: &JsValue, most: u32) -> Result<u32> {
    match value.as_f64() {
        Some(number) if number.fract() == 0.0 && (1.0..=f64::from(most)).contains(&number) => {
            Ok(number as u32)
        }
        _ => Err(Error::invalid(field, shown(value), format_args!("a whole number from 1 to {most}"))),
    }
}

/// `true` or `false`.
pub fn flag(field: &str, value: &JsValue) -> Result<bool> {
    value.as_bool().ok_or_else(|| Error::invalid(field, shown(value), "true or false"))
}

/// A canvas element.
pub fn canvas(value: JsValue) -> Result<HtmlCanvasElement> {
    value.dyn_into().map_err(|value| Error::invalid("canvas", shown(&value), "a canvas element"))
}
