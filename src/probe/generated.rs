// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&probe_eclipse::INFO, &probe_geometry::INFO, &probe_luts::INFO, &probe_medium::INFO, &probe_path::INFO, &probe_scatter::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_PROBE_CASE: &str = crate::shaders::wgsl!("lib/probe_case");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const PASS_PROBE_PROBE_ECLIPSE: &str = crate::shaders::wgsl!("pass/probe/probe_eclipse");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const PASS_PROBE_PROBE_GEOMETRY: &str = crate::shaders::wgsl!("pass/probe/probe_geometry");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("lib/multi_scattering_lut");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_PROBE_PROBE_LUTS: &str = crate::shaders::wgsl!("pass/probe/probe_luts");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_PROBE_PROBE_MEDIUM: &str = crate::shaders::wgsl!("pass/probe/probe_medium");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const PASS_PROBE_PROBE_PATH: &str = crate::shaders::wgsl!("pass/probe/probe_path");
    pub(super) const PASS_PROBE_PROBE_SCATTER: &str = crate::shaders::wgsl!("pass/probe/probe_scatter");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst int CASE_TEXELS = 14;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst int ANSWERS = 2;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst int CASE_TEXELS = 14;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst int ANSWERS = 5;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst int CASE_TEXELS = 14;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\nconst int ANSWERS = 12;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const uint WIDE=4u;const int CASE_TEXELS=14;const float PI=3.1415927;const float SQRT_HALF=0.70710677;const int ANSWERS=1;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const uint WIDE=4u;const int CASE_TEXELS=14;const int ANSWERS=4;\n",
    "layout(location=0)out vec4 o0;\n",
    "precision highp float;precision highp int;\n",
    "uniform highp sampler2D g1;\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){float k=excess_of(f,e);float l=sqrt(max(-b,0.0));if(d<=f){float m=excess_of(d,e);float n=distance_to_top(m,a,k);float o=distance_to_ground(m,a,l);g=0.0;h=c?o:n;i=m;j=a;return;}float p=(d-f)*(2.0*e+f+d);float q=top_half_chord2_(a,b,d,e,f);if(a>=0.0||q<=0.0){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float r=sqrt(q);float s=c?distance_to_ground(k,-r,l):2.0*r;g=p/(r-a);h=s;i=k;j=-r;}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout bool g){float h=0.0;float i=0.0;float j=0.0;bool k=false;line_past(a,b,c,h,i,j,k);air_ray_of(h,j,k,a,b,c,d,e,f,g);}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout bool q){float r=0.0;float s=0.0;bool t=false;line_past(a,b,c,r,s,t);air_ray_of(r,s,t,a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q);}\n",
    "void air_ray_of(float a,float b,bool c,vec3 d,float e,float f,float g,vec3 h,inout float i,inout bool j){float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;air_path(a,b,c,e,f,g,p,q,r,s);if(e<=g){sun_side_inside(d,h,f+e,r,f,k,l,m,n,o);}else{if(q>0.0){sun_side_outside(d,h,f+e,p,-s,r,f,k,l,m,n,o);}else{}}bool t=c&&q>=0.0;i=q;j=t;}\n",
    "void air_ray_of(float a,float b,bool c,vec3 d,float e,float f,float g,vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout bool t){float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;air_path(a,b,c,e,f,g,aa,ab,ac,ad);if(e<=g){sun_side_inside(d,h,f+e,ac,f,u,v,w,x,y,z);}else{if(ab>0.0){sun_side_outside(d,h,f+e,aa,-ad,ac,f,u,v,w,x,y,z);}else{v=dot(d,h);}}bool ae=c&&ab>=0.0;i=aa;j=ab;k=ac;l=ad;m=b;n=u;o=v;p=w;q=x;r=y;s=z;t=ae;}\n",
    "float altitude_after(float a,float b,float c,float d){return max(altitude_of(a+c*(2.0*b+c),d),0.0);}\n",
    "float altitude_of(float a,float b){return a/(b+sqrt(max(b*b+a,0.0)));}\n",
    "float altitude_to_v(float a,float b,float c,float d){float e=max(c,0.0)/d*b;return sqrt((e<0.05?e*(1.0-e*(0.5-e*(0.33333334-e*0.25))):log(1.0+e))/a);}\n",
    "vec4 axes_answer(int a,float b,vec4 c,vec4 d,vec4 e,vec4 f,vec4 g){float h=e.z;float i=e.w;float j=g.x;float k=g.y;float l=g.z;float m=g.w;if(a==6){float n=v_to_altitude(j,k,f.y,b);float o=u_to_mu_sun(l,m,h,i,f.x);return vec4(n,altitude_to_v(j,k,n,b),o,mu_sun_to_u(sun_axis(l,m,h,i),o));}float p=altitude_to_v(j,k,min(c.w,b),b);float q=mu_sun_to_u(sun_axis(l,m,h,i),d.z);return vec4(p,v_to_altitude(j,k,p,b),q,u_to_mu_sun(l,m,h,i,q));}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=a.x/b;float d=sqrt(0.5+0.5*min(abs(c),1.0));float e=0.5*abs(a.y)/b/d;return(c>=0.0?e:d)/(d+e);}\n",
    "void case_of(ivec2 a,int b,inout float c,inout float d,inout vec4 e,inout vec4 f,inout vec4 g){ivec2 h=ivec2(a.x/b*CASE_TEXELS,a.y);vec4 i=texelFetch(g1,h+ivec2(4,0),0);vec4 j=texelFetch(g1,h+ivec2(5,0),0);vec4 k=texelFetch(g1,h+ivec2(7,0),0);vec4 l=texelFetch(g1,h+ivec2(8,0),0);vec4 m=texelFetch(g1,h+ivec2(9,0),0);c=i.w;d=j.w;e=k;f=l;g=m;}\n",
    "void case_of(ivec2 a,int b,inout float c,inout float d,inout vec4 e,inout vec4 f,inout vec4 g,inout vec4 h,inout vec4 i,inout vec4 j,inout vec4 k){ivec2 l=ivec2(a.x/b*CASE_TEXELS,a.y);vec4 m=texelFetch(g1,l+ivec2(4,0),0);vec4 n=texelFetch(g1,l+ivec2(5,0),0);vec4 o=texelFetch(g1,l+ivec2(7,0),0);vec4 p=texelFetch(g1,l+ivec2(8,0),0);vec4 q=texelFetch(g1,l+ivec2(9,0),0);vec4 r=texelFetch(g1,l+ivec2(10,0),0);vec4 s=texelFetch(g1,l+ivec2(11,0),0);vec4 t=texelFetch(g1,l+ivec2(12,0),0);vec4 u=texelFetch(g1,l+ivec2(13,0),0);c=m.w;d=n.w;e=o;f=p;g=q;h=r;i=s;j=t;k=u;}\n",
    "void case_of(ivec2 a,int b,inout vec3 c,inout float d,inout float e,inout vec3 f,inout float g,inout float h,inout vec3 i,inout float j,inout float k,inout float l,inout vec4 m){ivec2 n=ivec2(a.x/b*CASE_TEXELS,a.y);vec4 o=texelFetch(g1,n,0);vec4 p=texelFetch(g1,n+ivec2(1,0),0);vec4 q=texelFetch(g1,n+ivec2(2,0),0);vec4 r=texelFetch(g1,n+ivec2(3,0),0);vec4 s=texelFetch(g1,n+ivec2(4,0),0);vec4 t=texelFetch(g1,n+ivec2(5,0),0);vec4 u=texelFetch(g1,n+ivec2(6,0),0);vec4 v=texelFetch(g1,n+ivec2(9,0),0);c=o.xyz;d=o.w;e=p.w;f=q.xyz;g=q.w;h=r.w;i=s.xyz;j=s.w;k=t.w;l=u.x;m=v;}\n",
    "void case_of(ivec2 a,int b,inout vec3 c,inout float d,inout float e,inout vec3 f,inout float g,inout vec3 h,inout float i,inout vec3 j,inout float k,inout vec4 l,inout vec4 m,inout vec4 n){ivec2 o=ivec2(a.x/b*CASE_TEXELS,a.y);vec4 p=texelFetch(g1,o,0);vec4 q=texelFetch(g1,o+ivec2(1,0),0);vec4 r=texelFetch(g1,o+ivec2(2,0),0);vec4 s=texelFetch(g1,o+ivec2(3,0),0);vec4 t=texelFetch(g1,o+ivec2(4,0),0);vec4 u=texelFetch(g1,o+ivec2(6,0),0);vec4 v=texelFetch(g1,o+ivec2(7,0),0);vec4 w=texelFetch(g1,o+ivec2(9,0),0);vec4 x=texelFetch(g1,o+ivec2(10,0),0);c=p.xyz;d=p.w;e=q.w;f=r.xyz;g=r.w;h=s.xyz;i=s.w;j=t.xyz;k=u.x;l=v;m=w;n=x;}\n",
    "void case_of(ivec2 a,int b,inout vec3 c,inout float d,inout vec3 e,inout float f,inout vec3 g,inout float h,inout vec3 i,inout float j,inout vec3 k,inout float l,inout float m,inout float n,inout vec4 o,inout vec4 p,inout vec4 q,inout vec4 r){ivec2 s=ivec2(a.x/b*CASE_TEXELS,a.y);vec4 t=texelFetch(g1,s,0);vec4 u=texelFetch(g1,s+ivec2(1,0),0);vec4 v=texelFetch(g1,s+ivec2(2,0),0);vec4 w=texelFetch(g1,s+ivec2(3,0),0);vec4 x=texelFetch(g1,s+ivec2(4,0),0);vec4 y=texelFetch(g1,s+ivec2(5,0),0);vec4 z=texelFetch(g1,s+ivec2(6,0),0);vec4 aa=texelFetch(g1,s+ivec2(7,0),0);vec4 ab=texelFetch(g1,s+ivec2(8,0),0);vec4 ac=texelFetch(g1,s+ivec2(9,0),0);vec4 ad=texelFetch(g1,s+ivec2(10,0),0);c=t.xyz;d=t.w;e=u.xyz;f=u.w;g=v.xyz;h=v.w;i=w.xyz;j=w.w;k=x.xyz;l=x.w;m=y.w;n=z.x;o=aa;p=ab;q=ac;r=ad;}\n",
    "void case_of(ivec2 a,int b,inout vec4 c,inout vec4 d){ivec2 e=ivec2(a.x/b*CASE_TEXELS,a.y);vec4 f=texelFetch(g1,e+ivec2(7,0),0);vec4 g=texelFetch(g1,e+ivec2(8,0),0);c=f;d=g;}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=1.0-a;return vec3(1.5*(1.0+d*d))/(vec3(2.0)+c*c)*henyey_greenstein_phase(a,b,c);}\n",
    "float crowded(float a,float b,float c){return sqrt(max(a,0.0)/(c*(b+c)));}\n",
    "vec3 dark_part(vec2 a,float b,float c){float d=clamp(a.x,b,c);float e=clamp(a.y,b,c);return vec3(d,e,a.y>a.x?max(e-d,0.0):0.0);}\n",
    "vec3 densities(mat2x3 a,float b){vec3 c=vec3(0.0);vec3 d=a[0];float e=max(b-a[1].x,0.0);if(RAYLEIGH){c.x=exp(-e*d.x);}if(MIE){c.y=exp(-e*d.y);}if(OZONE){c.z=max(0.0,1.0-abs(e-a[1].y)*d.z);}return c;}\n",
    "vec4 direction_answer(int a,float b,float c,vec4 d,vec4 e,vec4 f){float g=0.0;bool h=false;float i=0.0;float j=0.0;float k=0.0;bool l=false;vec3 m=vec3(0.0);float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;air_ray(d.xyz,d.w,b,c,e.xyz,g,h);line_past(d.xyz,d.w,b,i,j,k,l);vec2 v=view_uv(i,j,k,l,d.xyz,b,c,d,f);if(a==0){return vec4(v,g,float(h));}view_ray(v,h,b,c,d,e,f,m,n,o,p,q,r,s,t,u);return vec4(m,0.0);}\n",
    "float distance_to_ground(float a,float b,float c){return min(a/(c-b),-b);}\n",
    "float distance_to_top(float a,float b,float c){float d=max(c-a,0.0);float e=sqrt(b*b+d);if(b>0.0){return d/(b+e);}return e-b;}\n",
    "float distance_to_u(float a,float b){return sign(b-a)*sqrt(abs(b-a));}\n",
    "float excess_of(float a,float b){return a*(2.0*b+a);}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){c=c+a[0]*b.x;}if(MIE){c=c+a[1]*b.y;}if(OZONE){c=c+a[2]*b.z;}return c;}\n",
    "vec2 gauss8_(int a){switch(a){case 0:{return vec2(0.01985507,0.050614268);}case 1:{return vec2(0.10166676,0.11119052);}case 2:{return vec2(0.23723379,0.15685332);}case 3:{return vec2(0.40828267,0.18134189);}case 4:{return vec2(0.5917173,0.18134189);}case 5:{return vec2(0.7627662,0.15685332);}case 6:{return vec2(0.89833325,0.11119052);}default:{return vec2(0.9801449,0.050614268);}}}\n",
    "vec2 half_angle(float a,float b,float c){float d=c-a;return sqrt(max(vec2((d+b)*(c+a-b),(b-d)*(a+b+c)),vec2(0.0)));}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=c+d;if(abs(a)<e){return a*a-b;}return c*(e+d);}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=vec3(1.0)-abs(c);vec3 e=d*d+2.0*abs(c)*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)));return INV_4PI*(vec3(1.0)-c*c)/(e*sqrt(e));}\n",
    "bool hits_planet(vec3 a,float b,float c){float d=0.0;float e=0.0;bool f=false;line_past(a,b,c,d,e,f);return f;}\n",
    "void inner_ray(vec3 a,float b,float c,float d,vec3 e,bool f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n){float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=c+b;float u=excess_of(b,c);float v=t*a.z;float w=t*sqrt(dot(a.xy,a.xy));float x=half_chord2_(v,u,c-w,w);sun_side_inside(a,e,t,u,c,o,p,q,r,s);float y=f&&v<0.0?distance_to_ground(u,v,sqrt(max(x,0.0))):distance_to_top(u,v,excess_of(d,c));g=0.0;h=y;i=u;j=v;k=-x;l=o;m=p;n=q;}\n",
    "mat2x3 layers_of(float a,float b,float c,float d,float e){return mat2x3(vec3(a,b,d),vec3(e,c,0.0));}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout bool f){float g=c+b;float h=g*a.z;float i=g*sqrt(dot(a.xy,a.xy));float j=half_chord2_(h,excess_of(b,c),c-i,i);bool k=h<0.0&&j>=0.0;d=h;e=-j;f=k;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){float h=c+b;float i=h*a.z;float j=h*sqrt(dot(a.xy,a.xy));float k=half_chord2_(i,excess_of(b,c),c-j,j);bool l=i<0.0&&k>=0.0;d=i;e=j;f=-k;g=l;}\n",
    "float lit_middle(vec3 a,float b,float c,float d){bool e=a.x-c>d-a.y;return u_to_distance(b,0.5*(distance_to_u(b,e?c:a.y)+distance_to_u(b,e?a.x:d)));}\n",
    "void lowest_point(float a,float b,float c,bool d,float e,float f,inout float g,inout float h,inout float i){if(b>=0.0){g=0.0;h=a;i=b;return;}if(-b<=e){g=-b;h=c;i=0.0;return;}float j=b+e;if(d){g=e;h=0.0;i=j;return;}bool k=-b*e>f*f;float l=a+e*(2.0*b+e);g=e;h=k?c+j*j:l;i=j;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4(vec2(float(a<<1u&2u),float(a&2u))*2.0-vec2(1.0),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;vec4 d=vec4(0.0);vec4 e=vec4(0.0);vec4 f=vec4(0.0);float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;bool r=false;float s=0.0;float t=0.0;float u=0.0;ivec2 v=ivec2(a.xy);case_of(v,ANSWERS,b,c,d,e,f);air_ray(d.xyz,d.w,b,c,e.xyz,g,h,i,j,k,l,m,n,o,p,q,r);switch(v.x%ANSWERS){case 0:{o0=vec4(g,h,i,j);return;}case 1:{o0=vec4(l,m,n,float(r));return;}case 2:{float w=max(h,0.0);vec2 x=clamp(shadow_stretch(l,m,n,o,p,q),vec2(0.0),vec2(w));float y=float(hits_planet(d.xyz,d.w,b));perigee_of(h,i,j,k,r,w,b,s,t,u);o0=vec4(altitude_after(t,u,e.w*w-s,b),y,x);return;}default:{float z=excess_of(d.w,b);o0=vec4(z,altitude_of(z,b),distance_to_top(f.x,f.y,excess_of(c,b)),0.0);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;vec4 d=vec4(0.0);vec4 e=vec4(0.0);vec4 f=vec4(0.0);vec4 g=vec4(0.0);vec4 h=vec4(0.0);vec4 i=vec4(0.0);vec4 j=vec4(0.0);ivec2 k=ivec2(a.xy);case_of(k,ANSWERS,b,c,d,e,f,g,h,i,j);int l=k.x%ANSWERS;switch(l){case 0:case 1:{o0=direction_answer(l,b,c,d,e,j);return;}case 2:case 3:case 4:case 5:{o0=ray_answer(l,b,c,d,e,h,j);return;}case 6:case 7:{o0=axes_answer(l,c,d,e,g,h,i);return;}case 8:case 9:{o0=transmittance_answer(l,b,c,f,h);return;}case 10:{o0=node_answer(b,c,d,h);return;}default:{o0=step_answer(f,h);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;float d=0.0;vec3 e=vec3(0.0);float f=0.0;float g=0.0;vec3 h=vec3(0.0);float i=0.0;float j=0.0;float k=0.0;vec4 l=vec4(0.0);ivec2 m=ivec2(a.xy);case_of(m,ANSWERS,b,c,d,e,f,g,h,i,j,k,l);uint n=uint(l.w);mat2x3 o=layers_of(c,d,f,g,k);if(m.x%ANSWERS==0){o0=vec4(path_densities(o,i,l.x,l.y,l.z,n),0.0);return;}o0=vec4(sun_transmittance(coefficients_of(b,e,h),o,i,j,l.x,l.y,n),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;float d=0.0;vec3 e=vec3(0.0);float f=0.0;vec3 g=vec3(0.0);float h=0.0;vec3 i=vec3(0.0);float j=0.0;vec4 k=vec4(0.0);vec4 l=vec4(0.0);vec4 m=vec4(0.0);ivec2 n=ivec2(a.xy);case_of(n,ANSWERS,b,c,d,e,f,g,h,i,j,k,l,m);float o=m.x;vec3 p=densities(layers_of(c,d,f,h,j),k.w);vec3 q=extinction(coefficients_of(b,e,i),p);switch(n.x%ANSWERS){case 0:{o0=vec4(p,rayleigh_phase(1.0-o));return;}case 1:{o0=vec4(q,0.0);return;}case 2:{o0=vec4(henyey_greenstein_phase(o,2.0-o,g),0.0);return;}case 3:{o0=vec4(cornette_shanks_phase(o,2.0-o,g),0.0);return;}default:{o0=vec4(mean_transmittance(q*l.z),0.0);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;vec3 d=vec3(0.0);float e=0.0;vec3 f=vec3(0.0);float g=0.0;vec3 h=vec3(0.0);float i=0.0;vec3 j=vec3(0.0);float k=0.0;float l=0.0;float m=0.0;vec4 n=vec4(0.0);vec4 o=vec4(0.0);vec4 p=vec4(0.0);vec4 q=vec4(0.0);float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;bool ac=false;vec3 ad=vec3(0.0);vec3 ae=vec3(0.0);ivec2 af=ivec2(a.xy);case_of(af,ANSWERS,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q);air_ray(n.xyz,n.w,k,l,o.xyz,r,s,t,u,v,w,x,y,z,aa,ab,ac);vec3 ag=n.xyz-o.xyz;float ah=0.5*dot(ag,ag);float ai=max(s,0.0)*o.w;single_scattering(b,c,d,e,f,g,h,i,j,k,l,m,r,s,t,u,v,w,x,y,z,aa,ab,ac,n.xyz,ai,ah,uint(p.w),uint(q.y),ad,ae);if(af.x%ANSWERS==0){o0=vec4(ad,ai);return;}o0=vec4(ae,float(ac));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);vec4 c=vec4(0.0);case_of(ivec2(a.xy),ANSWERS,b,c);vec2 d=moon_before_sun(length(b.xy),b.z,b.w,c.w);o0=vec4(visible_fraction(d.x,d.y),d,0.0);return;}\n",
    "vec3 mean_transmittance(vec3 a){return mix((vec3(1.0)-exp(-a))/a,vec3(1.0)-a*(vec3(0.5)-a*0.16666667),lessThan(a,vec3(0.01)));}\n",
    "vec3 mie_phase(float a,float b,vec3 c){if(CORNETTE_SHANKS){return cornette_shanks_phase(a,b,c);}else{return henyey_greenstein_phase(a,b,c);}}\n",
    "vec2 moon_before_sun(float a,float b,float c,float d){return b>0.0?vec2(c,a)*(1.0/(max(b,0.001*c)*d)):vec2(0.0,1000.0);}\n",
    "float mu_sun_to_u(vec4 a,float b){float c=(b-a.x)/a.y;return(sign(c)*log(abs(c)+sqrt(c*c+1.0))-a.z)/a.w;}\n",
    "vec4 node_answer(float a,float b,vec4 c,vec4 d){float e=0.0;int f=0;float g=0.0;float h=0.0;bool i=false;float j=0.0;float k=0.0;float l=0.0;bool m=false;float n=0.0;float o=min(c.w,b);int p=int(d.w);node_direction(p/AZIMUTHS,p%AZIMUTHS,o,a,g,h,i,j);bool q=true;while(true){if(!q){f=f+1;}q=false;if(f<128){}else{break;}{float r=e;int s=f;int t=f;node_direction(s/AZIMUTHS,t%AZIMUTHS,o,a,k,l,m,n);e=r+n;}}return vec4(g,h,float(i),e);}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout bool g,inout float h){bool i=a<8;vec2 j=gauss8_(i?a:a-8);float k=-sqrt(excess_of(c,d))/(d+c);float l=i?1.0-k:-1.0-k;e=clamp(k+l*j.x*j.x,-1.0,1.0);f=(float(b)+0.5)*0.3926991;g=i;h=abs(l)*2.0*j.x*j.y*2.0*0.3926991;}\n",
    "vec3 path_densities(mat2x3 a,float b,float c,float d,float e,uint f){vec3 g=vec3(0.0);float h=0.0;uint i=0u;float j=clamp(-d,0.0,e);float k=-sqrt(j);float l=(sqrt(e-j)-k)/float(f);bool m=true;while(true){if(!m){i=i+1u;}m=false;if(i<f){}else{break;}{float n=k+l*float(i);float o=u_to_distance(j,n+0.5*l);float p=u_to_distance(j,n+l);g=g+densities(a,altitude_after(c,d,o,b))*(p-h);h=p;}}return g;}\n",
    "void perigee_of(float a,float b,float c,float d,bool e,float f,float g,inout float h,inout float i,inout float j){bool k=e&&f>=a;lowest_point(b,c,d,k,f,g,h,i,j);}\n",
    "float quarter_atan(float a,float b){float c=min(b,a)/max(max(b,a),1e-30);float d=c*c;float e=1.0+d*(-0.33333147+d*(0.19993551+d*(-0.142089+d*(0.10656264+d*(-0.07528964+d*(0.042909615+d*(-0.016165737+d*0.0028662258)))))));return a>b?1.5707964-c*e:c*e;}\n",
    "vec4 ray_answer(int a,float b,float c,vec4 d,vec4 e,vec4 f,vec4 g){float h=0.0;float i=0.0;float j=0.0;bool k=false;vec3 l=vec3(0.0);float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;vec3 u=vec3(0.0);float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;bool ad=f.z>0.5;view_ray(f.xy,ad,b,c,d,e,g,l,m,n,o,p,q,r,s,t);if(a==2){return vec4(l,n);}if(a==3){return vec4(m,o,p,q);}line_past(l,d.w,b,h,i,j,k);j=q;k=ad;vec2 ae=view_uv(h,i,j,k,l,b,c,d,g);if(a==4){return vec4(ae,r,s);}view_ray(ae,ad,b,c,d,e,g,u,v,w,x,y,z,aa,ab,ac);return vec4(u,t);}\n",
    "float rayleigh_phase(float a){return 0.0596831*(1.0+a*a);}\n",
    "float segment(vec2 a){float b=2.0*quarter_atan(a.x,a.y);if(b<0.5){float c=4.0*b*b;return b*c*0.16666667*(1.0-c*0.05*(1.0-c*0.023809524*(1.0-c*0.013888889)));}float d=dot(a,a);return b-2.0*a.x*a.y*(a.y*a.y-a.x*a.x)/(d*d);}\n",
    "float shadow_half2_(float a,float b,float c,float d,float e,float f){float g=max(sqrt(a),1e-18);float h=e*abs(d)/g;return half_chord2_(b/g,c,f-h,h);}\n",
    "vec2 shadow_stretch(float a,float b,float c,float d,float e,float f){vec2 g=vec2(1.0,0.0);vec2 h=vec2(-1e30,1e30);if(c>1e-30){if(f<=0.0){return g;}float i=-(d+(d>=0.0?1.0:-1.0)*sqrt(c*f));float j=i/c;float k=i!=0.0?e/i:j;h=vec2(min(j,k),max(j,k));}else{if(e>=0.0){return g;}}if(abs(b)<1e-12){if(a>=0.0){return g;}}else{float l=-a/b;if(b>0.0){h.y=min(h.y,l);}else{h.x=max(h.x,l);}}return h;}\n",
    "void single_scattering(vec3 a,float b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,float k,float l,float m,float n,float o,float p,float q,float r,float s,float t,float u,float v,float w,bool x,vec3 y,float z,float aa,uint ab,uint ac,inout vec3 ad,inout vec3 ae){vec3 af=vec3(0.0);vec3 ag=vec3(0.0);vec2 ah=vec2(0.0);float ai=0.0;uint aj=0u;float ak=0.0;vec3 al=vec3(0.0);float am=0.0;float an=0.0;float ao=0.0;ad=vec3(0.0);ae=vec3(1.0);if(SUNLIGHT){ah=shadow_stretch(r,s,t,u,v,w);if(RAYLEIGH){af=a*rayleigh_phase(1.0-aa);}if(MIE){ag=c*mie_phase(aa,aa>1.0?t/max(aa,1.0):2.0-aa,g);}}mat2x3 ap=layers_of(b,d,f,h,l);mat3x3 aq=coefficients_of(a,e,i);perigee_of(n,o,p,q,x,z,j,am,an,ao);float ar=-sqrt(am);float as=(sqrt(z-am)-ar)/float(ab);bool at=true;while(true){if(!at){aj=aj+1u;}at=false;if(aj<ab){}else{break;}{float au=ar+as*float(aj);float av=u_to_distance(am,au+as);float aw=u_to_distance(am,au+0.5*as);float ax=altitude_after(an,ao,aw-am,j);float ay=av-ai;vec3 az=extinction(aq,densities(ap,ax))*ay;if(SUNLIGHT){vec3 ba=dark_part(ah,ai,av);if(ba.z<ay){ak=aw;if(ba.z>0.0){ak=lit_middle(ba,am,ai,av);}float bb=ak-am;float bc=an+bb*(2.0*ao+bb);vec3 bd=densities(ap,max(altitude_of(bc,j),0.0));al=vec3(0.0);if(RAYLEIGH){al=al+af*bd.x;}if(MIE){al=al+ag*bd.y;}al=al*sun_transmittance(aq,ap,j,k,bc,r+s*ak,ac);al=al*sun_visibility(y,m+ak);ad=ad+ae*mean_transmittance(az)*al*(ay-ba.z);}}ae=ae*exp(-az);ai=av;}}}\n",
    "void sky_view_ray(float a,float b,bool c,float d,float e,float f,vec4 g,vec3 h,inout vec3 i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q){float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;vec2 ab=u_to_azimuth(a);if(!c&&b>g.x){upward_ray(ab,b,d,e,f,g,h,i,j,k,l,m,n,o,p,q);return;}float ac=e+d;float ad=excess_of(d,e);float ae=excess_of(f,e);bool af=d>f;float ag=af?ae:ad;if(c){float ah=(1.0-b)*(1.0+b);float ai=SQRT_HALF*ah;u=b*b*(1.0+ah);r=-e*e*u*u;s=e*(2.0*ai*sqrt(1.0-ai*ai));t=ag-r;}else{float aj=min(d,f);float ak=min(b/max(g.x,1e-20),1.0);float al=(1.0-ak)*(1.0+ak);float am=1.0-g.y;float an=2.0*al/max(am+sqrt(am*am+4.0*g.y*al),1e-20);float ao=aj*min(ak*ak*(1.0+an)/(1.0+g.y*an),1.0);r=excess_of(ao,e);s=e+ao;t=aj*an*an*(2.0*e+aj+ao);}float ap=(d-f)*(2.0*e+f+d);float aq=-sqrt(max(t,0.0));float ar=(af?-sqrt(max(ap+t,0.0)):aq)/ac;vec3 as=vec3(ab*min(s/ac,1.0),ar);if(af){aa=ap/(-aq-ac*ar);float at=aa;sun_side_outside(as,h,ac,at,-aq,ae,e,v,w,x,y,z);}else{sun_side_inside(as,h,ac,ad,e,v,w,x,y,z);}float au=c?ag/max(e*u-aq,1e-20):distance_to_top(ag,aq,ae);i=as;j=aa;k=au;l=ag;m=aq;n=r;o=v;p=w;q=x;}\n",
    "vec4 step_answer(vec4 a,vec4 b){float c=clamp(-a.y,0.0,a.z);float d=distance_to_u(c,0.0);float e=distance_to_u(c,a.z);float f=u_to_distance(c,d+(e-d)*b.x);return vec4(d,e,f,u_to_distance(c,distance_to_u(c,f)));}\n",
    "vec4 sun_axis(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;g=dot(a,b);vec3 k=cross(a-(g>=0.0?1.0:-1.0)*b,b);h=dot(k,k);f=c*b.z;i=c*(b.x*k.y-b.y*k.x);float l=c*length(b.xy);j=-half_chord2_(f,d,e-l,l);float m=shadow_half2_(h,i,j,k.z,c,e);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;k=0.0;g=dot(a,b);vec3 l=cross(a-(g>=0.0?1.0:-1.0)*b,b);h=dot(l,l);f=c*b.z;i=c*(b.x*l.y-b.y*l.x);float m=c*length(b.xy);j=-half_chord2_(f,d,e-m,m);k=shadow_half2_(h,i,j,l.z,c,e);}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;i=dot(a,b);float m=i>=0.0?1.0:-1.0;vec3 n=a-m*b;vec3 o=cross(n,b);j=dot(o,o);vec3 p=vec3(-a.z*a.xy,dot(a.xy,a.xy))*c;float q=-m*dot(p,n);float r=c*b.z;h=abs(r)+d*abs(i)<abs(q)+e*abs(i)?r+d*i:q-e*i;vec3 s=cross(p,b);k=dot(s,o)-e*j;float t=length(s-e*o);l=-half_chord2_(h,f,g-t,t);float u=shadow_half2_(j,k,l,o.z,c,g);}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;m=0.0;i=dot(a,b);float n=i>=0.0?1.0:-1.0;vec3 o=a-n*b;vec3 p=cross(o,b);j=dot(p,p);vec3 q=vec3(-a.z*a.xy,dot(a.xy,a.xy))*c;float r=-n*dot(q,o);float s=c*b.z;h=abs(s)+d*abs(i)<abs(r)+e*abs(i)?s+d*i:r-e*i;vec3 t=cross(q,b);k=dot(t,p)-e*j;float u=length(t-e*p);l=-half_chord2_(h,f,g-u,u);m=shadow_half2_(j,k,l,p.z,c,g);}\n",
    "vec3 sun_transmittance(mat3x3 a,mat2x3 b,float c,float d,float e,float f,uint g){return exp(-extinction(a,path_densities(b,c,e,f,distance_to_top(e,f,excess_of(d,c)),g)));}\n",
    "vec3 sun_visibility(vec3 a,float b){return vec3(1.0);}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=a*a;float g=excess_of(e,d);return f<g?f-(c-e)*(2.0*d+e+c):g-b;}\n",
    "vec4 transmittance_answer(int a,float b,float c,vec4 d,vec4 e){vec3 f=transmittance_texel_ray(e.xy,vec2(2.0),b,c);if(a==8){return vec4(f,0.0);}return vec4(transmittance_uv(f.x,min(altitude_of(f.x,b),c),f.y,b,c),transmittance_uv(d.x,altitude_of(d.x,b),d.y,b,c));}\n",
    "vec3 transmittance_texel_ray(vec2 a,vec2 b,float c,float d){vec2 e=a/(b-vec2(1.0));float f=sqrt(excess_of(d,c));float g=e.y*f;float h=min(altitude_of(g*g,c),d);float i=d-h;float j=i+e.x*(g+f-i);return vec3(g*g,max(j>0.0?((f-g)*(f+g)/j-j)*0.5:c+h,-g),j);}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max(e-b,0.0);return vec2((i-j)/max(g+h-j,1e-20),g/h);}\n",
    "vec2 u_to_azimuth(float a){float b=1.0-a;return vec2((b-a)*(b+a),2.0*a*b)*(1.0/(a*a+b*b));}\n",
    "float u_to_distance(float a,float b){return a+b*abs(b);}\n",
    "float u_to_mu_sun(float a,float b,float c,float d,float e){return clamp(a+b*sinh(c+e*d),-1.0,1.0);}\n",
    "void upward_ray(vec2 a,float b,float c,float d,float e,vec4 f,vec3 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p){float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=min(f.z+(b-f.x)/(1.0-f.x)*(1.0-f.z),1.0);float z=(1.0-y)*(1.0+y);float aa=0.5+0.5*f.w;float ab=sqrt(aa)*z;vec3 ac=vec3(a*(2.0*ab*sqrt(1.0-ab*ab)),max(2.0*aa*y*y*(1.0+z)-f.w,0.0));inner_ray(ac,c,d,e,g,false,q,r,s,t,u,v,w,x);h=ac;i=q;j=r;k=s;l=t;m=u;n=v;o=w;p=x;}\n",
    "float v_to_altitude(float a,float b,float c,float d){float e=a*c*c;return d*min((e<0.05?e*(1.0+e*(0.5+e*(0.16666667+e*0.041666668))):exp(e)-1.0)/b,1.0);}\n",
    "void view_ray(vec2 a,bool b,float c,float d,vec4 e,vec4 f,vec4 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p){sky_view_ray(a.x,a.y,b,e.w,c,d,g,f.xyz,h,i,j,k,l,m,n,o,p);}\n",
    "vec2 view_uv(float a,float b,float c,bool d,vec3 e,float f,float g,vec4 h,vec4 i){return vec2(azimuth_to_u(e),zenith_to_v(a,b,c,d,e.z,h.w,f,g,i));}\n",
    "float visible_fraction(float a,float b){if(b>=1.0+a){return 1.0;}if(b<=a-1.0){return 0.0;}if(b<=1.0-a){return(1.0-a)*(1.0+a);}vec2 c=half_angle(1.0,b,a);float d=a*a*segment(half_angle(a,b,1.0));if(c.y<c.x){return clamp((segment(c.yx)-d)/PI,0.0,1.0);}return clamp(1.0-(segment(c)+d)/PI,0.0,1.0);}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min(sqrt(max(-c,0.0))/g,1.0);return crowded(0.5*j,b/g/sqrt(2.0+2.0*j),SQRT_HALF);}if(e>=0.0){return i.x+(1.0-i.x)*max(crowded(0.5*(e+i.w),b/(g+f)/sqrt(2.0+2.0*e),sqrt(0.5+0.5*i.w))-i.z,0.0)/(1.0-i.z);}float k=max(min(f,h),1e-20);float l=max(c,0.0)/(g+b);float m=min(l/k,1.0);float n=sqrt(clamp((f>h?top_half_chord2_(a,c,f,g,h):a*a)/(k*(2.0*g+k+l)),0.0,1.0));return i.x*sqrt(m*(1.0+i.y*n)/(1.0+n));}\n",
];

/// The visible fraction of the sun behind a moon, one case at a time. A case's direction holds the moon's
/// position less the point's, its altitude the moon's radius, both km; its fraction the tangent of the sun's
/// radius.
pub mod probe_eclipse {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const CASE_TEXELS: u32 = 14;
        pub const ANSWERS: u32 = 1;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_eclipse",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::PASS_PROBE_PROBE_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 47],
            fragment: &[0, 7, 4, 8, 6, 24, 62, 37, 65, 89, 56, 53],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// Rays, spheres, altitudes and the planet's shadow, one case at a time.
pub mod probe_geometry {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const CASE_TEXELS: u32 = 14;
        pub const ANSWERS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_geometry",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::PASS_PROBE_PROBE_GEOMETRY],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 47],
            fragment: &[0, 7, 5, 8, 6, 19, 15, 34, 14, 32, 38, 66, 73, 75, 43, 78, 31, 9, 13, 11, 46, 61, 40, 67, 48],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// Where in the LUTs a ray, an altitude or a sun's angle is, and what a texel stands for, one case at a time.
pub mod probe_luts {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const CASE_TEXELS: u32 = 14;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
        pub const ANSWERS: u32 = 12;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_luts",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_DIRECTIONS, text::PASS_PROBE_PROBE_LUTS],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 47],
            fragment: &[0, 7, 3, 8, 6, 20, 15, 34, 32, 38, 66, 72, 74, 44, 78, 31, 9, 12, 10, 41, 83, 33, 80, 81, 16, 86, 71, 57, 84, 27, 18, 82, 90, 85, 69, 36, 59, 88, 87, 30, 63, 17, 79, 58, 70, 49],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// Densities, extinction, phase functions and the mean transmittance of a step, one case at a time.
pub mod probe_medium {
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
        pub const WIDE: u32 = 4;
        pub const CASE_TEXELS: u32 = 14;
        pub const ANSWERS: u32 = 5;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_medium",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::PASS_PROBE_PROBE_MEDIUM],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 47],
            fragment: &[0, 7, 2, 8, 6, 22, 42, 25, 29, 35, 54, 64, 39, 26, 51],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// The optical path and the transmittance to the sun, one case at a time.
pub mod probe_path {
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
        pub const WIDE: u32 = 4;
        pub const CASE_TEXELS: u32 = 14;
        pub const ANSWERS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_path",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_PATH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 47],
            fragment: &[0, 7, 1, 8, 6, 21, 15, 34, 14, 32, 42, 25, 29, 35, 83, 60, 76, 50],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// Single scattering along a ray, one case at a time.
pub mod probe_scatter {
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
        pub const WIDE: u32 = 4;
        pub const CASE_TEXELS: u32 = 14;
        pub const ANSWERS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_scatter",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_SCATTER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 47],
            fragment: &[0, 7, 1, 8, 6, 23, 15, 34, 14, 32, 38, 66, 73, 75, 43, 78, 31, 9, 13, 11, 46, 61, 67, 42, 25, 29, 35, 83, 33, 60, 54, 28, 45, 64, 39, 26, 55, 76, 77, 68, 52],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}
