// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&aerial_lut_scan::INFO, &aerial_lut_slices::INFO, &aerial_march::INFO, &aerial_march_eclipse::INFO, &aerial_perspective::INFO, &airglow::INFO, &copy::INFO, &moon_disk::INFO, &multi_scattering_gather::INFO, &multi_scattering_lut::INFO, &sky_march::INFO, &sky_march_eclipse::INFO, &sky_view::INFO, &sky_view_lut::INFO, &sun_disk::INFO, &terrain::INFO, &tone_map::INFO, &transmittance_lut::INFO, &upsample::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_AERIAL_LUT: &str = crate::shaders::wgsl!("lib/aerial_lut");
    pub(super) const PASS_AERIAL_LUT_SCAN: &str = crate::shaders::wgsl!("pass/aerial_lut_scan");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("lib/multi_scattering_lut");
    pub(super) const LIB_GATHER: &str = crate::shaders::wgsl!("lib/gather");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_AERIAL_LUT_SLICES: &str = crate::shaders::wgsl!("pass/aerial_lut_slices");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_AERIAL: &str = crate::shaders::wgsl!("lib/aerial");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const PASS_AERIAL_MARCH: &str = crate::shaders::wgsl!("pass/aerial_march");
    pub(super) const LIB_ALL_ORDERS: &str = crate::shaders::wgsl!("lib/all_orders");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const LIB_MOON_SHADOW: &str = crate::shaders::wgsl!("lib/moon_shadow");
    pub(super) const LIB_ECLIPSED_SUN: &str = crate::shaders::wgsl!("lib/eclipsed_sun");
    pub(super) const PASS_AERIAL_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/aerial_march_eclipse");
    pub(super) const LIB_LUT_AIR: &str = crate::shaders::wgsl!("lib/lut_air");
    pub(super) const PASS_AERIAL_PERSPECTIVE: &str = crate::shaders::wgsl!("pass/aerial_perspective");
    pub(super) const PASS_AIRGLOW: &str = crate::shaders::wgsl!("pass/airglow");
    pub(super) const PASS_COPY: &str = crate::shaders::wgsl!("pass/copy");
    pub(super) const LIB_CELESTIAL_DISK: &str = crate::shaders::wgsl!("lib/celestial_disk");
    pub(super) const PASS_MOON_DISK: &str = crate::shaders::wgsl!("pass/moon_disk");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_MULTI_SCATTERING_GATHER: &str = crate::shaders::wgsl!("pass/multi_scattering_gather");
    pub(super) const PASS_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("pass/multi_scattering_lut");
    pub(super) const PASS_SKY_MARCH: &str = crate::shaders::wgsl!("pass/sky_march");
    pub(super) const PASS_SKY_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/sky_march_eclipse");
    pub(super) const PASS_SKY_VIEW: &str = crate::shaders::wgsl!("pass/sky_view");
    pub(super) const PASS_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("pass/sky_view_lut");
    pub(super) const LIB_LIMB_DARKENING: &str = crate::shaders::wgsl!("lib/limb_darkening");
    pub(super) const PASS_SUN_DISK: &str = crate::shaders::wgsl!("pass/sun_disk");
    pub(super) const LIB_NOISE: &str = crate::shaders::wgsl!("lib/noise");
    pub(super) const PASS_TERRAIN: &str = crate::shaders::wgsl!("pass/terrain");
    pub(super) const PASS_TONE_MAP: &str = crate::shaders::wgsl!("pass/tone_map");
    pub(super) const PASS_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("pass/transmittance_lut");
    pub(super) const PASS_UPSAMPLE: &str = crate::shaders::wgsl!("pass/upsample");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const bool ACES = true;\nconst bool AGX = true;\nconst bool DITHER = true;\n",
    "const float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst bool FINISH = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const float HALF_MAX=32000.0;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BEFORE = true;\nconst vec4 NODES = vec4(0.06943184, 0.3300095, 0.66999054, 0.93056816);\nconst vec4 WEIGHTS = vec4(0.17392743, 0.32607257, 0.32607257, 0.17392743);\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst bool MIE_SINGLE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool BODY = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool LIMB_DARKENING = true;\nconst bool MOON = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint RINGS = 256u;\nconst uint SEGMENTS = 384u;\nconst bool SKY_LIGHT = true;\nconst bool MOON = true;\nconst uint VERTICES = 197632u;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float LOG_FLOOR = -100.0;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\nconst bool BLEND = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float LOG_FLOOR = -100.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\n",
    "layout(location=0)out vec4 o0;\n",
    "layout(std140)uniform Frame_block_0Fragment{Frame g0;};\n",
    "layout(std140)uniform Terrain_block_0Fragment{Terrain g0;};\n",
    "layout(std140)uniform Terrain_block_0Vertex{Terrain h0;};\n",
    "layout(std140)uniform Tone_block_0Fragment{Tone g0;};\n",
    "layout(std140)uniform Uniforms_block_0Fragment{Uniforms g0;};\n",
    "layout(std140)uniform Uniforms_block_0Vertex{Uniforms h0;};\n",
    "precision highp float;precision highp int;\n",
    "smooth in vec3 v0;smooth in vec3 v1;smooth in vec3 v2;layout(location=0)out vec4 o0;\n",
    "smooth out vec3 v0;smooth out vec3 v1;smooth out vec3 v2;\n",
    "struct DepthCode{float scale;float bias;float log_;float background;};\n",
    "struct Frame{Medium medium;vec3 ray_forward;float altitude;vec3 ray_right;float sky_weight;vec3 ray_up;float shell_weight;vec3 sun;float sun_chord;vec2 size;float sun_disk;float pixel_angle;DepthCode depth;uint view_samples;uint light_samples;uint flags;float camera_altitude;vec4 sky_view_mapping;};\n",
    "struct Luts{vec3 mie_extinction;float altitude_steepness;vec3 mie_moment0_;float altitude_growth;vec3 mie_moment1_;float sun_middle;vec3 mie_moment2_;float sun_width;vec3 mie_asymmetry;float pad;vec3 albedo;float sun_first;float sun_span;float ground_rows;uvec2 size;uint steps;uint shift;uint slices;float aerial_ground_rows;};\n",
    "struct Medium{vec3 rayleigh;float rayleigh_inv_height;vec3 mie_scattering;float mie_inv_height;vec3 mie_extinction;float ozone_center;vec3 mie_asymmetry;float ozone_inv_half_width;vec3 ozone;float radius;vec3 irradiance;float thickness;};\n",
    "struct MoonShadow{vec3 across;float along;float radius;float tan_sun_radius;float min_visibility;float inv_extent;};\n",
    "struct Terrain{Frame frame;vec3 axis;float amplitude;vec3 grid_x;float arc_scale;vec3 grid_y;float arc_rate;vec3 planet_x;float sea;vec3 planet_y;float offset_x;vec3 planet_z;float offset_y;vec3 low_albedo;float mountain_rate;vec3 high_albedo;float snow_line;vec3 sky_light;float pad;Luts luts;MoonShadow moon_shadow;};\n",
    "struct Tone{float exposure;uint flipped;float pad1_;float pad2_;};\n",
    "struct Uniforms{Frame frame;Luts luts;MoonShadow moon_shadow;};\n",
    "struct Uniforms{Frame frame;Luts luts;};\n",
    "struct Uniforms{Frame frame;vec3 zenith;float bottom;float middle;float top;float pad1_;float pad2_;};\n",
    "struct Uniforms{Frame frame;vec4 rectangle;vec3 moon_direction;float moon_sine;float moon_chord;float albedo_over_pi;float earthshine;float sun_visibility;};\n",
    "struct Uniforms{Medium medium;Luts luts;};\n",
    "uniform highp sampler2D g1;\n",
    "uniform highp sampler2D g2;\n",
    "uniform highp sampler2D g3;\n",
    "uniform highp sampler2D g4;\n",
    "uniform highp sampler2D g5;\n",
    "uniform highp sampler2D g6;\n",
    "uniform highp sampler2D g7;\n",
    "vec3 aces(vec3 a){mat3x3 b=mat3x3(vec3(0.59719,0.076,0.0284),vec3(0.35458,0.90834,0.13383),vec3(0.04823,0.01566,0.83777));mat3x3 c=mat3x3(vec3(1.60475,-0.10208,-0.00327),vec3(-0.53108,1.10813,-0.07276),vec3(-0.07367,-0.00605,1.07602));vec3 d=(b*a);vec3 e=((d*(d+vec3(0.0245786)))-vec3(9.0537e-5));vec3 f=((d*((0.983729*d)+vec3(0.432951)))+vec3(0.238081));return(c*(e/f));}\n",
    "vec4 aerial_at(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,float g){if((e<0.0)){return vec4(vec3(g),0.0);}vec2 h=(vec2(1.0)/vec2((c.x*d),(c.y*4.0)));vec2 i=((b+(c*vec2(e,float(f))))+vec2(0.5));vec4 j=textureLod(a,vec2((i*h)),0.0);return j;}\n",
    "void aerial_column(highp sampler2D a,uint b,float c,float d,float e,bool f,inout vec2 g,inout vec2 h,inout float i){float j=float(b);vec2 k=(vec2(uvec2(textureSize(a,0).xy))/vec2(j,4.0));float l=v_to_row(e,f,k.y,c);g=vec2((d*(k.x-1.0)),l);h=k;i=j;}\n",
    "vec3 aerial_light(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,vec3 g){vec4 h=aerial_at(a,b,c,d,(e-1.0),f,0.0);vec3 i=h.xyz;vec4 j=aerial_at(a,b,c,d,e,f,0.0);return mix(i,j.xyz,g);}\n",
    "vec4 aerial_load(highp sampler2D a,int b,int c,int d,int e,int f,int g){vec4 h=texelFetch(a,ivec2(((g*e)+c),((f*d)+b)),0);return h;}\n",
    "void aerial_slice(highp sampler2D a,vec2 b,vec2 c,float d,float e,float f,float g,inout float h,inout vec4 i,inout vec4 j){float k=0.0;vec4 l=vec4(0.0);vec4 m=vec4(0.0);int n=0;bool o=false;bool p=false;int q=0;bool r=false;bool s=false;float t=clamp(-(f),0.0,e);float u=distance_to_u(t,0.0);float v=distance_to_u(t,g);float w=distance_to_u(t,e);float x=((v-u)/(w-u));float y=(d-1.0);float z=min((g/e),1.0);k=clamp(floor((x*d)),0.0,y);float aa=k;vec4 ab=aerial_at(a,b,c,d,(aa-1.0),AIR_TRANSMITTANCE,1.0);l=ab;float ac=k;vec4 ad=aerial_at(a,b,c,d,ac,AIR_TRANSMITTANCE,1.0);m=ad;bool ae=true;while(true){if(!ae){int af=n;n=(af+1);}ae=false;int ag=n;if((ag<4)){float ah=m.w;o=(z>ah);}else{o=false;}bool ai=o;if(ai){float aj=k;p=(aj<y);}else{p=false;}bool ak=p;if(ak){}else{break;}{float al=k;k=(al+1.0);vec4 am=m;l=am;float an=k;vec4 ao=aerial_at(a,b,c,d,an,AIR_TRANSMITTANCE,1.0);m=ao;}}bool ap=true;while(true){if(!ap){int aq=q;q=(aq+1);}ap=false;int ar=q;if((ar<4)){float as=l.w;r=(z<as);}else{r=false;}bool at=r;if(at){float au=k;s=(au>0.0);}else{s=false;}bool av=s;if(av){}else{break;}{float aw=k;k=(aw-1.0);vec4 ax=l;m=ax;float ay=k;vec4 az=aerial_at(a,b,c,d,(ay-1.0),AIR_TRANSMITTANCE,1.0);l=az;}}float ba=k;vec4 bb=l;vec4 bc=m;h=ba;i=bb;j=bc;}\n",
    "void aerial_texel(vec2 a,uvec2 b,uint c,inout int d,inout int e,inout int f,inout int g,inout int h,inout int i){ivec2 j=ivec2(a);int k=int((b.x/c));int l=(int(b.y)/AIR_KINDS);d=(j.y/l);e=(j.y%l);f=(j.x%k);g=(j.x/k);h=l;i=k;}\n",
    "vec3 agx(vec3 a){mat3x3 b=mat3x3(vec3(0.84247905,0.042328242,0.042375654),vec3(0.0784336,0.87846863,0.0784336),vec3(0.079223745,0.07916613,0.879143));mat3x3 c=mat3x3(vec3(1.196879,-0.052896854,-0.052971635),vec3(-0.09802088,1.1519032,-0.09804345),vec3(-0.09902974,-0.098961174,1.1510737));vec3 d=clamp(log2(max((b*a),vec3(1e-10))),vec3(-12.47393),vec3(4.026069));vec3 e=((d+vec3(12.47393))/vec3(16.499998));vec3 f=(e*e);vec3 g=(f*f);vec3 h=((((((((15.5*g)*f)-((40.14*g)*e))+(31.96*g))-((6.868*f)*e))+(0.4298*f))+(0.1191*e))-vec3(0.00232));return pow(max((c*h),vec3(0.0)),vec3(2.2));}\n",
    "void air_before(highp sampler2D a,float b,float c,float d,float e,float f,float g,vec2 h,vec2 i,float j,float k,vec3 l,vec3 m,inout vec3 n,inout vec3 o){vec3 p=vec3(0.0);vec3 q=vec3(0.0);float r=0.0;vec4 s=vec4(0.0);vec4 t=vec4(0.0);aerial_slice(a,h,i,j,e,g,k,r,s,t);float u=r;vec4 v=s;vec4 w=t;vec3 x=slice_passed(v,w,e,f,g,k,b,c,d);vec3 y=slice_depth(v,w);vec3 z=mean_transmittance((y*x.x));vec3 aa=mean_transmittance(y);vec3 ab=(z/aa);p=l;q=m;if((k<e)){vec3 ac=p;vec3 ad=aerial_light(a,h,i,j,u,AIR_SMOOTH,(x.x*ab));p=(ac*ad);if(MIE_SINGLE){vec3 ae=min((x.y*ab),vec3(1.0));vec3 af=q;vec3 ag=aerial_light(a,h,i,j,u,AIR_MIE,ae);q=(af*ag);}}if(MIE_SINGLE){vec3 ah=p;vec3 ai=q;p=(ah+ai);}vec3 aj=p;n=(v.xyz*exp((-(y)*x.x)));o=aj;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i){bool j=false;float k=excess_of(f,e);float l=sqrt(max(-(b),0.0));if((d<=f)){float m=excess_of(d,e);float n=distance_to_top(m,a,k);float o=distance_to_ground(m,a,l);g=(c?o:n);h=m;i=a;return;}float p=top_half_chord2_(a,b,d,e,f);if(!((a>=0.0))){j=(p<=0.0);}else{j=true;}bool q=j;if(q){g=-1.0;h=0.0;i=0.0;return;}float r=sqrt(p);float s=distance_to_ground(k,-(r),l);float t=(c?s:(2.0*r));g=t;h=k;i=-(r);}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){bool k=false;float l=excess_of(f,e);float m=sqrt(max(-(b),0.0));if((d<=f)){float n=excess_of(d,e);float o=distance_to_top(n,a,l);float p=distance_to_ground(n,a,m);g=0.0;h=(c?p:o);i=n;j=a;return;}float q=((d-f)*(((2.0*e)+f)+d));float r=top_half_chord2_(a,b,d,e,f);if(!((a>=0.0))){k=(r<=0.0);}else{k=true;}bool s=k;if(s){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float t=sqrt(r);float u=distance_to_ground(l,-(t),m);float v=(c?u:(2.0*t));g=(q/(t-a));h=v;i=l;j=-(t);}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout bool q){float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;bool x=false;float y=0.0;float z=0.0;bool aa=false;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;line_past(a,b,c,y,z,aa);float af=y;float ag=z;bool ah=aa;air_path(af,ag,ah,b,c,d,ab,ac,ad,ae);float ai=ab;float aj=ac;float ak=ad;float al=ae;if((b<=d)){sun_side_inside(a,e,(c+b),ak,c,r,s,t,u,v,w);}else{if((aj>0.0)){sun_side_outside(a,e,(c+b),ai,-(al),ak,c,r,s,t,u,v,w);}else{s=dot(a,e);}}if(ah){x=(aj>=0.0);}else{x=false;}bool am=x;float an=r;float ao=s;float ap=t;float aq=u;float ar=v;float as=w;f=ai;g=aj;h=ak;i=al;j=ag;k=an;l=ao;m=ap;n=aq;o=ar;p=as;q=am;}\n",
    "void all_orders(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,vec3 k,float l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,vec3 t,float u,float v,float w,uint x,float y,float z,float aa,float ab,float ac,float ad,float ae,float af,float ag,float ah,float ai,bool aj,vec3 ak,vec3 al,float am,inout vec3 an,inout vec3 ao){float ap=0.0;float aq=0.0;float ar=0.0;vec3 as=vec3(0.0);vec3 at=vec3(0.0);vec3 au=vec3(0.0);perigee_of(z,aa,ab,ac,aj,am,l,ap,aq,ar);float av=ap;float aw=aq;float ax=ar;float ay=distance_to_u(av,0.0);float az=distance_to_u(av,am);float ba=rayleigh_phase(ae);vec3 bb=(c*ba);vec3 bc=mie_phase_between(ak,al,i);vec3 bd=(e*bc);gather(a,b,c,d,e,f,h,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,y,ad,ae,af,ag,ah,ai,ak,av,aw,ax,ay,az,bb,bd,1.0,as,at,au);vec3 be=as;vec3 bf=au;mat3x3 bg=coefficients_of(c,g,k);vec3 bh=extinction(bg,bf);an=be;ao=exp(-(bh));}\n",
    "float altitude_after(float a,float b,float c,float d){float e=altitude_of((a+(c*((2.0*b)+c))),d);return max(e,0.0);}\n",
    "float altitude_of(float a,float b){return(a/(b+sqrt(max(((b*b)+a),0.0))));}\n",
    "float altitude_to_v(float a,float b,float c,float d){float e=((max(c,0.0)/d)*b);float f=(e*(1.0-(e*(0.5-(e*(0.33333334-(e*0.25)))))));return sqrt((((e<0.05)?f:log((1.0+e)))/a));}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=(a.x/b);float d=sqrt((0.5+(0.5*min(abs(c),1.0))));float e=(((0.5*abs(a.y))/b)/d);float f=((c>=0.0)?e:d);return(f/(d+e));}\n",
    "vec4 bilinear(highp sampler2D a,ivec2 b,ivec2 c,vec2 d,ivec2 e){ivec2 f=(b+e);ivec2 g=(c+e);vec4 h=texelFetch(a,f,0);vec4 i=texelFetch(a,ivec2(g.x,f.y),0);vec4 j=mix(h,i,d.x);vec4 k=texelFetch(a,ivec2(f.x,g.y),0);vec4 l=texelFetch(a,g,0);vec4 m=mix(k,l,d.x);return mix(j,m,d.y);}\n",
    "vec4 clip_position(vec3 a){vec3 b=h0.frame.ray_right;vec3 c=h0.frame.ray_up;vec3 d=h0.axis;float e=dot(a,d);float f=h0.offset_x;float g=((dot(a,b)/dot(b,b))-(f*e));float h=h0.offset_y;float i=((dot(a,c)/dot(c,c))-(h*e));return vec4(g,i,(0.5*e),e);}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "vec4 compose(vec4 a,vec3 b,vec3 c){if(BLEND){vec4 d=veil(c,b);return d;}else{vec3 e=(a.xyz*b);return vec4((e+min(c,max((vec3(32000.0)-e),vec3(0.0)))),a.w);}}\n",
    "void corner(vec2 a,ivec2 b,inout ivec2 c,inout ivec2 d,inout vec2 e){vec2 f=clamp(a,vec2(0.0),vec2((b-ivec2(1))));ivec2 g=min(ivec2(f),(b-ivec2(1)));c=g;d=min((g+ivec2(1)),(b-ivec2(1)));e=(f-vec2(g));}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=(1.0-a);vec3 e=henyey_greenstein_phase(a,b,c);return((vec3((1.5*(1.0+(d*d))))/(vec3(2.0)+(c*c)))*e);}\n",
    "float crowded(float a,float b,float c){return sqrt((max(a,0.0)/(c*(b+c))));}\n",
    "vec3 dark_part(vec2 a,float b,float c){float d=clamp(a.x,b,c);float e=clamp(a.y,b,c);return vec3(d,e,((a.y>a.x)?max((e-d),0.0):0.0));}\n",
    "vec3 decode_light(vec3 a){vec3 b=(a*a);return(b*b);}\n",
    "vec3 densities(vec4 a,float b){vec3 c=vec3(0.0);if(RAYLEIGH){c.x=exp((-(b)*a.x));}if(MIE){c.y=exp((-(b)*a.y));}if(OZONE){c.z=max(0.0,(1.0-(abs((b-a.z))*a.w)));}vec3 d=c;return d;}\n",
    "float depth_distance(float a,float b,float c,float d,float e,float f){if((e==d)){return-1.0;}if((c>0.0)){return(((exp2((e*c))-1.0)*0.001)*f);}float g=((e*a)+b);if((g<=0.0)){return-1.0;}return(f/g);}\n",
    "float depth_of(float a,float b,float c,float d){if((c>0.0)){return(log2((1.0+(d*1000.0)))/c);}return(((1.0/d)-b)/a);}\n",
    "vec4 disk_color(vec3 a,float b,float c,bool d,float e,vec3 f,float g,float h,vec3 i,float j,float k,vec3 l,float m,float n){vec3 o=vec3(0.0);float p=0.0;float q=0.0;float r=0.0;o=a;if(AIR){air_path(b,c,d,e,m,n,p,q,r);float s=p;float t=q;float u=r;if((s>0.0)){vec4 v=layers_of(g,h,j,k);vec3 w=path_densities(v,m,t,u,s,DISK_STEPS);vec3 x=o;mat3x3 y=coefficients_of(f,i,l);vec3 z=extinction(y,w);o=(x*exp(-(z)));}}vec3 aa=o;o=min(aa,vec3(32000.0));vec3 ab=o;float ac=o.x;float ad=o.y;float ae=o.z;return vec4(ab,(max(ac,max(ad,ae))*3.125e-5));}\n",
    "float disk_coverage(vec3 a,float b,float c){return clamp((((b-length(a))/c)+0.5),0.0,1.0);}\n",
    "float distance_to_ground(float a,float b,float c){return min((a/(c-b)),-(b));}\n",
    "float distance_to_top(float a,float b,float c){float d=max((c-a),0.0);float e=sqrt(((b*b)+d));if((b>0.0)){return(d/(b+e));}return(e-b);}\n",
    "float distance_to_u(float a,float b){return(sign((b-a))*sqrt(abs((b-a))));}\n",
    "vec3 dither(uvec2 a){uint b=((a.x*3242174889u)+(a.y*2447445413u));uvec3 c=uvec3(b,(b+1431655765u),(b+2863311530u));uvec3 d=((c<<uvec3(1u))^(uvec3(0u)-(c>>uvec3(31u))));return(((vec3((d>>uvec3(24u)))+vec3(0.5))/vec3(256.0))-vec3(0.5));}\n",
    "void eclipsed_light(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,vec3 k,float l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,vec3 t,float u,float v,float w,uint x,float y,float z,float aa,float ab,float ac,float ad,float ae,float af,float ag,float ah,float ai,bool aj,vec3 ak,vec3 al,float am,uint an,uint ao,inout vec3 ap,inout vec3 aq){if(MULTI_SCATTERING){all_orders(a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,am,ap,aq);return;}else{vec3 ar=(ak-al);single_scattering(c,d,e,f,g,h,i,j,k,l,m,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,am,(0.5*dot(ar,ar)),an,ao,ap,aq);return;}}\n",
    "vec3 encode_light(vec3 a){return sqrt(sqrt(a));}\n",
    "float excess_of(float a,float b){return(a*((2.0*b)+a));}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){vec3 d=c;c=(d+(a[0]*b.x));}if(MIE){vec3 e=c;c=(e+(a[1]*b.y));}if(OZONE){vec3 f=c;c=(f+(a[2]*b.z));}vec3 g=c;return g;}\n",
    "void gather(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,float g,float h,vec3 i,float j,float k,vec3 l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,float t,float u,uint v,float w,float x,float y,float z,float aa,float ab,float ac,vec3 ad,float ae,float af,float ag,float ah,float ai,vec3 aj,vec3 ak,float al,inout vec3 am,inout vec3 an){float ao=0.0;uint ap=0u;float aq=0.0;vec3 ar=vec3(0.0);vec3 as=vec3(0.0);vec3 at=vec3(0.0);am=vec3(0.0);an=vec3(1.0);vec4 au=layers_of(d,f,g,h);mat3x3 av=mat3x3(c,l,i);vec2 aw=shadow_stretch(x,y,z,aa,ab,ac);vec4 ax=sun_axis(q,s,t,u);vec2 ay=multi_scattering_span(b);mat3x3 az=mat3x3((e*n),(e*p),(e*r));float ba=((ai-ah)/float(v));float bb=u_to_distance(ae,ah);ao=bb;bool bc=true;while(true){if(!bc){uint bd=ap;ap=(bd+1u);}bc=false;uint be=ap;if((be<v)){}else{break;}{uint bf=ap;float bg=(ah+(ba*float(bf)));float bh=u_to_distance(ae,(bg+ba));float bi=ao;float bj=(bh-bi);float bk=u_to_distance(ae,(bg+(0.5*ba)));float bl=altitude_after(af,ag,(bk-ae),j);vec3 bm=densities(au,bl);vec3 bn=extinction(av,bm);vec3 bo=(bn*bj);vec3 bp=an;vec3 bq=mean_transmittance(bo);vec3 br=(bp*bq);float bs=ao;vec3 bt=dark_part(aw,bs,bh);if((bt.z<bj)){aq=bk;if((bt.z>0.0)){float bu=ao;float bv=lit_middle(bt,ae,bu,bh);aq=bv;}float bw=aq;float bx=(bw-ae);float by=max((af+(bx*((2.0*ag)+bx))),0.0);float bz=altitude_of(by,j);vec3 ca=densities(au,bz);float cb=aq;float cc=(x+(y*cb));vec3 cd=optical_path_to_top(a,j,k,by,bz,cc);vec3 ce=extinction(av,cd);ar=(((aj*ca.x)+(ak*ca.y))*exp(-(ce)));vec3 cf=ar;float cg=aq;vec3 ch=sun_visibility(ad,(w+cg));ar=(cf*ch);vec3 ci=am;vec3 cj=ar;am=(ci+((br*cj)*(bj-bt.z)));}if(MULTI_SCATTERING){float ck=(j+bl);float cl=clamp((((ag+bk)-ae)/ck),-1.0,1.0);float cm=clamp(((x+(y*bk))/ck),-1.0,1.0);float cn=altitude_to_v(m,o,bl,k);float co=mu_sun_to_u(ax,cm);vec2 cp=(vec2(co,cn)*ay);multi_scattering_source(b,cp,c,az,cl,cm,y,as,at);vec3 cq=as;vec3 cr=at;vec3 cs=sun_visibility_around(ad,(w+bk));vec3 ct=(((cq*cs)*bm.x)+((cr*cs)*bm.y));vec3 cu=am;am=(cu+((br*(bj*al))*ct));}vec3 cv=an;an=(cv*exp(-(bo)));ao=bh;}}}\n",
    "void gather(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,float g,float h,vec3 i,float j,float k,vec3 l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,float t,float u,uint v,float w,float x,float y,float z,float aa,float ab,float ac,vec3 ad,float ae,float af,float ag,float ah,float ai,vec3 aj,vec3 ak,float al,inout vec3 am,inout vec3 an,inout vec3 ao){float ap=0.0;uint aq=0u;float ar=0.0;vec3 as=vec3(0.0);vec3 at=vec3(0.0);vec3 au=vec3(0.0);am=vec3(0.0);an=vec3(1.0);ao=vec3(0.0);vec4 av=layers_of(d,f,g,h);mat3x3 aw=mat3x3(c,l,i);vec2 ax=shadow_stretch(x,y,z,aa,ab,ac);vec4 ay=sun_axis(q,s,t,u);vec2 az=multi_scattering_span(b);mat3x3 ba=mat3x3((e*n),(e*p),(e*r));float bb=((ai-ah)/float(v));float bc=u_to_distance(ae,ah);ap=bc;bool bd=true;while(true){if(!bd){uint be=aq;aq=(be+1u);}bd=false;uint bf=aq;if((bf<v)){}else{break;}{uint bg=aq;float bh=(ah+(bb*float(bg)));float bi=u_to_distance(ae,(bh+bb));float bj=ap;float bk=(bi-bj);float bl=u_to_distance(ae,(bh+(0.5*bb)));float bm=altitude_after(af,ag,(bl-ae),j);vec3 bn=densities(av,bm);vec3 bo=extinction(aw,bn);vec3 bp=(bo*bk);vec3 bq=an;vec3 br=mean_transmittance(bp);vec3 bs=(bq*br);float bt=ap;vec3 bu=dark_part(ax,bt,bi);if((bu.z<bk)){ar=bl;if((bu.z>0.0)){float bv=ap;float bw=lit_middle(bu,ae,bv,bi);ar=bw;}float bx=ar;float by=(bx-ae);float bz=max((af+(by*((2.0*ag)+by))),0.0);float ca=altitude_of(bz,j);vec3 cb=densities(av,ca);float cc=ar;float cd=(x+(y*cc));vec3 ce=optical_path_to_top(a,j,k,bz,ca,cd);vec3 cf=extinction(aw,ce);as=(((aj*cb.x)+(ak*cb.y))*exp(-(cf)));vec3 cg=as;float ch=ar;vec3 ci=sun_visibility(ad,(w+ch));as=(cg*ci);vec3 cj=am;vec3 ck=as;am=(cj+((bs*ck)*(bk-bu.z)));}if(MULTI_SCATTERING){float cl=(j+bm);float cm=clamp((((ag+bl)-ae)/cl),-1.0,1.0);float cn=clamp(((x+(y*bl))/cl),-1.0,1.0);float co=altitude_to_v(m,o,bm,k);float cp=mu_sun_to_u(ay,cn);vec2 cq=(vec2(cp,co)*az);multi_scattering_source(b,cq,c,ba,cm,cn,y,at,au);vec3 cr=at;vec3 cs=au;vec3 ct=sun_visibility_around(ad,(w+bl));vec3 cu=(((cr*ct)*bn.x)+((cs*ct)*bn.y));vec3 cv=am;am=(cv+((bs*(bk*al))*cu));}vec3 cw=an;an=(cw*exp(-(bp)));vec3 cx=ao;ao=(cx+(bn*bk));ap=bi;}}}\n",
    "vec2 gauss8_(int a){switch(a){case 0:{return vec2(0.01985507,0.050614268);}case 1:{return vec2(0.10166676,0.11119052);}case 2:{return vec2(0.23723379,0.15685332);}case 3:{return vec2(0.40828267,0.18134189);}case 4:{return vec2(0.5917173,0.18134189);}case 5:{return vec2(0.7627662,0.15685332);}case 6:{return vec2(0.89833325,0.11119052);}default:{return vec2(0.9801449,0.050614268);}}}\n",
    "void grid_point(uint a,inout vec3 b,inout float c,inout float d,inout float e){uint f=min((max((a%772u),1u)-1u),(772u-3u));uint g=((a/772u)+(f&1u));float h=((6.2831855*float(((f/2u)%SEGMENTS)))/384.0);float i=h0.arc_rate;float j=(i*float(g));float k=h0.arc_scale;float l=((k*0.5)*(exp(j)-exp(-(j))));vec3 m=h0.grid_x;vec3 n=h0.grid_y;vec3 o=normalize(((m*cos(h))+(n*sin(h))));float p=((2.0*l)/(1.0+(l*l)));float q=(((2.0*l)*l)/(1.0+(l*l)));float r=h0.arc_rate;float s=h0.arc_scale;float t=h0.arc_scale;float u=(((2.0*r)*sqrt(((s*t)+(l*l))))/(1.0+(l*l)));b=o;c=p;d=q;e=max(u,(p*0.016362462));}\n",
    "vec3 ground_albedo(float a,float b){vec3 c=vec3(0.0);float d=g0.amplitude;float e=smoothstep(0.05,0.6,(a/d));vec3 f=g0.low_albedo;vec3 g=g0.high_albedo;c=mix(f,g,e);vec3 h=g0.high_albedo;vec3 i=c;c=mix(h,i,smoothstep(0.8,0.95,b));vec3 j=c;float k=g0.snow_line;float l=g0.snow_line;c=mix(j,vec3(0.8),smoothstep(k,(l*1.15),a));vec3 m=c;float n=g0.sea;return mix(m,vec3(0.02,0.04,0.06),(n*(1.0-smoothstep(0.0,0.004,a))));}\n",
    "vec3 ground_irradiance(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec4 k=sun_axis(b,c,d,e);float l=mu_sun_to_u(k,f);vec2 m=vec2((l*float((j.x-1))),0.0);corner(m,ivec2(j.x,1),g,h,i);ivec2 n=g;ivec2 o=h;vec2 p=i;vec4 q=bilinear(a,n,o,p,ivec2(0,(j.y-1)));return exp2(q.xyz);}\n",
    "vec3 ground_light(vec3 a,float b,float c,vec3 d,float e,float f,vec3 g,float h,float i,float j,vec3 k,vec3 l){vec3 m=vec3(0.0);vec3 n=h0.frame.sun;float o=h0.frame.sun_chord;float p=dot(k,n);float q=excess_of(j,h);float r=((h+j)*p);float s=(sqrt(q)/(h+j));float t=smoothstep(-1.0,1.0,((p+s)/o));if(SKY_LIGHT){}else{vec3 u=h0.sky_light;m=((u*clamp(((p+0.1)/1.1),0.0,1.0))*(0.5+(0.5*dot(l,k))));}if((t>0.0)){mat3x3 v=coefficients_of(a,d,g);vec4 w=layers_of(b,c,e,f);vec3 x=sun_transmittance(v,w,h,i,q,r,8u);vec3 y=m;m=(y+(x*(t*max(dot(l,n),0.0))));}vec3 z=m;return z;}\n",
    "vec3 ground_radiance(vec3 a,vec3 b,float c,float d,vec3 e,float f,float g,vec3 h,float i,float j,float k){vec3 l=vec3(0.0);float m=clamp((k/c),-1.0,1.0);vec3 n=ground_irradiance(g2,f,g,i,j,m);l=n;if((m>0.0)){mat3x3 o=mat3x3(a,e,b);vec3 p=optical_path_to_top(g1,c,d,0.0,0.0,k);vec3 q=l;vec3 r=extinction(o,p);l=(q+(m*exp(-(r))));}vec3 s=l;return((s*h)*0.31830987);}\n",
    "vec2 half_angle(float a,float b,float c){float d=(c-a);float e=((d+b)*((c+a)-b));float f=((b-d)*((a+b)+c));return sqrt(max(vec2(e,f),vec2(0.0)));}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=(c+d);if((abs(a)<e)){return((a*a)-b);}return(c*(e+d));}\n",
    "float harmonic(int a,float b,float c){switch(a){case 0:{return SH0_;}case 1:{return(SH1_*b);}case 2:{return(SH1_*c);}case 3:{return(SH20_*(((3.0*b)*b)-1.0));}case 4:{return((SH21_*b)*c);}default:{return(SH22_*((((2.0*c)*c)+(b*b))-1.0));}}}\n",
    "vec4 height_field(vec3 a,float b,float c,float d,float e){vec4 f=vec4(0.0);vec4 g=vec4(0.0);float h=0.0;float i=0.55;int j=0;vec4 k=noise(((a*2.3)+vec3(11.0)));f=((k*vec4(vec3(2.3),1.0))*0.6);vec4 l=f;vec4 m=noise(((a*5.1)+vec3(5.0)));f=(l+((m*vec4(vec3(5.1),1.0))*0.3));vec4 n=f;vec4 o=noise(((a*13.7)+vec3(3.0)));f=(n+((o*vec4(vec3(13.7),1.0))*0.1));float p=mix(0.25,0.48,d);float q=f.w;float r=((q-p)*14.0);if((r<=0.0)){return vec4(0.0);}float s=min(r,1.0);vec4 t=f;vec3 u=((r<1.0)?(t.xyz*14.0):vec3(0.0));vec4 v=noise(((a*9.0)+vec3(29.0)));vec4 w=(v*vec4(vec3(9.0),1.0));float x=clamp(((w.w-0.38)*4.0),0.0,1.0);float y=(0.1+(((0.9*x)*x)*(3.0-(2.0*x))));vec3 z=(w.xyz*(((5.4*x)*(1.0-x))*4.0));h=c;bool aa=true;while(true){if(!aa){int ab=j;j=(ab+1);}aa=false;int ac=j;if((ac<6)){}else{break;}{float ad=h;float ae=clamp(((0.3/(ad*e))-0.5),0.0,1.0);if((ae>0.0)){float af=h;int ag=j;vec4 ah=noise(((a*af)+vec3((float(ag)*17.0))));float ai=h;vec4 aj=(ah*vec4(vec3(ai),1.0));float ak=((aj.w<0.5)?2.0:-2.0);vec4 al=g;float am=i;g=(al+(vec4((aj.xyz*ak),(1.0-abs(((2.0*aj.w)-1.0))))*(am*ae)));}float an=g.w;float ao=i;g.w=(an+((0.6*ao)*(1.0-ae)));float ap=h;h=(ap*2.03);float aq=i;i=(aq*0.45);}}float ar=g.w;float as=((s*y)*ar);float at=g.w;float au=g.w;vec4 av=g;vec3 aw=((((u*y)*at)+((s*z)*au))+((s*y)*av.xyz));return(vec4(aw,as)*b);}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=(vec3(1.0)-abs(c));vec3 e=((d*d)+((2.0*abs(c))*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)))));return((INV_4PI*(vec3(1.0)-(c*c)))/(e*sqrt(e)));}\n",
    "bool hits_planet(vec3 a,float b,float c){bool d=false;line_past(a,b,c,d);bool e=d;return e;}\n",
    "bool hits_planet(vec3 a,float b,float c){float d=0.0;float e=0.0;bool f=false;line_past(a,b,c,d,e,f);bool g=f;return g;}\n",
    "void inner_ray(vec3 a,float b,float c,float d,vec3 e,bool f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout bool r){bool s=false;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=(c+b);float aa=excess_of(b,c);float ab=(z*a.z);float ac=(z*sqrt(dot(a.xy,a.xy)));float ad=half_chord2_(ab,aa,(c-ac),ac);sun_side_inside(a,e,z,aa,c,t,u,v,w,x,y);float ae=t;float af=u;float ag=v;float ah=w;float ai=x;float aj=y;float ak=excess_of(d,c);float al=distance_to_top(aa,ab,ak);float am=distance_to_ground(aa,ab,sqrt(max(ad,0.0)));if(f){s=(ab<0.0);}else{s=false;}bool an=s;float ao=(an?am:al);g=0.0;h=ao;i=aa;j=ab;k=-(ad);l=ae;m=af;n=ag;o=ah;p=ai;q=aj;r=f;}\n",
    "float lattice(ivec3 a){uint b=0u;b=(((uint(a.x)*2376512323u)^(uint(a.y)*3625334849u))^(uint(a.z)*3407524639u));uint c=b;uint d=b;b=((c^(d>>13u))*1540483477u);uint e=b;uint f=b;b=((e^(f>>15u))*739982445u);uint g=b;uint h=b;b=(g^(h>>14u));uint i=b;return(float((i>>8u))*5.9604645e-8);}\n",
    "vec4 layers_of(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "vec3 limb_darkening(float a,float b){vec3 c=limb_exponents();vec3 d=((0.5*c)+vec3(1.0));float e=clamp((a-b),0.0,1.0);float f=clamp((a+b),0.0,1.0);float g=((f-e)*(f+e));if((g<0.02)){float h=(0.5*(e+f));return(d*pow(vec3(((1.0-h)*(1.0+h))),(d-vec3(1.0))));}vec3 i=pow(vec3(((1.0-e)*(1.0+e))),d);vec3 j=pow(vec3(max(((1.0-f)*(1.0+f)),0.0)),d);return((i-j)/vec3(g));}\n",
    "vec3 limb_exponents(){return vec3(0.397,0.503,0.652);}\n",
    "void line_past(vec3 a,float b,float c,inout bool d){bool e=false;float f=(c+b);float g=(f*a.z);float h=(f*sqrt(dot(a.xy,a.xy)));float i=excess_of(b,c);float j=half_chord2_(g,i,(c-h),h);if((g<0.0)){e=(j>=0.0);}else{e=false;}bool k=e;d=k;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout bool f){bool g=false;float h=(c+b);float i=(h*a.z);float j=(h*sqrt(dot(a.xy,a.xy)));float k=excess_of(b,c);float l=half_chord2_(i,k,(c-j),j);if((i<0.0)){g=(l>=0.0);}else{g=false;}bool m=g;d=i;e=-(l);f=m;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){bool h=false;float i=(c+b);float j=(i*a.z);float k=(i*sqrt(dot(a.xy,a.xy)));float l=excess_of(b,c);float m=half_chord2_(j,l,(c-k),k);if((j<0.0)){h=(m>=0.0);}else{h=false;}bool n=h;d=j;e=k;f=-(m);g=n;}\n",
    "float lit_fraction_at(highp sampler2D a,ivec2 b){if(LIT_FRACTION){vec4 c=texelFetch(a,b,0);return clamp(c.x,0.0,1.0);}else{return 1.0;}}\n",
    "float lit_middle(vec3 a,float b,float c,float d){bool e=((a.x-c)>(d-a.y));float f=(e?c:a.y);float g=(e?a.x:d);float h=distance_to_u(b,f);float i=distance_to_u(b,g);float j=u_to_distance(b,(0.5*(h+i)));return j;}\n",
    "float lommel_seeliger(vec3 a,vec3 b,vec3 c,float d,float e){float f=max(-(dot(a,b)),0.0001);float g=max(dot(a,c),0.0);return(d*(((2.0*g)/(g+f))+e));}\n",
    "void main(){uint a=uint(gl_VertexID);float b=h0.rectangle.x;float c=h0.rectangle.z;float d=(((a&1u)!=0u)?c:b);float e=h0.rectangle.y;float f=h0.rectangle.w;float g=(((a&2u)!=0u)?f:e);gl_Position=vec4(d,g,0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){uint a=uint(gl_VertexID);vec2 b=vec2(float(((a<<1u)&2u)),float((a&2u)));gl_Position=vec4(((b*2.0)-vec2(1.0)),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){uint a=uint(gl_VertexID);vec3 b=vec3(0.0);float c=0.0;float d=0.0;vec3 e=vec3(0.0);float f=0.0;float g=0.0;vec3 h=vec3(0.0);float i=0.0;float j=0.0;vec4 k=vec4(0.0);vec3 l=vec3(0.0);vec3 m=vec3(0.0);vec3 n=vec3(0.0);vec3 o=vec3(0.0);float p=0.0;float q=0.0;float r=0.0;vec3 s=h0.frame.medium.rayleigh;float t=h0.frame.medium.rayleigh_inv_height;float u=h0.frame.medium.mie_inv_height;vec3 v=h0.frame.medium.mie_extinction;float w=h0.frame.medium.ozone_center;float x=h0.frame.medium.ozone_inv_half_width;vec3 y=h0.frame.medium.ozone;float z=h0.frame.medium.radius;float aa=h0.frame.medium.thickness;vec3 ab=h0.frame.sun;float ac=h0.frame.camera_altitude;b=s;c=t;d=u;e=v;f=w;g=x;h=y;i=z;j=aa;if(SKY_LIGHT){vec3 ad=h0.luts.mie_extinction;e=ad;}vec3 ae=vec3(0.0,0.0,1.0);grid_point(a,o,p,q,r);vec3 af=o;float ag=p;float ah=q;float ai=r;vec3 aj=((af*ag)+(ae*(1.0-ah)));vec3 ak=h0.planet_x;vec3 al=h0.planet_y;vec3 am=h0.planet_z;vec3 an=vec3(dot(ak,aj),dot(al,aj),dot(am,aj));float ao=h0.amplitude;float ap=h0.mountain_rate;float aq=h0.sea;vec4 ar=height_field(an,ao,ap,aq,ai);float as=ar.w;float at=i;float au=(at+as);vec3 av=((af*(au*ag))+(ae*((as-ac)-(au*ah))));vec3 aw=h0.planet_x;vec3 ax=h0.planet_y;vec3 ay=h0.planet_z;vec3 az=(((aw*ar.x)+(ax*ar.y))+(ay*ar.z));float ba=i;vec3 bb=normalize((aj-((az-(aj*dot(az,aj)))/vec3(ba))));vec4 bc=clip_position(av);k=bc;l=av;vec3 bd=b;float be=c;float bf=d;vec3 bg=e;float bh=f;float bi=g;vec3 bj=h;float bk=i;float bl=j;vec3 bm=ground_light(bd,be,bf,bg,bh,bi,bj,bk,bl,as,aj,bb);m=bm;n=vec3(as,dot(bb,aj),dot(aj,ab));vec4 bn=k;vec3 bo=l;vec3 bp=m;vec3 bq=n;gl_Position=bn;v0=bo;v1=bp;v2=bq;gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;bool b=false;float c=0.0;float d=0.0;bool e=false;vec3 f=g0.frame.medium.rayleigh;float g=g0.frame.medium.rayleigh_inv_height;float h=g0.frame.medium.mie_inv_height;vec3 i=g0.frame.medium.mie_extinction;float j=g0.frame.medium.ozone_center;float k=g0.frame.medium.ozone_inv_half_width;vec3 l=g0.frame.medium.ozone;float m=g0.frame.medium.radius;vec3 n=g0.frame.medium.irradiance;float o=g0.frame.medium.thickness;vec3 p=g0.frame.ray_forward;float q=g0.frame.altitude;vec3 r=g0.frame.ray_right;vec3 s=g0.frame.ray_up;vec3 t=g0.frame.sun;vec2 u=g0.frame.size;float v=g0.frame.pixel_angle;vec3 w=pixel_ray(a.xy,u,p,r,s);vec3 x=normalize(w);line_past(x,q,m,c,d,e);float y=c;float z=d;bool aa=e;vec3 ab=g0.moon_direction;vec3 ac=(x-ab);float ad=g0.moon_chord;float ae=disk_coverage(ac,ad,v);if(!(aa)){b=(ae<=0.0);}else{b=true;}bool af=b;if(af){discard;}if(BODY){o0=vec4(0.0,0.0,0.0,ae);return;}else{float ag=g0.moon_sine;vec3 ah=moon_normal(x,ac,ag);float ai=g0.albedo_over_pi;float aj=g0.earthshine;float ak=lommel_seeliger(ah,x,t,ai,aj);vec4 al=disk_color((n*(ae*ak)),y,z,aa,q,f,g,h,i,j,k,l,m,o);o0=al;return;}}\n",
    "void main(){vec4 a=gl_FragCoord;bool b=false;vec3 c=vec3(0.0);float d=0.0;float e=0.0;bool f=false;vec3 g=g0.frame.medium.rayleigh;float h=g0.frame.medium.rayleigh_inv_height;float i=g0.frame.medium.mie_inv_height;vec3 j=g0.frame.medium.mie_extinction;float k=g0.frame.medium.ozone_center;float l=g0.frame.medium.ozone_inv_half_width;vec3 m=g0.frame.medium.ozone;float n=g0.frame.medium.radius;vec3 o=g0.frame.medium.irradiance;float p=g0.frame.medium.thickness;vec3 q=g0.frame.ray_forward;float r=g0.frame.altitude;vec3 s=g0.frame.ray_right;vec3 t=g0.frame.ray_up;vec3 u=g0.frame.sun;float v=g0.frame.sun_chord;vec2 w=g0.frame.size;float x=g0.frame.sun_disk;float y=g0.frame.pixel_angle;vec3 z=pixel_ray(a.xy,w,q,s,t);vec3 aa=normalize(z);line_past(aa,r,n,d,e,f);float ab=d;float ac=e;bool ad=f;float ae=disk_coverage((aa-u),v,y);if(!(ad)){b=(ae<=0.0);}else{b=true;}bool af=b;if(af){discard;}c=(o*(x*ae));if(LIMB_DARKENING){vec3 ag=c;vec3 ah=limb_darkening((length((aa-u))/v),((0.5*y)/v));c=(ag*ah);}if(MOON){vec3 ai=g0.moon_direction;float aj=g0.moon_chord;float ak=disk_coverage((aa-ai),aj,y);float al=(1.0-ak);vec3 am=c;float an=g0.sun_visibility;float ao=resolved(v,y);c=(am*mix(an,al,ao));}vec3 ap=c;vec4 aq=disk_color(ap,ab,ac,ad,r,g,h,i,j,k,l,m,n,p);o0=aq;return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;bool c=false;float d=0.0;float e=0.0;float f=0.0;bool g=false;float h=g0.frame.medium.radius;vec3 i=g0.frame.ray_forward;float j=g0.frame.altitude;vec3 k=g0.frame.ray_right;vec3 l=g0.frame.ray_up;vec2 m=g0.frame.size;float n=g0.frame.depth.scale;float o=g0.frame.depth.bias;float p=g0.frame.depth.log_;float q=g0.frame.depth.background;vec3 r=pixel_ray(a.xy,m,i,k,l);float s=length(r);line_past((r/vec3(s)),j,h,d,e,f,g);float t=d;float u=e;float v=f;bool w=g;float x=g0.bottom;float y=g0.middle;float z=g0.top;vec3 aa=vec3(x,y,z);float ab=altitude_of(v,h);float ac=(abs(t)/sqrt(((h+j)+u)));if(BEFORE){if((t<0.0)){vec4 ad=texelFetch(g1,ivec2(a.xy),0);float ae=ad.x;float af=depth_distance(n,o,p,q,ae,s);float ag=rise_to_distance(ac,u);float ah=g0.middle;float ai=rise_to_distance(sqrt(max((ah-ab),0.0)),u);float aj=(ag-ai);if(!((af<0.0))){c=(af>aj);}else{c=true;}bool ak=c;if(ak){float al=tent_column(0.0,ac,ab,u,aa);b=al;}}}else{if(!(w)){float am=tent_column(((t>0.0)?ac:0.0),1000000000.0,ab,u,aa);b=am;}}vec3 an=g0.zenith;float ao=b;float ap=g0.top;float aq=g0.middle;o0=vec4((an*(ao/(ap-aq))),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec3 p=g0.frame.medium.rayleigh;float q=g0.frame.medium.rayleigh_inv_height;vec3 r=g0.frame.medium.mie_scattering;float s=g0.frame.medium.mie_inv_height;vec3 t=g0.frame.medium.mie_extinction;float u=g0.frame.medium.ozone_center;vec3 v=g0.frame.medium.mie_asymmetry;float w=g0.frame.medium.ozone_inv_half_width;vec3 x=g0.frame.medium.ozone;float y=g0.frame.medium.radius;vec3 z=g0.frame.medium.irradiance;float aa=g0.frame.medium.thickness;vec3 ab=g0.frame.ray_forward;float ac=g0.frame.altitude;vec3 ad=g0.frame.ray_right;float ae=g0.frame.sky_weight;vec3 af=g0.frame.ray_up;vec3 ag=g0.frame.sun;vec2 ah=g0.frame.size;uint ai=g0.frame.view_samples;uint aj=g0.frame.light_samples;uint ak=g0.frame.flags;vec3 al=pixel_ray(a.xy,ah,ab,ad,af);vec3 am=normalize(al);bool an=hits_planet(am,ac,y);if(an){if(((ak&REDUCED)==0u)){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}air_ray(am,ac,y,aa,ag,b,c,d,e,f,g,h,i,j,k,l,m);float ao=b;float ap=c;float aq=d;float ar=e;float as=f;float at=g;float au=h;float av=i;float aw=j;float ax=k;float ay=l;bool az=m;if((ap<=0.0)){o0=vec4(0.0);return;}vec3 ba=g0.luts.mie_extinction;float bb=g0.luts.altitude_steepness;vec3 bc=g0.luts.mie_moment0_;float bd=g0.luts.altitude_growth;vec3 be=g0.luts.mie_moment1_;float bf=g0.luts.sun_middle;vec3 bg=g0.luts.mie_moment2_;float bh=g0.luts.sun_width;float bi=g0.luts.sun_first;float bj=g0.luts.sun_span;uint bk=g0.luts.steps;eclipsed_light(g2,g3,p,q,r,s,t,u,v,w,x,y,aa,ba,bb,bc,bd,be,bf,bg,bh,bi,bj,bk,ao,ap,aq,ar,as,at,au,av,aw,ax,ay,az,am,ag,ap,ai,aj,n,o);vec3 bl=n;vec3 bm=o;vec4 bn=veil(((bl*ae)*z),bm);o0=bn;return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec3 p=g0.medium.rayleigh;float q=g0.medium.rayleigh_inv_height;vec3 r=g0.medium.mie_scattering;float s=g0.medium.mie_inv_height;vec3 t=g0.medium.mie_extinction;float u=g0.medium.ozone_center;vec3 v=g0.medium.mie_asymmetry;float w=g0.medium.ozone_inv_half_width;vec3 x=g0.medium.ozone;float y=g0.medium.radius;vec3 z=g0.medium.irradiance;float aa=g0.medium.thickness;vec2 ab=g0.size;vec3 ac=g0.ray_forward;vec3 ad=g0.ray_right;vec3 ae=g0.ray_up;vec3 af=pixel_ray(a.xy,ab,ac,ad,ae);vec3 ag=normalize(af);float ah=g0.altitude;bool ai=hits_planet(ag,ah,y);if(ai){uint aj=g0.flags;if(((aj&REDUCED)==0u)){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}float ak=g0.altitude;vec3 al=g0.sun;air_ray(ag,ak,y,aa,al,b,c,d,e,f,g,h,i,j,k,l,m);float am=b;float an=c;float ao=d;float ap=e;float aq=f;float ar=g;float as=h;float at=i;float au=j;float av=k;float aw=l;bool ax=m;if((an<=0.0)){o0=vec4(0.0);return;}vec3 ay=g0.sun;vec3 az=(ag-ay);uint ba=g0.view_samples;uint bb=g0.light_samples;single_scattering(p,q,r,s,t,u,v,w,x,y,aa,am,an,ao,ap,aq,ar,as,at,au,av,aw,ax,ag,an,(0.5*dot(az,az)),ba,bb,n,o);vec3 bc=n;vec3 bd=o;float be=g0.sky_weight;vec4 bf=veil(((bc*be)*z),bd);o0=bf;return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=g0.medium.radius;float c=g0.medium.thickness;ivec2 d=ivec2(a.xy);int e=(ivec2(uvec2(textureSize(g1,0).xy)).y/ZENITHS);bool f=(d.y==(e*MOMENTS));ivec2 g=ivec2(d.x,(f?0:(d.y/MOMENTS)));float h=g0.luts.altitude_steepness;float i=g0.luts.altitude_growth;float j=v_to_altitude(h,i,(float(g.y)/float((e-1))),c);vec3 k=vec3(7.888609e-31);if(f){vec3 l=moment(g,j,b,MOMENTS);o0=vec4(log2(max(l,k)),0.0);return;}vec3 m=moment(g,j,b,0);vec3 n=max(m,k);int o=(d.y%MOMENTS);if((o==0)){o0=vec4(log2(n),0.0);return;}vec3 p=moment(g,j,b,o);o0=vec4((p/n),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=g0.medium.rayleigh_inv_height;float c=g0.medium.mie_inv_height;float d=g0.medium.ozone_center;float e=g0.medium.ozone_inv_half_width;float f=g0.medium.radius;float g=g0.medium.thickness;uvec2 h=g0.luts.size;vec3 i=transmittance_texel_ray(floor(a.xy),vec2(h),f,g);vec4 j=layers_of(b,c,d,e);uint k=g0.luts.steps;vec3 l=path_densities(j,f,i.x,i.y,i.z,k);o0=vec4(max(log2(max(l,vec3(1e-37))),vec3(-100.0)),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;int b=0;int c=0;int d=0;int e=0;int f=0;int g=0;uvec2 h=g0.luts.size;uint i=g0.luts.shift;uint j=g0.luts.slices;aerial_texel(a.xy,h,j,b,c,d,e,f,g);int k=b;int l=c;int m=d;int n=e;int o=f;int p=g;vec4 q=aerial_load(g1,l,m,o,p,k,n);if(FINISH){if((k>=AIR_BEAM)){o0=q;return;}vec4 r=aerial_load(g1,l,m,o,p,k,(int(j)-1));vec3 s=r.xyz;float t=(float((n+1))/float(j));o0=vec4(mix(vec3(t),(q.xyz/max(s,vec3(1e-37))),greaterThan(s,vec3(1e-30))),q.w);return;}else{int u=(n-int(i));if((u<0)){o0=q;return;}vec4 v=aerial_load(g1,l,m,o,p,k,u);vec3 w=v.xyz;if((k>=AIR_BEAM)){o0=vec4((w*q.xyz),q.w);return;}vec4 x=aerial_load(g1,l,m,o,p,AIR_BEAM,u);o0=vec4((w+(x.xyz*q.xyz)),q.w);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;ivec2 b=ivec2(0);b=ivec2(a.xy);int c=b.y;int d=b.y;uint e=g0.flipped;b.y=((e!=0u)?((int(uvec2(textureSize(g1,0).xy).y)-1)-d):c);ivec2 f=b;vec4 g=texelFetch(g1,f,0);float h=g0.exposure;vec3 i=(g.xyz*h);vec3 j=tone_curve(max(i,vec3(0.0)));vec3 k=srgb_encode(j);if(DITHER){ivec2 l=b;vec3 m=dither(uvec2(l));o0=vec4((k+(m/vec3(255.0))),1.0);return;}else{o0=vec4(k,1.0);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=v0;vec3 c=v1;vec3 d=v2;vec3 e=vec3(0.0);vec3 f=vec3(0.0);vec3 g=g0.frame.medium.irradiance;vec3 h=g0.frame.sun;float i=g0.frame.depth.scale;float j=g0.frame.depth.bias;float k=g0.frame.depth.log_;e=c;if(MOON){vec3 l=e;vec3 m=g0.moon_shadow.across;float n=g0.moon_shadow.along;float o=g0.moon_shadow.radius;float p=g0.moon_shadow.tan_sun_radius;float q=g0.moon_shadow.min_visibility;vec3 r=moon_shadow_visibility(g1,m,n,o,p,q,b,h);e=(l*r);}if(SKY_LIGHT){float s=g0.luts.sun_middle;float t=g0.luts.sun_width;float u=g0.luts.sun_first;float v=g0.luts.sun_span;vec3 w=ground_irradiance(g2,s,t,u,v,d.z);f=w;vec3 x=f;f=(x*(0.5+(0.5*d.y)));if(MOON){vec3 y=f;vec3 z=g0.moon_shadow.across;float aa=g0.moon_shadow.min_visibility;float ab=g0.moon_shadow.inv_extent;vec3 ac=moon_shadow_visibility_around(g1,z,aa,ab,b,h);f=(y*ac);}vec3 ad=e;vec3 ae=f;e=(ad+ae);}vec3 af=ground_albedo(d.x,d.y);vec3 ag=e;vec3 ah=(((af*ag)*g)*0.31830987);vec3 ai=g0.axis;float aj=depth_of(i,j,k,max(dot(b,ai),1e-9));o0=vec4(min(ah,vec3(32000.0)),1.0);gl_FragDepth=clamp(aj,0.0,1.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;float d=0.0;bool e=false;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;bool q=false;float r=0.0;float s=0.0;float t=0.0;vec3 u=vec3(0.0);vec3 v=vec3(0.0);vec3 w=g0.medium.rayleigh;float x=g0.medium.rayleigh_inv_height;vec3 y=g0.medium.mie_scattering;float z=g0.medium.mie_inv_height;float aa=g0.medium.ozone_center;float ab=g0.medium.ozone_inv_half_width;vec3 ac=g0.medium.ozone;float ad=g0.medium.radius;float ae=g0.medium.thickness;vec3 af=g0.luts.mie_extinction;float ag=g0.luts.altitude_steepness;vec3 ah=g0.luts.mie_moment0_;float ai=g0.luts.altitude_growth;vec3 aj=g0.luts.mie_moment1_;float ak=g0.luts.sun_middle;vec3 al=g0.luts.mie_moment2_;float am=g0.luts.sun_width;vec3 an=g0.luts.mie_asymmetry;vec3 ao=g0.luts.albedo;float ap=g0.luts.sun_first;float aq=g0.luts.sun_span;uint ar=g0.luts.steps;ivec2 as=ivec2(a.xy);ivec2 at=ivec2((as.x/AZIMUTHS),(as.y/ZENITHS));vec2 au=multi_scattering_span(g2);vec2 av=(vec2(at)/au);float aw=u_to_mu_sun(ak,am,ap,aq,av.x);float ax=v_to_altitude(ag,ai,av.y,ae);vec3 ay=vec3(sqrt(max(((1.0-aw)*(1.0+aw)),0.0)),0.0,aw);node_direction((as.y%ZENITHS),(as.x%AZIMUTHS),ax,ad,c,d,e);float az=c;float ba=d;bool bb=e;float bc=sqrt(max(((1.0-az)*(1.0+az)),0.0));vec3 bd=vec3((bc*cos(ba)),(bc*sin(ba)),az);inner_ray(bd,ax,ad,ae,ay,!(bb),f,g,h,i,j,k,l,m,n,o,p,q);float be=f;float bf=g;float bg=h;float bh=i;float bi=j;float bj=k;float bk=l;float bl=m;float bm=n;float bn=o;float bo=p;bool bp=q;float bq=rayleigh_phase(bk);vec3 br=(w*bq);vec3 bs=henyey_greenstein_phase((1.0-bk),(1.0+bk),an);vec3 bt=((y*ah)*bs);perigee_of(bf,bg,bh,bi,bp,bf,ad,r,s,t);float bu=r;float bv=s;float bw=t;float bx=distance_to_u(bu,0.0);float by=distance_to_u(bu,bf);gather(g1,g2,w,x,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,am,ap,aq,ar,be,bj,bk,bl,bm,bn,bo,bd,bu,bv,bw,bx,by,br,bt,1.0,u,v);vec3 bz=u;vec3 ca=v;b=bz;if(bp){vec3 cb=b;vec3 cc=ground_radiance(w,ac,ad,ae,af,ak,am,ao,ap,aq,(bj+(bk*bf)));b=(cb+(ca*cc));}vec3 cd=b;o0=vec4(cd,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;float d=0.0;float e=0.0;bool f=false;vec3 g=g0.frame.medium.mie_asymmetry;float h=g0.frame.medium.radius;vec3 i=g0.frame.medium.irradiance;float j=g0.frame.medium.thickness;vec3 k=g0.frame.ray_forward;float l=g0.frame.altitude;vec3 m=g0.frame.ray_right;float n=g0.frame.sky_weight;vec3 o=g0.frame.ray_up;vec3 p=g0.frame.sun;vec2 q=g0.frame.size;uint r=g0.frame.flags;vec4 s=g0.frame.sky_view_mapping;vec3 t=pixel_ray(a.xy,q,k,m,o);vec3 u=normalize(t);line_past(u,l,h,c,d,e,f);float v=c;float w=d;float x=e;bool y=f;if(y){if(BLEND){if(((r&REDUCED)==0u)){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}else{o0=vec4(0.0,0.0,0.0,1.0);return;}}vec2 z=vec2(uvec2(textureSize(g1,0).xy));float aa=zenith_to_v(v,w,x,y,u.z,l,h,j,s);float ab=g0.luts.ground_rows;float ac=v_to_row(aa,false,z.y,ab);float ad=azimuth_to_u(u);vec2 ae=sky_view_uv(ad,ac,z);vec4 af=textureLod(g1,vec2(ae),0.0);vec3 ag=decode_light(af.xyz);b=ag;if(MIE_SINGLE){vec3 ah=b;vec4 ai=textureLod(g2,vec2(ae),0.0);vec3 aj=decode_light(ai.xyz);vec3 ak=mie_phase_between(u,p,g);b=(ah+(aj*ak));}vec3 al=b;b=min(((al*n)*i),vec3(32000.0));if(BLEND){vec3 am=b;o0=vec4(am,(1.0-af.w));return;}else{vec3 an=b;o0=vec4(an,1.0);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);int d=0;int e=0;int f=0;int g=0;int h=0;int i=0;vec3 j=vec3(0.0);float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;bool v=false;float w=0.0;float x=0.0;float y=0.0;vec3 z=vec3(0.0);vec3 aa=vec3(0.0);vec3 ab=vec3(0.0);vec3 ac=g0.frame.medium.rayleigh;float ad=g0.frame.medium.rayleigh_inv_height;vec3 ae=g0.frame.medium.mie_scattering;float af=g0.frame.medium.mie_inv_height;vec3 ag=g0.frame.medium.mie_extinction;float ah=g0.frame.medium.ozone_center;float ai=g0.frame.medium.ozone_inv_half_width;vec3 aj=g0.frame.medium.ozone;float ak=g0.frame.medium.radius;float al=g0.frame.medium.thickness;float am=g0.frame.altitude;vec3 an=g0.frame.sun;vec4 ao=g0.frame.sky_view_mapping;vec3 ap=g0.luts.mie_extinction;float aq=g0.luts.altitude_steepness;vec3 ar=g0.luts.mie_moment0_;float as=g0.luts.altitude_growth;vec3 at=g0.luts.mie_moment1_;float au=g0.luts.sun_middle;vec3 av=g0.luts.mie_moment2_;float aw=g0.luts.sun_width;float ax=g0.luts.sun_first;float ay=g0.luts.sun_span;float az=g0.luts.ground_rows;uvec2 ba=g0.luts.size;uint bb=g0.luts.steps;uint bc=g0.luts.slices;aerial_texel(a.xy,ba,bc,d,e,f,g,h,i);int bd=d;int be=e;int bf=f;int bg=g;int bh=h;int bi=i;float bj=(float(bf)/float((bi-1)));vec2 bk=row_to_v(be,bh,int(az));sky_view_ray(bj,bk.x,(bk.y>0.5),am,ak,al,ao,an,j,k,l,m,n,o,p,q,r,s,t,u,v);vec3 bl=j;float bm=k;float bn=l;float bo=m;float bp=n;float bq=o;float br=p;float bs=q;float bt=r;float bu=s;float bv=t;float bw=u;bool bx=v;if((bn<=0.0)){o0=vec4(vec3(((bd>=AIR_BEAM)?1.0:0.0)),(float((bg+1))/float(bc)));return;}perigee_of(bn,bo,bp,bq,bx,bn,ak,w,x,y);float by=w;float bz=x;float ca=y;float cb=distance_to_u(by,0.0);float cc=distance_to_u(by,bn);float cd=((cc-cb)/float(bc));float ce=(cb+(cd*float(bg)));float cf=u_to_distance(by,(ce+cd));float cg=(cf/bn);if((bd==AIR_SMOOTH)){float ch=rayleigh_phase(bs);b=(ac*ch);}else{c=ae;}float ci=((bd==AIR_SMOOTH)?1.0:0.0);vec3 cj=b;vec3 ck=c;gather(g1,g2,ac,ad,ae,af,ah,ai,aj,ak,al,ap,aq,ar,as,at,au,av,aw,ax,ay,bb,bm,br,bs,bt,bu,bv,bw,bl,by,bz,ca,ce,(ce+cd),cj,ck,ci,z,aa,ab);vec3 cl=z;vec3 cm=aa;vec3 cn=ab;switch(bd){case 2:{o0=vec4(cm,cg);return;}case 3:{mat3x3 co=coefficients_of(ac,ag,aj);vec3 cp=extinction(co,cn);o0=vec4(exp(-(cp)),cg);return;}default:{o0=vec4(max(cl,vec3(0.0)),cg);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);vec3 d=vec3(0.0);float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;bool p=false;float q=0.0;float r=0.0;float s=0.0;vec3 t=vec3(0.0);vec3 u=vec3(0.0);vec3 v=vec3(0.0);vec3 w=g0.frame.medium.rayleigh;float x=g0.frame.medium.rayleigh_inv_height;vec3 y=g0.frame.medium.mie_scattering;float z=g0.frame.medium.mie_inv_height;vec3 aa=g0.frame.medium.mie_extinction;float ab=g0.frame.medium.ozone_center;float ac=g0.frame.medium.ozone_inv_half_width;vec3 ad=g0.frame.medium.ozone;float ae=g0.frame.medium.radius;float af=g0.frame.medium.thickness;float ag=g0.frame.altitude;vec3 ah=g0.frame.sun;vec4 ai=g0.frame.sky_view_mapping;vec3 aj=g0.luts.mie_extinction;float ak=g0.luts.altitude_steepness;vec3 al=g0.luts.mie_moment0_;float am=g0.luts.altitude_growth;vec3 an=g0.luts.mie_moment1_;float ao=g0.luts.sun_middle;vec3 ap=g0.luts.mie_moment2_;float aq=g0.luts.sun_width;float ar=g0.luts.sun_first;float as=g0.luts.sun_span;float at=g0.luts.ground_rows;uvec2 au=g0.luts.size;uint av=g0.luts.steps;ivec2 aw=ivec2(a.xy);ivec2 ax=ivec2(au);float ay=(float(aw.x)/float((ax.x-1)));vec2 az=row_to_v(aw.y,ax.y,int(at));bool ba=(az.y>0.5);sky_view_ray(ay,az.x,ba,ag,ae,af,ai,ah,d,e,f,g,h,i,j,k,l,m,n,o,p);vec3 bb=d;float bc=e;float bd=f;float be=g;float bf=h;float bg=i;float bh=j;float bi=k;float bj=l;float bk=m;float bl=n;float bm=o;bool bn=p;if((bd<=0.0)){o0=vec4(0.0,0.0,0.0,1.0);return;}perigee_of(bd,be,bf,bg,bn,bd,ae,q,r,s);float bo=q;float bp=r;float bq=s;float br=distance_to_u(bo,0.0);float bs=distance_to_u(bo,bd);if(MIE_SINGLE){c=y;}else{float bt=rayleigh_phase(bi);b=(w*bt);}vec3 bu=b;vec3 bv=c;gather(g1,g2,w,x,y,z,ab,ac,ad,ae,af,aj,ak,al,am,an,ao,ap,aq,ar,as,av,bc,bh,bi,bj,bk,bl,bm,bb,bo,bp,bq,br,bs,bu,bv,1.0,t,u,v);vec3 bw=t;vec3 bx=v;mat3x3 by=coefficients_of(w,aa,ad);vec3 bz=extinction(by,bx);float ca=dot(exp(-(bz)),vec3(0.33333334));float cb=(ba?(1.0/bd):1.0);vec3 cc=encode_light((max(bw,vec3(0.0))*cb));o0=vec4(cc,ca);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=texelFetch(g1,ivec2(a.xy),0);o0=b;return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);bool c=false;bool d=false;vec3 e=vec3(0.0);vec3 f=vec3(0.0);bool g=false;float h=0.0;float i=0.0;float j=0.0;bool k=false;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;bool r=false;vec3 s=vec3(0.0);vec3 t=vec3(0.0);vec2 u=vec2(0.0);vec2 v=vec2(0.0);float w=0.0;vec3 x=g0.frame.medium.rayleigh;float y=g0.frame.medium.rayleigh_inv_height;float z=g0.frame.medium.mie_inv_height;vec3 aa=g0.frame.medium.mie_extinction;vec3 ab=g0.frame.medium.mie_asymmetry;vec3 ac=g0.frame.medium.ozone;float ad=g0.frame.medium.radius;vec3 ae=g0.frame.medium.irradiance;float af=g0.frame.medium.thickness;vec3 ag=g0.frame.ray_forward;float ah=g0.frame.altitude;vec3 ai=g0.frame.ray_right;vec3 aj=g0.frame.ray_up;float ak=g0.frame.shell_weight;vec3 al=g0.frame.sun;vec2 am=g0.frame.size;float an=g0.frame.pixel_angle;float ao=g0.frame.depth.scale;float ap=g0.frame.depth.bias;float aq=g0.frame.depth.log_;float ar=g0.frame.depth.background;uint as=g0.frame.flags;vec4 at=g0.frame.sky_view_mapping;float au=g0.luts.ground_rows;uint av=g0.luts.slices;float aw=g0.luts.aerial_ground_rows;ivec2 ax=ivec2(a.xy);if(BLEND){}else{vec4 ay=texelFetch(g1,ax,0);b=ay;}vec3 az=pixel_ray(a.xy,am,ag,ai,aj);float ba=length(az);vec4 bb=texelFetch(g2,ax,0);float bc=depth_distance(ao,ap,aq,ar,bb.x,ba);vec3 bd=(az/vec3(ba));line_past(bd,ah,ad,h,i,j,k);float be=h;float bf=i;float bg=j;bool bh=k;air_path(be,bg,bh,ah,ad,af,l,m,n,o);float bi=l;float bj=m;float bk=n;float bl=o;if(bh){c=(bj>=0.0);}else{c=false;}bool bm=c;ray_end(bi,bj,bl,bm,bc,ad,an,ak,as,p,q,r);float bn=p;float bo=q;bool bp=r;if(!((bn<=0.0))){d=(bo<=0.0);}else{d=true;}bool bq=d;if(bq){vec4 br=b;o0=br;return;}float bs=azimuth_to_u(bd);float bt=zenith_to_v(be,bf,bg,bh,bd.z,ah,ad,af,at);vec2 bu=vec2(uvec2(textureSize(g3,0).xy));float bv=v_to_row(bt,bm,bu.y,au);vec2 bw=sky_view_uv(bs,bv,bu);vec3 bx=mie_phase_between(bd,al,ab);path_light(g3,g6,bw,bm,bj,bx,s,t);vec3 by=s;vec3 bz=t;e=vec3(1.0);f=(by+bz);if(!(bm)){g=(bn>=bj);}else{g=false;}bool ca=g;if(ca){if(bp){vec3 cb=whole_transmittance(g5,x,aa,ac,ad,af,bk,bl);e=cb;}}else{aerial_column(g4,av,aw,bs,bt,bm,u,v,w);vec2 cc=u;vec2 cd=v;float ce=w;air_before(g4,y,z,ad,bj,bk,bl,cc,cd,ce,bn,by,bz,e,f);}vec3 cf=f;float cg=lit_fraction_at(g7,ax);vec3 ch=((cf*ae)*(bo*cg));vec4 ci=b;vec3 cj=e;vec4 ck=compose(ci,cj,ch);o0=ck;return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);bool c=false;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;bool o=false;float p=0.0;float q=0.0;bool r=false;vec3 s=vec3(0.0);vec3 t=vec3(0.0);vec3 u=g0.frame.medium.rayleigh;float v=g0.frame.medium.rayleigh_inv_height;vec3 w=g0.frame.medium.mie_scattering;float x=g0.frame.medium.mie_inv_height;vec3 y=g0.frame.medium.mie_extinction;float z=g0.frame.medium.ozone_center;vec3 aa=g0.frame.medium.mie_asymmetry;float ab=g0.frame.medium.ozone_inv_half_width;vec3 ac=g0.frame.medium.ozone;float ad=g0.frame.medium.radius;vec3 ae=g0.frame.medium.irradiance;float af=g0.frame.medium.thickness;vec3 ag=g0.frame.ray_forward;float ah=g0.frame.altitude;vec3 ai=g0.frame.ray_right;vec3 aj=g0.frame.ray_up;float ak=g0.frame.shell_weight;vec3 al=g0.frame.sun;vec2 am=g0.frame.size;float an=g0.frame.pixel_angle;float ao=g0.frame.depth.scale;float ap=g0.frame.depth.bias;float aq=g0.frame.depth.log_;float ar=g0.frame.depth.background;uint as=g0.frame.view_samples;uint at=g0.frame.light_samples;uint au=g0.frame.flags;ivec2 av=ivec2(a.xy);if(BLEND){}else{vec4 aw=texelFetch(g1,av,0);b=aw;}vec3 ax=pixel_ray(a.xy,am,ag,ai,aj);float ay=length(ax);vec4 az=texelFetch(g2,av,0);float ba=depth_distance(ao,ap,aq,ar,az.x,ay);vec3 bb=(ax/vec3(ay));air_ray(bb,ah,ad,af,al,d,e,f,g,h,i,j,k,l,m,n,o);float bc=d;float bd=e;float be=f;float bf=g;float bg=h;float bh=i;float bi=j;float bj=k;float bk=l;float bl=m;float bm=n;bool bn=o;ray_end(bc,bd,bf,bn,ba,ad,an,ak,au,p,q,r);float bo=p;float bp=q;bool bq=r;if(!((bo<=0.0))){c=(bp<=0.0);}else{c=true;}bool br=c;if(br){vec4 bs=b;o0=bs;return;}vec3 bt=g0.luts.mie_extinction;float bu=g0.luts.altitude_steepness;vec3 bv=g0.luts.mie_moment0_;float bw=g0.luts.altitude_growth;vec3 bx=g0.luts.mie_moment1_;float by=g0.luts.sun_middle;vec3 bz=g0.luts.mie_moment2_;float ca=g0.luts.sun_width;float cb=g0.luts.sun_first;float cc=g0.luts.sun_span;uint cd=g0.luts.steps;eclipsed_light(g4,g5,u,v,w,x,y,z,aa,ab,ac,ad,af,bt,bu,bv,bw,bx,by,bz,ca,cb,cc,cd,bc,bd,be,bf,bg,bh,bi,bj,bk,bl,bm,bn,bb,al,bo,as,at,s,t);vec3 ce=s;vec3 cf=t;vec3 cg=(bq?cf:vec3(1.0));float ch=lit_fraction_at(g6,av);vec3 ci=((ce*ae)*(bp*ch));vec4 cj=b;vec4 ck=compose(cj,cg,ci);o0=ck;return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);bool c=false;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;bool o=false;float p=0.0;float q=0.0;bool r=false;vec3 s=vec3(0.0);vec3 t=vec3(0.0);vec3 u=g0.medium.rayleigh;float v=g0.medium.rayleigh_inv_height;vec3 w=g0.medium.mie_scattering;float x=g0.medium.mie_inv_height;vec3 y=g0.medium.mie_extinction;float z=g0.medium.ozone_center;vec3 aa=g0.medium.mie_asymmetry;float ab=g0.medium.ozone_inv_half_width;vec3 ac=g0.medium.ozone;float ad=g0.medium.radius;vec3 ae=g0.medium.irradiance;float af=g0.medium.thickness;ivec2 ag=ivec2(a.xy);if(BLEND){}else{vec4 ah=texelFetch(g1,ag,0);b=ah;}vec2 ai=g0.size;vec3 aj=g0.ray_forward;vec3 ak=g0.ray_right;vec3 al=g0.ray_up;vec3 am=pixel_ray(a.xy,ai,aj,ak,al);float an=length(am);float ao=g0.depth.scale;float ap=g0.depth.bias;float aq=g0.depth.log_;float ar=g0.depth.background;vec4 as=texelFetch(g2,ag,0);float at=depth_distance(ao,ap,aq,ar,as.x,an);vec3 au=(am/vec3(an));float av=g0.altitude;vec3 aw=g0.sun;air_ray(au,av,ad,af,aw,d,e,f,g,h,i,j,k,l,m,n,o);float ax=d;float ay=e;float az=f;float ba=g;float bb=h;float bc=i;float bd=j;float be=k;float bf=l;float bg=m;float bh=n;bool bi=o;float bj=g0.pixel_angle;float bk=g0.shell_weight;uint bl=g0.flags;ray_end(ax,ay,ba,bi,at,ad,bj,bk,bl,p,q,r);float bm=p;float bn=q;bool bo=r;if(!((bm<=0.0))){c=(bn<=0.0);}else{c=true;}bool bp=c;if(bp){vec4 bq=b;o0=bq;return;}vec3 br=g0.sun;vec3 bs=(au-br);uint bt=g0.view_samples;uint bu=g0.light_samples;single_scattering(u,v,w,x,y,z,aa,ab,ac,ad,af,ax,ay,az,ba,bb,bc,bd,be,bf,bg,bh,bi,au,bm,(0.5*dot(bs,bs)),bt,bu,s,t);vec3 bv=s;vec3 bw=t;vec3 bx=(bo?bw:vec3(1.0));float by=lit_fraction_at(g3,ag);vec3 bz=((bv*ae)*(bn*by));vec4 ca=b;vec4 cb=compose(ca,bx,bz);o0=cb;return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;int d=-1;int e=0;vec2 f=g0.size;vec3 g=g0.ray_forward;vec3 h=g0.ray_right;vec3 i=g0.ray_up;vec3 j=pixel_ray(a.xy,f,g,h,i);vec3 k=normalize(j);float l=g0.altitude;float m=g0.medium.radius;bool n=hits_planet(k,l,m);if(n){discard;}ivec2 o=ivec2(uvec2(textureSize(g1,0).xy));vec2 p=g0.size;vec2 q=(((a.xy/p)*vec2(o))-vec2(0.5));ivec2 r=ivec2(floor(q));vec2 s=(q-floor(q));bool t=true;while(true){if(!t){int u=d;d=(u+1);}t=false;int v=d;if((v<=2)){}else{break;}{e=-1;bool w=true;while(true){if(!w){int x=e;e=(x+1);}w=false;int y=e;if((y<=2)){}else{break;}{int z=e;int aa=d;vec4 ab=texelFetch(g1,min(max((r+ivec2(z,aa)),ivec2(0)),(o-ivec2(1))),0);int ac=e;int ad=d;vec2 ae=max((vec2(1.0)-abs((vec2(float(ac),float(ad))-s))),vec2(0.0001));if((ab.w>=0.0)){vec4 af=b;b=(af+((ab*ae.x)*ae.y));float ag=c;c=(ag+(ae.x*ae.y));}}}}}vec4 ah=b;float ai=c;o0=(ah/vec4(max(ai,1e-12)));return;}\n",
    "vec3 mean_transmittance(vec3 a){vec3 b=(vec3(1.0)-(a*(vec3(0.5)-(a*0.16666667))));return mix(((vec3(1.0)-exp(-(a)))/a),b,lessThan(a,vec3(0.01)));}\n",
    "vec3 mie_phase(float a,float b,vec3 c){if(CORNETTE_SHANKS){vec3 d=cornette_shanks_phase(a,b,c);return d;}else{vec3 e=henyey_greenstein_phase(a,b,c);return e;}}\n",
    "vec3 mie_phase_between(vec3 a,vec3 b,vec3 c){vec3 d=(a-b);vec3 e=(a+b);vec3 f=mie_phase((0.5*dot(d,d)),(0.5*dot(e,e)),c);return f;}\n",
    "vec3 moment(ivec2 a,float b,float c,int d){vec3 e=vec3(0.0);int f=0;int g=0;float h=0.0;float i=0.0;float j=0.0;bool k=true;while(true){if(!k){int l=f;f=(l+1);}k=false;int m=f;if((m<ZENITHS)){}else{break;}{g=0;bool n=true;while(true){if(!n){int o=g;g=(o+1);}n=false;int p=g;if((p<AZIMUTHS)){}else{break;}{int q=f;int r=g;node_direction(q,r,b,c,h,i,j);float s=h;float t=i;float u=j;float v=(sqrt(max(((1.0-s)*(1.0+s)),0.0))*cos(t));float w=harmonic(d,s,v);float x=((d==MOMENTS)?max(s,0.0):w);int y=g;int z=f;ivec2 aa=((a*ivec2(8,16))+ivec2(y,z));vec3 ab=e;vec4 ac=texelFetch(g1,aa,0);e=(ab+(ac.xyz*(x*u)));}}}}vec3 ad=e;return ad;}\n",
    "vec2 moon_before_sun(float a,float b,float c,float d){float e=(1.0/(max(b,(0.001*c))*d));return((b>0.0)?(vec2(c,a)*e):vec2(0.0,1000.0));}\n",
    "float moon_distance_to_u(float a,float b){float c=abs((a-1.0));if((b<c)){return((0.25*b)/c);}return(0.25+(0.75*sqrt(((b-c)/(2.0*min(a,1.0))))));}\n",
    "vec3 moon_normal(vec3 a,vec3 b,float c){float d=dot(b,b);float e=((1.0-(0.5*d))-sqrt(max(((c*c)-(d*(1.0-(0.25*d)))),0.0)));return normalize((b+((e-1.0)*a)));}\n",
    "vec3 moon_shadow_lut_row(highp sampler2D a,float b,int c){int d=(int(uvec2(textureSize(a,0).xy).x)-1);float e=(clamp(b,0.0,1.0)*float(d));int f=min(int(e),d);vec4 g=texelFetch(a,ivec2(f,c),0);vec4 h=texelFetch(a,ivec2(min((f+1),d),c),0);return mix(g.xyz,h.xyz,(e-float(f)));}\n",
    "vec3 moon_shadow_visibility(highp sampler2D a,vec3 b,float c,float d,float e,float f,vec3 g,vec3 h){vec3 i=vec3(0.0);bool j=false;float k=dot(g,h);float l=length((b-(g-(h*k))));vec2 m=moon_before_sun(l,(c-k),d,e);float n=visible_fraction(m.x,m.y);i=vec3(n);float o=i.x;if((o>0.0)){float p=i.x;j=(p<1.0);}else{j=false;}bool q=j;if(q){vec3 r=i;float s=moon_distance_to_u(m.x,m.y);vec3 t=moon_shadow_lut_row(a,s,1);i=(r*t);}vec3 u=i;return max(u,vec3(f));}\n",
    "vec3 moon_shadow_visibility_around(highp sampler2D a,vec3 b,float c,float d,vec3 e,vec3 f){float g=length((b-(e-(f*dot(e,f)))));vec3 h=moon_shadow_lut_row(a,(g*d),0);return max(h,vec3(c));}\n",
    "float mu_sun_to_u(vec4 a,float b){float c=((b-a.x)/a.y);return(((sign(c)*log((abs(c)+sqrt(((c*c)+1.0)))))-a.z)/a.w);}\n",
    "void multi_scattering_source(highp sampler2D a,vec2 b,vec3 c,mat3x3 d,float e,float f,float g,inout vec3 h,inout vec3 i){ivec2 j=ivec2(0);ivec2 k=ivec2(0);vec2 l=vec2(0.0);h=vec3(0.0);i=vec3(0.0);ivec2 m=ivec2(uvec2(textureSize(a,0).xy));corner(b,ivec2(m.x,((m.y-1)/MOMENTS)),j,k,l);int n=j.y;j.y=(n*MOMENTS);int o=k.y;k.y=(o*MOMENTS);ivec2 p=j;ivec2 q=k;vec2 r=l;vec4 s=bilinear(a,p,q,r,ivec2(0));vec3 t=exp2(s.xyz);float u=sqrt(max(((1.0-f)*(1.0+f)),1e-12));float v=sqrt(max(((1.0-e)*(1.0+e)),0.0));float w=clamp(((g-(e*f))/u),-(v),v);ivec2 x=j;ivec2 y=k;vec2 z=l;vec4 aa=bilinear(a,x,y,z,ivec2(0,3));float ab=harmonic(3,e,w);ivec2 ac=j;ivec2 ad=k;vec2 ae=l;vec4 af=bilinear(a,ac,ad,ae,ivec2(0,4));float ag=harmonic(4,e,w);ivec2 ah=j;ivec2 ai=k;vec2 aj=l;vec4 ak=bilinear(a,ah,ai,aj,ivec2(0,5));float al=harmonic(5,e,w);vec3 am=(((aa.xyz*ab)+(af.xyz*ag))+(ak.xyz*al));if(RAYLEIGH){h=((c*(vec3(0.2820948)+(0.1*am)))*t);}if(MIE){ivec2 an=j;ivec2 ao=k;vec2 ap=l;vec4 aq=bilinear(a,an,ao,ap,ivec2(0,1));float ar=harmonic(1,e,w);ivec2 as=j;ivec2 at=k;vec2 au=l;vec4 av=bilinear(a,as,at,au,ivec2(0,2));float aw=harmonic(2,e,w);vec3 ax=((aq.xyz*ar)+(av.xyz*aw));i=((((SH0_*d[0])+(ax*d[1]))+(am*d[2]))*t);}}\n",
    "vec2 multi_scattering_span(highp sampler2D a){ivec2 b=ivec2(uvec2(textureSize(a,0).xy));return(vec2(float(b.x),float(((b.y-1)/MOMENTS)))-vec2(1.0));}\n",
    "vec3 neutral(vec3 a){float b=min(a.x,min(a.y,a.z));vec3 c=(a-vec3(((b<0.08)?(b-((6.25*b)*b)):0.04)));float d=max(c.x,max(c.y,c.z));if((d<0.76)){return c;}float e=(1.0-0.76);float f=(1.0-((e*e)/((d+e)-0.76)));float g=(1.0-(1.0/((0.15*(d-f))+1.0)));return mix((c*(f/d)),vec3(f),g);}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout bool g){bool h=(a<8);vec2 i=gauss8_((h?a:(a-8)));float j=excess_of(c,d);float k=(-(sqrt(j))/(d+c));float l=(h?(1.0-k):(-1.0-k));float m=clamp((k+((l*i.x)*i.x)),-1.0,1.0);e=m;f=((float(b)+0.5)*0.3926991);g=h;}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout float g){bool h=(a<8);vec2 i=gauss8_((h?a:(a-8)));float j=excess_of(c,d);float k=(-(sqrt(j))/(d+c));float l=(h?(1.0-k):(-1.0-k));float m=clamp((k+((l*i.x)*i.x)),-1.0,1.0);e=m;f=((float(b)+0.5)*0.3926991);g=(((((abs(l)*2.0)*i.x)*i.y)*2.0)*0.3926991);}\n",
    "vec4 noise(vec3 a){vec3 b=floor(a);ivec3 c=ivec3(b);vec3 d=(a-b);vec3 e=(((d*d)*d)*((d*((d*6.0)-vec3(15.0)))+vec3(10.0)));vec3 f=(((30.0*d)*d)*((d*(d-vec3(2.0)))+vec3(1.0)));float g=lattice(c);float h=lattice((c+ivec3(1,0,0)));float i=lattice((c+ivec3(0,1,0)));float j=lattice((c+ivec3(1,1,0)));float k=lattice((c+ivec3(0,0,1)));float l=lattice((c+ivec3(1,0,1)));float m=lattice((c+ivec3(0,1,1)));float n=lattice((c+ivec3(1,1,1)));float o=mix(g,h,e.x);float p=mix(i,j,e.x);float q=mix(k,l,e.x);float r=mix(m,n,e.x);float s=mix(o,p,e.y);float t=mix(q,r,e.y);float u=mix(mix((h-g),(j-i),e.y),mix((l-k),(n-m),e.y),e.z);float v=mix((p-o),(r-q),e.z);return vec4((vec3(u,v,(t-s))*f),mix(s,t,e.z));}\n",
    "vec3 optical_path_to_top(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=transmittance_uv(d,e,f,b,c);vec2 l=(k*vec2((j-ivec2(1))));corner(l,j,g,h,i);ivec2 m=g;ivec2 n=h;vec2 o=i;vec4 p=bilinear(a,m,n,o,ivec2(0));return exp2(p.xyz);}\n",
    "vec3 path_densities(vec4 a,float b,float c,float d,float e,uint f){vec3 g=vec3(0.0);float h=0.0;uint i=0u;float j=clamp(-(d),0.0,e);float k=-(sqrt(j));float l=((sqrt((e-j))-k)/float(f));bool m=true;while(true){if(!m){uint n=i;i=(n+1u);}m=false;uint o=i;if((o<f)){}else{break;}{uint p=i;float q=(k+(l*float(p)));float r=u_to_distance(j,(q+(0.5*l)));float s=u_to_distance(j,(q+l));float t=altitude_after(c,d,r,b);vec3 u=g;vec3 v=densities(a,t);float w=h;g=(u+(v*(s-w)));h=s;}}vec3 x=g;return x;}\n",
    "void path_light(highp sampler2D a,highp sampler2D b,vec2 c,bool d,float e,vec3 f,inout vec3 g,inout vec3 h){vec3 i=vec3(0.0);float j=(d?e:1.0);vec4 k=textureLod(a,vec2(c),0.0);vec3 l=decode_light(k.xyz);vec3 m=(l*j);if(MIE_SINGLE){vec4 n=textureLod(b,vec2(c),0.0);vec3 o=decode_light(n.xyz);i=((o*j)*f);}vec3 p=i;g=m;h=p;}\n",
    "void perigee_of(float a,float b,float c,float d,bool e,float f,float g,inout float h,inout float i,inout float j){bool k=false;if((c>=0.0)){h=0.0;i=b;j=c;return;}if((-(c)<=f)){h=-(c);i=d;j=0.0;return;}float l=(c+f);if(e){k=(f>=a);}else{k=false;}bool m=k;if(m){h=f;i=0.0;j=l;return;}bool n=((-(c)*f)>(g*g));float o=(b+(f*((2.0*c)+f)));h=f;i=(n?(d+(l*l)):o);j=l;}\n",
    "vec3 pixel_ray(vec2 a,vec2 b,vec3 c,vec3 d,vec3 e){vec2 f=(((a/b)*vec2(2.0,-2.0))+vec2(-1.0,1.0));return((c+(d*f.x))+(e*f.y));}\n",
    "float quarter_atan(float a,float b){float c=(min(b,a)/max(max(b,a),1e-30));float d=(c*c);float e=(1.0+(d*(-0.33333147+(d*(0.19993551+(d*(-0.142089+(d*(0.10656264+(d*(-0.07528964+(d*(0.042909615+(d*(-0.016165737+(d*0.0028662258))))))))))))))));return((a>b)?(1.5707964-(c*e)):(c*e));}\n",
    "void ray_end(float a,float b,float c,bool d,float e,float f,float g,float h,uint i,inout float j,inout float k,inout bool l){if((e>=0.0)){float m=scene_reach(a,b,c,d,e,f,g);j=m;k=1.0;l=true;return;}if(d){j=b;k=1.0;l=true;return;}j=b;k=h;l=((i&SHELL_DIMS)!=0u);}\n",
    "float rayleigh_phase(float a){return(0.0596831*(1.0+(a*a)));}\n",
    "float resolved(float a,float b){return smoothstep(1.0,4.0,(a/b));}\n",
    "float rise_to_distance(float a,float b){return(a*sqrt(((a*a)+(2.0*b))));}\n",
    "vec2 row_to_v(int a,int b,int c){bool d=(a<c);int e=(d?0:c);int f=(d?c:(b-c));return vec2((float((a-e))/float((f-1))),(d?1.0:0.0));}\n",
    "float scene_reach(float a,float b,float c,bool d,float e,float f,float g){float h=min(b,(e-a));if(!(d)){return h;}float i=max((abs((c+b))/f),0.05);float j=(((SUBPIXEL*g)*e)/i);float k=smoothstep((0.5*j),j,(b-h));return((b*(1.0-k))+(h*k));}\n",
    "float segment(vec2 a){float b=quarter_atan(a.x,a.y);float c=(2.0*b);if((c<0.5)){float d=((4.0*c)*c);float e=(1.0-((d*0.05)*(1.0-((d*0.023809524)*(1.0-(d*0.013888889))))));return(((c*d)*0.16666667)*e);}float f=dot(a,a);return(c-((((2.0*a.x)*a.y)*((a.y*a.y)-(a.x*a.x)))/(f*f)));}\n",
    "float shadow_half2_(float a,float b,float c,float d,float e,float f){float g=max(sqrt(a),1e-18);float h=((e*abs(d))/g);float i=half_chord2_((b/g),c,(f-h),h);return i;}\n",
    "vec2 shadow_stretch(float a,float b,float c,float d,float e,float f){vec2 g=vec2(0.0);vec2 h=vec2(1.0,0.0);g=vec2(-(1e30),1e30);if((c>1e-30)){if((f<=0.0)){return h;}float i=-((d+(((d>=0.0)?1.0:-1.0)*sqrt((c*f)))));float j=(i/c);float k=((i!=0.0)?(e/i):j);g=vec2(min(j,k),max(j,k));}else{if((e>=0.0)){return h;}}if((abs(b)<1e-12)){if((a>=0.0)){return h;}}else{float l=(-(a)/b);if((b>0.0)){float m=g.y;g.y=min(m,l);}else{float n=g.x;g.x=max(n,l);}}vec2 o=g;return o;}\n",
    "void single_scattering(vec3 a,float b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,float k,float l,float m,float n,float o,float p,float q,float r,float s,float t,float u,float v,bool w,vec3 x,float y,float z,uint aa,uint ab,inout vec3 ac,inout vec3 ad){vec3 ae=vec3(0.0);vec3 af=vec3(0.0);vec2 ag=vec2(0.0);float ah=0.0;uint ai=0u;float aj=0.0;vec3 ak=vec3(0.0);float al=0.0;float am=0.0;float an=0.0;ac=vec3(0.0);ad=vec3(1.0);if(SUNLIGHT){vec2 ao=shadow_stretch(q,r,s,t,u,v);ag=ao;if(RAYLEIGH){float ap=rayleigh_phase((1.0-z));ae=(a*ap);}if(MIE){float aq=((z>1.0)?(s/max(z,1.0)):(2.0-z));vec3 ar=mie_phase(z,aq,g);af=(c*ar);}}vec4 as=layers_of(b,d,f,h);mat3x3 at=coefficients_of(a,e,i);perigee_of(m,n,o,p,w,y,j,al,am,an);float au=al;float av=am;float aw=an;float ax=-(sqrt(au));float ay=((sqrt((y-au))-ax)/float(aa));bool az=true;while(true){if(!az){uint ba=ai;ai=(ba+1u);}az=false;uint bb=ai;if((bb<aa)){}else{break;}{uint bc=ai;float bd=(ax+(ay*float(bc)));float be=u_to_distance(au,(bd+ay));float bf=u_to_distance(au,(bd+(0.5*ay)));float bg=altitude_after(av,aw,(bf-au),j);float bh=ah;float bi=(be-bh);vec3 bj=densities(as,bg);vec3 bk=extinction(at,bj);vec3 bl=(bk*bi);if(SUNLIGHT){vec2 bm=ag;float bn=ah;vec3 bo=dark_part(bm,bn,be);if((bo.z<bi)){aj=bf;if((bo.z>0.0)){float bp=ah;float bq=lit_middle(bo,au,bp,be);aj=bq;}float br=aj;float bs=(br-au);float bt=(av+(bs*((2.0*aw)+bs)));float bu=altitude_of(bt,j);vec3 bv=densities(as,max(bu,0.0));ak=vec3(0.0);if(RAYLEIGH){vec3 bw=ak;vec3 bx=ae;ak=(bw+(bx*bv.x));}if(MIE){vec3 by=ak;vec3 bz=af;ak=(by+(bz*bv.y));}float ca=aj;float cb=(q+(r*ca));vec3 cc=ak;vec3 cd=sun_transmittance(at,as,j,k,bt,cb,ab);ak=(cc*cd);vec3 ce=ak;float cf=aj;vec3 cg=sun_visibility(x,(l+cf));ak=(ce*cg);vec3 ch=ac;vec3 ci=ad;vec3 cj=mean_transmittance(bl);vec3 ck=ak;ac=(ch+(((ci*cj)*ck)*(bi-bo.z)));}}vec3 cl=ad;ad=(cl*exp(-(bl)));ah=be;}}}\n",
    "void sky_view_ray(float a,float b,bool c,float d,float e,float f,vec4 g,vec3 h,inout vec3 i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout float t,inout bool u){bool v=false;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;float af=0.0;float ag=0.0;vec2 ah=u_to_azimuth(a);if(!(c)){v=(b>g.x);}else{v=false;}bool ai=v;if(ai){upward_ray(ah,b,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u);return;}float aj=(e+d);float ak=excess_of(d,e);float al=excess_of(f,e);bool am=(d>f);float an=(am?al:ak);if(c){float ao=((1.0-b)*(1.0+b));float ap=(SQRT_HALF*ao);z=((b*b)*(1.0+ao));float aq=z;float ar=z;w=(((-(e)*e)*aq)*ar);x=(e*((2.0*ap)*sqrt((1.0-(ap*ap)))));float as=w;y=(an-as);}else{float at=min(d,f);float au=min((b/max(g.x,1e-20)),1.0);float av=((1.0-au)*(1.0+au));float aw=(1.0-g.y);float ax=((2.0*av)/max((aw+sqrt(((aw*aw)+((4.0*g.y)*av)))),1e-20));float ay=(at*min((((au*au)*(1.0+ax))/(1.0+(g.y*ax))),1.0));float az=excess_of(ay,e);w=az;x=(e+ay);y=(((at*ax)*ax)*(((2.0*e)+at)+ay));}float ba=((d-f)*(((2.0*e)+f)+d));float bb=y;float bc=-(sqrt(max(bb,0.0)));float bd=y;float be=((am?-(sqrt(max((ba+bd),0.0))):bc)/aj);float bf=x;vec3 bg=vec3((ah*min((bf/aj),1.0)),be);if(am){ag=(ba/(-(bc)-(aj*be)));float bh=ag;sun_side_outside(bg,h,aj,bh,-(bc),al,e,aa,ab,ac,ad,ae,af);}else{sun_side_inside(bg,h,aj,ak,e,aa,ab,ac,ad,ae,af);}float bi=distance_to_top(an,bc,al);float bj=z;float bk=(c?(an/max(((e*bj)-bc),1e-20)):bi);float bl=ag;float bm=w;float bn=aa;float bo=ab;float bp=ac;float bq=ad;float br=ae;float bs=af;i=bg;j=bl;k=bk;l=an;m=bc;n=bm;o=bn;p=bo;q=bp;r=bq;s=br;t=bs;u=c;}\n",
    "vec2 sky_view_uv(float a,float b,vec2 c){return((vec2((a*(c.x-1.0)),b)+vec2(0.5))/c);}\n",
    "vec3 slice_depth(vec4 a,vec4 b){return-(log(clamp((b.xyz/max(a.xyz,vec3(1e-30))),vec3(1e-30),vec3(1.0))));}\n",
    "vec3 slice_fraction(vec3 a,float b,float c,float d,float e){vec3 f=(a*(c-b));vec3 g=(a*(d-b));vec3 h=mean_transmittance(abs(f));vec3 i=mean_transmittance(abs(g));vec3 j=(h/i);vec3 k=exp((max(-(f),vec3(0.0))-max(-(g),vec3(0.0))));return clamp(((e*j)*k),vec3(0.0),vec3(1.0));}\n",
    "vec3 slice_passed(vec4 a,vec4 b,float c,float d,float e,float f,float g,float h,float i){float j=min((f/c),1.0);float k=clamp(((j-a.w)/max((b.w-a.w),1e-9)),0.0,1.0);float l=altitude_after(d,e,(a.w*c),i);float m=altitude_after(d,e,f,i);float n=altitude_after(d,e,(b.w*c),i);vec3 o=slice_fraction(vec3(g,h,0.0),l,m,n,k);return o;}\n",
    "vec3 srgb_encode(vec3 a){vec3 b=clamp(a,vec3(0.0),vec3(1.0));vec3 c=sqrt(b);vec3 d=sqrt(c);vec3 e=((((0.642361*c)+(0.7121163*d))-(0.3368725*sqrt(d)))-(0.01756167*b));return mix(min(e,vec3(1.0)),(b*12.92),lessThanEqual(b,vec3(0.0031308)));}\n",
    "vec4 sun_axis(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;k=0.0;g=dot(a,b);float l=g;vec3 m=cross((a-(((l>=0.0)?1.0:-1.0)*b)),b);h=dot(m,m);f=(c*b.z);i=(c*((b.x*m.y)-(b.y*m.x)));float n=(c*length(b.xy));float o=f;float p=half_chord2_(o,d,(e-n),n);j=-(p);float q=h;float r=i;float s=j;float t=shadow_half2_(q,r,s,m.z,c,e);k=t;}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;m=0.0;i=dot(a,b);float n=i;float o=((n>=0.0)?1.0:-1.0);vec3 p=(a-(o*b));vec3 q=cross(p,b);j=dot(q,q);vec3 r=(vec3((-(a.z)*a.xy),dot(a.xy,a.xy))*c);float s=(-(o)*dot(r,p));float t=(c*b.z);float u=i;float v=i;bool w=((abs(t)+(d*abs(u)))<(abs(s)+(e*abs(v))));float x=i;float y=i;h=(w?(t+(d*y)):(s-(e*x)));vec3 z=cross(r,b);float aa=j;k=(dot(z,q)-(e*aa));float ab=length((z-(e*q)));float ac=h;float ad=half_chord2_(ac,f,(g-ab),ab);l=-(ad);float ae=j;float af=k;float ag=l;float ah=shadow_half2_(ae,af,ag,q.z,c,g);m=ah;}\n",
    "vec3 sun_transmittance(mat3x3 a,vec4 b,float c,float d,float e,float f,uint g){float h=excess_of(d,c);float i=distance_to_top(e,f,h);vec3 j=path_densities(b,c,e,f,i,g);vec3 k=extinction(a,j);return exp(-(k));}\n",
    "vec3 sun_visibility(vec3 a,float b){return vec3(1.0);}\n",
    "vec3 sun_visibility(vec3 a,float b){vec3 c=g0.moon_shadow.across;float d=g0.moon_shadow.along;float e=g0.moon_shadow.radius;float f=g0.moon_shadow.tan_sun_radius;float g=g0.moon_shadow.min_visibility;vec3 h=g0.frame.sun;vec3 i=moon_shadow_visibility(g1,c,d,e,f,g,(a*b),h);return i;}\n",
    "vec3 sun_visibility(vec3 a,float b){vec3 c=g0.moon_shadow.across;float d=g0.moon_shadow.along;float e=g0.moon_shadow.radius;float f=g0.moon_shadow.tan_sun_radius;float g=g0.moon_shadow.min_visibility;vec3 h=g0.frame.sun;vec3 i=moon_shadow_visibility(g3,c,d,e,f,g,(a*b),h);return i;}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return vec3(1.0);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){vec3 c=g0.moon_shadow.across;float d=g0.moon_shadow.min_visibility;float e=g0.moon_shadow.inv_extent;vec3 f=g0.frame.sun;vec3 g=moon_shadow_visibility_around(g1,c,d,e,(a*b),f);return g;}\n",
    "vec3 sun_visibility_around(vec3 a,float b){vec3 c=g0.moon_shadow.across;float d=g0.moon_shadow.min_visibility;float e=g0.moon_shadow.inv_extent;vec3 f=g0.frame.sun;vec3 g=moon_shadow_visibility_around(g3,c,d,e,(a*b),f);return g;}\n",
    "float tent_column(float a,float b,float c,float d,vec3 e){float f=(1.0/(e.z-e.y));vec3 g=clamp(sqrt(max((e-vec3(c)),vec3(0.0))),vec3(a),vec3(max(b,a)));float h=tent_part(g.x,g.y,c,d,e.y,f);float i=tent_part(g.y,g.z,c,d,e.y,f);return(h+i);}\n",
    "float tent_part(float a,float b,float c,float d,float e,float f){vec4 g=(vec4(a)+((b-a)*NODES));vec4 h=((2.0*(vec4(d)+(g*g)))/sqrt((vec4((2.0*d))+(g*g))));vec4 i=max((vec4(1.0)-(abs(((vec4(c)+(g*g))-vec4(e)))*f)),vec4(0.0));return((b-a)*dot(WEIGHTS,(h*i)));}\n",
    "vec3 tone_curve(vec3 a){if(ACES){vec3 b=aces(a);return b;}if(AGX){vec3 c=agx(a);return c;}vec3 d=neutral(a);return d;}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=(a*a);float g=excess_of(e,d);float h=((c-e)*(((2.0*d)+e)+c));return((f<g)?(f-h):(g-b));}\n",
    "vec3 transmittance_texel_ray(vec2 a,vec2 b,float c,float d){vec2 e=(a/(b-vec2(1.0)));float f=excess_of(d,c);float g=sqrt(f);float h=(e.y*g);float i=altitude_of((h*h),c);float j=min(i,d);float k=(d-j);float l=(k+(e.x*((h+g)-k)));float m=((l>0.0)?(((((g-h)*(g+h))/l)-l)*0.5):(c+j));return vec3((h*h),max(m,-(h)),l);}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max((e-b),0.0);return vec2(((i-j)/max(((g+h)-j),1e-20)),(g/h));}\n",
    "vec2 u_to_azimuth(float a){float b=(1.0-a);float c=(1.0/((a*a)+(b*b)));return(vec2(((b-a)*(b+a)),((2.0*a)*b))*c);}\n",
    "float u_to_distance(float a,float b){return(a+(b*abs(b)));}\n",
    "float u_to_mu_sun(float a,float b,float c,float d,float e){return clamp((a+(b*sinh((c+(e*d))))),-1.0,1.0);}\n",
    "void upward_ray(vec2 a,float b,float c,float d,float e,vec4 f,vec3 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout bool t){float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;bool af=false;float ag=min((f.z+(((b-f.x)/(1.0-f.x))*(1.0-f.z))),1.0);float ah=((1.0-ag)*(1.0+ag));float ai=(0.5+(0.5*f.w));float aj=(sqrt(ai)*ah);float ak=max((((((2.0*ai)*ag)*ag)*(1.0+ah))-f.w),0.0);vec3 al=vec3((a*((2.0*aj)*sqrt((1.0-(aj*aj))))),ak);inner_ray(al,c,d,e,g,false,u,v,w,x,y,z,aa,ab,ac,ad,ae,af);float am=u;float an=v;float ao=w;float ap=x;float aq=y;float ar=z;float as=aa;float at=ab;float au=ac;float av=ad;float aw=ae;bool ax=af;h=al;i=am;j=an;k=ao;l=ap;m=aq;n=ar;o=as;p=at;q=au;r=av;s=aw;t=ax;}\n",
    "float v_to_altitude(float a,float b,float c,float d){float e=((a*c)*c);float f=((e<0.05)?(e*(1.0+(e*(0.5+(e*(0.16666667+(e*0.041666668))))))):(exp(e)-1.0));return(d*min((f/b),1.0));}\n",
    "float v_to_row(float a,bool b,float c,float d){return(b?(a*(d-1.0)):(d+(a*((c-d)-1.0))));}\n",
    "vec4 veil(vec3 a,vec3 b){return vec4(min(a,vec3(32000.0)),(1.0-dot(b,vec3(0.33333334))));}\n",
    "float visible_fraction(float a,float b){if((b>=(1.0+a))){return 1.0;}if((b<=(a-1.0))){return 0.0;}if((b<=(1.0-a))){return((1.0-a)*(1.0+a));}vec2 c=half_angle(1.0,b,a);vec2 d=half_angle(a,b,1.0);float e=segment(d);float f=((a*a)*e);if((c.y<c.x)){float g=segment(c.yx);return clamp(((g-f)/PI),0.0,1.0);}float h=segment(c);return clamp((1.0-((h+f)/PI)),0.0,1.0);}\n",
    "vec3 whole_transmittance(highp sampler2D a,vec3 b,vec3 c,vec3 d,float e,float f,float g,float h){float i=altitude_of(g,e);vec3 j=optical_path_to_top(a,e,f,g,i,h);mat3x3 k=coefficients_of(b,c,d);vec3 l=extinction(k,j);return exp(-(l));}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min((sqrt(max(-(c),0.0))/g),1.0);float k=crowded((0.5*j),((b/g)/sqrt((2.0+(2.0*j)))),SQRT_HALF);return k;}if((e>=0.0)){float l=((b/(g+f))/sqrt((2.0+(2.0*e))));float m=crowded((0.5*(e+i.w)),l,sqrt((0.5+(0.5*i.w))));return(i.x+(((1.0-i.x)*max((m-i.z),0.0))/(1.0-i.z)));}float n=max(min(f,h),1e-20);float o=(max(c,0.0)/(g+b));float p=min((o/n),1.0);float q=top_half_chord2_(a,c,f,g,h);float r=((f>h)?q:(a*a));float s=sqrt(clamp((r/(n*(((2.0*g)+n)+o))),0.0,1.0));return(i.x*sqrt(((p*(1.0+(i.y*s)))/(1.0+s))));}\n",
];

/// One step of adding up the aerial LUT's slices along rays: each takes in the one `shift` nearer to the
/// camera (Hillis & Steele 1986, "Data Parallel Algorithms"). After shifts of 1, 2, 4, ... a slice holds
/// everything up to its end.
pub mod aerial_lut_scan {
    use super::*;

    /// The last step: radiance becomes a part of the whole ray's; off: a sum.
    pub const FINISH: u32 = 1 << 0;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_scan",
        uniform_size: 352,
        textures: &[TextureSlot { name: "aerial_lut", binding: 1, filtered: false }],
        constants: &["FINISH"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::PASS_AERIAL_LUT_SCAN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 32, 33, 30, 31, 38, 2, 25, 42, 20, 55, 53, 124],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// Fills the aerial LUT's slices, each on its own: what it scatters and what it lets through.
/// `aerial_lut_scan` adds them up along the rays.
pub mod aerial_lut_slices {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_slices",
        uniform_size: 352,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_AERIAL_LUT, text::LIB_PHASE, text::PASS_AERIAL_LUT_SLICES],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 5, 25, 42, 43, 20, 63, 86, 62, 81, 97, 166, 176, 177, 80, 103, 156, 167, 105, 68, 75, 87, 192, 82, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 179, 182, 89, 191, 194, 169, 163, 55, 160, 129],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// The air between the camera and the scene, marched along each ray: the scene dimmed by transmittance, per
/// channel, plus the light scattered once into the ray on the way.
pub mod aerial_march {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 5;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march",
        uniform_size: 224,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "lit_fraction", binding: 3, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_AERIAL_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 9, 21, 42, 43, 44, 20, 157, 76, 197, 164, 159, 111, 69, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 160, 100, 71, 137, 178, 179, 168, 134],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}

/// The air between the camera and the scene under a moon's shadow, as `aerial_march`: of all orders, or
/// scattered once.
pub mod aerial_march_eclipse {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 5;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 6;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 7;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march_eclipse",
        uniform_size: 384,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "moon_shadow_lut", binding: 3, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 4, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 5, filtered: false }, TextureSlot { name: "lit_fraction", binding: 6, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_AERIAL_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 32, 34, 37, 10, 44, 25, 42, 43, 45, 46, 47, 20, 157, 76, 197, 164, 159, 111, 69, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 140, 96, 158, 165, 198, 143, 141, 144, 181, 145, 184, 89, 160, 100, 71, 137, 138, 178, 168, 61, 84, 133],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4", "g5", "g6"],
        },
    };
}

/// The air between the camera and the scene from LUTs, as `aerial_march` with all orders of scattering. The
/// light of the ray's whole length is in the sky-view LUT; the aerial LUT tells which part of it comes from
/// before the scene.
pub mod aerial_perspective {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 5;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_perspective",
        uniform_size: 352,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "sky_view_lut", binding: 3, filtered: true }, TextureSlot { name: "aerial_lut", binding: 4, filtered: true }, TextureSlot { name: "transmittance_lut", binding: 5, filtered: false }, TextureSlot { name: "mie_single_lut", binding: 6, filtered: true }, TextureSlot { name: "lit_fraction", binding: 7, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "MIE_SINGLE", "CORNETTE_SHANKS"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_TRANSMITTANCE_LUT, text::LIB_LUT_AIR, text::LIB_PHASE, text::PASS_AERIAL_PERSPECTIVE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 11, 25, 42, 43, 44, 45, 46, 47, 48, 20, 157, 76, 197, 164, 159, 111, 69, 70, 66, 63, 86, 62, 81, 97, 110, 188, 80, 59, 72, 65, 200, 196, 170, 74, 68, 87, 82, 136, 51, 50, 54, 172, 173, 171, 52, 190, 153, 57, 199, 155, 100, 71, 137, 138, 132],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4", "g5", "g6", "g7"],
        },
    };
}

/// Airglow: a thin layer of air that shines by itself, alike in all directions. A ray sees the emission
/// integrated along its way. For a layer without thickness seen from the ground that is van Rhijn's factor
/// (1921), 1 / sqrt(1 - (R sin z / (R + h))^2); from orbit the limb of the layer is some fifty times as bright
/// as its zenith. Out: radiance that is added to what is there.
pub mod airglow {
    use super::*;

    /// What a ray enters before the air; off: what it leaves last, behind the air.
    pub const BEFORE: u32 = 1 << 0;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "airglow",
        uniform_size: 256,
        textures: &[TextureSlot { name: "scene_depth", binding: 1, filtered: false }],
        constants: &["BEFORE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_AIRGLOW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 39, 8, 25, 42, 20, 157, 76, 63, 86, 97, 110, 162, 186, 185, 119],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// A plain full-screen copy: what every time is measured against.
pub mod copy {
    use super::*;

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "copy",
        uniform_size: 0,
        textures: &[TextureSlot { name: "source", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::PASS_COPY],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 42, 20, 131],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// The moon's disk with its phase, dimmed by the air like the sun's. As a body, before the sky is drawn, it
/// hides what lies behind it.
pub mod moon_disk {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// There is air that dims the disk.
    pub const AIR: u32 = 1 << 3;
    /// Nothing but what it hides, in alpha; off: its light, laid over the sky.
    pub const BODY: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "moon_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "BODY"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::PASS_MOON_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 33, 30, 31, 40, 12, 26, 114],
            fragment: &[0, 27, 33, 30, 31, 40, 13, 25, 20, 157, 63, 86, 62, 81, 97, 109, 188, 80, 58, 105, 68, 75, 87, 192, 154, 79, 78, 113, 142, 117],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// Gathers the radiance of all orders in a set of directions at each node of the multi-scattering LUT: the
/// light that the last round's LUT and the sun send into them. Column: sun angle, azimuth within it. Row:
/// altitude, zenith angle within it.
pub mod multi_scattering_gather {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_gather",
        uniform_size: 224,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_PHASE, text::LIB_CONSTANTS, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_GATHER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 32, 41, 3, 25, 42, 43, 20, 63, 86, 62, 81, 97, 166, 176, 80, 103, 156, 167, 105, 75, 87, 192, 82, 136, 73, 112, 70, 66, 190, 153, 64, 195, 175, 146, 193, 148, 98, 147, 93, 179, 182, 88, 160, 100, 90, 150, 95, 127],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Fills the multi-scattering LUT: angular moments of the radiance gathered at each node; the last row is
/// the ground's irradiance.
pub mod multi_scattering_lut {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_lut",
        uniform_size: 224,
        textures: &[TextureSlot { name: "gathered", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 32, 41, 6, 25, 42, 20, 195, 98, 86, 90, 151, 139, 122],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// The background sky, marched along each ray: what a ray sees that meets no ground, scattered once. Drawn
/// first, depth ALWAYS, no depth write.
pub mod sky_march {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_SKY_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 15, 21, 20, 157, 197, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 102, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 160, 100, 71, 137, 178, 179, 168, 121],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The background sky under a moon's shadow, as `sky_march`: of all orders, or scattered once.
pub mod sky_march_eclipse {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march_eclipse",
        uniform_size: 384,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 2, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 3, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_SKY_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 32, 34, 37, 17, 42, 25, 43, 44, 20, 157, 197, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 102, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 140, 96, 158, 165, 198, 143, 141, 144, 180, 145, 183, 89, 160, 100, 71, 137, 138, 178, 168, 61, 84, 120],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}

/// The background sky from the sky-view LUT: what a ray sees that meets no ground, with all orders of
/// scattering. Drawn first, depth ALWAYS, no depth write.
pub mod sky_view {
    use super::*;

    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 0;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 1;
    /// Laid over what is in the target; off: the target holds nothing.
    pub const BLEND: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view",
        uniform_size: 352,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 2, filtered: true }],
        constants: &["CORNETTE_SHANKS", "MIE_SINGLE", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_LUTS, text::LIB_PHASE, text::PASS_SKY_VIEW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 18, 25, 42, 43, 20, 157, 86, 97, 110, 188, 72, 65, 200, 196, 170, 74, 100, 71, 137, 138, 128],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Fills the sky-view LUT, the light of every direction around the camera: light scattered by the gas, and
/// all that was scattered before; alpha: grey transmittance. With MIE_SINGLE another LUT: sunlight scattered
/// once by the aerosol, without its phase function, which changes too fast near the sun for any LUT. Per km
/// of the ray where it ends on the ground, so that its length, which jumps between texels, can be put in for
/// each pixel.
pub mod sky_view_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Sunlight scattered once by the aerosol; off: all other light.
    pub const MIE_SINGLE: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view_lut",
        uniform_size: 352,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_PHASE, text::PASS_SKY_VIEW_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 4, 25, 42, 43, 20, 63, 86, 62, 81, 97, 166, 176, 177, 80, 103, 156, 167, 105, 68, 75, 87, 192, 82, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 179, 182, 89, 191, 194, 169, 163, 85, 160, 130],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// The sun's disk. The air dims it along each ray.
pub mod sun_disk {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// There is air that dims the disk.
    pub const AIR: u32 = 1 << 3;
    /// The disk is darker towards its edge.
    pub const LIMB_DARKENING: u32 = 1 << 4;
    /// A moon hides a part of it.
    pub const MOON: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sun_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "LIMB_DARKENING", "MOON"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::LIB_LIMB_DARKENING, text::PASS_SUN_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 33, 30, 31, 40, 12, 26, 114],
            fragment: &[0, 27, 33, 30, 31, 40, 14, 25, 20, 157, 63, 86, 62, 81, 97, 109, 188, 80, 58, 105, 68, 75, 87, 192, 154, 79, 161, 78, 107, 106, 118],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The demonstration's ground: a planet-scale height field as a grid of rings around the point below the
/// camera, so that it reaches from the camera's feet to the horizon at any altitude. No vertex buffer.
/// It stands in for a user's own terrain.
pub mod terrain {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Lit by the sky, from the multi-scattering LUT; off: by an estimate.
    pub const SKY_LIGHT: u32 = 1 << 3;
    /// Under a moon's shadow.
    pub const MOON: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const RINGS: u32 = 256;
        pub const SEGMENTS: u32 = 384;
        pub const VERTICES: u32 = 197632;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "terrain",
        uniform_size: 528,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "SKY_LIGHT", "MOON"],
        vertices: Vertices::Strip(197632),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_NOISE, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::PASS_TERRAIN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 33, 30, 31, 32, 34, 35, 16, 23, 29, 63, 86, 62, 81, 105, 68, 75, 87, 192, 154, 178, 104, 152, 99, 91, 94, 67, 116],
            fragment: &[0, 27, 33, 30, 31, 32, 34, 35, 16, 22, 42, 43, 28, 77, 70, 66, 175, 146, 93, 158, 96, 165, 198, 140, 143, 141, 144, 145, 92, 126],
            blocks: ["Terrain_block_0Vertex", "Terrain_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Scene-linear radiance to a display: exposure, one of three operators, sRGB encoding, dither.
/// Rust twin for the CPU renderer: src/frame/tone_map.rs; a test holds the two together.
pub mod tone_map {
    use super::*;

    /// The curve is ACES.
    pub const ACES: u32 = 1 << 0;
    /// The curve is AgX where it is not ACES; off: Khronos PBR Neutral.
    pub const AGX: u32 = 1 << 1;
    /// With the noise of one 8-bit step.
    pub const DITHER: u32 = 1 << 2;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "tone_map",
        uniform_size: 16,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }],
        constants: &["ACES", "AGX", "DITHER"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::PASS_TONE_MAP],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 36, 1, 24, 42, 20, 49, 56, 149, 187, 174, 83, 125],
            blocks: ["", "Tone_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// Fills the transmittance LUT: the densities integrated from each altitude and direction to the top of the
/// air.
pub mod transmittance_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "transmittance_lut",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::PASS_TRANSMITTANCE_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 32, 41, 19, 25, 20, 63, 86, 62, 189, 105, 75, 192, 154, 123],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// A sky drawn at a lower resolution, brought up to the target's. The planet's edge stays sharp: it is
/// decided per target pixel, and planet texels (alpha < 0) take no part in the filter.
pub mod upsample {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "upsample",
        uniform_size: 224,
        textures: &[TextureSlot { name: "reduced_sky", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_UPSAMPLE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 115],
            fragment: &[0, 27, 33, 30, 31, 7, 21, 42, 20, 157, 86, 97, 108, 101, 135],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}
