//! Takes the one struct out of a GLSL text that naga's writer makes by itself.

use super::Result;

const TEMPORARY: &str = "_tmp_return";

/// Assigns an entry point's outputs one by one. naga writes what returns several as
///
/// ```glsl
/// struct Shaded {
///     vec4 color;
///     float depth;
/// };
/// ...
///     Shaded _tmp_return = Shaded(a, b);
///     _fs2p_location0 = _tmp_return.color;
///     gl_FragDepth = _tmp_return.depth;
/// ```
///
/// of which `_fs2p_location0 = a;` and `gl_FragDepth = b;` are left. A text without it stays as it is.
///
/// # Errors
/// A text that says where the form is not this one.
pub fn split_outputs(text: &str) -> Result<String> {
    let Some(name) = text.lines().find_map(declared) else {
        return if text.contains(TEMPORARY) {
            Err(format!("{TEMPORARY} without its declaration"))
        } else {
            Ok(text.into())
        };
    };
    let head = format!("struct {name} {{");
    let mut lines = text.lines().peekable();
    let mut out = String::with_capacity(text.len());
    let mut members = None;
    while let Some(line) = lines.next() {
        if line == head {
            let mut own = Vec::new();
            loop {
                let line = lines.next().ok_or_else(|| format!("struct {name} does not end"))?;
                if line == "};" {
                    break;
                }
                let member = line.trim().strip_suffix(';').and_then(|l| l.split_once(' '));
                own.push(
                    member.ok_or_else(|| format!("struct {name} has a member of another form: {line}"))?.1,
                );
            }
            members = Some(own);
        } else if declared(line) == Some(name) {
            let members = members.as_ref().ok_or_else(|| format!("struct {name} comes after its use"))?;
            let inner = line.trim().strip_prefix(&format!("{name} {TEMPORARY} = {name}("));
            let inner =
                inner.and_then(|l| l.strip_suffix(");")).ok_or_else(|| format!("another form: {line}"))?;
            let values = arguments(inner);
            if values.len() != members.len() {
                return Err(format!("{} values for {} members: {line}", values.len(), members.len()));
            }
            let indent = &line[..line.len() - line.trim_start().len()];
            for (member, value) in members.iter().zip(values) {
                let next = lines.next().unwrap_or_default();
                let output = next.trim().strip_suffix(&format!(" = {TEMPORARY}.{member};"));
                let output =
                    output.ok_or_else(|| format!("{member} is not assigned to an output: {next}"))?;
                out += &format!("{indent}{output} = {value};\n");
            }
        } else {
            out += line;
            out += "\n";
        }
    }
    let left = out.lines().find(|l| words(l).any(|word| word == TEMPORARY || word == name));
    left.map_or(Ok(out.clone()), |line| Err(format!("{name} is left: {line}")))
}

/// The struct of a line that declares the temporary.
fn declared(line: &str) -> Option<&str> {
    let (name, rest) = line.trim_start().split_once(' ')?;
    rest.strip_prefix(TEMPORARY)?.starts_with(" = ").then_some(name)
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}

/// A list cut at the commas that stand in no brackets.
fn arguments(list: &str) -> Vec<&str> {
    let (mut depth, mut start) = (0, 0);
    let mut out = Vec::new();
    for (i, c) in list.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                out.push(list[start..i].trim());
                start = i + 1;
            }
            _ => {}
        }
    }
    out.push(list[start..].trim());
    out
}
