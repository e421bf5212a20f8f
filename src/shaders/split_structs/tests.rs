use naga::back::glsl;
use naga::valid::{Capabilities, ValidationFlags, Validator};

use super::*;
use crate::shaders::struct_lint::struct_values;

/// GLSL ES 3.00 of a text with one entry point, valid before and after.
fn translated(wgsl: &str) -> String {
    let valid = |module: &Module| {
        let info = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(module);
        info.unwrap_or_else(|e| panic!("{}\n{module:#?}", e.emit_to_string(wgsl)))
    };
    let mut module =
        naga::front::wgsl::parse_str(wgsl).unwrap_or_else(|e| panic!("{}", e.emit_to_string(wgsl)));
    valid(&module);
    split_structs(&mut module).unwrap();
    let info = valid(&module);
    let options = glsl::Options {
        version: glsl::Version::Embedded { version: 300, is_webgl: true },
        writer_flags: glsl::WriterFlags::empty(),
        ..Default::default()
    };
    let entry = &module.entry_points[0];
    let pipeline =
        glsl::PipelineOptions { shader_stage: entry.stage, entry_point: entry.name.clone(), multiview: None };
    let mut text = String::new();
    glsl::Writer::new(
        &mut text,
        &module,
        &info,
        &options,
        &pipeline,
        naga::proc::BoundsCheckPolicies::default(),
    )
    .unwrap()
    .write()
    .unwrap();
    let text = split_outputs(&text).unwrap();
    let found = struct_values(&text);
    assert!(found.is_empty(), "{found:?} in\n{text}");
    text
}

const BLOCK: &str = "
struct Medium { gas: vec3f, radius: f32, unused: f32 }
struct Frame { medium: Medium, height: f32, rows: array<vec4f, 2> }
@group(0) @binding(0) var<uniform> frame: Frame;
";

/// GLSL of a fragment shader, from the block above, functions, and the body of its entry point.
fn fragment(functions: &str, body: &str) -> String {
    translated(&format!(
        "{BLOCK}{functions}\n@fragment fn main(@location(0) at: vec2f) -> @location(0) vec4f {{\n{body}\n}}"
    ))
}

/// The lines of a function without indentation.
fn function<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let lines = text.lines().skip_while(|l| !l.contains(&format!(" {name}(")) || !l.ends_with('{'));
    let lines: Vec<_> = lines.take_while(|l| *l != "}").map(str::trim).collect();
    assert!(!lines.is_empty(), "no {name} in\n{text}");
    lines
}

#[test]
fn arguments_are_handed_over_member_by_member_and_only_what_is_read() {
    let text = fragment(
        "fn inner(m: Medium, k: f32) -> f32 { return m.radius * k; }
         fn outer(f: Frame, k: f32) -> f32 { return inner(f.medium, f.height) + f.rows[1].x + k; }",
        "return vec4f(outer(frame, at.x));",
    );
    assert_eq!(function(&text, "inner")[0], "float inner(float m_radius, float k) {");
    let head = "float outer(float f_medium_radius, float f_height, vec4 f_rows[2], float k_1) {";
    assert_eq!(function(&text, "outer")[0], head);
    assert!(!text.contains("gas,") && !text.contains("unused;\n    float"), "{text}");
}

#[test]
fn a_struct_that_is_passed_on_and_returned_nested_is_flat() {
    let text = fragment(
        "struct Pair { first: Medium, second: vec2f }
         fn make(m: Medium, k: f32) -> Pair { return Pair(m, vec2f(k)); }
         fn again(m: Medium, k: f32) -> Pair { return make(m, k + 1.0); }",
        "let p = again(frame.medium, at.x); return vec4f(p.first.gas * p.second.x, p.first.radius);",
    );
    let head = "void make(vec3 m_gas, float m_radius, float k, \
                inout vec3 out_first_gas, inout float out_first_radius, inout vec2 out_second) {";
    assert_eq!(
        function(&text, "make"),
        [head, "out_first_gas = m_gas;", "out_first_radius = m_radius;", "out_second = vec2(k);"]
    );
    // What another function returns is written at once where it goes.
    let call = "make(m_gas_1, m_radius_1, (k_1 + 1.0), out_first_gas_1, out_first_radius_1, out_second_1);";
    assert_eq!(function(&text, "again")[1..], [call], "{text}");
    assert!(text.contains("vec3 p_first_gas = vec3(0.0);"), "{text}");
}

#[test]
fn members_of_variables_are_assigned_each() {
    let text = fragment(
        "fn make(k: f32) -> Medium {
             var m: Medium;
             m.gas.y = k;
             m.radius = m.gas.y + 1.0;
             return m;
         }",
        "var m = make(at.x);
         var copy = m;
         copy.gas += vec3f(1.0);
         m.gas = copy.gas;
         return vec4f(m.gas, copy.radius);",
    );
    // A variable that starts at zero still does.
    let make = function(&text, "make");
    assert_eq!(
        make[..4],
        [
            "void make(float k, inout vec3 out_gas, inout float out_radius) {",
            "out_gas = vec3(0.0);",
            "out_radius = 0.0;",
            "out_gas.y = k;"
        ]
    );
    assert!(!text.contains("_unused"), "{text}");
    let main = function(&text, "main");
    assert!(main.contains(&"make(at.x, m_gas, m_radius);"), "{text}");
    assert!(main.contains(&"vec3 copy_gas = vec3(0.0);"), "{text}");
}

#[test]
fn values_are_of_the_time_when_they_were_taken() {
    let text = fragment(
        "fn swapped(k: f32) -> Medium {
             var m = Medium(vec3f(k), 2.0 * k, 0.0);
             let before = m;
             m.radius = 7.0;
             if k > 0.5 { return before; }
             return m;
         }",
        "let m = swapped(at.x); return vec4f(m.gas, m.radius);",
    );
    let swapped = function(&text, "swapped");
    // `before` is read before the member changes, and written back after.
    let place =
        |what: &str| swapped.iter().position(|l| *l == what).unwrap_or_else(|| panic!("{what}: {text}"));
    let read = place("float before_radius = out_radius;");
    assert!(
        read < place("out_radius = 7.0;")
            && place("out_radius = 7.0;") < place("out_radius = before_radius;")
    );
}

#[test]
fn returns_in_the_middle_and_in_loops_and_switches_write_all_members() {
    let text = fragment(
        "struct Low { t: f32, x: f32 }
         fn lowest(k: f32, n: u32) -> Low {
             if k < 0.0 { return Low(0.0, k); }
             for (var i = 0u; i < n; i++) {
                 if f32(i) > k { return Low(f32(i), 1.0); }
             }
             switch n {
                 case 1u: { return Low(1.0, 2.0); }
                 case 2u, 3u: { }
                 default: { let other = Low(k, k + 1.0); return other; }
             }
             return Low(3.0, 4.0);
         }",
        "var sum = 0.0;
         for (var i = 0u; i < 4u; i++) {
             let low = lowest(at.x, i);
             if low.t > 1.0 { continue; }
             sum += low.x;
         }
         return vec4f(sum);",
    );
    let lowest = function(&text, "lowest");
    assert_eq!(lowest[0], "void lowest(float k, uint n, inout float out_t, inout float out_x) {");
    let count = |what: &str| lowest.iter().filter(|l| l.starts_with(what)).count();
    assert_eq!([count("out_t = "), count("out_x = "), count("return;")], [5, 5, 4], "{text}");
}

#[test]
fn pointers_to_structs_become_pointers_to_members() {
    let text = fragment(
        "struct Low { t: f32, x: f32 }
         fn change(p: ptr<function, Low>, q: ptr<function, f32>) { (*p).x += 1.0; *q = (*p).x; }
         fn reset(p: ptr<function, Low>) { *p = Low(1.0, 2.0); }",
        "var low: Low; var k = at.x; reset(&low); change(&low, &k); return vec4f(low.t, low.x, k, 0.0);",
    );
    assert_eq!(
        function(&text, "change")[0],
        "void change(inout float p_t, inout float p_x, inout float q) {"
    );
    assert_eq!(function(&text, "reset")[1..], ["p_t_1 = 1.0;", "p_x_1 = 2.0;"]);
    assert!(text.contains("change(low_t, low_x, k);"), "{text}");
    // What a function reads through a pointer is not what it writes as its result, even if the source says
    // so.
    let text = fragment(
        "struct Low { t: f32, x: f32 }
         fn turned(p: ptr<function, Low>) -> Low { return Low((*p).x, (*p).t); }",
        "var low = Low(at.x, at.y); low = turned(&low); return vec4f(low.t, low.x, 0.0, 0.0);",
    );
    assert!(text.contains("turned(low_t, low_x, turned_t, turned_x);"), "{text}");
}

#[test]
fn constants_and_zero_values_are_taken_apart() {
    let text = fragment(
        "struct Low { t: f32, x: vec3f }
         struct Two { low: Low, k: f32 }
         const LOW = Low(2.5, vec3f(1.0, 2.0, 3.0));
         const TWO = Two(LOW, 4.0);
         fn total(two: Two) -> f32 { return two.low.t + two.k; }",
        "var two = TWO; two.k += at.x; let none = Two();
         return vec4f(TWO.low.x * LOW.t, total(two) + total(none) + total(TWO));",
    );
    // naga numbers a name that the caller's local has, too.
    assert_eq!(function(&text, "total")[0], "float total(float two_low_t_1, float two_k_1) {", "{text}");
    assert!(text.contains("2.5") && text.contains("4.0"), "{text}");
}

#[test]
fn a_struct_of_one_member_is_returned_as_it() {
    let text = fragment(
        "struct One { x: f32 }
         fn one(k: f32) -> One { if k > 1.0 { return One(1.0); } var o: One; o.x = k; return o; }",
        "return vec4f(one(at.x).x);",
    );
    assert_eq!(function(&text, "one")[0], "float one(float k) {");
}

#[test]
fn results_that_nobody_reads_are_not_written() {
    let text = fragment(
        "struct Line { b: f32, p: f32, x: f32 }
         fn line(k: f32) -> Line { var l: Line; l.b = k; l.p = l.b * 2.0; l.x = 3.0; return l; }
         fn through(k: f32) -> Line { return line(k); }",
        "line(at.y); return vec4f(through(at.x).p);",
    );
    // b is read inside; x nowhere.
    assert_eq!(
        function(&text, "line")[0],
        "void line(float k, inout float out_b, inout float out_p) {",
        "{text}"
    );
    assert!(!text.contains("out_x"), "{text}");
}

#[test]
fn entry_points_have_an_input_and_an_output_for_each_member() {
    let io = "struct In { @builtin(position) clip: vec4f, @location(0) place: vec3f,
                   @location(1) @interpolate(flat) n: u32 }
         struct Out { @location(0) color: vec4f, @builtin(frag_depth) depth: f32 }";
    let text = translated(&format!(
        "{BLOCK}{io}
         @fragment fn main(in: In) -> Out {{
             if in.n == 3u {{
                 return Out(vec4f(f32(in.n), max(in.place.x, 1.0), 2.0, 3.0), clamp(in.clip.x, 0.0, 1.0));
             }}
             var out: Out;
             out.color = vec4f(in.place, frame.height);
             return out;
         }}"
    ));
    assert!(
        text.contains("vec3 in_place = _vs2fs_location0;") && text.contains("flat in uint _vs2fs_location1;"),
        "{text}"
    );
    let main = function(&text, "main");
    let colors = main.iter().filter(|l| l.starts_with("_fs2p_location0 = ")).count();
    assert_eq!((colors, main.iter().filter(|l| l.starts_with("gl_FragDepth = ")).count()), (2, 2), "{text}");
    assert!(!text.contains("struct Out") && !text.contains("_tmp_return"), "{text}");

    let vertex = translated(
        "struct Out { @builtin(position) clip: vec4f, @location(0) place: vec3f }
         @vertex fn main(@builtin(vertex_index) i: u32) -> Out { return Out(vec4f(f32(i)), vec3f(1.0)); }",
    );
    assert!(
        vertex.contains("gl_Position = vec4(") && vertex.contains("_vs2fs_location0 = vec3(1.0);"),
        "{vertex}"
    );
}

#[test]
fn textures_and_samplers_pass_through() {
    let text = fragment(
        "@group(0) @binding(1) var table: texture_2d<f32>;
         @group(0) @binding(2) var linear: sampler;
         struct Corner { at: vec2i, weight: vec2f }
         fn corner(at: vec2f, t: texture_2d<f32>) -> Corner {
             let size = vec2f(textureDimensions(t, 0)) * at;
             return Corner(vec2i(floor(size)), fract(size));
         }
         fn load(t: texture_2d<f32>, s: sampler, c: Corner) -> vec4f {
             return textureLoad(t, c.at + vec2i(1, 0), 0) * c.weight.x
                 + textureSampleLevel(t, s, c.weight, 0.0);
         }",
        "return load(table, linear, corner(at, table));",
    );
    assert!(function(&text, "corner")[0].ends_with("inout ivec2 out_at, inout vec2 out_weight) {"), "{text}");
}

#[test]
fn what_cannot_be_split_is_an_error_that_says_so() {
    let error = |wgsl: &str| {
        let mut module = naga::front::wgsl::parse_str(wgsl).unwrap();
        split_structs(&mut module).unwrap_err()
    };
    let main = "@fragment fn main() -> @location(0) vec4f";
    assert_eq!(
        error(&format!("struct S {{ x: f32 }} {main} {{ var s: array<S, 2>; return vec4f(s[1].x); }}")),
        "arrays of structs cannot be split: an array of S"
    );
    assert_eq!(
        error(&format!("struct S {{ x: f32 }} var<private> state: S; {main} {{ return vec4f(state.x); }}")),
        "variables of a module are split only in uniform blocks: state is a struct"
    );
    assert_eq!(
        error(&format!("fn f(x: f32) -> f32 {{ return modf(x).fract; }} {main} {{ return vec4f(f(2.5)); }}")),
        "function f: modf and frexp return structs, which cannot be split"
    );
}

#[test]
fn outputs_of_another_form_are_an_error() {
    let whole = "struct Out {\n    vec4 color;\n    float depth;\n};\nvoid main() {\n    \
                 Out _tmp_return = Out(vec4(a, b, f(c, d), e), depths[1]);\n    \
                 _fs2p_location0 = _tmp_return.color;\n    \
                 gl_FragDepth = _tmp_return.depth;\n    return;\n}\n";
    assert_eq!(
        split_outputs(whole).unwrap(),
        "void main() {\n    _fs2p_location0 = vec4(a, b, f(c, d), e);\n    gl_FragDepth = \
         depths[1];\n    return;\n}\n"
    );
    let none = "struct Frame {\n    float x;\n};\nvoid main() {\n}\n";
    assert_eq!(split_outputs(none).unwrap(), none);
    for (from, to, expected) in [
        (", depths[1])", ")", "1 values for 2 members"),
        ("gl_FragDepth = _tmp_return.depth;", "", "depth is not assigned to an output"),
        ("_tmp_return.color;", "_tmp_return.depth;", "color is not assigned to an output"),
        ("return;", "g(_tmp_return);", "Out is left: "),
        ("return;", "Out other;", "Out is left: "),
        ("struct Out {", "struct Other {", "struct Out comes after its use"),
        ("= Out(", "= make_out(", "another form"),
        ("    vec4 color;\n", "    vec4\n", "struct Out has a member of another form"),
        (
            "Out _tmp_return = Out(vec4(a, b, f(c, d), e), depths[1]);",
            "",
            "_tmp_return without its declaration",
        ),
    ] {
        assert!(whole.contains(from));
        let error = split_outputs(&whole.replace(from, to)).unwrap_err();
        assert!(error.contains(expected), "{from} -> {to}: {error}");
    }
}
