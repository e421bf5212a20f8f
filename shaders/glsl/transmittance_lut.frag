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
const float LOG_FLOOR = -100.0;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float excess_1, float r_mu, float t, float radius_2) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);
    return max(_e9, 0.0);
}

vec3 transmittance_texel_ray(vec2 position_1, vec2 size, float m_radius, float m_thickness) {
    vec2 uv = (position_1 / (size - vec2(1.0)));
    float _e8 = excess_of(m_thickness, m_radius);
    float rho_top = sqrt(_e8);
    float rho = (uv.y * rho_top);
    float _e13 = altitude_of((rho * rho), m_radius);
    float h_2 = min(_e13, m_thickness);
    float shortest = (m_thickness - h_2);
    float d_1 = (shortest + (uv.x * ((rho + rho_top) - shortest)));
    float r_mu_2 = ((d_1 > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d_1) - d_1) * 0.5) : (m_radius + h_2));
    return vec3((rho * rho), max(r_mu_2, -(rho)), d_1);
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall, vec3(m_datum, m_ozone_center, 0.0));
}

vec3 densities(mat2x3 layers, float h_1) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h_1 - layers[1].x), 0.0);
    if (RAYLEIGH) {
        d.x = exp((-(z) * fall_1.x));
    }
    if (MIE) {
        d.y = exp((-(z) * fall_1.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((z - layers[1].y)) * fall_1.z)));
    }
    vec3 _e35 = d;
    return _e35;
}

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

vec3 path_densities(mat2x3 layers_1, float radius_3, float excess_2, float r_mu_1, float distance_, uint samples) {
    vec3 sum = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_1), 0.0, distance_);
    float u0_ = -(sqrt(perigee_1));
    float du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e42 = i;
            i = (_e42 + 1u);
        }
        loop_init = false;
        uint _e18 = i;
        if ((_e18 < samples)) {
        } else {
            break;
        }
        {
            uint _e20 = i;
            float u_1 = (u0_ + (du * float(_e20)));
            float _e27 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));
            float _e29 = u_to_distance(perigee_1, (u_1 + du));
            float _e32 = altitude_after(excess_2, r_mu_1, _e27, radius_3);
            vec3 _e34 = sum;
            vec3 _e36 = densities(layers_1, _e32);
            float _e38 = t0_;
            sum = (_e34 + (_e36 * (_e29 - _e38)));
            t0_ = _e29;
        }
    }
    vec3 _e45 = sum;
    return _e45;
}

void main() {
    vec4 position = gl_FragCoord;
    float m_rayleigh_inv_height_1 = _group_0_binding_0_fs.medium.rayleigh_inv_height;
    float m_mie_inv_height_1 = _group_0_binding_0_fs.medium.mie_inv_height;
    float m_ozone_center_1 = _group_0_binding_0_fs.medium.ozone_center;
    float m_ozone_inv_half_width_1 = _group_0_binding_0_fs.medium.ozone_inv_half_width;
    float m_radius_1 = _group_0_binding_0_fs.medium.radius;
    float m_thickness_1 = _group_0_binding_0_fs.medium.thickness;
    float m_datum_1 = _group_0_binding_0_fs.medium.datum;
    uvec2 _e22 = _group_0_binding_0_fs.luts.size;
    vec3 _e24 = transmittance_texel_ray(floor(position.xy), vec2(_e22), m_radius_1, m_thickness_1);
    mat2x3 _e25 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    uint _e32 = _group_0_binding_0_fs.luts.steps;
    vec3 _e33 = path_densities(_e25, m_radius_1, _e24.x, _e24.y, _e24.z, _e32);
    _fs2p_location0 = vec4(max(log2(max(_e33, vec3(1e-37))), vec3(-100.0)), 0.0);
    return;
}

