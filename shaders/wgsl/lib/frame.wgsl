// The uniform block of the passes that know the camera. Lengths in km, coefficients in 1/km, angles as
// vectors in the zenith frame: z from the planet's centre to the camera, the sun in the x-z plane. Rust
// twins: `MediumUniform`, `DepthUniform`, `FrameUniform` in src/frame/uniforms.rs; a test compares the
// layouts.

// The planet and its air.
struct Medium {
    rayleigh: vec3f,            // Rayleigh scattering at altitude 0, 1/km
    rayleigh_inv_height: f32,   // 1 / scale height, 1/km
    mie_scattering: vec3f,      // aerosol scattering at altitude 0, 1/km
    mie_inv_height: f32,        // 1 / scale height, 1/km
    mie_extinction: vec3f,      // aerosol scattering + absorption at altitude 0, 1/km
    ozone_center: f32,          // altitude of the tent's tip, km
    mie_asymmetry: vec3f,       // g of the aerosol's phase function, per channel
    ozone_inv_half_width: f32,  // 1 / (tip to foot of the tent), 1/km
    ozone: vec3f,               // absorption at the tent's tip, 1/km
    radius: f32,                // of the lowest ground, km
    irradiance: vec3f,          // sun at the top of the atmosphere, per channel
    thickness: f32,             // top of the atmosphere above the lowest ground, km
    datum: f32,                 // altitude 0 above the lowest ground, km
    pad1: f32,
    pad2: f32,
    pad3: f32,
}

// How distances are stored in a depth buffer.
struct DepthCode {
    scale: f32,                 // 1 / z = scale * depth + bias, 1/km
    bias: f32,                  // 1/km
    log: f32,                   // log2(1 + far in m), or 0 for the other conventions
    background: f32,            // stored depth of the background
}

const REDUCED: u32 = 1u;    // The target is smaller than the picture; planet pixels get alpha -1.
const SHELL_DIMS: u32 = 2u; // The depth-aware pass dims what lies behind the air; else the background has.
const WIDE: u32 = 4u;       // The target holds 32-bit floats: nothing is cut.

struct Frame {
    medium: Medium,
    ray_forward: vec3f,         // ray through the middle of the picture, axial part 1
    altitude: f32,              // camera above the lowest ground, km, never negative
    ray_right: vec3f,           // added from the middle to the right edge
    sky_weight: f32,            // the background pass's part of the sky's light, 0 to 1
    ray_up: vec3f,              // added from the middle to the top edge
    shell_weight: f32,          // the depth-aware pass's part, 1 - sky_weight
    sun: vec3f,                 // towards the sun, unit
    sun_chord: f32,             // chord of the disk's angular radius, 2 sin(radius / 2)
    size: vec2f,                // of the target, pixels
    sun_disk: f32,              // radiance of the disk per unit of irradiance, 1/sr
    pixel_angle: f32,           // angle of one pixel in the middle of the picture, rad
    depth: DepthCode,
    view_samples: u32,          // steps along the view ray
    light_samples: u32,         // steps towards the sun
    flags: u32,                 // REDUCED, SHELL_DIMS and WIDE, added
    camera_altitude: f32,       // camera above altitude 0, km, may be negative (terrain only)
    sky_view_mapping: vec4f,    // of the sky-view LUT's rows, see `zenith_to_v`
}
