//#include view
//#include single_scattering
//#include noise
//#include multi_scattering_lut
//#include open_sun
//#include moon_shadow
// The demonstration's ground: a planet-scale height field as a grid of rings around the point below the
// camera, so that it reaches from the camera's feet to the horizon at any altitude. No vertex buffer.
// It stands in for a user's own terrain.

const RINGS: u32 = 256u;    // rings from the camera's foot to beyond the horizon
const SEGMENTS: u32 = 384u; // around

struct Terrain {
    frame: Frame,
    axis: vec3f,          // the camera's axis, zenith frame, unit
    amplitude: f32,       // highest mountains above the surface, km
    grid_x: vec3f,        // two horizontal directions that turn with the planet, zenith frame
    arc_scale: f32,       // tan(arc / 2) of a ring is arc_scale * sinh(arc_rate * ring)
    grid_y: vec3f,
    arc_rate: f32,        // per ring
    planet_x: vec3f,      // rows: from the zenith frame to the planet's own axes
    sea: f32,             // 1: the lowest places are water
    planet_y: vec3f,
    offset_x: f32,        // of the picture's middle from the axis, in half widths
    planet_z: vec3f,
    offset_y: f32,        // in half heights
    low_albedo: vec3f,    // plains, 0 to 1
    mountain_rate: f32,   // mountain ranges per radian
    high_albedo: vec3f,   // rock
    snow_line: f32,       // km; above the highest mountains where there is none
    sky_light: vec3f,     // sky light on the ground per unit of irradiance with the sun in the zenith
    pad: f32,
    luts: Luts,
    moon_shadow: MoonShadow,
}

@group(0) @binding(0) var<uniform> terrain: Terrain;
@group(0) @binding(1) var moon_shadow_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

const SKY_LIGHT: bool = true; // Lit by the sky, from the multi-scattering LUT; off: by an estimate.
const MOON: bool = true;      // Under a moon's shadow.

const VERTICES: u32 = RINGS * (2u * (SEGMENTS + 1u) + 2u); // of the one triangle strip

// Height above the surface (km, >= 0) in w and its gradient per radian in xyz, at a unit direction in the
// planet's own axes: continents, belts of mountains on them and ridges in those. Ridges narrower than a few
// `spacing` (of the mesh, rad) count with their mean.
fn height_field(n: vec3f, amplitude: f32, rate: f32, sea: f32, spacing: f32) -> vec4f {
    var land = noise(n * 2.3 + 11.0) * vec4f(vec3f(2.3), 1.0) * 0.6;
    land += noise(n * 5.1 + 5.0) * vec4f(vec3f(5.1), 1.0) * 0.3;
    land += noise(n * 13.7 + 3.0) * vec4f(vec3f(13.7), 1.0) * 0.1;
    // Below the coast 0, above it rising to 1.
    let coast = mix(0.25, 0.48, sea);
    let slope = 14.0;
    let rise = (land.w - coast) * slope;
    if rise <= 0.0 {
        return vec4f(0.0);
    }
    let above = min(rise, 1.0);
    let d_above = select(vec3f(0.0), land.xyz * slope, rise < 1.0);
    // Belts of mountains: from 0.1 in the plains to 1.
    let belt_noise = noise(n * 9.0 + 29.0) * vec4f(vec3f(9.0), 1.0);
    let t = clamp((belt_noise.w - 0.38) * 4.0, 0.0, 1.0);
    let belt = 0.1 + 0.9 * t * t * (3.0 - 2.0 * t);
    let d_belt = belt_noise.xyz * (0.9 * 6.0 * t * (1.0 - t) * 4.0);
    // Ridges: 1 - |2 noise - 1| over six octaves, height 0 to 1; their mean is about 0.6.
    var ridge = vec4f(0.0);
    var frequency = rate;
    var gain = 0.55;
    for (var octave = 0; octave < 6; octave++) {
        let seen = clamp(0.3 / (frequency * spacing) - 0.5, 0.0, 1.0);
        if seen > 0.0 {
            let v = noise(n * frequency + f32(octave) * 17.0) * vec4f(vec3f(frequency), 1.0);
            let s = select(-2.0, 2.0, v.w < 0.5);
            ridge += vec4f(v.xyz * s, 1.0 - abs(2.0 * v.w - 1.0)) * (gain * seen);
        }
        ridge.w += 0.6 * gain * (1.0 - seen);
        frequency *= 2.03;
        gain *= 0.45;
    }
    let w = above * belt * ridge.w;
    let d = d_above * belt * ridge.w + above * d_belt * ridge.w + above * belt * ridge.xyz;
    return vec4f(d, w) * amplitude;
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f, // from the camera, zenith frame, km
    @location(1) light: vec3f,    // irradiance per unit of the sun's
    @location(2) surface: vec3f,  // height (km), cosines of the slope and of the sun's zenith angle
}

// A point of the grid of rings on the sphere: its direction from the planet's centre is
// flat sin_arc + zenith (1 - drop).
struct GridPoint {
    flat: vec3f,    // horizontal, unit, zenith frame
    sin_arc: f32,   // sine of the arc from the point below the camera
    drop: f32,      // 1 - cosine of that arc
    spacing: f32,   // the mesh's widest step here, rad: along a ring or from ring to ring
}

// The point of a vertex. One triangle strip: a row of quads per ring, rows joined by doubled vertices. The
// tangent t of half the arc grows like sinh(arc_rate ring); sine and cosine of the arc follow from it
// without trigonometry, which drivers round as they please.
fn grid_point(index: u32) -> GridPoint {
    let row = 2u * (SEGMENTS + 1u) + 2u;
    let k = min(max(index % row, 1u) - 1u, row - 3u);
    let ring = index / row + (k & 1u);
    let azimuth = 2.0 * PI * f32((k / 2u) % SEGMENTS) / f32(SEGMENTS);
    let s = terrain.arc_rate * f32(ring);
    let t = terrain.arc_scale * 0.5 * (exp(s) - exp(-s));
    let flat = normalize(terrain.grid_x * cos(azimuth) + terrain.grid_y * sin(azimuth));
    let sin_arc = 2.0 * t / (1.0 + t * t);
    let drop = 2.0 * t * t / (1.0 + t * t);
    let along = 2.0 * terrain.arc_rate * sqrt(terrain.arc_scale * terrain.arc_scale + t * t) / (1.0 + t * t);
    return GridPoint(flat, sin_arc, drop, max(along, sin_arc * (2.0 * PI / f32(SEGMENTS))));
}

// Irradiance of the ground per unit of the sun's: sunlight through the air, fading while the disk sets
// behind the local horizon, and without SKY_LIGHT a rough estimate of the sky's. h: height, km; n: away
// from the planet's centre; normal: of the slope, both unit.
fn ground_light(m: Medium, h: f32, n: vec3f, normal: vec3f) -> vec3f {
    let f = terrain.frame;
    let mu_sun = dot(n, f.sun);
    let height = m.datum + h;
    let excess = excess_of(height, m.radius);
    let sun_r_mu = (m.radius + height) * mu_sun;
    let dip = sqrt(excess) / (m.radius + height);
    let visible = smoothstep(-1.0, 1.0, (mu_sun + dip) / f.sun_chord);
    var light = vec3f(0.0);
    if SKY_LIGHT {
    } else {
        light = terrain.sky_light * clamp((mu_sun + 0.1) / 1.1, 0.0, 1.0) * (0.5 + 0.5 * dot(normal, n));
    }
    if visible > 0.0 {
        let transmittance = sun_transmittance(
            coefficients_of(m), layers_of(m), m.radius, m.thickness, excess, sun_r_mu, 8u);
        light += transmittance * (visible * max(dot(normal, f.sun), 0.0));
    }
    return light;
}

// Clip position of a point (km from the camera) in the middle of the depth range: nothing is cut by near or
// far; the fragment writes its depth.
fn clip_position(position: vec3f) -> vec4f {
    let f = terrain.frame;
    let z = dot(position, terrain.axis);
    let right = dot(position, f.ray_right) / dot(f.ray_right, f.ray_right) - terrain.offset_x * z;
    let top = dot(position, f.ray_up) / dot(f.ray_up, f.ray_up) - terrain.offset_y * z;
    return vec4f(right, top, 0.5 * z, z);
}

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> Varyings {
    let f = terrain.frame;
    var m = f.medium;
    if SKY_LIGHT {
        // What the aerosol turns by small angles counts as going straight on: the LUT holds the rest.
        m.mie_extinction = terrain.luts.mie_extinction;
    }
    let up = vec3f(0.0, 0.0, 1.0);
    let p = grid_point(index);
    let n = p.flat * p.sin_arc + up * (1.0 - p.drop);
    let planet_n = vec3f(dot(terrain.planet_x, n), dot(terrain.planet_y, n), dot(terrain.planet_z, n));
    let field = height_field(planet_n, terrain.amplitude, terrain.mountain_rate, terrain.sea, p.spacing);
    let h = field.w;
    // (R + h) n - (R + camera altitude) up, without the two radii: n - up = flat sin - up (1 - cos).
    let r = m.radius + m.datum + h;
    let position = p.flat * (r * p.sin_arc) + up * (h - f.camera_altitude - r * p.drop);
    // The gradient's tangential part tilts the normal.
    let g = terrain.planet_x * field.x + terrain.planet_y * field.y + terrain.planet_z * field.z;
    let normal = normalize(n - (g - n * dot(g, n)) / m.radius);

    var out: Varyings;
    out.clip = clip_position(position);
    out.position = position;
    out.light = ground_light(m, h, n, normal);
    out.surface = vec3f(h, dot(normal, n), dot(n, f.sun));
    return out;
}

struct Shaded {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

// Albedo of the ground by height (km) and cosine of the slope: plains, rock, snow, and open water, which is
// dark and slightly blue (albedo of clear water away from the glint, about 0.03 to 0.06).
fn ground_albedo(h: f32, slope: f32) -> vec3f {
    let mountain = smoothstep(0.05, 0.6, h / terrain.amplitude);
    var albedo = mix(terrain.low_albedo, terrain.high_albedo, mountain);
    albedo = mix(terrain.high_albedo, albedo, smoothstep(0.80, 0.95, slope));
    albedo = mix(albedo, vec3f(0.8), smoothstep(terrain.snow_line, terrain.snow_line * 1.15, h));
    return mix(albedo, vec3f(0.02, 0.04, 0.06), terrain.sea * (1.0 - smoothstep(0.0, 0.004, h)));
}

@fragment
fn fragment_main(in: Varyings) -> Shaded {
    let f = terrain.frame;
    var light = in.light;
    if MOON {
        light *= moon_shadow_visibility(moon_shadow_lut, terrain.moon_shadow, in.position, f.sun);
    }
    if SKY_LIGHT {
        // On level ground; a slope sees less of the sky.
        var sky = ground_irradiance(multi_scattering_lut, terrain.luts, in.surface.z);
        sky *= 0.5 + 0.5 * in.surface.y;
        if MOON {
            sky *= moon_shadow_visibility_around(moon_shadow_lut, terrain.moon_shadow, in.position, f.sun);
        }
        light += sky;
    }
    let albedo = ground_albedo(in.surface.x, in.surface.y);
    let reflected = albedo * light * f.medium.irradiance * (1.0 / PI); // Lambert
    let depth = depth_of(f.depth, max(dot(in.position, terrain.axis), 1e-9));
    return Shaded(vec4f(min(reflected, vec3f(most_light(f.flags))), 1.0), clamp(depth, 0.0, 1.0));
}
