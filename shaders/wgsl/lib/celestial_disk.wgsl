//#include view
//#include path
// A disk in the sky, laid over it: a rectangle around it. Rust twin: `DiskUniform` in src/frame/disks.rs.

struct Uniforms {
    frame: Frame,
    rectangle: vec4f,      // left, bottom, right, top in the picture, -1 to 1
    moon_direction: vec3f, // towards the moon's middle, unit
    moon_sine: f32,        // sine of the moon's angular radius
    moon_chord: f32,       // chord of the moon's angular radius, 2 sin(radius / 2)
    albedo_over_pi: f32,   // of the moon, 1/sr
    earthshine: f32,       // light on the moon's dark side per unit of sunlight
    sun_visibility: f32,   // visible fraction of the sun's disk, 0 to 1
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

const AIR: bool = true; // There is air that dims the disk.

const DISK_STEPS: u32 = 128u; // along the ray: within 5e-4 of the transmittance, see tests/sky.rs

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let x = select(uniforms.rectangle.x, uniforms.rectangle.z, (index & 1u) != 0u);
    let y = select(uniforms.rectangle.y, uniforms.rectangle.w, (index & 2u) != 0u);
    return vec4f(x, y, 0.0, 1.0);
}

const VERTICES: u32 = 4u;

// Fraction of a pixel that a disk covers. offset: ray minus the direction of its middle, both unit; chord:
// of its angular radius; pixel: a pixel's angle, rad.
fn disk_coverage(offset: vec3f, chord: f32, pixel: f32) -> f32 {
    return clamp((chord - length(offset)) / pixel + 0.5, 0.0, 1.0);
}

// How far a disk is large enough for what hides it to be told pixel by pixel, 0 to 1: from one to four
// pixels of radius. Below, edges of both disks within one pixel would let light through that is not there.
fn resolved(chord: f32, pixel: f32) -> f32 {
    return smoothstep(1.0, 4.0, chord / pixel);
}

// The colour of a disk's pixel: its light (radiance) through the air along the whole ray, exp(-tau). In
// alpha how far it hides the sky. Not quite a sum, or disk and sky together could exceed a 16-bit float: what
// is as bright as that (`most_light`) hides all of the sky.
fn disk_color(light: vec3f, line: Line, altitude: f32, m: Medium, most: f32) -> vec4f {
    var seen = light;
    if AIR {
        let path = air_path(line, altitude, m.radius, m.thickness);
        if path.length > 0.0 {
            let sums = path_densities(
                layers_of(m), m.radius, path.excess, path.r_mu, path.length, DISK_STEPS);
            seen *= exp(-extinction(coefficients_of(m), sums));
        }
    }
    seen = min(seen, vec3f(most));
    return vec4f(seen, max(seen.r, max(seen.g, seen.b)) / most);
}
