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
    float datum;
    float pad1_;
    float pad2_;
    float pad3_;
};
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
    uint pad1_;
    uint slices;
    float aerial_ground_rows;
};
struct Uniforms {
    Medium medium;
    Luts luts;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
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
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const int ZENITHS = 16;
const int AZIMUTHS = 8;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

float v_to_altitude(float luts_altitude_steepness, float luts_altitude_growth, float v, float thickness) {
    float s = ((luts_altitude_steepness * v) * v);
    float grown = ((s < 0.05) ? (s * (1.0 + (s * (0.5 + (s * (0.16666667 + (s * 0.041666668))))))) : (exp(s) - 1.0));
    return (thickness * min((grown / luts_altitude_growth), 1.0));
}

float harmonic(int index, float mu, float along) {
    switch(index) {
        case 0: {
            return SH0_;
        }
        case 1: {
            return (SH1_ * mu);
        }
        case 2: {
            return (SH1_ * along);
        }
        case 3: {
            return (SH20_ * (((3.0 * mu) * mu) - 1.0));
        }
        case 4: {
            return ((SH21_ * mu) * along);
        }
        default: {
            return (SH22_ * ((((2.0 * along) * along) + (mu * mu)) - 1.0));
        }
    }
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

vec2 gauss8_(int i) {
    switch(i) {
        case 0: {
            return vec2(0.01985507, 0.050614268);
        }
        case 1: {
            return vec2(0.10166676, 0.11119052);
        }
        case 2: {
            return vec2(0.23723379, 0.15685332);
        }
        case 3: {
            return vec2(0.40828267, 0.18134189);
        }
        case 4: {
            return vec2(0.5917173, 0.18134189);
        }
        case 5: {
            return vec2(0.7627662, 0.15685332);
        }
        case 6: {
            return vec2(0.89833325, 0.11119052);
        }
        default: {
            return vec2(0.9801449, 0.050614268);
        }
    }
}

void node_direction(int zenith, int azimuth, float h_1, float radius_1, inout float out_mu, inout float out_azimuth, inout float out_weight) {
    bool above = (zenith < 8);
    vec2 _e8 = gauss8_((above ? zenith : (zenith - 8)));
    float _e11 = excess_of(h_1, radius_1);
    float horizon = (-(sqrt(_e11)) / (radius_1 + h_1));
    float span = (above ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_1 = clamp((horizon + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    out_mu = mu_1;
    out_azimuth = ((float(azimuth) + 0.5) * 0.3926991);
    out_weight = (((((abs(span) * 2.0) * _e8.x) * _e8.y) * 2.0) * 0.3926991);
}

vec3 moment(ivec2 node, float h_2, float radius_2, int index_1) {
    vec3 sum = vec3(0.0);
    int z = 0;
    int a = 0;
    float d_mu = 0.0;
    float d_azimuth = 0.0;
    float d_weight = 0.0;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e60 = z;
            z = (_e60 + 1);
        }
        loop_init = false;
        int _e4 = z;
        if ((_e4 < ZENITHS)) {
        } else {
            break;
        }
        {
            a = 0;
            bool loop_init_1 = true;
            while(true) {
                if (!loop_init_1) {
                    int _e57 = a;
                    a = (_e57 + 1);
                }
                loop_init_1 = false;
                int _e9 = a;
                if ((_e9 < AZIMUTHS)) {
                } else {
                    break;
                }
                {
                    int _e12 = z;
                    int _e13 = a;
                    node_direction(_e12, _e13, h_2, radius_2, d_mu, d_azimuth, d_weight);
                    float _e19 = d_mu;
                    float _e20 = d_azimuth;
                    float _e21 = d_weight;
                    float along_1 = (sqrt(max(((1.0 - _e19) * (1.0 + _e19)), 0.0)) * cos(_e20));
                    float _e33 = harmonic(index_1, _e19, along_1);
                    float y = ((index_1 == MOMENTS) ? max(_e19, 0.0) : _e33);
                    int _e44 = a;
                    int _e45 = z;
                    ivec2 texel = ((node * ivec2(8, 16)) + ivec2(_e44, _e45));
                    vec3 _e49 = sum;
                    vec4 _e52 = texelFetch(_group_0_binding_1_fs, texel, 0);
                    sum = (_e49 + (_e52.xyz * (y * _e21)));
                }
            }
        }
    }
    vec3 _e63 = sum;
    return _e63;
}

void main() {
    vec4 position = gl_FragCoord;
    float m_radius = _group_0_binding_0_fs.medium.radius;
    float m_thickness = _group_0_binding_0_fs.medium.thickness;
    ivec2 texel_1 = ivec2(position.xy);
    int altitudes = (ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)).y / ZENITHS);
    bool ground = (texel_1.y == (altitudes * MOMENTS));
    ivec2 node_1 = ivec2(texel_1.x, (ground ? 0 : (texel_1.y / MOMENTS)));
    float _e29 = _group_0_binding_0_fs.luts.altitude_steepness;
    float _e31 = _group_0_binding_0_fs.luts.altitude_growth;
    float _e38 = v_to_altitude(_e29, _e31, (float(node_1.y) / float((altitudes - 1))), m_thickness);
    vec3 tiny = vec3(7.888609e-31);
    if (ground) {
        vec3 _e42 = moment(node_1, _e38, m_radius, MOMENTS);
        _fs2p_location0 = vec4(log2(max(_e42, tiny)), 0.0);
        return;
    }
    vec3 _e48 = moment(node_1, _e38, m_radius, 0);
    vec3 mean = max(_e48, tiny);
    int index_2 = (texel_1.y % MOMENTS);
    if ((index_2 == 0)) {
        _fs2p_location0 = vec4(log2(mean), 0.0);
        return;
    }
    vec3 _e58 = moment(node_1, _e38, m_radius, index_2);
    _fs2p_location0 = vec4((_e58 / mean), 0.0);
    return;
}

