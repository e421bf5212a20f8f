//! naga's GLSL as a person would write it: naga gives every value that it loads, samples or calls for a name
//! and a line, spells `&&` out as branches, and puts parentheses around every operation. None of that is
//! needed, and a browser's module carries all of it. No operation changes, nor the order of any two.

use super::translate::{is_word, words};

/// A function's lines without indentation, shorter.
pub fn tidy(lines: &[&str]) -> Vec<String> {
    let mut lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
    while join_branches(&mut lines)
        || use_last_copies(&mut lines)
        || declare_late(&mut lines)
        || inline_values(&mut lines)
    {}
    lines[1..].iter_mut().for_each(|line| *line = without_parentheses(line));
    lines
}

/// Type, name and value of a declaration.
fn declaration(line: &str) -> Option<(&str, &str, &str)> {
    let (head, value) = line.strip_suffix(';')?.split_once(" = ")?;
    let (kind, name) = head.split_once(' ')?;
    (kind.chars().all(is_word) && name.chars().all(is_word)).then_some((kind, name, value))
}

/// Name and value of an assignment to a whole variable.
fn assignment(line: &str) -> Option<(&str, &str)> {
    let (name, value) = line.strip_suffix(';')?.split_once(" = ")?;
    name.chars().all(is_word).then_some((name, value))
}

/// How often a text has a variable.
fn count(text: &str, name: &str) -> usize {
    words(text).filter(|(word, member)| *word == name && !member).count()
}

/// How often lines have a variable.
fn count_in(lines: &[String], name: &str) -> usize {
    lines.iter().map(|line| count(line, name)).sum()
}

/// A text with something else in place of a variable.
fn replaced(text: &str, name: &str, with: &str) -> String {
    let (mut out, mut rest) = (String::new(), text);
    for (word, member) in words(text) {
        let (before, tail) = rest.split_once(word).unwrap_or((rest, ""));
        out += before;
        out += if word == name && !member { with } else { word };
        rest = tail;
    }
    out + rest
}

/// How many blocks a line opens, less those it closes.
fn opened(line: &str) -> isize {
    line.chars().map(|c| isize::from(c == '{') - isize::from(c == '}')).sum()
}

/// `if (a) { x = b; } else { x = false; }` is `x = a && b`, and the like with `true` is `x = !a || b`.
fn join_branches(lines: &mut Vec<String>) -> bool {
    for i in 0..lines.len().saturating_sub(4) {
        let joined = || {
            let condition = lines[i].strip_prefix("if (")?.strip_suffix(") {")?;
            let (name, value) = assignment(&lines[i + 1])?;
            let (other, constant) = assignment(&lines[i + 3])?;
            if lines[i + 2] != "} else {" || lines[i + 4] != "}" || name != other {
                return None;
            }
            match constant {
                "false" => Some(format!("{name} = (({condition}) && ({value}));")),
                "true" => {
                    let condition = condition.strip_prefix("!(")?.strip_suffix(')')?;
                    Some(format!("{name} = (({condition}) || ({value}));"))
                }
                _ => None,
            }
        };
        if let Some(line) = joined() {
            lines.splice(i..i + 5, [line]);
            return true;
        }
    }
    false
}

/// `float b = a;`, where nothing asks for the function's own variable `a` any more, makes `b` another name.
fn use_last_copies(lines: &mut Vec<String>) -> bool {
    for i in 1..lines.len() {
        let Some((_, copy, variable)) = declaration(&lines[i]) else { continue };
        let own =
            lines[1..i].iter().any(|line| declaration(line).is_some_and(|(_, name, _)| name == variable));
        if own && count_in(&lines[i + 1..], variable) == 0 && !in_loop(&lines[..i]) {
            let (copy, variable) = (copy.to_owned(), variable.to_owned());
            lines.remove(i);
            lines[i..].iter_mut().for_each(|line| *line = replaced(line, &copy, &variable));
            return true;
        }
    }
    false
}

/// Whether lines end within a loop.
fn in_loop(lines: &[String]) -> bool {
    let mut depth = 0;
    // From the end: a line that opens a block which is not closed behind it encloses the end.
    lines.iter().rev().any(|line| {
        depth += opened(line);
        let encloses = depth > 0;
        depth = depth.min(0);
        encloses && line.starts_with("while")
    })
}

/// `bool a = false;` and, in the same block and before any other use, `a = …;` is `bool a = …;` there.
fn declare_late(lines: &mut Vec<String>) -> bool {
    for i in 1..lines.len() {
        let Some((kind, name, _)) = declaration(&lines[i]) else { continue };
        let Some(next) = (i + 1..lines.len()).find(|&j| count(&lines[j], name) > 0) else { continue };
        let mut depth = 0;
        let inside = lines[i + 1..next].iter().all(|line| {
            depth += opened(line);
            depth >= 0 && !(depth == 0 && line.starts_with('}') && line.ends_with('{'))
        });
        let Some((assigned, value)) = assignment(&lines[next]) else { continue };
        if inside && depth == 0 && assigned == name && count(value, name) == 0 {
            let line = format!("{kind} {name} = {value};");
            lines[next] = line;
            lines.remove(i);
            return true;
        }
    }
    false
}

/// A value that the next line alone asks for, and once, stands there. naga's functions that answer a value
/// change nothing else; what a line assigns to, it does after all the reading. A call that answers nothing is
/// left as it is: it may want a variable to write to.
fn inline_values(lines: &mut Vec<String>) -> bool {
    for i in (1..lines.len() - 1).rev() {
        let Some((_, name, value)) = declaration(&lines[i]) else { continue };
        let next = &lines[i + 1];
        let call = next.split('(').next().is_some_and(|head| head != "switch" && head.chars().all(is_word));
        let written = words(next).next().is_some_and(|(word, _)| word == name);
        if call || written || count(next, name) != 1 || count_in(&lines[i + 2..], name) != 0 {
            continue;
        }
        let line = replaced(next, name, &format!("({value})"));
        lines[i + 1] = line;
        lines.remove(i);
        return true;
    }
    false
}

/// How tightly operators bind, the loosest first; what is no operator binds tightest.
const OPERATORS: [&[&str]; 12] = [
    &["?", ":"],
    &["||"],
    &["^^"],
    &["&&"],
    &["|"],
    &["^"],
    &["&"],
    &["==", "!="],
    &["<", ">", "<=", ">="],
    &["<<", ">>"],
    &["+", "-"],
    &["*", "/", "%"],
];
const UNARY: usize = OPERATORS.len();
const PRIMARY: usize = UNARY + 1;

fn tightness(operator: &str) -> Option<usize> {
    OPERATORS.iter().position(|operators| operators.contains(&operator))
}

/// A line without the parentheses that change nothing. naga puts spaces around every operator of two
/// operands, and none behind one of one operand.
fn without_parentheses(line: &str) -> String {
    let mut line = line.to_owned();
    let mut at = 0;
    while let Some(start) = line[at..].find('(').map(|i| at + i) {
        at = start + 1;
        let Some(end) = closing(&line, start) else { return line };
        let (before, inner, after) = (&line[..start], &line[start + 1..end], &line[end + 1..]);
        // A call, or a statement that wants them.
        let called = before.ends_with(|c: char| is_word(c) || c == ']');
        if called || before.ends_with("if ") {
            continue;
        }
        let Some(loosest) = loosest(inner) else { continue };
        let (mut left, mut right) = (None, None);
        if before.ends_with(['-', '!', '~']) {
            left = Some(UNARY);
        } else if let Some(text) = before.strip_suffix(' ') {
            left = text.rsplit(' ').next().and_then(tightness);
        }
        if after.starts_with(['.', '[']) {
            right = Some(PRIMARY);
        } else if let Some(text) = after.strip_prefix(' ') {
            right = text.split(' ').next().and_then(tightness);
        }
        // What stands on the right of `-` or `?` must bind tighter, for operators are joined from the left.
        let fits = left.is_none_or(|left| loosest > left)
            && right.is_none_or(|right| loosest >= right && loosest > 0);
        if fits {
            line = [before, inner, after].concat();
            at = start;
        }
    }
    line
}

/// Where the parenthesis that opens there is closed.
fn closing(line: &str, start: usize) -> Option<usize> {
    let mut depth = 0;
    for (i, c) in line[start..].char_indices() {
        depth += isize::from(c == '(') - isize::from(c == ')');
        if depth == 0 {
            return Some(start + i);
        }
    }
    None
}

/// How tightly the loosest operator outside of parentheses binds; none for a list.
fn loosest(text: &str) -> Option<usize> {
    let mut loosest = if text.starts_with(['-', '!', '~']) { UNARY } else { PRIMARY };
    let mut depth = 0;
    for token in text.split(' ') {
        if depth == 0 {
            loosest = loosest.min(tightness(token).unwrap_or(PRIMARY));
        }
        for c in token.chars() {
            depth += isize::from(matches!(c, '(' | '[')) - isize::from(matches!(c, ')' | ']'));
            if depth == 0 && c == ',' {
                return None;
            }
        }
    }
    Some(loosest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parentheses_stay_where_they_change_the_value() {
        for (text, bare) in [
            ("x = ((a + b) + c);", "x = a + b + c;"),
            ("x = (a + (b + c));", "x = a + (b + c);"),
            ("x = (a - (b - c));", "x = a - (b - c);"),
            ("x = ((a * b) - (c / d));", "x = a * b - c / d;"),
            ("x = ((a + b) * (c - d));", "x = (a + b) * (c - d);"),
            ("x = (a / (b * c));", "x = a / (b * c);"),
            ("x = -((a + b));", "x = -(a + b);"),
            ("x = -((b));", "x = -b;"),
            ("x = (a - (-(b)));", "x = a - -b;"),
            ("x = (a + b).xy;", "x = (a + b).xy;"),
            ("x = f((a), (b + 1.0));", "x = f(a, b + 1.0);"),
            ("x = (((a < b)) ? (c ? d : e) : (f + g));", "x = a < b ? (c ? d : e) : f + g;"),
            ("x = ((a && b) || (c && (d || e)));", "x = a && b || c && (d || e);"),
            ("x = (((a & 1u) == 0u) ? vec2(b, (c)) : d);", "x = (a & 1u) == 0u ? vec2(b, c) : d;"),
            ("if ((a >= (b))) {", "if (a >= b) {"),
            ("return (a[(i + 1)] * 2.0);", "return a[i + 1] * 2.0;"),
        ] {
            assert_eq!(without_parentheses(text), bare);
        }
    }

    #[test]
    fn values_stand_where_they_are_asked_for() {
        let check = |lines: &[&str], short: &[&str]| assert_eq!(tidy(lines), short);
        check(
            &["float f(float a) {", "float _e1 = g(a);", "float _e2 = h(_e1);", "return (_e2 * a);", "}"],
            &["float f(float a) {", "return h(g(a)) * a;", "}"],
        );
        // Twice, past a line, and as what is written to.
        for lines in [
            ["void f(inout float a) {", "float b = g(a);", "a = b * b;", "}"].as_slice(),
            &["void f(inout float a) {", "float b = a;", "a = 1.0;", "g(b);", "a = b;", "}"],
            &["void f(inout float a) {", "float b = 0.0;", "g(a, b);", "}"],
            &["void f(inout float a) {", "float b = a;", "b.x = a;", "}"],
            &["void f(inout bool a) {", "bool b = a;", "while(true) {", "if (b) {", "break;", "}", "}", "}"],
        ] {
            check(lines, lines);
        }
        // The last to ask for `b`, and not: in a loop, it comes around again.
        check(
            &["void f(inout float a) {", "float b = 0.0;", "g(b);", "float c = b;", "h(c);", "a = c;", "}"],
            &["void f(inout float a) {", "float b = 0.0;", "g(b);", "h(b);", "a = b;", "}"],
        );
        let turns = [
            "void f(inout float a) {",
            "float b = 0.0;",
            "while(true) {",
            "g(b);",
            "float c = b;",
            "h(c);",
            "a = c;",
            "}",
            "}",
        ];
        check(&turns, &turns);
    }

    #[test]
    fn branches_are_operators_again() {
        let lines = [
            "float f(float a, bool c) {",
            "bool local = false;",
            "bool local_1 = false;",
            "if ((a < 0.0)) {",
            "bool _e1 = g(a);",
            "local = _e1;",
            "} else {",
            "local = false;",
            "}",
            "bool _e2 = local;",
            "if (!(c)) {",
            "local_1 = _e2;",
            "} else {",
            "local_1 = true;",
            "}",
            "bool _e3 = local_1;",
            "if (_e3) {",
            "return 1.0;",
            "}",
            "return a;",
            "}",
        ];
        let short = [
            "float f(float a, bool c) {",
            "if (c || a < 0.0 && g(a)) {",
            "return 1.0;",
            "}",
            "return a;",
            "}",
        ];
        assert_eq!(tidy(&lines), short);
    }
}
