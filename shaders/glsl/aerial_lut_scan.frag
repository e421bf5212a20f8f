#version 300 es

precision highp float;
precision highp int;

struct Luts {
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
    float aerial_ground_rows;
};
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
    uint flags;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct Uniforms {
    Frame frame;
    Luts luts;
};
const float LOG_FLOOR = -100.0;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const int AIR_SMOOTH = 0;
const int AIR_MIE = 1;
const int AIR_BEAM = 2;
const int AIR_TRANSMITTANCE = 3;
const int AIR_KINDS = 4;
const bool FINISH = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void aerial_texel(vec2 position_1, uvec2 luts_size, uint luts_slices, inout int out_kind, inout int out_row, inout int out_column, inout int out_slice, inout int out_rows, inout int out_columns) {
    ivec2 texel = ivec2(position_1);
    int columns = int((luts_size.x / luts_slices));
    int rows = (int(luts_size.y) / AIR_KINDS);
    out_kind = (texel.y / rows);
    out_row = (texel.y % rows);
    out_column = (texel.x % columns);
    out_slice = (texel.x / columns);
    out_rows = rows;
    out_columns = columns;
}

vec4 aerial_load(highp sampler2D lut, int a_row_1, int a_column_1, int a_rows_1, int a_columns_1, int kind, int slice) {
    vec4 _e13 = texelFetch(lut, ivec2(((slice * a_columns_1) + a_column_1), ((kind * a_rows_1) + a_row_1)), 0);
    return _e13;
}

void main() {
    vec4 position = gl_FragCoord;
    int a_kind = 0;
    int a_row = 0;
    int a_column = 0;
    int a_slice = 0;
    int a_rows = 0;
    int a_columns = 0;
    uvec2 luts_size_1 = _group_0_binding_0_fs.luts.size;
    uint luts_shift = _group_0_binding_0_fs.luts.shift;
    uint luts_slices_1 = _group_0_binding_0_fs.luts.slices;
    aerial_texel(position.xy, luts_size_1, luts_slices_1, a_kind, a_row, a_column, a_slice, a_rows, a_columns);
    int _e16 = a_kind;
    int _e17 = a_row;
    int _e18 = a_column;
    int _e19 = a_slice;
    int _e20 = a_rows;
    int _e21 = a_columns;
    vec4 _e23 = aerial_load(_group_0_binding_1_fs, _e17, _e18, _e20, _e21, _e16, _e19);
    if (FINISH) {
        if ((_e16 >= AIR_BEAM)) {
            _fs2p_location0 = _e23;
            return;
        }
        vec4 _e31 = aerial_load(_group_0_binding_1_fs, _e17, _e18, _e20, _e21, _e16, (int(luts_slices_1) - 1));
        vec3 whole = _e31.xyz;
        float even = (float((_e19 + 1)) / float(luts_slices_1));
        _fs2p_location0 = vec4(mix(vec3(even), (_e23.xyz / max(whole, vec3(1e-37))), greaterThan(whole, vec3(1e-30))), _e23.w);
        return;
    } else {
        int nearer = (_e19 - int(luts_shift));
        if ((nearer < 0)) {
            _fs2p_location0 = _e23;
            return;
        }
        vec4 _e55 = aerial_load(_group_0_binding_1_fs, _e17, _e18, _e20, _e21, _e16, nearer);
        vec3 before = _e55.xyz;
        if ((_e16 >= AIR_BEAM)) {
            _fs2p_location0 = vec4((before * _e23.xyz), _e23.w);
            return;
        }
        vec4 _e65 = aerial_load(_group_0_binding_1_fs, _e17, _e18, _e20, _e21, AIR_BEAM, nearer);
        _fs2p_location0 = vec4((before + (_e65.xyz * _e23.xyz)), _e23.w);
        return;
    }
}

