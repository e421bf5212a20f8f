//! The functions that Rust's `f64::sin` and its like call, done by the browser: its own come with every page,
//! and Rust's are 5 kB of a module, gzipped. Both are right to the last digit or two.
// The linker finds these by name, which Rust cannot check: they replace the weak symbols of the same
// signature.
#![allow(unsafe_code)]

macro_rules! by_the_browser {
    ($($name:ident($($x:ident),+) = $function:path;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name($($x: f64),+) -> f64 {
            $function($($x),+)
        }
    )*};
}

by_the_browser! {
    sin(x) = js_sys::Math::sin;
    cos(x) = js_sys::Math::cos;
    tan(x) = js_sys::Math::tan;
    asin(x) = js_sys::Math::asin;
    acos(x) = js_sys::Math::acos;
    atan(x) = js_sys::Math::atan;
    atan2(y, x) = js_sys::Math::atan2;
    exp(x) = js_sys::Math::exp;
    expm1(x) = js_sys::Math::expm1;
    log(x) = js_sys::Math::log;
    log1p(x) = js_sys::Math::log1p;
    log2(x) = js_sys::Math::log2;
    log10(x) = js_sys::Math::log10;
    pow(x, y) = js_sys::Math::pow;
}
