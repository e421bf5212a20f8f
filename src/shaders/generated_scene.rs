// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&scene_air::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_AERIAL: &str = crate::shaders::wgsl!("lib/aerial");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_AERIAL_LUT: &str = crate::shaders::wgsl!("lib/aerial_lut");
    pub(super) const LIB_COLUMNS: &str = crate::shaders::wgsl!("lib/columns");
    pub(super) const LIB_LUT_AIR: &str = crate::shaders::wgsl!("lib/lut_air");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const LIB_SCENE_AIR: &str = crate::shaders::wgsl!("lib/scene_air");
    pub(super) const PASS_SCENE_SCENE_AIR: &str = crate::shaders::wgsl!("pass/scene/scene_air");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_KINDS = 2;\nconst int AIR_PATH = 2;\nconst int AIR_SUMMANDS = 3;\nconst vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);\nconst vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);\nconst float COLUMN_HEIGHTS = 7.0;\nconst vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);\nconst vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);\nconst vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);\nconst vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);\nconst float ROUGH_HEIGHTS = 5.0;\nconst bool MIE_SINGLE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float IRRADIANCE_0_ = 0.88622695;\nconst float IRRADIANCE_1_ = 1.0233268;\nconst float IRRADIANCE_2_ = 0.8580855;\nconst float IRRADIANCE_ZZ = 0.24770796;\nconst float IRRADIANCE_XX = 0.42904276;\n",
    "layout(location=0)out vec4 o0;\n",
    "layout(std140)uniform SceneAir_block_0Fragment{SceneAir g0;};\n",
    "precision highp float;precision highp int;\n",
    "struct DepthCode{float scale;float bias;float log_;float background;};\n",
    "struct Frame{Medium medium;vec3 ray_forward;float altitude;vec3 ray_right;float sky_weight;vec3 ray_up;float shell_weight;vec3 sun;float sun_chord;vec2 size;float sun_disk;float pixel_angle;DepthCode depth;uint view_samples;uint light_samples;uint flags;float camera_altitude;vec4 sky_view_mapping;};\n",
    "struct Luts{vec3 mie_extinction;float altitude_steepness;vec3 mie_moment0_;float altitude_growth;vec3 mie_moment1_;float sun_middle;vec3 mie_moment2_;float sun_width;vec3 mie_asymmetry;float pad;vec3 albedo;float sun_first;float sun_span;float ground_rows;uvec2 size;uint steps;uint pad1_;uint slices;float aerial_ground_rows;};\n",
    "struct Medium{vec3 rayleigh;float rayleigh_inv_height;vec3 mie_scattering;float mie_inv_height;vec3 mie_extinction;float ozone_center;vec3 mie_asymmetry;float ozone_inv_half_width;vec3 ozone;float radius;vec3 irradiance;float thickness;float datum;float pad1_;float pad2_;float pad3_;};\n",
    "struct SceneAir{Frame frame;Luts luts;vec3 zenith_x;float present;vec3 zenith_y;float cornette_shanks;vec3 zenith_z;float mie_light;vec4 harmonics_00_;vec4 harmonics_1y;vec4 harmonics_1z;vec4 harmonics_1x;vec4 harmonics_2xy;vec4 harmonics_2yz;vec4 harmonics_2zz;vec4 harmonics_2xz;vec4 harmonics_2xx;};\n",
    "uniform highp sampler2D g1;\n",
    "uniform highp sampler2D g2;\n",
    "uniform highp sampler2D g3;\n",
    "void aerial(vec3 a,float b,inout vec3 c,inout vec3 d){float e=0.0;float f=0.0;float g=0.0;bool h=false;float i=0.0;float j=0.0;float k=0.0;bool l=false;float m=0.0;float n=0.0;float o=0.0;float p=0.0;vec3 q=vec3(0.0);vec3 r=vec3(0.0);vec3 s=vec3(0.0);vec3 t=vec3(0.0);vec3 u=g0.frame.medium.rayleigh;float v=g0.frame.medium.rayleigh_inv_height;float w=g0.frame.medium.mie_inv_height;vec3 x=g0.frame.medium.mie_extinction;float y=g0.frame.medium.ozone_center;vec3 z=g0.frame.medium.mie_asymmetry;float aa=g0.frame.medium.ozone_inv_half_width;vec3 ab=g0.frame.medium.ozone;float ac=g0.frame.medium.radius;vec3 ad=g0.frame.medium.irradiance;float ae=g0.frame.medium.thickness;float af=g0.frame.medium.datum;float ag=g0.frame.altitude;vec3 ah=g0.frame.sun;float ai=g0.frame.pixel_angle;vec4 aj=g0.frame.sky_view_mapping;vec3 ak=g0.luts.mie_extinction;float al=g0.luts.ground_rows;uint am=g0.luts.slices;float an=g0.luts.aerial_ground_rows;vec3 ao=to_zenith(a,g0.zenith_x,g0.zenith_y,g0.zenith_z);float ap=b*0.001*stretch(a,g0.zenith_x,g0.zenith_y,g0.zenith_z);line_past(ao,ag,ac,e,f,g,h);line_to_scene(e,f,g,h,ag,ap,ac,ae,ai,i,j,k,l);air_path(i,k,l,ag,ac,ae,m,n,o,p);bool aq=l&&n>=0.0;float ar=scene_reach(m,n,p,aq,ap,ac,ai);if(ar<=0.0||g0.present<=0.0){c=vec3(0.0);d=vec3(1.0);return;}float as=azimuth_to_u(ao);float at=zenith_to_v(i,j,k,l,ao.z,ag,ac,ae,aj);vec2 au=vec2(uvec2(textureSize(g1,0).xy));vec2 av=sky_view_uv(as,v_to_row(at,aq,au.y,al),au);vec3 aw=scene_phase(ao,ah,z,g0.cornette_shanks);float ax=g0.mie_light;path_light(g1,g3,av,aq,n,aw*ax,q,r);air_before(g2,u,v,w,x,y,aa,ab,ac,af,ak,am,an,k,l,n,o,p,as,at,ar,q,r,s,t);c=t*ad;d=s;}\n",
    "vec3 aerial_brightness(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f){float g=min(floor(e),d-2.0);vec2 h=vec2(1.0)/vec2(c.x*d,c.y*2.0);vec2 i=(b+c*vec2(g,float(f))+vec2(0.5))*h;return mix(textureLod(a,vec2(i),0.0).xyz,textureLod(a,vec2(i+vec2(c.x*h.x,0.0)),0.0).xyz,e-g);}\n",
    "void aerial_point(highp sampler2D a,uint b,float c,float d,float e,bool f,float g,float h,float i,inout vec2 j,inout vec2 k,inout float l,inout float m){float n=float(b);vec2 o=vec2(uvec2(textureSize(a,0).xy))/vec2(n,2.0);float p=v_to_row(e,f,o.y,c);float q=clamp(-h,0.0,g);float r=distance_to_u(q,0.0);float s=(distance_to_u(q,i)-r)/(distance_to_u(q,g)-r);j=vec2(d*(o.x-1.0),p);k=o;l=n;m=clamp(s,0.0,1.0)*(n-1.0);}\n",
    "void air_before(highp sampler2D a,vec3 b,float c,float d,vec3 e,float f,float g,vec3 h,float i,float j,vec3 k,uint l,float m,float n,bool o,float p,float q,float r,float s,float t,float u,vec3 v,vec3 w,inout vec3 x,inout vec3 y){float z=0.0;float aa=0.0;float ab=0.0;vec2 ac=vec2(0.0);vec2 ad=vec2(0.0);float ae=0.0;float af=0.0;mat2x3 ag=layers_of(c,d,f,g,j);bool ah=u>=p;vec3 ai=path_columns(ag,n,o,q,r,min(u,p),ah,i);vec3 aj=v;vec3 ak=w;if(!ah){mat3x3 al=scatterer_coefficients(b,k);lowest_point(q,r,n,o,p,i,z,aa,ab);vec3 am=opacity(extinction(al,ai))/max(rough_opacity(ag,al,aa,ab,-z,p-z,i),vec3(1e-30));aerial_point(a,l,m,s,t,o,p,r,u,ac,ad,ae,af);aj=aj*min(am*aerial_brightness(a,ac,ad,ae,af,AIR_SMOOTH),vec3(1.0));if(MIE_SINGLE){ak=ak*min(am*aerial_brightness(a,ac,ad,ae,af,AIR_MIE),vec3(1.0));}}if(MIE_SINGLE){aj=aj+ak;}x=exp(-extinction(coefficients_of(b,e,h),ai));y=aj;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){float k=excess_of(f,e);float l=sqrt(max(-b,0.0));if(d<=f){float m=excess_of(d,e);float n=distance_to_top(m,a,k);float o=distance_to_ground(m,a,l);g=0.0;h=c?o:n;i=m;j=a;return;}float p=(d-f)*(2.0*e+f+d);float q=top_half_chord2_(a,b,d,e,f);if(a>=0.0||q<=0.0){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float r=sqrt(q);float s=c?distance_to_ground(k,-r,l):2.0*r;g=p/(r-a);h=s;i=k;j=-r;}\n",
    "float altitude_after(float a,float b,float c,float d){return max(altitude_of(a+c*(2.0*b+c),d),0.0);}\n",
    "float altitude_of(float a,float b){return a/(b+sqrt(max(b*b+a,0.0)));}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=a.x/b;float d=sqrt(0.5+0.5*min(abs(c),1.0));float e=0.5*abs(a.y)/b/d;return(c>=0.0?e:d)/(d+e);}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "vec3 columns(mat2x3 a,float b,float c,float d,float e,float f){vec3 g=vec3(0.0);vec3 h=a[0];float i=a[1].x;if(RAYLEIGH){g.x=exponential_column(b,c,d,e,f,h.x,i);}if(MIE){g.y=exponential_column(b,c,d,e,f,h.y,i);}if(OZONE){float j=a[1].y;g.z=tent_column(b,abs(c),max(-d,e),f,h.z,j,i);float k=min(-d,e);if(k>0.0){g.z=g.z+tent_column(b,0.0,k,f,h.z,j,i);}}return g;}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=1.0-a;return vec3(1.5*(1.0+d*d))/(vec3(2.0)+c*c)*henyey_greenstein_phase(a,b,c);}\n",
    "float crowded(float a,float b,float c){return sqrt(max(a,0.0)/(c*(b+c)));}\n",
    "vec3 decode_light(vec3 a){vec3 b=a*a;return b*b;}\n",
    "vec2 dense_part(float a,float b,float c,float d,float e,float f,float g){float h=distance_at_height(a,b,max(altitude_of(a,e),g)+f,e);float i=max(c,-h-b);float j=0.5*max(min(d,h-b)-i,0.0);return vec2(i+j,j);}\n",
    "float distance_at_height(float a,float b,float c,float d){return sqrt(max(excess_of(c,d)-a+b*b,0.0));}\n",
    "float distance_to_ground(float a,float b,float c){return min(a/(c-b),-b);}\n",
    "float distance_to_top(float a,float b,float c){float d=max(c-a,0.0);float e=sqrt(b*b+d);if(b>0.0){return d/(b+e);}return e-b;}\n",
    "float distance_to_u(float a,float b){return sign(b-a)*sqrt(abs(b-a));}\n",
    "float excess_of(float a,float b){return a*(2.0*b+a);}\n",
    "float exponential_column(float a,float b,float c,float d,float e,float f,float g){vec2 h=dense_part(a,b,c,d,e,COLUMN_HEIGHTS/f,g);float i=h.y;vec4 j=i*COLUMN_NODES;return i*dot(COLUMN_WEIGHTS,exp(-max(heights_after(a,b,vec4(h.x)-j,e)-vec4(g),vec4(0.0))*f)+exp(-max(heights_after(a,b,vec4(h.x)+j,e)-vec4(g),vec4(0.0))*f));}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){c=c+a[0]*b.x;}if(MIE){c=c+a[1]*b.y;}if(OZONE){c=c+a[2]*b.z;}return c;}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=c+d;if(abs(a)<e){return a*a-b;}return c*(e+d);}\n",
    "vec4 heights_after(float a,float b,vec4 c,float d){vec4 e=vec4(a)+c*(vec4(2.0*b)+c);return max(e/(vec4(d)+sqrt(max(vec4(d*d)+e,vec4(0.0)))),vec4(0.0));}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=vec3(1.0)-abs(c);vec3 e=d*d+2.0*abs(c)*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)));return INV_4PI*(vec3(1.0)-c*c)/(e*sqrt(e));}\n",
    "vec3 irradiance(vec3 a){vec3 b=to_zenith(a,g0.zenith_x,g0.zenith_y,g0.zenith_z);return max((g0.harmonics_00_*IRRADIANCE_0_+(g0.harmonics_1y*b.y+g0.harmonics_1z*b.z+g0.harmonics_1x*b.x)*IRRADIANCE_1_+(g0.harmonics_2xy*(b.x*b.y)+g0.harmonics_2yz*(b.y*b.z)+g0.harmonics_2xz*(b.x*b.z))*IRRADIANCE_2_+g0.harmonics_2zz*((3.0*b.z*b.z-1.0)*IRRADIANCE_ZZ)+g0.harmonics_2xx*((b.x*b.x-b.y*b.y)*IRRADIANCE_XX)).xyz,vec3(0.0));}\n",
    "mat2x3 layers_of(float a,float b,float c,float d,float e){return mat2x3(vec3(a,b,d),vec3(e,c,0.0));}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){float h=c+b;float i=h*a.z;float j=h*sqrt(dot(a.xy,a.xy));float k=half_chord2_(i,excess_of(b,c),c-j,j);bool l=i<0.0&&k>=0.0;d=i;e=j;f=-k;g=l;}\n",
    "void line_to_scene(float a,float b,float c,bool d,float e,float f,float g,float h,float i,inout float j,inout float k,inout float l,inout bool m){float n=excess_of(e,g);float o=sqrt(n);float p=sqrt(max(-c,0.0));float q=distance_to_ground(n,a,p);float r=f-q;if(!d||r<=0.0||f>o+sqrt(excess_of(h,g))){j=a;k=b;l=c;m=d;return;}float s=snapped(f,i,p/g);float t=q+r*smoothstep(0.5*s,s,r);float u=clamp(t,1e-9,max(o,1e-9));float v=max(p-0.5*(u-q)*(1.0+(q+2.0*p)/u),0.0);j=-(u+v);k=sqrt((g-v)*(g+v));l=-v*v;m=t<o;}\n",
    "void lowest_point(float a,float b,float c,bool d,float e,float f,inout float g,inout float h,inout float i){if(b>=0.0){g=0.0;h=a;i=b;return;}if(-b<=e){g=-b;h=c;i=0.0;return;}float j=b+e;if(d){g=e;h=0.0;i=j;return;}bool k=-b*e>f*f;float l=a+e*(2.0*b+e);g=e;h=k?c+j*j:l;i=j;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4(vec2(float(a<<1u&2u),float(a&2u))*2.0-vec2(1.0),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);aerial(a.xyz,a.w,b,c);o0=vec4(b+sky(a.xyz),1.0)+vec4(irradiance(a.xyz)*c,0.0);return;}\n",
    "vec3 mean_transmittance(vec3 a){return mix((vec3(1.0)-exp(-a))/a,vec3(1.0)-a*(vec3(0.5)-a*0.16666667),lessThan(a,vec3(0.01)));}\n",
    "vec3 opacity(vec3 a){return a*mean_transmittance(a);}\n",
    "vec3 path_columns(mat2x3 a,float b,bool c,float d,float e,float f,bool g,float h){float i=0.0;float j=0.0;float k=0.0;bool l=c&&g;lowest_point(d,e,b,l,f,h,i,j,k);return columns(a,j,k,-i,f-i,h);}\n",
    "void path_light(highp sampler2D a,highp sampler2D b,vec2 c,bool d,float e,vec3 f,inout vec3 g,inout vec3 h){vec3 i=vec3(0.0);float j=d?e:1.0;vec3 k=decode_light(textureLod(a,vec2(c),0.0).xyz)*j;if(MIE_SINGLE){i=decode_light(textureLod(b,vec2(c),0.0).xyz)*j*f;}g=k;h=i;}\n",
    "float rough_column(float a,float b,float c,float d,float e,float f,float g){vec2 h=dense_part(a,b,c,d,e,ROUGH_HEIGHTS/f,g);float i=h.y;vec2 j=i*ROUGH_NODES;vec4 k=exp(-max(heights_after(a,b,vec4(h.x)+vec4(-j,j),e)-vec4(g),vec4(0.0))*f);return i*dot(ROUGH_WEIGHTS,k.xy+k.zw);}\n",
    "vec3 rough_opacity(mat2x3 a,mat3x3 b,float c,float d,float e,float f,float g){vec3 h=vec3(0.0);if(RAYLEIGH){h.x=rough_column(c,d,e,f,g,a[0].x,a[1].x);}if(MIE){h.y=rough_column(c,d,e,f,g,a[0].y,a[1].x);}return opacity(extinction(b,h));}\n",
    "mat3x3 scatterer_coefficients(vec3 a,vec3 b){return mat3x3(a,b,vec3(0.0));}\n",
    "vec3 scene_phase(vec3 a,vec3 b,vec3 c,float d){vec3 e=a-b;vec3 f=a+b;float g=0.5*dot(e,e);float h=0.5*dot(f,f);return mix(henyey_greenstein_phase(g,h,c),cornette_shanks_phase(g,h,c),d);}\n",
    "float scene_reach(float a,float b,float c,bool d,float e,float f,float g){float h=min(b,e-a);if(!d){return h;}float i=snapped(e,g,abs(c+b)/f);float j=smoothstep(0.5*i,i,b-h);return b*(1.0-j)+h*j;}\n",
    "vec3 sky(vec3 a){vec3 b=vec3(0.0);vec3 c=vec3(0.0);aerial(a,1000000000000.0,b,c);return b;}\n",
    "vec2 sky_view_uv(float a,float b,vec2 c){return(vec2(a*(c.x-1.0),b)+vec2(0.5))/c;}\n",
    "float slope_column(float a,float b,float c,float d,float e,float f,float g,float h){float i=max(d-c,0.0);vec3 j=vec3(c)+i*TENT_NODES;return i*dot(TENT_WEIGHTS,max(vec3(1.0)-abs(max(vec3(altitude_after(a,b,j.x,e),altitude_after(a,b,j.y,e),altitude_after(a,b,j.z,e))-vec3(h),vec3(0.0))-vec3(g))*f,vec3(0.0)));}\n",
    "float snapped(float a,float b,float c){return SUBPIXEL*b*a/max(c,0.05);}\n",
    "float stretch(vec3 a,vec3 b,vec3 c,vec3 d){vec3 e=vec3(dot(a,b),dot(a,c),dot(a,d));return sqrt(dot(e,e)/max(dot(a,a),1e-30));}\n",
    "float tent_column(float a,float b,float c,float d,float e,float f,float g){float h=1.0/e;float i=f<=h?0.0:distance_at_height(a,b,g+f-h,d)-b;if(i>=c){return 0.0;}vec3 j=clamp(vec3(i,distance_at_height(a,b,g+f,d)-b,distance_at_height(a,b,g+f+h,d)-b),vec3(0.0),vec3(c));return slope_column(a,b,j.x,j.y,d,e,f,g)+slope_column(a,b,j.y,j.z,d,e,f,g);}\n",
    "vec3 to_zenith(vec3 a,vec3 b,vec3 c,vec3 d){return normalize(vec3(dot(a,b),dot(a,c),dot(a,d)));}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=a*a;float g=excess_of(e,d);return f<g?f-(c-e)*(2.0*d+e+c):g-b;}\n",
    "float v_to_row(float a,bool b,float c,float d){return b?a*(d-1.0):d+a*(c-d-1.0);}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min(sqrt(max(-c,0.0))/g,1.0);return crowded(0.5*j,b/g/sqrt(2.0+2.0*j),SQRT_HALF);}if(e>=0.0){return i.x+(1.0-i.x)*max(crowded(0.5*(e+i.w),b/(g+f)/sqrt(2.0+2.0*e),sqrt(0.5+0.5*i.w))-i.z,0.0)/(1.0-i.z);}float k=max(min(f,h),1e-20);float l=max(c,0.0)/(g+b);float m=min(l/k,1.0);float n=sqrt(clamp((f>h?top_half_chord2_(a,c,f,g,h):a*a)/(k*(2.0*g+k+l)),0.0,1.0));return i.x*sqrt(m*(1.0+i.y*n)/(1.0+n));}\n",
];

/// Calls every function of `lib/scene_air.wgsl`, so that it is translated and checked; nobody draws with it.
/// What travels is what it includes: [`crate::shaders::scene`] gives it to a user's own shader.
pub mod scene_air {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_KINDS: u32 = 2;
        pub const AIR_PATH: u32 = 2;
        pub const AIR_SUMMANDS: u32 = 3;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "scene_air",
        uniform_size: 560,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "aerial_lut", binding: 2, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 3, filtered: true }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_COLUMNS, text::LIB_LUT_AIR, text::LIB_PHASE, text::LIB_SCENE_AIR, text::PASS_SCENE_SCENE_AIR],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 4, 42],
            fragment: &[0, 4, 8, 5, 6, 7, 9, 1, 3, 10, 11, 12, 2, 56, 31, 28, 40, 52, 19, 18, 29, 34, 39, 60, 17, 41, 24, 20, 62, 61, 54, 25, 38, 21, 33, 30, 44, 45, 50, 15, 14, 35, 27, 26, 32, 55, 58, 22, 46, 48, 49, 16, 47, 36, 23, 59, 57, 51, 13, 53, 37, 43],
            blocks: ["", "SceneAir_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}
