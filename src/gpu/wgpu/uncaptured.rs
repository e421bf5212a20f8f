//! Errors of a device that no scope captures.

use std::sync::Arc;

/// Calls `handler` with the text of every error of the device that no scope captures.
#[cfg(not(target_arch = "wasm32"))]
pub(super) fn on_error(device: &wgpu::Device, handler: impl Fn(String) + Send + Sync + 'static) {
    device.on_uncaptured_error(Arc::new(move |e: wgpu::Error| handler(e.to_string())));
}

/// Calls `handler` with the text of every error of the device that no scope captures. A browser's own device
/// is asked itself: wgpu knows two of the three kinds of errors there, panics at the third, and brings the
/// tables of all printable characters for the sake of an error within the error, 4 kB of a browser's module.
#[cfg(target_arch = "wasm32")]
pub(super) fn on_error(device: &wgpu::Device, handler: impl Fn(String) + Send + Sync + 'static) {
    #[allow(unused_imports)]
    use web::NoHandle as _;
    match device.as_webgpu() {
        Some(device) => web::listen(device.as_ref(), handler),
        // WebGL through wgpu, or wgpu 29.
        None => device.on_uncaptured_error(Arc::new(move |e: wgpu::Error| handler(e.to_string()))),
    }
}

#[cfg(target_arch = "wasm32")]
mod web {
    use wasm_bindgen::prelude::*;

    /// What wgpu 29 answers; 30 has a method of this name, which comes first.
    #[allow(dead_code)]
    pub trait NoHandle {
        fn as_webgpu(&self) -> Option<&JsValue> {
            None
        }
    }

    impl NoHandle for wgpu::Device {}

    #[wasm_bindgen]
    extern "C" {
        type GpuDevice;
        #[wasm_bindgen(method, setter)]
        fn set_onuncapturederror(this: &GpuDevice, handler: &JsValue);

        type UncapturedErrorEvent;
        #[wasm_bindgen(method, getter)]
        fn error(this: &UncapturedErrorEvent) -> GpuError;

        type GpuError;
        #[wasm_bindgen(method, getter)]
        fn constructor(this: &GpuError) -> Class;
        #[wasm_bindgen(method, getter)]
        fn message(this: &GpuError) -> String;

        type Class;
        #[wasm_bindgen(method, getter)]
        fn name(this: &Class) -> String;
    }

    /// Calls `handler` with kind and message of each error: `GPUValidationError: …`.
    pub fn listen(device: &JsValue, handler: impl Fn(String) + 'static) {
        let listener = Closure::<dyn FnMut(JsValue)>::new(move |event: JsValue| {
            let error = event.unchecked_ref::<UncapturedErrorEvent>().error();
            handler([error.constructor().name(), error.message()].join(": "));
        });
        device.unchecked_ref::<GpuDevice>().set_onuncapturederror(&listener.into_js_value());
    }
}
