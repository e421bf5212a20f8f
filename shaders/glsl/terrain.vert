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
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tan_sun_radius;
    float min_visibility;
    float inv_extent;
};
struct Terrain {
    Frame frame;
    vec3 axis;
    float amplitude;
    vec3 grid_x;
    float arc_scale;
    vec3 grid_y;
    float arc_rate;
    vec3 planet_x;
    float sea;
    vec3 planet_y;
    float offset_x;
    vec3 planet_z;
    float offset_y;
    vec3 low_albedo;
    float mountain_rate;
    vec3 high_albedo;
    float snow_line;
    vec3 sky_light;
    float pad;
    Luts luts;
    MoonShadow moon_shadow;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const uint RINGS = 256u;
const uint SEGMENTS = 384u;
const bool SKY_LIGHT = true;
const bool MOON = true;
const uint VERTICES = 197632u;

layout(std140) uniform Terrain_block_0Vertex { Terrain _group_0_binding_0_vs; };

smooth out vec3 _vs2fs_location0;
smooth out vec3 _vs2fs_location1;
smooth out vec3 _vs2fs_location2;

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

float distance_to_top(float excess_2, float r_mu_1, float top_excess) {
    float c = max((top_excess - excess_2), 0.0);
    float root = sqrt(((r_mu_1 * r_mu_1) + c));
    if ((r_mu_1 > 0.0)) {
        return (c / (r_mu_1 + root));
    }
    return (root - r_mu_1);
}

mat2x3 layers_of(float m_rayleigh_inv_height_1, float m_mie_inv_height_1, float m_ozone_center_1, float m_ozone_inv_half_width_1, float m_datum_1) {
    vec3 fall = vec3(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_inv_half_width_1);
    return mat2x3(fall, vec3(m_datum_1, m_ozone_center_1, 0.0));
}

mat3x3 coefficients_of(vec3 m_rayleigh_1, vec3 m_mie_extinction_1, vec3 m_ozone_1) {
    return mat3x3(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
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

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e4 = sum;
        sum = (_e4 + (coefficients[0] * d_1.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d_1.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d_1.z));
    }
    vec3 _e23 = sum;
    return _e23;
}

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

vec3 path_densities(mat2x3 layers_1, float radius_3, float excess_3, float r_mu_2, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_2), 0.0, distance_);
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
            float _e32 = altitude_after(excess_3, r_mu_2, _e27, radius_3);
            vec3 _e34 = sum_1;
            vec3 _e36 = densities(layers_1, _e32);
            float _e38 = t0_;
            sum_1 = (_e34 + (_e36 * (_e29 - _e38)));
            t0_ = _e29;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 sun_transmittance(mat3x3 coefficients_1, mat2x3 layers_2, float radius_4, float thickness, float excess_4, float sun_r_mu, uint samples_1) {
    float _e2 = excess_of(thickness, radius_4);
    float _e5 = distance_to_top(excess_4, sun_r_mu, _e2);
    vec3 _e8 = path_densities(layers_2, radius_4, excess_4, sun_r_mu, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

float lattice(ivec3 p) {
    uint h_2 = 0u;
    h_2 = (((uint(p.x) * 2376512323u) ^ (uint(p.y) * 3625334849u)) ^ (uint(p.z) * 3407524639u));
    uint _e16 = h_2;
    uint _e17 = h_2;
    h_2 = ((_e16 ^ (_e17 >> 13u)) * 1540483477u);
    uint _e23 = h_2;
    uint _e24 = h_2;
    h_2 = ((_e23 ^ (_e24 >> 15u)) * 739982445u);
    uint _e30 = h_2;
    uint _e31 = h_2;
    h_2 = (_e30 ^ (_e31 >> 14u));
    uint _e35 = h_2;
    return (float((_e35 >> 8u)) * 5.9604645e-8);
}

vec4 noise(vec3 p_1) {
    vec3 cell = floor(p_1);
    ivec3 i_1 = ivec3(cell);
    vec3 f = (p_1 - cell);
    vec3 w = (((f * f) * f) * ((f * ((f * 6.0) - vec3(15.0))) + vec3(10.0)));
    vec3 dw = (((30.0 * f) * f) * ((f * (f - vec3(2.0))) + vec3(1.0)));
    float _e27 = lattice(i_1);
    float _e33 = lattice((i_1 + ivec3(1, 0, 0)));
    float _e39 = lattice((i_1 + ivec3(0, 1, 0)));
    float _e45 = lattice((i_1 + ivec3(1, 1, 0)));
    float _e51 = lattice((i_1 + ivec3(0, 0, 1)));
    float _e57 = lattice((i_1 + ivec3(1, 0, 1)));
    float _e63 = lattice((i_1 + ivec3(0, 1, 1)));
    float _e69 = lattice((i_1 + ivec3(1, 1, 1)));
    float x00_ = mix(_e27, _e33, w.x);
    float x10_ = mix(_e39, _e45, w.x);
    float x01_ = mix(_e51, _e57, w.x);
    float x11_ = mix(_e63, _e69, w.x);
    float y0_ = mix(x00_, x10_, w.y);
    float y1_ = mix(x01_, x11_, w.y);
    float dx = mix(mix((_e33 - _e27), (_e45 - _e39), w.y), mix((_e57 - _e51), (_e69 - _e63), w.y), w.z);
    float dy = mix((x10_ - x00_), (x11_ - x01_), w.z);
    return vec4((vec3(dx, dy, (y1_ - y0_)) * dw), mix(y0_, y1_, w.z));
}

vec4 height_field(vec3 n, float amplitude, float rate, float sea, float spacing) {
    vec4 land = vec4(0.0);
    vec4 ridge = vec4(0.0);
    float frequency = 0.0;
    float gain = 0.55;
    int octave = 0;
    vec4 _e10 = noise(((n * 2.3) + vec3(11.0)));
    land = ((_e10 * vec4(vec3(2.3), 1.0)) * 0.6);
    vec4 _e19 = land;
    vec4 _e25 = noise(((n * 5.1) + vec3(5.0)));
    land = (_e19 + ((_e25 * vec4(vec3(5.1), 1.0)) * 0.3));
    vec4 _e34 = land;
    vec4 _e40 = noise(((n * 13.7) + vec3(3.0)));
    land = (_e34 + ((_e40 * vec4(vec3(13.7), 1.0)) * 0.1));
    float coast = mix(0.25, 0.48, sea);
    float _e54 = land.w;
    float rise = ((_e54 - coast) * 14.0);
    if ((rise <= 0.0)) {
        return vec4(0.0);
    }
    float above = min(rise, 1.0);
    vec4 _e66 = land;
    vec3 d_above = ((rise < 1.0) ? (_e66.xyz * 14.0) : vec3(0.0));
    vec4 _e77 = noise(((n * 9.0) + vec3(29.0)));
    vec4 belt_noise = (_e77 * vec4(vec3(9.0), 1.0));
    float t_1 = clamp(((belt_noise.w - 0.38) * 4.0), 0.0, 1.0);
    float belt = (0.1 + (((0.9 * t_1) * t_1) * (3.0 - (2.0 * t_1))));
    vec3 d_belt = (belt_noise.xyz * (((5.4 * t_1) * (1.0 - t_1)) * 4.0));
    frequency = rate;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e181 = octave;
            octave = (_e181 + 1);
        }
        loop_init_1 = false;
        int _e113 = octave;
        if ((_e113 < 6)) {
        } else {
            break;
        }
        {
            float _e116 = frequency;
            float seen = clamp(((0.3 / (_e116 * spacing)) - 0.5), 0.0, 1.0);
            if ((seen > 0.0)) {
                float _e128 = frequency;
                int _e130 = octave;
                vec4 _e136 = noise(((n * _e128) + vec3((float(_e130) * 17.0))));
                float _e137 = frequency;
                vec4 v = (_e136 * vec4(vec3(_e137), 1.0));
                float s = ((v.w < 0.5) ? 2.0 : -2.0);
                vec4 _e149 = ridge;
                float _e162 = gain;
                ridge = (_e149 + (vec4((v.xyz * s), (1.0 - abs(((2.0 * v.w) - 1.0)))) * (_e162 * seen)));
            }
            float _e167 = ridge.w;
            float _e168 = gain;
            ridge.w = (_e167 + ((0.6 * _e168) * (1.0 - seen)));
            float _e175 = frequency;
            frequency = (_e175 * 2.03);
            float _e178 = gain;
            gain = (_e178 * 0.45);
        }
    }
    float _e186 = ridge.w;
    float w_1 = ((above * belt) * _e186);
    float _e190 = ridge.w;
    float _e194 = ridge.w;
    vec4 _e198 = ridge;
    vec3 d_2 = ((((d_above * belt) * _e190) + ((above * d_belt) * _e194)) + ((above * belt) * _e198.xyz));
    return (vec4(d_2, w_1) * amplitude);
}

void grid_point(uint index_1, inout vec3 out_flat, inout float out_sin_arc, inout float out_drop, inout float out_spacing) {
    uint k = min((max((index_1 % 772u), 1u) - 1u), (772u - 3u));
    uint ring = ((index_1 / 772u) + (k & 1u));
    float azimuth = ((6.2831855 * float(((k / 2u) % SEGMENTS))) / 384.0);
    float _e29 = _group_0_binding_0_vs.arc_rate;
    float s_1 = (_e29 * float(ring));
    float _e34 = _group_0_binding_0_vs.arc_scale;
    float t_2 = ((_e34 * 0.5) * (exp(s_1) - exp(-(s_1))));
    vec3 _e44 = _group_0_binding_0_vs.grid_x;
    vec3 _e49 = _group_0_binding_0_vs.grid_y;
    vec3 flat_ = normalize(((_e44 * cos(azimuth)) + (_e49 * sin(azimuth))));
    float sin_arc = ((2.0 * t_2) / (1.0 + (t_2 * t_2)));
    float drop = (((2.0 * t_2) * t_2) / (1.0 + (t_2 * t_2)));
    float _e69 = _group_0_binding_0_vs.arc_rate;
    float _e74 = _group_0_binding_0_vs.arc_scale;
    float _e77 = _group_0_binding_0_vs.arc_scale;
    float along = (((2.0 * _e69) * sqrt(((_e74 * _e77) + (t_2 * t_2)))) / (1.0 + (t_2 * t_2)));
    out_flat = flat_;
    out_sin_arc = sin_arc;
    out_drop = drop;
    out_spacing = max(along, (sin_arc * 0.016362462));
}

vec3 ground_light(vec3 m_rayleigh_2, float m_rayleigh_inv_height_2, float m_mie_inv_height_2, vec3 m_mie_extinction_2, float m_ozone_center_2, float m_ozone_inv_half_width_2, vec3 m_ozone_2, float m_radius_1, float m_thickness_1, float m_datum_2, float h_3, vec3 n_1, vec3 normal) {
    vec3 light = vec3(0.0);
    vec3 f_sun = _group_0_binding_0_vs.frame.sun;
    float f_sun_chord = _group_0_binding_0_vs.frame.sun_chord;
    float mu_sun = dot(n_1, f_sun);
    float height = (m_datum_2 + h_3);
    float _e22 = excess_of(height, m_radius_1);
    float sun_r_mu_1 = ((m_radius_1 + height) * mu_sun);
    float dip = (sqrt(_e22) / (m_radius_1 + height));
    float visible = smoothstep(-1.0, 1.0, ((mu_sun + dip) / f_sun_chord));
    if (SKY_LIGHT) {
    } else {
        vec3 _e36 = _group_0_binding_0_vs.sky_light;
        light = ((_e36 * clamp(((mu_sun + 0.1) / 1.1), 0.0, 1.0)) * (0.5 + (0.5 * dot(normal, n_1))));
    }
    if ((visible > 0.0)) {
        mat3x3 _e55 = coefficients_of(m_rayleigh_2, m_mie_extinction_2, m_ozone_2);
        mat2x3 _e56 = layers_of(m_rayleigh_inv_height_2, m_mie_inv_height_2, m_ozone_center_2, m_ozone_inv_half_width_2, m_datum_2);
        vec3 _e58 = sun_transmittance(_e55, _e56, m_radius_1, m_thickness_1, _e22, sun_r_mu_1, 8u);
        vec3 _e59 = light;
        light = (_e59 + (_e58 * (visible * max(dot(normal, f_sun), 0.0))));
    }
    vec3 _e66 = light;
    return _e66;
}

vec4 clip_position(vec3 position) {
    vec3 f_ray_right = _group_0_binding_0_vs.frame.ray_right;
    vec3 f_ray_up = _group_0_binding_0_vs.frame.ray_up;
    vec3 _e8 = _group_0_binding_0_vs.axis;
    float z_1 = dot(position, _e8);
    float _e16 = _group_0_binding_0_vs.offset_x;
    float right = ((dot(position, f_ray_right) / dot(f_ray_right, f_ray_right)) - (_e16 * z_1));
    float _e24 = _group_0_binding_0_vs.offset_y;
    float top = ((dot(position, f_ray_up) / dot(f_ray_up, f_ray_up)) - (_e24 * z_1));
    return vec4(right, top, (0.5 * z_1), z_1);
}

void main() {
    uint index = uint(gl_VertexID);
    vec3 m_rayleigh = vec3(0.0);
    float m_rayleigh_inv_height = 0.0;
    float m_mie_inv_height = 0.0;
    vec3 m_mie_extinction = vec3(0.0);
    float m_ozone_center = 0.0;
    float m_ozone_inv_half_width = 0.0;
    vec3 m_ozone = vec3(0.0);
    float m_radius = 0.0;
    float m_thickness = 0.0;
    float m_datum = 0.0;
    vec4 out_clip = vec4(0.0);
    vec3 out_position = vec3(0.0);
    vec3 out_light = vec3(0.0);
    vec3 out_surface = vec3(0.0);
    vec3 p_flat = vec3(0.0);
    float p_sin_arc = 0.0;
    float p_drop = 0.0;
    float p_spacing = 0.0;
    vec3 f_medium_rayleigh = _group_0_binding_0_vs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_vs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_vs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_vs.frame.medium.mie_extinction;
    float f_medium_ozone_center = _group_0_binding_0_vs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_vs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_vs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_vs.frame.medium.radius;
    float f_medium_thickness = _group_0_binding_0_vs.frame.medium.thickness;
    float f_medium_datum = _group_0_binding_0_vs.frame.medium.datum;
    vec3 f_sun_1 = _group_0_binding_0_vs.frame.sun;
    float f_camera_altitude = _group_0_binding_0_vs.frame.camera_altitude;
    m_rayleigh = f_medium_rayleigh;
    m_rayleigh_inv_height = f_medium_rayleigh_inv_height;
    m_mie_inv_height = f_medium_mie_inv_height;
    m_mie_extinction = f_medium_mie_extinction;
    m_ozone_center = f_medium_ozone_center;
    m_ozone_inv_half_width = f_medium_ozone_inv_half_width;
    m_ozone = f_medium_ozone;
    m_radius = f_medium_radius;
    m_thickness = f_medium_thickness;
    m_datum = f_medium_datum;
    if (SKY_LIGHT) {
        vec3 _e41 = _group_0_binding_0_vs.luts.mie_extinction;
        m_mie_extinction = _e41;
    }
    vec3 up = vec3(0.0, 0.0, 1.0);
    grid_point(index, p_flat, p_sin_arc, p_drop, p_spacing);
    vec3 _e51 = p_flat;
    float _e52 = p_sin_arc;
    float _e53 = p_drop;
    float _e54 = p_spacing;
    vec3 n_2 = ((_e51 * _e52) + (up * (1.0 - _e53)));
    vec3 _e62 = _group_0_binding_0_vs.planet_x;
    vec3 _e66 = _group_0_binding_0_vs.planet_y;
    vec3 _e70 = _group_0_binding_0_vs.planet_z;
    vec3 planet_n = vec3(dot(_e62, n_2), dot(_e66, n_2), dot(_e70, n_2));
    float _e75 = _group_0_binding_0_vs.amplitude;
    float _e78 = _group_0_binding_0_vs.mountain_rate;
    float _e81 = _group_0_binding_0_vs.sea;
    vec4 _e82 = height_field(planet_n, _e75, _e78, _e81, _e54);
    float h_4 = _e82.w;
    float _e84 = m_radius;
    float _e85 = m_datum;
    float r = ((_e84 + _e85) + h_4);
    vec3 position_1 = ((_e51 * (r * _e52)) + (up * ((h_4 - f_camera_altitude) - (r * _e53))));
    vec3 _e97 = _group_0_binding_0_vs.planet_x;
    vec3 _e102 = _group_0_binding_0_vs.planet_y;
    vec3 _e108 = _group_0_binding_0_vs.planet_z;
    vec3 g = (((_e97 * _e82.x) + (_e102 * _e82.y)) + (_e108 * _e82.z));
    float _e115 = m_radius;
    vec3 normal_1 = normalize((n_2 - ((g - (n_2 * dot(g, n_2))) / vec3(_e115))));
    vec4 _e124 = clip_position(position_1);
    out_clip = _e124;
    out_position = position_1;
    vec3 _e125 = m_rayleigh;
    float _e126 = m_rayleigh_inv_height;
    float _e127 = m_mie_inv_height;
    vec3 _e128 = m_mie_extinction;
    float _e129 = m_ozone_center;
    float _e130 = m_ozone_inv_half_width;
    vec3 _e131 = m_ozone;
    float _e132 = m_radius;
    float _e133 = m_thickness;
    float _e134 = m_datum;
    vec3 _e135 = ground_light(_e125, _e126, _e127, _e128, _e129, _e130, _e131, _e132, _e133, _e134, h_4, n_2, normal_1);
    out_light = _e135;
    out_surface = vec3(h_4, dot(normal_1, n_2), dot(n_2, f_sun_1));
    vec4 _e139 = out_clip;
    vec3 _e140 = out_position;
    vec3 _e141 = out_light;
    vec3 _e142 = out_surface;
    gl_Position = _e139;
    _vs2fs_location0 = _e140;
    _vs2fs_location1 = _e141;
    _vs2fs_location2 = _e142;
    gl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);
    return;
}

