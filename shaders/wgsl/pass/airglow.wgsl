//#include view
//#include columns
// Airglow: a thin layer of air that shines by itself, alike in all directions. A ray sees the emission
// integrated along its way. For a layer without thickness seen from the ground that is van Rhijn's factor
// (1921), 1 / sqrt(1 - (R sin z / (R + h))^2); from orbit the limb of the layer is some fifty times as bright
// as its zenith. Out: radiance that is added to what is there.

struct Uniforms {
    frame: Frame,
    zenith: vec3f,  // radiance of the layer from straight below, in the picture's unit
    bottom: f32,    // altitude at which the emission begins, km
    middle: f32,    // altitude at which it is strongest, km
    top: f32,       // altitude at which it ends, km
    pad1: f32,
    pad2: f32,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var scene_depth: texture_2d<f32>;

const BEFORE: bool = true; // What a ray enters before the air; off: what it leaves last, behind the air.
const THROUGH_AIR: bool = true; // Of the latter what the air lets through; off: another pass dims it.

// Abscissas and weights of Gauss-Legendre's rule with 4 points on 0..1 (Abramowitz & Stegun 1964, table
// 25.4).
const NODES: vec4f = vec4f(0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
const WEIGHTS: vec4f = vec4f(0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);

// Distance (km) from a line's perigee to where it has risen v^2 km above it: s = v sqrt(v^2 + 2 p), p the
// perigee's distance from the centre.
fn rise_to_distance(v: f32, p: f32) -> f32 {
    return v * sqrt(v * v + 2.0 * p);
}

// A tent of altitude integrated (km) along one side of a perigee, from v = a to v = b. In v the way is smooth
// at the perigee, ds/dv = 2 (p + v^2) / sqrt(2 p + v^2), and the tent a parabola. h: altitude of the perigee,
// p: its distance from the centre, km; rate: 1 / half width of the tent.
fn layer_part(a: f32, b: f32, h: f32, p: f32, middle: f32, rate: f32) -> f32 {
    let v = a + (b - a) * NODES;
    let way = 2.0 * (p + v * v) / sqrt(2.0 * p + v * v);
    let tent = max(1.0 - abs(h + v * v - middle) * rate, vec4f(0.0));
    return (b - a) * dot(WEIGHTS, way * tent);
}

// The same from v = first to v = last over the whole tent, whose two sides are integrated by themselves.
// edges: altitudes of the tent's foot, tip and other foot, km.
fn layer_column(first: f32, last: f32, h: f32, p: f32, edges: vec3f) -> f32 {
    let rate = 1.0 / (edges.z - edges.y);
    let v = clamp(sqrt(max(edges - h, vec3f(0.0))), vec3f(first), vec3f(max(last, first)));
    return layer_part(v.x, v.y, h, p, edges.y, rate) + layer_part(v.y, v.z, h, p, edges.y, rate);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let direction = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    let ray_length = length(direction);
    let line = line_past(direction / ray_length, f.altitude, m.radius);
    let edges = vec3f(uniforms.bottom, uniforms.middle, uniforms.top);
    let h = altitude_of(line.perigee_excess, m.radius);
    // The camera's v: its height above the perigee is r - p = b^2 / (r + p), without a difference.
    let camera = abs(line.r_mu) / sqrt(m.radius + f.altitude + line.perigee);
    var column = 0.0;
    if BEFORE {
        if line.r_mu < 0.0 {
            let depth = textureLoad(scene_depth, vec2i(position.xy), 0).x;
            let distance = depth_distance(f.depth, depth, ray_length);
            let middle = rise_to_distance(camera, line.perigee)
                - rise_to_distance(sqrt(max(uniforms.middle - h, 0.0)), line.perigee);
            // What stands before the layer hides it.
            if distance < 0.0 || distance > middle {
                column = layer_column(0.0, camera, h, line.perigee, edges);
            }
        }
    } else {
        if !line.ground {
            column = layer_column(select(0.0, camera, line.r_mu > 0.0), 1e9, h, line.perigee, edges);
        }
    }
    var light = uniforms.zenith * (column / (uniforms.top - uniforms.middle));
    if THROUGH_AIR {
        let path = air_path(line, f.altitude, m.radius, m.thickness);
        if column > 0.0 && path.length > 0.0 {
            let sums = path_columns(layers_of(m), line, path, path.length, true, m.radius);
            light *= exp(-extinction(coefficients_of(m), sums));
        }
    }
    return vec4f(light, 0.0);
}
