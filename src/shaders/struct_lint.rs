//! Finds struct values in a GLSL text: [`super::split_structs`] says why a shipped shader must hold none.
//!
//! It reads the text, not the module that it was made of, so that it also sees what naga's writer adds.

use std::collections::HashMap;

/// A place in a GLSL text where a struct is more than the form of a uniform block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StructValue {
    /// Line of the text, counted from 1.
    pub line: usize,
    /// What is wrong there.
    pub what: String,
}

impl std::fmt::Display for StructValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {}: {}", self.line, self.what)
    }
}

/// Every struct value of every text, each with the text's name: empty where all is well.
pub fn struct_values_of<'a>(
    texts: impl IntoIterator<Item = (&'a str, &'a str)>,
) -> impl Iterator<Item = (&'a str, StructValue)> {
    texts.into_iter().flat_map(|(name, text)| struct_values(text).into_iter().map(move |found| (name, found)))
}

/// Every struct value of a GLSL ES 3.00 text, in its order: a declaration, argument, result or constructor
/// whose type is a struct; a struct inside a function; a uniform block's struct that is read as a whole.
/// Structs may only be declared, be members of structs and be members of uniform blocks. What would hide one
/// from this is found too: a macro, a struct without a name or with a variable behind it.
pub fn struct_values(text: &str) -> Vec<StructValue> {
    let tokens = tokens(text);
    let mut lint =
        Lint { tokens: &tokens, structs: HashMap::new(), blocks: HashMap::new(), found: Vec::new() };
    lint.run();
    lint.found
}

/// A word, number or sign, and its line.
struct Token<'a> {
    text: &'a str,
    line: usize,
}

fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut out = Vec::new();
    let mut comment = false;
    for (line, mut rest) in (1..).zip(text.lines()) {
        loop {
            if comment {
                let Some(end) = rest.find("*/") else { break };
                rest = &rest[end + 2..];
                comment = false;
            }
            rest = rest.trim_start();
            if rest.starts_with("//") {
                break;
            }
            if let Some(tail) = rest.strip_prefix("/*") {
                (comment, rest) = (true, tail);
                continue;
            }
            let Some(first) = rest.chars().next() else { break };
            // A directive is one token.
            let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
            let length = match first {
                '#' => rest.len(),
                c if word(c) => rest.find(|c| !word(c)).unwrap_or(rest.len()),
                c => c.len_utf8(),
            };
            out.push(Token { text: &rest[..length], line });
            rest = &rest[length..];
        }
    }
    out
}

struct Lint<'a> {
    tokens: &'a [Token<'a>],
    /// Members of each struct: name and type.
    structs: HashMap<&'a str, HashMap<&'a str, &'a str>>,
    /// Variables that a uniform block declares, and their types.
    blocks: HashMap<&'a str, &'a str>,
    found: Vec<StructValue>,
}

impl<'a> Lint<'a> {
    fn text(&self, at: usize) -> &'a str {
        self.tokens.get(at).map_or("", |token| token.text)
    }

    fn report(&mut self, at: usize, what: String) {
        let line = self.tokens.get(at).or(self.tokens.last()).map_or(1, |token| token.line);
        self.found.push(StructValue { line, what });
    }

    fn run(&mut self) {
        let (mut at, mut depth) = (0, 0);
        while at < self.tokens.len() {
            match self.text(at) {
                "struct" if depth == 0 => at = self.declaration(at),
                "struct" => {
                    self.report(at, "a struct inside a function".into());
                    at += 1;
                }
                "uniform" if depth == 0 && self.text(at + 2) == "{" => at = self.block(at),
                token => {
                    depth += i32::from(token == "{") - i32::from(token == "}");
                    at = self.other(at);
                }
            }
        }
    }

    /// `struct Name { … };`. Where it ends.
    fn declaration(&mut self, at: usize) -> usize {
        let name = self.text(at + 1);
        if self.text(at + 2) != "{" {
            self.report(at, "a struct without a name".into());
            return at + 1;
        }
        let (members, end) = self.members(at + 3);
        self.structs.insert(name, members);
        if self.text(end) != ";" {
            self.report(end, format!("a variable behind the struct {name}"));
        }
        end
    }

    /// `uniform Name { … } variable;` or `uniform Name { … };`. Where it ends.
    fn block(&mut self, at: usize) -> usize {
        let (members, end) = self.members(at + 3);
        if self.text(end) == ";" {
            self.blocks.extend(members);
        } else {
            self.structs.insert(self.text(at + 1), members);
            self.blocks.insert(self.text(end), self.text(at + 1));
        }
        end + 1
    }

    /// Members up to the closing brace, and what follows it.
    fn members(&self, mut at: usize) -> (HashMap<&'a str, &'a str>, usize) {
        let mut members = HashMap::new();
        while at < self.tokens.len() && self.text(at) != "}" {
            // The type stands before the name, behind qualifiers; an array's size behind it.
            let end = (at..self.tokens.len()).find(|&i| matches!(self.text(i), ";" | "[")).unwrap_or(at);
            let after = (end..self.tokens.len()).find(|&i| self.text(i) == ";").unwrap_or(self.tokens.len());
            if end >= at + 2 {
                members.insert(self.text(end - 1), self.text(end - 2));
            }
            at = after + 1;
        }
        (members, at + 1)
    }

    /// A token outside declarations. Where the next one is.
    fn other(&mut self, at: usize) -> usize {
        let token = self.text(at);
        if token.starts_with('#') && !(token.starts_with("#version ") || token.starts_with("#extension ")) {
            self.report(at, format!("a directive that may hide a struct: {token}"));
        }
        // What stands behind a dot is a member, whatever it is called.
        let member = at > 0 && self.text(at - 1) == ".";
        if member {
            return at + 1;
        }
        if self.structs.contains_key(token) {
            let what = match (self.text(at + 1), self.text(at + 2)) {
                ("(" | "[", _) => format!("a value of struct {token} is made"),
                (name, "(") => format!("{name} returns struct {token}"),
                (name, _) => format!("{name} is of struct {token}"),
            };
            self.report(at, what);
        }
        let Some(mut ty) = self.blocks.get(token).copied() else { return at + 1 };
        let mut path = token.to_owned();
        let mut end = at + 1;
        while self.text(end) == "."
            && let Some(members) = self.structs.get(ty)
        {
            let name = self.text(end + 1);
            path += ".";
            path += name;
            ty = members.get(name).copied().unwrap_or_default();
            end += 2;
        }
        if self.structs.contains_key(ty) {
            self.report(at, format!("{path} is read as a whole, struct {ty}"));
        }
        end
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "#version 300 es
precision highp float;
struct Medium {
    vec3 gas;
    float radius;
};
struct Frame {
    Medium medium;
    float h[2];
};
layout(std140) uniform Frame_block { Frame block; };
";

    /// What is found in lines that follow the head, the first of which is line 12.
    fn found(lines: &str) -> Vec<String> {
        struct_values(&format!("{HEAD}{lines}")).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_block_and_its_members_are_no_struct_values() {
        let text = "// Medium m = block.medium;
/* Frame
   f; */
float f(float Medium_radius, inout float r) {
    vec3 gas = block.medium.gas;
    r = block.medium.radius * block.h[1] + gas.x;
    return r;
}
";
        assert_eq!(found(text), [""; 0]);
        assert_eq!(
            found("uniform Other { Medium inner; float x; };\nfloat f() { return inner.radius + x; }\n"),
            [""; 0]
        );
    }

    #[test]
    fn every_struct_value_is_found_with_its_line() {
        for (text, expected) in [
            ("float f(Medium m) { return m.radius; }", "line 12: m is of struct Medium"),
            ("\nMedium f() { discard; }", "line 13: f returns struct Medium"),
            ("void f() {\n    Medium m;\n}", "line 13: m is of struct Medium"),
            ("void f() {\n    highp Medium m[2];\n}", "line 13: m is of struct Medium"),
            ("void f() {\n\n    g(Medium(vec3(0.0), 1.0));\n}", "line 14: a value of struct Medium is made"),
            ("void f() { g(Medium[2](a, b)); }", "line 12: a value of struct Medium is made"),
            ("const Medium EARTH = x;", "line 12: EARTH is of struct Medium"),
            ("uniform Medium m;", "line 12: m is of struct Medium"),
            ("in Medium m;", "line 12: m is of struct Medium"),
            ("void f() { g(block.medium); }", "line 12: block.medium is read as a whole, struct Medium"),
            ("void f() { g(block); }", "line 12: block is read as a whole, struct Frame"),
            (
                "uniform B { Medium inner; };\nvoid f() { g(inner); }",
                "line 13: inner is read as a whole, struct Medium",
            ),
            ("struct Late { float x; } late;", "line 12: a variable behind the struct Late"),
            ("struct { float x; } late;", "line 12: a struct without a name"),
            ("void f() {\n    struct Inner { float x; };\n}", "line 13: a struct inside a function"),
            ("#define M Medium", "line 12: a directive that may hide a struct: #define M Medium"),
        ] {
            assert_eq!(found(text).first().map(String::as_str), Some(expected), "{text}");
        }
        let texts = [("good", HEAD), ("bad", "struct S { float x; };\nS f() { return S(1.0); }")];
        let all: Vec<_> = struct_values_of(texts).map(|(name, found)| format!("{name}: {found}")).collect();
        assert_eq!(all, ["bad: line 2: f returns struct S", "bad: line 2: a value of struct S is made"]);
    }
}
