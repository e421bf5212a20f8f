//#include lut_air
//#include phase
// The air for a scene's own shaders, in world space: `aerial`, `sky` and `irradiance` are what a user calls,
// and besides entry points the only functions that read what is bound. All three are of the camera's place.
// Rust twin: `SceneAirUniform` in src/frame/scene_air.rs.

struct SceneAir {
    frame: Frame,
    luts: Luts,
    zenith_x: vec3f,        // the zenith frame's axes in the scene's, unit but for ellipsoids: the sun's side
    present: f32,           // 1; 0 where there is no air
    zenith_y: vec3f,
    cornette_shanks: f32,   // 1: the aerosol scatters after Cornette & Shanks; 0: Henyey & Greenstein
    zenith_z: vec3f,        // away from the planet
    mie_light: f32,         // 1; 0 where the aerosol has no LUT of its own
    harmonics_00: vec4f,    // light from all sides, real spherical harmonics in the zenith frame, in xyz;
    harmonics_1y: vec4f,    // times steradian
    harmonics_1z: vec4f,
    harmonics_1x: vec4f,
    harmonics_2xy: vec4f,
    harmonics_2yz: vec4f,
    harmonics_2zz: vec4f,
    harmonics_2xz: vec4f,
    harmonics_2xx: vec4f,
}

@group(0) @binding(0) var<uniform> air_block: SceneAir;
@group(0) @binding(1) var sky_view_lut: texture_2d<f32>;
@group(0) @binding(2) var aerial_lut: texture_2d<f32>;
@group(0) @binding(3) var mie_single_lut: texture_2d<f32>;
@group(0) @binding(8) var linear: sampler;

// What the air does to what lies behind it: behind * transmittance + inscatter.
struct Air {
    inscatter: vec3f,     // radiance
    transmittance: vec3f, // 0 to 1
}

// The harmonics' own constants times the cosine lobe's of their degree: pi, 2 pi / 3 and pi / 4 (Ramamoorthi
// & Hanrahan 2001, equation 8).
const IRRADIANCE_0: f32 = 0.886226925;  // pi sqrt(1 / (4 pi))
const IRRADIANCE_1: f32 = 1.023326708;  // 2 pi / 3 sqrt(3 / (4 pi))
const IRRADIANCE_2: f32 = 0.858085531;  // pi / 4 sqrt(15 / (4 pi))
const IRRADIANCE_ZZ: f32 = 0.247707956; // pi / 4 sqrt(5 / (16 pi))
const IRRADIANCE_XX: f32 = 0.429042765; // pi / 4 sqrt(15 / (16 pi))

// A direction of the scene's in the zenith frame.
fn to_zenith(direction: vec3f, x: vec3f, y: vec3f, z: vec3f) -> vec3f {
    return normalize(vec3f(dot(direction, x), dot(direction, y), dot(direction, z)));
}

// How much longer a way in a direction is in the zenith frame: 1, but for planets that are ellipsoids.
fn stretch(direction: vec3f, x: vec3f, y: vec3f, z: vec3f) -> f32 {
    let seen = vec3f(dot(direction, x), dot(direction, y), dot(direction, z));
    return sqrt(dot(seen, seen) / max(dot(direction, direction), 1e-30));
}

// The phase function of the aerosol, 1/sr: of two by a number, as a program of the user's is compiled once.
fn scene_phase(dir: vec3f, sun: vec3f, asymmetry: vec3f, cornette_shanks: f32) -> vec3f {
    let apart = dir - sun;
    let together = dir + sun;
    let away = 0.5 * dot(apart, apart);
    let toward = 0.5 * dot(together, together);
    return mix(
        henyey_greenstein_phase(away, toward, asymmetry), cornette_shanks_phase(away, toward, asymmetry),
        cornette_shanks);
}

// The air between the camera and a point. direction: from the camera, in the scene's axes, of any length;
// distance: metres, as large as you like for all of the air there.
fn aerial(direction: vec3f, distance: f32) -> Air {
    let f = air_block.frame;
    let luts = air_block.luts;
    let m = f.medium;
    let dir = to_zenith(direction, air_block.zenith_x, air_block.zenith_y, air_block.zenith_z);
    let reach = distance * 1e-3
        * stretch(direction, air_block.zenith_x, air_block.zenith_y, air_block.zenith_z);
    let line = line_to_scene(
        line_past(dir, f.altitude, m.radius), f.altitude, reach, m.radius, m.thickness, f.pixel_angle);
    let path = air_path(line, f.altitude, m.radius, m.thickness);
    let ground = line.ground && path.length >= 0.0;
    let end = scene_reach(
        path.start, path.length, path.r_mu, ground, reach, m.radius, f.pixel_angle);
    if end <= 0.0 || air_block.present <= 0.0 {
        return Air(vec3f(0.0), vec3f(1.0));
    }
    let u = azimuth_to_u(dir);
    let v = zenith_to_v(line, dir.z, f.altitude, m.radius, m.thickness, f.sky_view_mapping);
    let size = vec2f(textureDimensions(sky_view_lut));
    let uv = sky_view_uv(u, v_to_row(v, ground, size.y, luts.ground_rows), size);
    let light = path_light(
        sky_view_lut, mie_single_lut, linear, uv, ground, path.length,
        scene_phase(dir, f.sun, m.mie_asymmetry, air_block.cornette_shanks) * air_block.mie_light);
    let air = air_before(
        aerial_lut, linear, m, luts, line, path, u, v, end, light.smooth_light, light.mie_light);
    return Air(air.inscatter * m.irradiance, air.transmittance);
}

// The sky in a direction, for reflections: radiance of all the air there, over a black ground and a black
// space, without the sun's disk. direction: in the scene's axes, of any length.
fn sky(direction: vec3f) -> vec3f {
    return aerial(direction, 1e12).inscatter;
}

// Irradiance of a surface at the camera's place from the sky and the ground below, the sun's own light not
// counted (Ramamoorthi & Hanrahan 2001, equation 13 by its coefficients): radiance times steradian; a matt
// surface sends albedo / pi of it. normal: in the scene's axes, of any length.
fn irradiance(normal: vec3f) -> vec3f {
    let n = to_zenith(normal, air_block.zenith_x, air_block.zenith_y, air_block.zenith_z);
    let sum = air_block.harmonics_00 * IRRADIANCE_0
        + (air_block.harmonics_1y * n.y + air_block.harmonics_1z * n.z + air_block.harmonics_1x * n.x)
            * IRRADIANCE_1
        + (air_block.harmonics_2xy * (n.x * n.y) + air_block.harmonics_2yz * (n.y * n.z)
            + air_block.harmonics_2xz * (n.x * n.z)) * IRRADIANCE_2
        + air_block.harmonics_2zz * ((3.0 * n.z * n.z - 1.0) * IRRADIANCE_ZZ)
        + air_block.harmonics_2xx * ((n.x * n.x - n.y * n.y) * IRRADIANCE_XX);
    return max(sum.xyz, vec3f(0.0));
}
