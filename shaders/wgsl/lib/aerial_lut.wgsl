//#include sky_view_mapping
// The air between the camera and the scene: per direction (as `skyview`, with fewer texels) slices along the ray, even in
// the u of `path`. Slices stand side by side, four kinds of values above each other: the share of the ray's light that
// is scattered up to a slice's end, without and with the aerosol's (AIR_SMOOTH, AIR_AEROSOL); the transmittance up to there
// with the aerosol's forward light counted as not scattered (AIR_BEAM), and with it counted as lost (AIR_THROUGH). With
// each, how far along the ray the slice ends, as a share of its length: between two rows that is not where it ends on a
// ray of its own, but it is where the interpolated value is reached.

const AIR_SMOOTH: i32 = 0;
const AIR_AEROSOL: i32 = 1;
const AIR_BEAM: i32 = 2;
const AIR_THROUGH: i32 = 3;
const AIR_KINDS: i32 = 4;

struct AirTexel {
    kind: i32,
    row: i32,
    column: i32,
    slice: i32,
    rows: i32,
    columns: i32,
}

fn air_texel(position: vec2f, t: Tables) -> AirTexel {
    let at = vec2i(position);
    let columns = i32(t.size.x / t.slices);
    let rows = i32(t.size.y) / AIR_KINDS;
    return AirTexel(at.y / rows, at.y % rows, at.x % columns, at.x / columns, rows, columns);
}

// The same direction's texel of another kind and slice.
fn air_load(table: texture_2d<f32>, a: AirTexel, kind: i32, slice: i32) -> vec3f {
    return textureLoad(table, vec2i(slice * a.columns + a.column, kind * a.rows + a.row), 0).xyz;
}

// Where a texel's slice ends, as a share of the ray's length.
fn air_end(table: texture_2d<f32>, a: AirTexel) -> f32 {
    return textureLoad(table, vec2i(a.slice * a.columns + a.column, a.kind * a.rows + a.row), 0).w;
}
