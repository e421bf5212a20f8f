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
    uint reduced;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct AerialTexel {
    int kind;
    int row;
    int column;
    int slice;
    int rows;
    int columns;
};
struct Uniforms {
    Frame frame;
    Luts luts;
};
const float LOG_FLOOR = -100.0;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
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

AerialTexel aerial_texel(vec2 position_1, Luts luts) {
    ivec2 texel = ivec2(position_1);
    int columns = int((luts.size.x / luts.slices));
    int rows = (int(luts.size.y) / AIR_KINDS);
    return AerialTexel((texel.y / rows), (texel.y % rows), (texel.x % columns), (texel.x / columns), rows, columns);
}

vec4 aerial_load(highp sampler2D lut, AerialTexel a, int kind, int slice) {
    vec4 _e14 = texelFetch(lut, ivec2(((slice * a.columns) + a.column), ((kind * a.rows) + a.row)), 0);
    return _e14;
}

void main() {
    vec4 position = gl_FragCoord;
    Luts luts_1 = _group_0_binding_0_fs.luts;
    AerialTexel _e5 = aerial_texel(position.xy, luts_1);
    vec4 _e9 = aerial_load(_group_0_binding_1_fs, _e5, _e5.kind, _e5.slice);
    if (FINISH) {
        if ((_e5.kind >= AIR_BEAM)) {
            _fs2p_location0 = _e9;
            return;
        }
        vec4 _e20 = aerial_load(_group_0_binding_1_fs, _e5, _e5.kind, (int(luts_1.slices) - 1));
        vec3 whole = _e20.xyz;
        float even = (float((_e5.slice + 1)) / float(luts_1.slices));
        _fs2p_location0 = vec4(mix(vec3(even), (_e9.xyz / max(whole, vec3(1e-37))), greaterThan(whole, vec3(1e-30))), _e9.w);
        return;
    } else {
        int nearer = (_e5.slice - int(luts_1.shift));
        if ((nearer < 0)) {
            _fs2p_location0 = _e9;
            return;
        }
        vec4 _e49 = aerial_load(_group_0_binding_1_fs, _e5, _e5.kind, nearer);
        vec3 before = _e49.xyz;
        if ((_e5.kind >= AIR_BEAM)) {
            _fs2p_location0 = vec4((before * _e9.xyz), _e9.w);
            return;
        }
        vec4 _e60 = aerial_load(_group_0_binding_1_fs, _e5, AIR_BEAM, nearer);
        _fs2p_location0 = vec4((before + (_e60.xyz * _e9.xyz)), _e9.w);
        return;
    }
}

