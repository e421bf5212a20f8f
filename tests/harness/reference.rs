//! The f64 reference's light, solved once a run for each medium and setting.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{AtmosphereParams, Quality, Scene};

/// Light of all orders of scattering in a medium, solved by the first test that asks; others wait for it.
///
/// Per unit of the sun's irradiance: solutions know nothing of [`AtmosphereParams::sun_intensity`], which is
/// 1 here.
pub fn orders(params: &AtmosphereParams, settings: Settings) -> Arc<Orders> {
    type Slot = Arc<OnceLock<Arc<Orders>>>;
    static SOLVED: Mutex<Option<HashMap<String, Slot>>> = Mutex::new(None);
    let params = AtmosphereParams { sun_intensity: 1.0, ..params.clone() };
    // Debug prints an f64 so that it is read back to the last bit.
    let key = format!("{params:?} {settings:?}");
    let slot = {
        let mut solved = SOLVED.lock().unwrap_or_else(PoisonError::into_inner);
        solved.get_or_insert_default().entry(key).or_default().clone()
    };
    slot.get_or_init(|| Arc::new(Orders::solve(&params, settings, |_| ()).unwrap())).clone()
}

/// Earth's light of all orders.
pub fn earth() -> Arc<Orders> {
    orders(&AtmosphereParams::earth(), Settings::QUICK)
}

/// What a method should draw over black along a ray on Earth: the air's light, without the ground's.
pub fn expected(scene: &Scene, query: &RayQuery, method: Quality, relative: f64) -> [f64; 3] {
    let (sun, tolerance) = (scene.atmosphere.sun_intensity, Tolerance { relative });
    if method.is_single_scattering() {
        return single_scattering(&scene.atmosphere, query, Sun::Point, tolerance).unwrap().radiance;
    }
    let light = earth().radiance(query, tolerance).unwrap();
    std::array::from_fn(|c| (light.per_irradiance[c] - light.ground[c]) * sun)
}

/// What LUTs should draw over black in a picture on Earth.
pub fn expected_picture(scene: &Scene, size: [u32; 2]) -> Vec<[f64; 3]> {
    let method = Quality::Luts(Default::default());
    super::rays(scene, size).iter().map(|q| expected(scene, q, method, 1e-4)).collect()
}
