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
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst int CASE_TEXELS = 13;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst int ANSWERS = 2;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst int CASE_TEXELS = 13;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst int ANSWERS = 5;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst int CASE_TEXELS = 13;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\nconst int ANSWERS = 12;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const int CASE_TEXELS=13;const float PI=3.1415927;const float SQRT_HALF=0.70710677;const int ANSWERS=1;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const int CASE_TEXELS=13;const int ANSWERS=4;\n",
    "layout(location=0)out vec4 o0;\n",
    "precision highp float;precision highp int;\n",
    "uniform highp sampler2D g1;\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){bool k=false;float l=excess_of(f,e);float m=sqrt(max(-(b),0.0));if((d<=f)){float n=excess_of(d,e);float o=distance_to_top(n,a,l);float p=distance_to_ground(n,a,m);g=0.0;h=(c?p:o);i=n;j=a;return;}float q=((d-f)*(((2.0*e)+f)+d));float r=top_half_chord2_(a,b,d,e,f);if(!((a>=0.0))){k=(r<=0.0);}else{k=true;}bool s=k;if(s){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float t=sqrt(r);float u=distance_to_ground(l,-(t),m);float v=(c?u:(2.0*t));g=(q/(t-a));h=v;i=l;j=-(t);}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout bool g){float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;float n=0.0;float o=0.0;float p=0.0;bool q=false;float r=0.0;float s=0.0;float t=0.0;float u=0.0;line_past(a,b,c,n,o,p,q);float v=n;float w=p;bool x=q;air_path(v,w,x,b,c,d,r,s,t,u);float y=r;float z=s;float aa=t;float ab=u;if((b<=d)){sun_side_inside(a,e,(c+b),aa,c,h,i,j,k,l);}else{if((z>0.0)){sun_side_outside(a,e,(c+b),y,-(ab),aa,c,h,i,j,k,l);}else{}}if(x){m=(z>=0.0);}else{m=false;}bool ac=m;f=z;g=ac;}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout bool q){float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;bool x=false;float y=0.0;float z=0.0;bool aa=false;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;line_past(a,b,c,y,z,aa);float af=y;float ag=z;bool ah=aa;air_path(af,ag,ah,b,c,d,ab,ac,ad,ae);float ai=ab;float aj=ac;float ak=ad;float al=ae;if((b<=d)){sun_side_inside(a,e,(c+b),ak,c,r,s,t,u,v,w);}else{if((aj>0.0)){sun_side_outside(a,e,(c+b),ai,-(al),ak,c,r,s,t,u,v,w);}else{s=dot(a,e);}}if(ah){x=(aj>=0.0);}else{x=false;}bool am=x;float an=r;float ao=s;float ap=t;float aq=u;float ar=v;float as=w;f=ai;g=aj;h=ak;i=al;j=ag;k=an;l=ao;m=ap;n=aq;o=ar;p=as;q=am;}\n",
    "float altitude_after(float a,float b,float c,float d){float e=altitude_of((a+(c*((2.0*b)+c))),d);return max(e,0.0);}\n",
    "float altitude_of(float a,float b){return(a/(b+sqrt(max(((b*b)+a),0.0))));}\n",
    "float altitude_to_v(float a,float b,float c,float d){float e=((max(c,0.0)/d)*b);float f=(e*(1.0-(e*(0.5-(e*(0.33333334-(e*0.25)))))));return sqrt((((e<0.05)?f:log((1.0+e)))/a));}\n",
    "vec4 axes_answer(int a,float b,vec4 c,vec4 d,vec4 e,vec4 f,vec4 g){float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;l=e.z;m=e.w;h=g.x;i=g.y;j=g.z;k=g.w;if((a==6)){float n=h;float o=i;float p=v_to_altitude(n,o,f.y,b);float q=j;float r=k;float s=l;float t=m;float u=u_to_mu_sun(q,r,s,t,f.x);float v=h;float w=i;float x=altitude_to_v(v,w,p,b);float y=j;float z=k;float aa=l;float ab=m;vec4 ac=sun_axis(y,z,aa,ab);float ad=mu_sun_to_u(ac,u);return vec4(p,x,u,ad);}float ae=min(c.w,b);float af=h;float ag=i;float ah=altitude_to_v(af,ag,ae,b);float ai=j;float aj=k;float ak=l;float al=m;vec4 am=sun_axis(ai,aj,ak,al);float an=mu_sun_to_u(am,d.z);float ao=h;float ap=i;float aq=v_to_altitude(ao,ap,ah,b);float ar=j;float as=k;float at=l;float au=m;float av=u_to_mu_sun(ar,as,at,au,an);return vec4(ah,aq,an,av);}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=(a.x/b);float d=sqrt((0.5+(0.5*min(abs(c),1.0))));float e=(((0.5*abs(a.y))/b)/d);float f=((c>=0.0)?e:d);return(f/(d+e));}\n",
    "void case_of(ivec2 a,int b,inout float c,inout float d,inout vec4 e,inout vec4 f,inout vec4 g){ivec2 h=ivec2(((a.x/b)*CASE_TEXELS),a.y);vec4 i=texelFetch(g1,(h+ivec2(4,0)),0);vec4 j=texelFetch(g1,(h+ivec2(5,0)),0);vec4 k=texelFetch(g1,(h+ivec2(6,0)),0);vec4 l=texelFetch(g1,(h+ivec2(7,0)),0);vec4 m=texelFetch(g1,(h+ivec2(8,0)),0);c=i.w;d=j.w;e=k;f=l;g=m;}\n",
    "void case_of(ivec2 a,int b,inout float c,inout float d,inout vec4 e,inout vec4 f,inout vec4 g,inout vec4 h,inout vec4 i,inout vec4 j,inout vec4 k){ivec2 l=ivec2(((a.x/b)*CASE_TEXELS),a.y);vec4 m=texelFetch(g1,(l+ivec2(4,0)),0);vec4 n=texelFetch(g1,(l+ivec2(5,0)),0);vec4 o=texelFetch(g1,(l+ivec2(6,0)),0);vec4 p=texelFetch(g1,(l+ivec2(7,0)),0);vec4 q=texelFetch(g1,(l+ivec2(8,0)),0);vec4 r=texelFetch(g1,(l+ivec2(9,0)),0);vec4 s=texelFetch(g1,(l+ivec2(10,0)),0);vec4 t=texelFetch(g1,(l+ivec2(11,0)),0);vec4 u=texelFetch(g1,(l+ivec2(12,0)),0);c=m.w;d=n.w;e=o;f=p;g=q;h=r;i=s;j=t;k=u;}\n",
    "void case_of(ivec2 a,int b,inout vec3 c,inout float d,inout float e,inout vec3 f,inout float g,inout float h,inout vec3 i,inout float j,inout float k,inout vec4 l){ivec2 m=ivec2(((a.x/b)*CASE_TEXELS),a.y);vec4 n=texelFetch(g1,m,0);vec4 o=texelFetch(g1,(m+ivec2(1,0)),0);vec4 p=texelFetch(g1,(m+ivec2(2,0)),0);vec4 q=texelFetch(g1,(m+ivec2(3,0)),0);vec4 r=texelFetch(g1,(m+ivec2(4,0)),0);vec4 s=texelFetch(g1,(m+ivec2(5,0)),0);vec4 t=texelFetch(g1,(m+ivec2(8,0)),0);c=n.xyz;d=n.w;e=o.w;f=p.xyz;g=p.w;h=q.w;i=r.xyz;j=r.w;k=s.w;l=t;}\n",
    "void case_of(ivec2 a,int b,inout vec3 c,inout float d,inout float e,inout vec3 f,inout float g,inout vec3 h,inout float i,inout vec3 j,inout vec4 k,inout vec4 l,inout vec4 m){ivec2 n=ivec2(((a.x/b)*CASE_TEXELS),a.y);vec4 o=texelFetch(g1,n,0);vec4 p=texelFetch(g1,(n+ivec2(1,0)),0);vec4 q=texelFetch(g1,(n+ivec2(2,0)),0);vec4 r=texelFetch(g1,(n+ivec2(3,0)),0);vec4 s=texelFetch(g1,(n+ivec2(4,0)),0);vec4 t=texelFetch(g1,(n+ivec2(6,0)),0);vec4 u=texelFetch(g1,(n+ivec2(8,0)),0);vec4 v=texelFetch(g1,(n+ivec2(9,0)),0);c=o.xyz;d=o.w;e=p.w;f=q.xyz;g=q.w;h=r.xyz;i=r.w;j=s.xyz;k=t;l=u;m=v;}\n",
    "void case_of(ivec2 a,int b,inout vec3 c,inout float d,inout vec3 e,inout float f,inout vec3 g,inout float h,inout vec3 i,inout float j,inout vec3 k,inout float l,inout float m,inout vec4 n,inout vec4 o,inout vec4 p,inout vec4 q){ivec2 r=ivec2(((a.x/b)*CASE_TEXELS),a.y);vec4 s=texelFetch(g1,r,0);vec4 t=texelFetch(g1,(r+ivec2(1,0)),0);vec4 u=texelFetch(g1,(r+ivec2(2,0)),0);vec4 v=texelFetch(g1,(r+ivec2(3,0)),0);vec4 w=texelFetch(g1,(r+ivec2(4,0)),0);vec4 x=texelFetch(g1,(r+ivec2(5,0)),0);vec4 y=texelFetch(g1,(r+ivec2(6,0)),0);vec4 z=texelFetch(g1,(r+ivec2(7,0)),0);vec4 aa=texelFetch(g1,(r+ivec2(8,0)),0);vec4 ab=texelFetch(g1,(r+ivec2(9,0)),0);c=s.xyz;d=s.w;e=t.xyz;f=t.w;g=u.xyz;h=u.w;i=v.xyz;j=v.w;k=w.xyz;l=w.w;m=x.w;n=y;o=z;p=aa;q=ab;}\n",
    "void case_of(ivec2 a,int b,inout vec4 c,inout vec4 d){ivec2 e=ivec2(((a.x/b)*CASE_TEXELS),a.y);vec4 f=texelFetch(g1,(e+ivec2(6,0)),0);vec4 g=texelFetch(g1,(e+ivec2(7,0)),0);c=f;d=g;}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=(1.0-a);vec3 e=henyey_greenstein_phase(a,b,c);return((vec3((1.5*(1.0+(d*d))))/(vec3(2.0)+(c*c)))*e);}\n",
    "float crowded(float a,float b,float c){return sqrt((max(a,0.0)/(c*(b+c))));}\n",
    "vec3 dark_part(vec2 a,float b,float c){float d=clamp(a.x,b,c);float e=clamp(a.y,b,c);return vec3(d,e,((a.y>a.x)?max((e-d),0.0):0.0));}\n",
    "vec3 densities(vec4 a,float b){vec3 c=vec3(0.0);if(RAYLEIGH){c.x=exp((-(b)*a.x));}if(MIE){c.y=exp((-(b)*a.y));}if(OZONE){c.z=max(0.0,(1.0-(abs((b-a.z))*a.w)));}vec3 d=c;return d;}\n",
    "vec4 direction_answer(int a,float b,float c,vec4 d,vec4 e,vec4 f){float g=0.0;bool h=false;float i=0.0;float j=0.0;float k=0.0;bool l=false;vec3 m=vec3(0.0);float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;air_ray(d.xyz,d.w,b,c,e.xyz,g,h);float v=g;bool w=h;line_past(d.xyz,d.w,b,i,j,k,l);float x=i;float y=j;float z=k;bool aa=l;vec2 ab=view_uv(x,y,z,aa,d.xyz,b,c,d,f);if((a==0)){return vec4(ab,v,float(w));}view_ray(ab,w,b,c,d,e,f,m,n,o,p,q,r,s,t,u);vec3 ac=m;return vec4(ac,0.0);}\n",
    "float distance_to_ground(float a,float b,float c){return min((a/(c-b)),-(b));}\n",
    "float distance_to_top(float a,float b,float c){float d=max((c-a),0.0);float e=sqrt(((b*b)+d));if((b>0.0)){return(d/(b+e));}return(e-b);}\n",
    "float distance_to_u(float a,float b){return(sign((b-a))*sqrt(abs((b-a))));}\n",
    "float excess_of(float a,float b){return(a*((2.0*b)+a));}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){vec3 d=c;c=(d+(a[0]*b.x));}if(MIE){vec3 e=c;c=(e+(a[1]*b.y));}if(OZONE){vec3 f=c;c=(f+(a[2]*b.z));}vec3 g=c;return g;}\n",
    "vec2 gauss8_(int a){switch(a){case 0:{return vec2(0.01985507,0.050614268);}case 1:{return vec2(0.10166676,0.11119052);}case 2:{return vec2(0.23723379,0.15685332);}case 3:{return vec2(0.40828267,0.18134189);}case 4:{return vec2(0.5917173,0.18134189);}case 5:{return vec2(0.7627662,0.15685332);}case 6:{return vec2(0.89833325,0.11119052);}default:{return vec2(0.9801449,0.050614268);}}}\n",
    "vec2 half_angle(float a,float b,float c){float d=(c-a);float e=((d+b)*((c+a)-b));float f=((b-d)*((a+b)+c));return sqrt(max(vec2(e,f),vec2(0.0)));}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=(c+d);if((abs(a)<e)){return((a*a)-b);}return(c*(e+d));}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=(vec3(1.0)-abs(c));vec3 e=((d*d)+((2.0*abs(c))*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)))));return((INV_4PI*(vec3(1.0)-(c*c)))/(e*sqrt(e)));}\n",
    "bool hits_planet(vec3 a,float b,float c){float d=0.0;float e=0.0;bool f=false;line_past(a,b,c,d,e,f);bool g=f;return g;}\n",
    "void inner_ray(vec3 a,float b,float c,float d,vec3 e,bool f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n){bool o=false;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=(c+b);float v=excess_of(b,c);float w=(u*a.z);float x=(u*sqrt(dot(a.xy,a.xy)));float y=half_chord2_(w,v,(c-x),x);sun_side_inside(a,e,u,v,c,p,q,r,s,t);float z=p;float aa=q;float ab=r;float ac=excess_of(d,c);float ad=distance_to_top(v,w,ac);float ae=distance_to_ground(v,w,sqrt(max(y,0.0)));if(f){o=(w<0.0);}else{o=false;}bool af=o;float ag=(af?ae:ad);g=0.0;h=ag;i=v;j=w;k=-(y);l=z;m=aa;n=ab;}\n",
    "vec4 layers_of(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout bool f){bool g=false;float h=(c+b);float i=(h*a.z);float j=(h*sqrt(dot(a.xy,a.xy)));float k=excess_of(b,c);float l=half_chord2_(i,k,(c-j),j);if((i<0.0)){g=(l>=0.0);}else{g=false;}bool m=g;d=i;e=-(l);f=m;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){bool h=false;float i=(c+b);float j=(i*a.z);float k=(i*sqrt(dot(a.xy,a.xy)));float l=excess_of(b,c);float m=half_chord2_(j,l,(c-k),k);if((j<0.0)){h=(m>=0.0);}else{h=false;}bool n=h;d=j;e=k;f=-(m);g=n;}\n",
    "float lit_middle(vec3 a,float b,float c,float d){bool e=((a.x-c)>(d-a.y));float f=(e?c:a.y);float g=(e?a.x:d);float h=distance_to_u(b,f);float i=distance_to_u(b,g);float j=u_to_distance(b,(0.5*(h+i)));return j;}\n",
    "void main(){uint a=uint(gl_VertexID);vec2 b=vec2(float(((a<<1u)&2u)),float((a&2u)));gl_Position=vec4(((b*2.0)-vec2(1.0)),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;vec4 d=vec4(0.0);vec4 e=vec4(0.0);vec4 f=vec4(0.0);float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;bool r=false;float s=0.0;float t=0.0;float u=0.0;ivec2 v=ivec2(a.xy);case_of(v,ANSWERS,b,c,d,e,f);float w=b;float x=c;vec4 y=d;vec4 z=e;vec4 aa=f;air_ray(y.xyz,y.w,w,x,z.xyz,g,h,i,j,k,l,m,n,o,p,q,r);float ab=g;float ac=h;float ad=i;float ae=j;float af=k;float ag=l;float ah=m;float ai=n;float aj=o;float ak=p;float al=q;bool am=r;switch((v.x%ANSWERS)){case 0:{o0=vec4(ab,ac,ad,ae);return;}case 1:{o0=vec4(ag,ah,ai,float(am));return;}case 2:{float an=max(ac,0.0);vec2 ao=shadow_stretch(ag,ah,ai,aj,ak,al);vec2 ap=clamp(ao,vec2(0.0),vec2(an));bool aq=hits_planet(y.xyz,y.w,w);float ar=float(aq);perigee_of(ac,ad,ae,af,am,an,w,s,t,u);float as=s;float at=t;float au=u;float av=((z.w*an)-as);float aw=altitude_after(at,au,av,w);o0=vec4(aw,ar,ap);return;}default:{float ax=excess_of(y.w,w);float ay=excess_of(x,w);float az=distance_to_top(aa.x,aa.y,ay);float ba=altitude_of(ax,w);o0=vec4(ax,ba,az,0.0);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;vec4 d=vec4(0.0);vec4 e=vec4(0.0);vec4 f=vec4(0.0);vec4 g=vec4(0.0);vec4 h=vec4(0.0);vec4 i=vec4(0.0);vec4 j=vec4(0.0);ivec2 k=ivec2(a.xy);case_of(k,ANSWERS,b,c,d,e,f,g,h,i,j);float l=b;float m=c;vec4 n=d;vec4 o=e;vec4 p=f;vec4 q=g;vec4 r=h;vec4 s=i;vec4 t=j;int u=(k.x%ANSWERS);switch(u){case 0:case 1:{vec4 v=direction_answer(u,l,m,n,o,t);o0=v;return;}case 2:case 3:case 4:case 5:{vec4 w=ray_answer(u,l,m,n,o,r,t);o0=w;return;}case 6:case 7:{vec4 x=axes_answer(u,m,n,o,q,r,s);o0=x;return;}case 8:case 9:{vec4 y=transmittance_answer(u,l,m,p,r);o0=y;return;}case 10:{vec4 z=node_answer(l,m,n,r);o0=z;return;}default:{vec4 aa=step_answer(p,r);o0=aa;return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;float d=0.0;vec3 e=vec3(0.0);float f=0.0;float g=0.0;vec3 h=vec3(0.0);float i=0.0;float j=0.0;vec4 k=vec4(0.0);ivec2 l=ivec2(a.xy);case_of(l,ANSWERS,b,c,d,e,f,g,h,i,j,k);vec3 m=b;float n=c;float o=d;vec3 p=e;float q=f;float r=g;vec3 s=h;float t=i;float u=j;vec4 v=k;uint w=uint(v.w);vec4 x=layers_of(n,o,q,r);if(((l.x%ANSWERS)==0)){vec3 y=path_densities(x,t,v.x,v.y,v.z,w);o0=vec4(y,0.0);return;}mat3x3 z=coefficients_of(m,p,s);vec3 aa=sun_transmittance(z,x,t,u,v.x,v.y,w);o0=vec4(aa,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;float d=0.0;vec3 e=vec3(0.0);float f=0.0;vec3 g=vec3(0.0);float h=0.0;vec3 i=vec3(0.0);vec4 j=vec4(0.0);vec4 k=vec4(0.0);vec4 l=vec4(0.0);ivec2 m=ivec2(a.xy);case_of(m,ANSWERS,b,c,d,e,f,g,h,i,j,k,l);vec3 n=b;float o=c;float p=d;vec3 q=e;float r=f;vec3 s=g;float t=h;vec3 u=i;vec4 v=j;vec4 w=k;vec4 x=l;float y=x.x;vec4 z=layers_of(o,p,r,t);vec3 aa=densities(z,v.w);mat3x3 ab=coefficients_of(n,q,u);vec3 ac=extinction(ab,aa);switch((m.x%ANSWERS)){case 0:{float ad=rayleigh_phase((1.0-y));o0=vec4(aa,ad);return;}case 1:{o0=vec4(ac,0.0);return;}case 2:{vec3 ae=henyey_greenstein_phase(y,(2.0-y),s);o0=vec4(ae,0.0);return;}case 3:{vec3 af=cornette_shanks_phase(y,(2.0-y),s);o0=vec4(af,0.0);return;}default:{vec3 ag=mean_transmittance((ac*w.z));o0=vec4(ag,0.0);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);float c=0.0;vec3 d=vec3(0.0);float e=0.0;vec3 f=vec3(0.0);float g=0.0;vec3 h=vec3(0.0);float i=0.0;vec3 j=vec3(0.0);float k=0.0;float l=0.0;vec4 m=vec4(0.0);vec4 n=vec4(0.0);vec4 o=vec4(0.0);vec4 p=vec4(0.0);float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;bool ab=false;vec3 ac=vec3(0.0);vec3 ad=vec3(0.0);ivec2 ae=ivec2(a.xy);case_of(ae,ANSWERS,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p);vec3 af=b;float ag=c;vec3 ah=d;float ai=e;vec3 aj=f;float ak=g;vec3 al=h;float am=i;vec3 an=j;float ao=k;float ap=l;vec4 aq=m;vec4 ar=n;vec4 as=o;vec4 at=p;air_ray(aq.xyz,aq.w,ao,ap,ar.xyz,q,r,s,t,u,v,w,x,y,z,aa,ab);float au=q;float av=r;float aw=s;float ax=t;float ay=u;float az=v;float ba=w;float bb=x;float bc=y;float bd=z;float be=aa;bool bf=ab;vec3 bg=(aq.xyz-ar.xyz);float bh=(0.5*dot(bg,bg));float bi=(max(av,0.0)*ar.w);single_scattering(af,ag,ah,ai,aj,ak,al,am,an,ao,ap,au,av,aw,ax,ay,az,ba,bb,bc,bd,be,bf,aq.xyz,bi,bh,uint(as.w),uint(at.y),ac,ad);vec3 bj=ac;vec3 bk=ad;if(((ae.x%ANSWERS)==0)){o0=vec4(bj,bi);return;}o0=vec4(bk,float(bf));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);vec4 c=vec4(0.0);case_of(ivec2(a.xy),ANSWERS,b,c);vec4 d=b;vec4 e=c;vec2 f=moon_before_sun(length(d.xy),d.z,d.w,e.w);float g=visible_fraction(f.x,f.y);o0=vec4(g,f,0.0);return;}\n",
    "vec3 mean_transmittance(vec3 a){vec3 b=(vec3(1.0)-(a*(vec3(0.5)-(a*0.16666667))));return mix(((vec3(1.0)-exp(-(a)))/a),b,lessThan(a,vec3(0.01)));}\n",
    "vec3 mie_phase(float a,float b,vec3 c){if(CORNETTE_SHANKS){vec3 d=cornette_shanks_phase(a,b,c);return d;}else{vec3 e=henyey_greenstein_phase(a,b,c);return e;}}\n",
    "vec2 moon_before_sun(float a,float b,float c,float d){float e=(1.0/(max(b,(0.001*c))*d));return((b>0.0)?(vec2(c,a)*e):vec2(0.0,1000.0));}\n",
    "float mu_sun_to_u(vec4 a,float b){float c=((b-a.x)/a.y);return(((sign(c)*log((abs(c)+sqrt(((c*c)+1.0)))))-a.z)/a.w);}\n",
    "vec4 node_answer(float a,float b,vec4 c,vec4 d){float e=0.0;int f=0;float g=0.0;float h=0.0;bool i=false;float j=0.0;float k=0.0;float l=0.0;bool m=false;float n=0.0;float o=min(c.w,b);int p=int(d.w);node_direction((p/AZIMUTHS),(p%AZIMUTHS),o,a,g,h,i,j);float q=g;float r=h;bool s=i;bool t=true;while(true){if(!t){int u=f;f=(u+1);}t=false;int v=f;if((v<128)){}else{break;}{float w=e;int x=f;int y=f;node_direction((x/AZIMUTHS),(y%AZIMUTHS),o,a,k,l,m,n);float z=n;e=(w+z);}}float aa=e;return vec4(q,r,float(s),aa);}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout bool g,inout float h){bool i=(a<8);vec2 j=gauss8_((i?a:(a-8)));float k=excess_of(c,d);float l=(-(sqrt(k))/(d+c));float m=(i?(1.0-l):(-1.0-l));float n=clamp((l+((m*j.x)*j.x)),-1.0,1.0);e=n;f=((float(b)+0.5)*0.3926991);g=i;h=(((((abs(m)*2.0)*j.x)*j.y)*2.0)*0.3926991);}\n",
    "vec3 path_densities(vec4 a,float b,float c,float d,float e,uint f){vec3 g=vec3(0.0);float h=0.0;uint i=0u;float j=clamp(-(d),0.0,e);float k=-(sqrt(j));float l=((sqrt((e-j))-k)/float(f));bool m=true;while(true){if(!m){uint n=i;i=(n+1u);}m=false;uint o=i;if((o<f)){}else{break;}{uint p=i;float q=(k+(l*float(p)));float r=u_to_distance(j,(q+(0.5*l)));float s=u_to_distance(j,(q+l));float t=altitude_after(c,d,r,b);vec3 u=g;vec3 v=densities(a,t);float w=h;g=(u+(v*(s-w)));h=s;}}vec3 x=g;return x;}\n",
    "void perigee_of(float a,float b,float c,float d,bool e,float f,float g,inout float h,inout float i,inout float j){bool k=false;if((c>=0.0)){h=0.0;i=b;j=c;return;}if((-(c)<=f)){h=-(c);i=d;j=0.0;return;}float l=(c+f);if(e){k=(f>=a);}else{k=false;}bool m=k;if(m){h=f;i=0.0;j=l;return;}bool n=((-(c)*f)>(g*g));float o=(b+(f*((2.0*c)+f)));h=f;i=(n?(d+(l*l)):o);j=l;}\n",
    "float quarter_atan(float a,float b){float c=(min(b,a)/max(max(b,a),1e-30));float d=(c*c);float e=(1.0+(d*(-0.33333147+(d*(0.19993551+(d*(-0.142089+(d*(0.10656264+(d*(-0.07528964+(d*(0.042909615+(d*(-0.016165737+(d*0.0028662258))))))))))))))));return((a>b)?(1.5707964-(c*e)):(c*e));}\n",
    "vec4 ray_answer(int a,float b,float c,vec4 d,vec4 e,vec4 f,vec4 g){float h=0.0;float i=0.0;float j=0.0;bool k=false;vec3 l=vec3(0.0);float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;vec3 u=vec3(0.0);float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;bool ad=(f.z>0.5);view_ray(f.xy,ad,b,c,d,e,g,l,m,n,o,p,q,r,s,t);vec3 ae=l;float af=m;float ag=n;float ah=o;float ai=p;float aj=q;float ak=r;float al=s;float am=t;if((a==2)){return vec4(ae,ag);}if((a==3)){return vec4(af,ah,ai,aj);}line_past(ae,d.w,b,h,i,j,k);j=aj;k=ad;float an=h;float ao=i;float ap=j;bool aq=k;vec2 ar=view_uv(an,ao,ap,aq,ae,b,c,d,g);if((a==4)){return vec4(ar,ak,al);}view_ray(ar,ad,b,c,d,e,g,u,v,w,x,y,z,aa,ab,ac);vec3 as=u;return vec4(as,am);}\n",
    "float rayleigh_phase(float a){return(0.0596831*(1.0+(a*a)));}\n",
    "float segment(vec2 a){float b=quarter_atan(a.x,a.y);float c=(2.0*b);if((c<0.5)){float d=((4.0*c)*c);float e=(1.0-((d*0.05)*(1.0-((d*0.023809524)*(1.0-(d*0.013888889))))));return(((c*d)*0.16666667)*e);}float f=dot(a,a);return(c-((((2.0*a.x)*a.y)*((a.y*a.y)-(a.x*a.x)))/(f*f)));}\n",
    "float shadow_half2_(float a,float b,float c,float d,float e,float f){float g=max(sqrt(a),1e-18);float h=((e*abs(d))/g);float i=half_chord2_((b/g),c,(f-h),h);return i;}\n",
    "vec2 shadow_stretch(float a,float b,float c,float d,float e,float f){vec2 g=vec2(0.0);vec2 h=vec2(1.0,0.0);g=vec2(-(1e30),1e30);if((c>1e-30)){if((f<=0.0)){return h;}float i=-((d+(((d>=0.0)?1.0:-1.0)*sqrt((c*f)))));float j=(i/c);float k=((i!=0.0)?(e/i):j);g=vec2(min(j,k),max(j,k));}else{if((e>=0.0)){return h;}}if((abs(b)<1e-12)){if((a>=0.0)){return h;}}else{float l=(-(a)/b);if((b>0.0)){float m=g.y;g.y=min(m,l);}else{float n=g.x;g.x=max(n,l);}}vec2 o=g;return o;}\n",
    "void single_scattering(vec3 a,float b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,float k,float l,float m,float n,float o,float p,float q,float r,float s,float t,float u,float v,bool w,vec3 x,float y,float z,uint aa,uint ab,inout vec3 ac,inout vec3 ad){vec3 ae=vec3(0.0);vec3 af=vec3(0.0);vec2 ag=vec2(0.0);float ah=0.0;uint ai=0u;float aj=0.0;vec3 ak=vec3(0.0);float al=0.0;float am=0.0;float an=0.0;ac=vec3(0.0);ad=vec3(1.0);if(SUNLIGHT){vec2 ao=shadow_stretch(q,r,s,t,u,v);ag=ao;if(RAYLEIGH){float ap=rayleigh_phase((1.0-z));ae=(a*ap);}if(MIE){float aq=((z>1.0)?(s/max(z,1.0)):(2.0-z));vec3 ar=mie_phase(z,aq,g);af=(c*ar);}}vec4 as=layers_of(b,d,f,h);mat3x3 at=coefficients_of(a,e,i);perigee_of(m,n,o,p,w,y,j,al,am,an);float au=al;float av=am;float aw=an;float ax=-(sqrt(au));float ay=((sqrt((y-au))-ax)/float(aa));bool az=true;while(true){if(!az){uint ba=ai;ai=(ba+1u);}az=false;uint bb=ai;if((bb<aa)){}else{break;}{uint bc=ai;float bd=(ax+(ay*float(bc)));float be=u_to_distance(au,(bd+ay));float bf=u_to_distance(au,(bd+(0.5*ay)));float bg=altitude_after(av,aw,(bf-au),j);float bh=ah;float bi=(be-bh);vec3 bj=densities(as,bg);vec3 bk=extinction(at,bj);vec3 bl=(bk*bi);if(SUNLIGHT){vec2 bm=ag;float bn=ah;vec3 bo=dark_part(bm,bn,be);if((bo.z<bi)){aj=bf;if((bo.z>0.0)){float bp=ah;float bq=lit_middle(bo,au,bp,be);aj=bq;}float br=aj;float bs=(br-au);float bt=(av+(bs*((2.0*aw)+bs)));float bu=altitude_of(bt,j);vec3 bv=densities(as,max(bu,0.0));ak=vec3(0.0);if(RAYLEIGH){vec3 bw=ak;vec3 bx=ae;ak=(bw+(bx*bv.x));}if(MIE){vec3 by=ak;vec3 bz=af;ak=(by+(bz*bv.y));}float ca=aj;float cb=(q+(r*ca));vec3 cc=ak;vec3 cd=sun_transmittance(at,as,j,k,bt,cb,ab);ak=(cc*cd);vec3 ce=ak;float cf=aj;vec3 cg=sun_visibility(x,(l+cf));ak=(ce*cg);vec3 ch=ac;vec3 ci=ad;vec3 cj=mean_transmittance(bl);vec3 ck=ak;ac=(ch+(((ci*cj)*ck)*(bi-bo.z)));}}vec3 cl=ad;ad=(cl*exp(-(bl)));ah=be;}}}\n",
    "void sky_view_ray(float a,float b,bool c,float d,float e,float f,vec4 g,vec3 h,inout vec3 i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q){bool r=false;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;vec2 ac=u_to_azimuth(a);if(!(c)){r=(b>g.x);}else{r=false;}bool ad=r;if(ad){upward_ray(ac,b,d,e,f,g,h,i,j,k,l,m,n,o,p,q);return;}float ae=(e+d);float af=excess_of(d,e);float ag=excess_of(f,e);bool ah=(d>f);float ai=(ah?ag:af);if(c){float aj=((1.0-b)*(1.0+b));float ak=(SQRT_HALF*aj);v=((b*b)*(1.0+aj));float al=v;float am=v;s=(((-(e)*e)*al)*am);t=(e*((2.0*ak)*sqrt((1.0-(ak*ak)))));float an=s;u=(ai-an);}else{float ao=min(d,f);float ap=min((b/max(g.x,1e-20)),1.0);float aq=((1.0-ap)*(1.0+ap));float ar=(1.0-g.y);float as=((2.0*aq)/max((ar+sqrt(((ar*ar)+((4.0*g.y)*aq)))),1e-20));float at=(ao*min((((ap*ap)*(1.0+as))/(1.0+(g.y*as))),1.0));float au=excess_of(at,e);s=au;t=(e+at);u=(((ao*as)*as)*(((2.0*e)+ao)+at));}float av=((d-f)*(((2.0*e)+f)+d));float aw=u;float ax=-(sqrt(max(aw,0.0)));float ay=u;float az=((ah?-(sqrt(max((av+ay),0.0))):ax)/ae);float ba=t;vec3 bb=vec3((ac*min((ba/ae),1.0)),az);if(ah){ab=(av/(-(ax)-(ae*az)));float bc=ab;sun_side_outside(bb,h,ae,bc,-(ax),ag,e,w,x,y,z,aa);}else{sun_side_inside(bb,h,ae,af,e,w,x,y,z,aa);}float bd=distance_to_top(ai,ax,ag);float be=v;float bf=(c?(ai/max(((e*be)-ax),1e-20)):bd);float bg=ab;float bh=s;float bi=w;float bj=x;float bk=y;i=bb;j=bg;k=bf;l=ai;m=ax;n=bh;o=bi;p=bj;q=bk;}\n",
    "vec4 step_answer(vec4 a,vec4 b){float c=clamp(-(a.y),0.0,a.z);float d=distance_to_u(c,0.0);float e=distance_to_u(c,a.z);float f=u_to_distance(c,(d+((e-d)*b.x)));float g=distance_to_u(c,f);float h=u_to_distance(c,g);return vec4(d,e,f,h);}\n",
    "vec4 sun_axis(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;g=dot(a,b);float k=g;vec3 l=cross((a-(((k>=0.0)?1.0:-1.0)*b)),b);h=dot(l,l);f=(c*b.z);i=(c*((b.x*l.y)-(b.y*l.x)));float m=(c*length(b.xy));float n=f;float o=half_chord2_(n,d,(e-m),m);j=-(o);float p=h;float q=i;float r=j;float s=shadow_half2_(p,q,r,l.z,c,e);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;k=0.0;g=dot(a,b);float l=g;vec3 m=cross((a-(((l>=0.0)?1.0:-1.0)*b)),b);h=dot(m,m);f=(c*b.z);i=(c*((b.x*m.y)-(b.y*m.x)));float n=(c*length(b.xy));float o=f;float p=half_chord2_(o,d,(e-n),n);j=-(p);float q=h;float r=i;float s=j;float t=shadow_half2_(q,r,s,m.z,c,e);k=t;}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;i=dot(a,b);float m=i;float n=((m>=0.0)?1.0:-1.0);vec3 o=(a-(n*b));vec3 p=cross(o,b);j=dot(p,p);vec3 q=(vec3((-(a.z)*a.xy),dot(a.xy,a.xy))*c);float r=(-(n)*dot(q,o));float s=(c*b.z);float t=i;float u=i;bool v=((abs(s)+(d*abs(t)))<(abs(r)+(e*abs(u))));float w=i;float x=i;h=(v?(s+(d*x)):(r-(e*w)));vec3 y=cross(q,b);float z=j;k=(dot(y,p)-(e*z));float aa=length((y-(e*p)));float ab=h;float ac=half_chord2_(ab,f,(g-aa),aa);l=-(ac);float ad=j;float ae=k;float af=l;float ag=shadow_half2_(ad,ae,af,p.z,c,g);}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;m=0.0;i=dot(a,b);float n=i;float o=((n>=0.0)?1.0:-1.0);vec3 p=(a-(o*b));vec3 q=cross(p,b);j=dot(q,q);vec3 r=(vec3((-(a.z)*a.xy),dot(a.xy,a.xy))*c);float s=(-(o)*dot(r,p));float t=(c*b.z);float u=i;float v=i;bool w=((abs(t)+(d*abs(u)))<(abs(s)+(e*abs(v))));float x=i;float y=i;h=(w?(t+(d*y)):(s-(e*x)));vec3 z=cross(r,b);float aa=j;k=(dot(z,q)-(e*aa));float ab=length((z-(e*q)));float ac=h;float ad=half_chord2_(ac,f,(g-ab),ab);l=-(ad);float ae=j;float af=k;float ag=l;float ah=shadow_half2_(ae,af,ag,q.z,c,g);m=ah;}\n",
    "vec3 sun_transmittance(mat3x3 a,vec4 b,float c,float d,float e,float f,uint g){float h=excess_of(d,c);float i=distance_to_top(e,f,h);vec3 j=path_densities(b,c,e,f,i,g);vec3 k=extinction(a,j);return exp(-(k));}\n",
    "vec3 sun_visibility(vec3 a,float b){return vec3(1.0);}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=(a*a);float g=excess_of(e,d);float h=((c-e)*(((2.0*d)+e)+c));return((f<g)?(f-h):(g-b));}\n",
    "vec4 transmittance_answer(int a,float b,float c,vec4 d,vec4 e){vec3 f=transmittance_texel_ray(e.xy,vec2(2.0),b,c);if((a==8)){return vec4(f,0.0);}float g=altitude_of(f.x,b);float h=min(g,c);float i=altitude_of(d.x,b);vec2 j=transmittance_uv(f.x,h,f.y,b,c);vec2 k=transmittance_uv(d.x,i,d.y,b,c);return vec4(j,k);}\n",
    "vec3 transmittance_texel_ray(vec2 a,vec2 b,float c,float d){vec2 e=(a/(b-vec2(1.0)));float f=excess_of(d,c);float g=sqrt(f);float h=(e.y*g);float i=altitude_of((h*h),c);float j=min(i,d);float k=(d-j);float l=(k+(e.x*((h+g)-k)));float m=((l>0.0)?(((((g-h)*(g+h))/l)-l)*0.5):(c+j));return vec3((h*h),max(m,-(h)),l);}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max((e-b),0.0);return vec2(((i-j)/max(((g+h)-j),1e-20)),(g/h));}\n",
    "vec2 u_to_azimuth(float a){float b=(1.0-a);float c=(1.0/((a*a)+(b*b)));return(vec2(((b-a)*(b+a)),((2.0*a)*b))*c);}\n",
    "float u_to_distance(float a,float b){return(a+(b*abs(b)));}\n",
    "float u_to_mu_sun(float a,float b,float c,float d,float e){return clamp((a+(b*sinh((c+(e*d))))),-1.0,1.0);}\n",
    "void upward_ray(vec2 a,float b,float c,float d,float e,vec4 f,vec3 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p){float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=min((f.z+(((b-f.x)/(1.0-f.x))*(1.0-f.z))),1.0);float z=((1.0-y)*(1.0+y));float aa=(0.5+(0.5*f.w));float ab=(sqrt(aa)*z);float ac=max((((((2.0*aa)*y)*y)*(1.0+z))-f.w),0.0);vec3 ad=vec3((a*((2.0*ab)*sqrt((1.0-(ab*ab))))),ac);inner_ray(ad,c,d,e,g,false,q,r,s,t,u,v,w,x);float ae=q;float af=r;float ag=s;float ah=t;float ai=u;float aj=v;float ak=w;float al=x;h=ad;i=ae;j=af;k=ag;l=ah;m=ai;n=aj;o=ak;p=al;}\n",
    "float v_to_altitude(float a,float b,float c,float d){float e=((a*c)*c);float f=((e<0.05)?(e*(1.0+(e*(0.5+(e*(0.16666667+(e*0.041666668))))))):(exp(e)-1.0));return(d*min((f/b),1.0));}\n",
    "void view_ray(vec2 a,bool b,float c,float d,vec4 e,vec4 f,vec4 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p){sky_view_ray(a.x,a.y,b,e.w,c,d,g,f.xyz,h,i,j,k,l,m,n,o,p);}\n",
    "vec2 view_uv(float a,float b,float c,bool d,vec3 e,float f,float g,vec4 h,vec4 i){float j=azimuth_to_u(e);float k=zenith_to_v(a,b,c,d,e.z,h.w,f,g,i);return vec2(j,k);}\n",
    "float visible_fraction(float a,float b){if((b>=(1.0+a))){return 1.0;}if((b<=(a-1.0))){return 0.0;}if((b<=(1.0-a))){return((1.0-a)*(1.0+a));}vec2 c=half_angle(1.0,b,a);vec2 d=half_angle(a,b,1.0);float e=segment(d);float f=((a*a)*e);if((c.y<c.x)){float g=segment(c.yx);return clamp(((g-f)/PI),0.0,1.0);}float h=segment(c);return clamp((1.0-((h+f)/PI)),0.0,1.0);}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min((sqrt(max(-(c),0.0))/g),1.0);float k=crowded((0.5*j),((b/g)/sqrt((2.0+(2.0*j)))),SQRT_HALF);return k;}if((e>=0.0)){float l=((b/(g+f))/sqrt((2.0+(2.0*e))));float m=crowded((0.5*(e+i.w)),l,sqrt((0.5+(0.5*i.w))));return(i.x+(((1.0-i.x)*max((m-i.z),0.0))/(1.0-i.z)));}float n=max(min(f,h),1e-20);float o=(max(c,0.0)/(g+b));float p=min((o/n),1.0);float q=top_half_chord2_(a,c,f,g,h);float r=((f>h)?q:(a*a));float s=sqrt(clamp((r/(n*(((2.0*g)+n)+o))),0.0,1.0));return(i.x*sqrt(((p*(1.0+(i.y*s)))/(1.0+s))));}\n",
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
        pub const CASE_TEXELS: u32 = 13;
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
            vertex: &[0, 7, 44],
            fragment: &[0, 7, 4, 8, 6, 22, 59, 35, 62, 86, 53, 50],
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
        pub const CASE_TEXELS: u32 = 13;
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
            vertex: &[0, 7, 44],
            fragment: &[0, 7, 5, 8, 6, 17, 13, 32, 12, 30, 36, 63, 70, 72, 41, 75, 29, 9, 11, 58, 38, 64, 45],
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
        pub const CASE_TEXELS: u32 = 13;
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
            vertex: &[0, 7, 44],
            fragment: &[0, 7, 3, 8, 6, 18, 13, 32, 30, 36, 63, 69, 71, 42, 75, 29, 9, 10, 39, 80, 31, 77, 78, 14, 83, 68, 54, 81, 25, 16, 79, 87, 82, 66, 34, 56, 85, 84, 28, 60, 15, 76, 55, 67, 46],
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
        pub const CASE_TEXELS: u32 = 13;
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
            vertex: &[0, 7, 44],
            fragment: &[0, 7, 2, 8, 6, 20, 40, 23, 27, 33, 51, 61, 37, 24, 48],
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
        pub const CASE_TEXELS: u32 = 13;
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
            vertex: &[0, 7, 44],
            fragment: &[0, 7, 1, 8, 6, 19, 13, 32, 12, 30, 40, 23, 27, 33, 80, 57, 73, 47],
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
        pub const CASE_TEXELS: u32 = 13;
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
            vertex: &[0, 7, 44],
            fragment: &[0, 7, 1, 8, 6, 21, 13, 32, 12, 30, 36, 63, 70, 72, 41, 75, 29, 9, 11, 58, 64, 40, 23, 27, 33, 80, 31, 57, 51, 26, 43, 61, 37, 24, 52, 73, 74, 65, 49],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}
