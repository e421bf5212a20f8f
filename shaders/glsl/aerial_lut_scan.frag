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
struct AirTexel {
    int kind;
    int row;
    int column;
    int slice;
    int rows;
    int columns;
};
struct Uniforms {
    Frame frame;
    Tables tables;
};
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
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
const bool FINISH = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

AirTexel air_texel(vec2 position_1, Tables t) {
    ivec2 at = ivec2(position_1);
    int columns = int((t.size.x / t.slices));
    int rows = (int(t.size.y) / AIR_KINDS);
    return AirTexel((at.y / rows), (at.y % rows), (at.x % columns), (at.x / columns), rows, columns);
}

vec3 air_load(highp sampler2D table, AirTexel a, int kind, int slice) {
    vec4 _e14 = texelFetch(table, ivec2(((slice * a.columns) + a.column), ((kind * a.rows) + a.row)), 0);
    return _e14.xyz;
}

float air_end(highp sampler2D table_1, AirTexel a_1) {
    vec4 _e14 = texelFetch(table_1, ivec2(((a_1.slice * a_1.columns) + a_1.column), ((a_1.kind * a_1.rows) + a_1.row)), 0);
    return _e14.w;
}

void main() {
    vec4 position = gl_FragCoord;
    Tables t_1 = _group_0_binding_0_fs.tables;
    AirTexel _e5 = air_texel(position.xy, t_1);
    vec3 _e9 = air_load(_group_0_binding_1_fs, _e5, _e5.kind, _e5.slice);
    float _e11 = air_end(_group_0_binding_1_fs, _e5);
    if (FINISH) {
        if ((_e5.kind >= AIR_BEAM)) {
            _fs2p_location0 = vec4(_e9, _e11);
            return;
        }
        vec3 _e23 = air_load(_group_0_binding_1_fs, _e5, _e5.kind, (int(t_1.slices) - 1));
        float even = (float((_e5.slice + 1)) / float(t_1.slices));
        _fs2p_location0 = vec4(mix(vec3(even), (_e9 / max(_e23, vec3(1e-37))), greaterThan(_e23, vec3(1e-30))), _e11);
        return;
    } else {
        int nearer = (_e5.slice - int(t_1.shift));
        if ((nearer < 0)) {
            _fs2p_location0 = vec4(_e9, _e11);
            return;
        }
        vec3 _e50 = air_load(_group_0_binding_1_fs, _e5, _e5.kind, nearer);
        if ((_e5.kind >= AIR_BEAM)) {
            _fs2p_location0 = vec4((_e50 * _e9), _e11);
            return;
        }
        vec3 _e58 = air_load(_group_0_binding_1_fs, _e5, AIR_BEAM, nearer);
        _fs2p_location0 = vec4((_e50 + (_e58 * _e9)), _e11);
        return;
    }
}

