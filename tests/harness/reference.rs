//! The f64 reference's light, solved once for each medium and setting.

use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{AtmosphereParams, Quality, Scene};

/// Light of all orders of scattering in a medium, solved or read by the first test that asks; others wait for
/// it.
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
    slot.get_or_init(|| Arc::new(kept(&params, settings))).clone()
}

/// A solution from `target/tmp/orders`, where the tests of the command line keep theirs too, or a new one,
/// which is kept there. A file's name is a hash of the medium, the settings and the solver's source, so that
/// a changed solver finds none.
fn kept(params: &AtmosphereParams, settings: Settings) -> Orders {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("orders");
    let name = format!("orders-{:032x}", Orders::key(params, &settings));
    let file = folder.join(&name);
    if let Ok(bytes) = fs::read(&file)
        && let Ok(orders) = Orders::from_bytes(&bytes, params, settings)
    {
        return orders;
    }
    let orders = Orders::solve(params, settings, |_| ()).unwrap();
    // Whole at once, as others may read it. Where it cannot be kept, the next run solves again.
    let part = folder.join(format!("{name}-{}", std::process::id()));
    let written = fs::create_dir_all(&folder).and_then(|()| fs::write(&part, orders.to_bytes()));
    if let Err(e) = written.and_then(|()| fs::rename(&part, &file)) {
        eprintln!("the solution is not kept in {}: {e}", folder.display());
    }
    orders
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
