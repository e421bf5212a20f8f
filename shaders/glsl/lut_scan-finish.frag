#version 300 es

precision highp float;
precision highp int;

struct Medium {
    vec3 rayleigh;
    float rayleigh_inv_height;
    vec3 mie_scattering;
    float mie_inv_height;
    vec3 mie_extinction;
    float ozone_center;
    vec3 mie_asymmetry;
    float ozone_inv_half_width;
    vec3 ozone;
    float radius;
    vec3 irradiance;
    float thickness;
};
struct DepthCode {
    float scale;
    float bias;
    float log_;
    float background;
};
struct Frame {
    Medium medium;
    vec3 ray_forward;
    float altitude;
    vec3 ray_right;
    float sky_weight;
    vec3 ray_up;
    float shell_weight;
    vec3 sun;
    float sun_chord;
    vec2 size;
    float sun_disk;
    float pixel_angle;
    DepthCode depth;
    uint view_samples;
    uint light_samples;
    uint low_resolution;
    float camera_altitude;
    vec4 limb;
};
struct Tables {
    vec3 mie_extinction;
    float altitude_steepness;
    vec3 mie_moment0_;
    float altitude_growth;
    vec3 mie_moment1_;
    float sun_middle;
    vec3 mie_moment2_;
    float sun_width;
    vec3 mie_asymmetry;
    float pad;
    vec3 albedo;
    float sun_first;
    float sun_span;
    float ground_rows;
    uvec2 size;
    uint steps;
    uint shift;
    uint slices;
    float air_ground_rows;
};
struct Uniforms {
    Frame frame;
    Tables tables;
};
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float SQRT_HALF = 0.70710677;
const int AIR_SMOOTH = 0;
const int AIR_AEROSOL = 1;
const int AIR_BEAM = 2;
const int AIR_THROUGH = 3;
const int AIR_KINDS = 4;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void air_texel(vec2 position_1, uvec2 t_size, uint t_slices, inout int out_kind, inout int out_row, inout int out_column, inout int out_slice, inout int out_rows, inout int out_columns) {
    ivec2 at = ivec2(position_1);
    int columns = int((t_size.x / t_slices));
    int rows = (int(t_size.y) / AIR_KINDS);
    out_kind = (at.y / rows);
    out_row = (at.y % rows);
    out_column = (at.x % columns);
    out_slice = (at.x / columns);
    out_rows = rows;
    out_columns = columns;
}

vec3 air_load(highp sampler2D table, int a_row_1, int a_column_1, int a_rows_1, int a_columns_1, int kind, int slice) {
    vec4 _e13 = texelFetch(table, ivec2(((slice * a_columns_1) + a_column_1), ((kind * a_rows_1) + a_row_1)), 0);
    return _e13.xyz;
}

float air_end(highp sampler2D table_1, int a_kind_1, int a_row_2, int a_column_2, int a_slice_1, int a_rows_2, int a_columns_2) {
    vec4 _e13 = texelFetch(table_1, ivec2(((a_slice_1 * a_columns_2) + a_column_2), ((a_kind_1 * a_rows_2) + a_row_2)), 0);
    return _e13.w;
}

void main() {
    vec4 position = gl_FragCoord;
    int a_kind = 0;
    int a_row = 0;
    int a_column = 0;
    int a_slice = 0;
    int a_rows = 0;
    int a_columns = 0;
    uvec2 t_size_1 = _group_0_binding_0_fs.tables.size;
    uint t_slices_1 = _group_0_binding_0_fs.tables.slices;
    air_texel(position.xy, t_size_1, t_slices_1, a_kind, a_row, a_column, a_slice, a_rows, a_columns);
    int _e14 = a_kind;
    int _e15 = a_row;
    int _e16 = a_column;
    int _e17 = a_slice;
    int _e18 = a_rows;
    int _e19 = a_columns;
    vec3 _e21 = air_load(_group_0_binding_1_fs, _e15, _e16, _e18, _e19, _e14, _e17);
    float _e23 = air_end(_group_0_binding_1_fs, _e14, _e15, _e16, _e17, _e18, _e19);
    if ((_e14 >= AIR_BEAM)) {
        _fs2p_location0 = vec4(_e21, _e23);
        return;
    }
    vec3 _e31 = air_load(_group_0_binding_1_fs, _e15, _e16, _e18, _e19, _e14, (int(t_slices_1) - 1));
    float even = (float((_e17 + 1)) / float(t_slices_1));
    _fs2p_location0 = vec4(mix(vec3(even), (_e21 / max(_e31, vec3(1e-37))), greaterThan(_e31, vec3(1e-30))), _e23);
    return;
}

