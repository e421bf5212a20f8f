//! Splits every struct value of a naga module into scalars, vectors and matrices, so that no GLSL struct but
//! the uniform block is left in what a driver compiles.
//!
//! Common phone GPUs (Adreno up to the 6xx) keep the members of GLSL structs in 16 bits in WebGL, whatever
//! `highp` says: [KhronosGroup/WebGL#3351], [three.js#26805], and vello, which met the same on Android
//! ([vello#1604], [vello#1659]). The geometry here carries r² − R² up to 10⁷ km², which 16 bits cannot hold
//! (their largest number is 65504), and no desktop or software driver shows the fault. The WGSL keeps its
//! structs, for people; [`split_structs`] takes them out on the way to GLSL:
//!
//! * an argument becomes one argument a member, nested structs flattened, and a member that a function does
//!   not read is not handed to it;
//! * a local variable becomes one variable a member;
//! * a returned struct becomes arguments that the function writes (`ptr<function, T>`, GLSL's `inout`);
//! * what is loaded from a uniform block is loaded member by member.
//!
//! The operations and their order stay as they are, so that numbers are the same bit for bit. naga's writer
//! makes one more struct by itself, for an entry point with several outputs: [`split_outputs`] takes it out
//! of the text. [`super::struct_lint`] proves on the text that nothing was missed.
//!
//! [KhronosGroup/WebGL#3351]: https://github.com/KhronosGroup/WebGL/issues/3351
//! [three.js#26805]: https://github.com/mrdoob/three.js/issues/26805
//! [vello#1604]: https://github.com/linebender/vello/issues/1604
//! [vello#1659]: https://github.com/linebender/vello/issues/1659

mod outputs;
mod prune;
mod rewrite;

use std::collections::HashMap;

use naga::{
    AddressSpace, Binding, Constant, Expression, Function, GlobalVariable, Handle, MathFunction, Module,
    Span, Type, TypeInner, UniqueArena,
};

pub use outputs::split_outputs;
use prune::Facts;

type Result<T> = std::result::Result<T, String>;

/// Takes struct values out of a module, see the [module](self). The module is compacted: what was not used is
/// gone from it. It is valid if it was valid before.
///
/// # Errors
/// A text that says what the pass does not handle: arrays of structs, structs in private or workgroup
/// variables, `modf` and `frexp` (whose results are structs), and statements that no WebGL2 shader can have.
pub fn split_structs(module: &mut Module) -> Result<()> {
    refuse(module)?;
    let mut known = Known {
        names: module.functions.iter().map(|(h, f)| (h, f.name.clone().unwrap_or_default())).collect(),
        globals: module.global_variables.iter().map(|(h, global)| (h, global.ty)).collect(),
        constants: split_constants(module),
        results: HashMap::new(),
    };
    let mut facts = Facts::default();
    let Module { types, functions, entry_points, .. } = module;
    // A function calls only those before it.
    for (handle, function) in functions.iter_mut() {
        let name = |e| format!("function {}: {e}", known.names[&handle]);
        let old = std::mem::take(function);
        let (new, own) = rewrite::rewrite(types, &known, &old, false).map_err(name)?;
        if let Some(result) = &old.result
            && let shape @ Tree::Members(_) = shape(types, result.ty)
        {
            known.results.insert(handle, shape);
        }
        *function = new;
        facts.functions.insert(handle, own);
    }
    for entry in entry_points.iter_mut() {
        let old = std::mem::take(&mut entry.function);
        let (new, own) = rewrite::rewrite(types, &known, &old, true)
            .map_err(|e| format!("entry point {}: {e}", entry.name))?;
        entry.function = new;
        facts.entry_points.push(own);
    }
    prune::prune(module, facts)?;
    naga::compact::compact(module, naga::compact::KeepUnused::No);
    Ok(())
}

/// What the functions of a module share.
struct Known {
    names: HashMap<Handle<Function>, String>,
    /// Types of the module's variables.
    globals: HashMap<Handle<GlobalVariable>, Handle<Type>>,
    /// Of constants that are structs, a constant for each member.
    constants: HashMap<Handle<Constant>, Tree<Handle<Constant>>>,
    /// What is returned by those functions that return structs and are split.
    results: HashMap<Handle<Function>, Tree<Member>>,
}

/// Errors for what no shader here has.
fn refuse(module: &Module) -> Result<()> {
    let is_struct = |ty: Handle<Type>| matches!(module.types[ty].inner, TypeInner::Struct { .. });
    for (_, ty) in module.types.iter() {
        if let TypeInner::Array { base, .. } | TypeInner::BindingArray { base, .. } = ty.inner
            && is_struct(base)
        {
            let name = module.types[base].name.as_deref().unwrap_or("a struct");
            return Err(format!("arrays of structs cannot be split: an array of {name}"));
        }
    }
    for (_, variable) in module.global_variables.iter() {
        if variable.space != AddressSpace::Uniform && is_struct(variable.ty) {
            let name = variable.name.as_deref().unwrap_or("one");
            return Err(format!(
                "variables of a module are split only in uniform blocks: {name} is a struct"
            ));
        }
    }
    Ok(())
}

/// A value of any type as its members, down to what is no struct.
#[derive(Clone, Debug)]
enum Tree<T> {
    Leaf(T),
    /// Each with its name.
    Members(Vec<(String, Tree<T>)>),
}

impl<T> Tree<T> {
    fn map<U>(&self, f: &mut dyn FnMut(&T) -> U) -> Tree<U> {
        match self {
            Self::Leaf(leaf) => Tree::Leaf(f(leaf)),
            Self::Members(members) => {
                Tree::Members(members.iter().map(|(n, m)| (n.clone(), m.map(f))).collect())
            }
        }
    }

    fn leaves(&self) -> Vec<&T> {
        match self {
            Self::Leaf(leaf) => vec![leaf],
            Self::Members(members) => members.iter().flat_map(|(_, member)| member.leaves()).collect(),
        }
    }

    /// The leaves with their names, those of the structs around them in front, and `base` before all.
    fn named(&self, base: &str) -> Vec<(String, &T)> {
        match self {
            Self::Leaf(leaf) => vec![(base.to_owned(), leaf)],
            Self::Members(members) => {
                members.iter().flat_map(|(name, member)| member.named(&joined(base, name))).collect()
            }
        }
    }
}

impl<T: Clone> Tree<Option<T>> {
    /// `None` if any leaf is missing.
    fn complete(&self) -> Option<Tree<T>> {
        Some(match self {
            Self::Leaf(leaf) => Tree::Leaf(leaf.clone()?),
            Self::Members(members) => {
                let whole = members.iter().map(|(name, member)| Some((name.clone(), member.complete()?)));
                Tree::Members(whole.collect::<Option<_>>()?)
            }
        })
    }
}

/// A member's name behind that of its struct.
fn joined(base: &str, name: &str) -> String {
    match (base, name) {
        (base, "") => base.to_owned(),
        ("", name) => name.to_owned(),
        (base, name) => format!("{base}_{name}"),
    }
}

fn member_name(member: &naga::StructMember) -> String {
    member.name.clone().unwrap_or_else(|| "member".into())
}

/// A member that is no struct.
#[derive(Clone, Debug)]
struct Member {
    /// Its name behind those of the structs around it, `_` between them; empty for what is no struct.
    path: String,
    ty: Handle<Type>,
    binding: Option<Binding>,
}

fn shape(types: &UniqueArena<Type>, ty: Handle<Type>) -> Tree<Member> {
    fn walk(
        types: &UniqueArena<Type>,
        ty: Handle<Type>,
        path: &str,
        binding: Option<&Binding>,
    ) -> Tree<Member> {
        let TypeInner::Struct { members, .. } = &types[ty].inner else {
            return Tree::Leaf(Member { path: path.to_owned(), ty, binding: binding.cloned() });
        };
        let member = |m: &naga::StructMember| {
            let name = member_name(m);
            let tree = walk(types, m.ty, &joined(path, &name), m.binding.as_ref());
            (name, tree)
        };
        Tree::Members(members.iter().map(member).collect())
    }
    walk(types, ty, "", None)
}

/// A constant for each member of those constants that are structs.
fn split_constants(module: &mut Module) -> HashMap<Handle<Constant>, Tree<Handle<Constant>>> {
    let mut split = HashMap::new();
    let old: Vec<_> = module.constants.iter().map(|(handle, constant)| (handle, constant.clone())).collect();
    for (handle, constant) in old {
        let Tree::Members(_) = shape(&module.types, constant.ty) else { continue };
        let tree = constant_members(module, constant.init, constant.name.as_deref(), constant.ty, "");
        split.insert(handle, tree);
        // naga writes every constant that has a name.
        module.constants.get_mut(handle).name = None;
    }
    split
}

fn constant_members(
    module: &mut Module,
    init: Handle<Expression>,
    name: Option<&str>,
    ty: Handle<Type>,
    path: &str,
) -> Tree<Handle<Constant>> {
    let TypeInner::Struct { members, .. } = module.types[ty].inner.clone() else {
        let name = name.map(|n| format!("{n}{path}"));
        return Tree::Leaf(module.constants.append(Constant { name, ty, init }, Span::UNDEFINED));
    };
    // A constant of a constant has its members.
    let mut source = init;
    while let Expression::Constant(other) = module.global_expressions[source] {
        source = module.constants[other].init;
    }
    let components = match &module.global_expressions[source] {
        Expression::Compose { components, .. } => Some(components.clone()),
        _ => None,
    };
    let mut out = Vec::new();
    for (i, member) in members.iter().enumerate() {
        let own = member_name(member);
        let path = format!("{path}_{own}");
        // Else it is a zero value: constant expressions have no other structs.
        let init = match &components {
            Some(components) => components[i],
            None => module.global_expressions.append(Expression::ZeroValue(member.ty), Span::UNDEFINED),
        };
        out.push((own, constant_members(module, init, name, member.ty, &path)));
    }
    Tree::Members(out)
}

/// Calls `f` with each operand of an expression.
///
/// # Errors
/// For expressions that no WebGL2 shader has.
fn operands(expression: &mut Expression, f: &mut dyn FnMut(&mut Handle<Expression>)) -> Result<()> {
    use naga::{ImageQuery, SampleLevel};
    match expression {
        Expression::Literal(_)
        | Expression::Constant(_)
        | Expression::ZeroValue(_)
        | Expression::FunctionArgument(_)
        | Expression::GlobalVariable(_)
        | Expression::LocalVariable(_)
        | Expression::CallResult(_) => {}
        Expression::Compose { components, .. } => components.iter_mut().for_each(f),
        Expression::Access { base, index } => [base, index].into_iter().for_each(f),
        Expression::AccessIndex { base: one, .. }
        | Expression::Splat { value: one, .. }
        | Expression::Swizzle { vector: one, .. }
        | Expression::Load { pointer: one }
        | Expression::Unary { expr: one, .. }
        | Expression::Derivative { expr: one, .. }
        | Expression::Relational { argument: one, .. }
        | Expression::As { expr: one, .. } => f(one),
        Expression::Binary { left, right, .. } => [left, right].into_iter().for_each(f),
        Expression::Select { condition, accept, reject } => {
            [condition, accept, reject].into_iter().for_each(f)
        }
        Expression::Math { fun: MathFunction::Modf | MathFunction::Frexp, .. } => {
            return Err("modf and frexp return structs, which cannot be split".into());
        }
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            [Some(arg), arg1.as_mut(), arg2.as_mut(), arg3.as_mut()].into_iter().flatten().for_each(f);
        }
        Expression::ImageSample {
            image, sampler, coordinate, array_index, offset, level, depth_ref, ..
        } => {
            [image, sampler, coordinate].into_iter().for_each(&mut *f);
            [array_index, offset, depth_ref].into_iter().filter_map(Option::as_mut).for_each(&mut *f);
            match level {
                SampleLevel::Auto | SampleLevel::Zero => {}
                SampleLevel::Exact(one) | SampleLevel::Bias(one) => f(one),
                SampleLevel::Gradient { x, y } => [x, y].into_iter().for_each(f),
            }
        }
        Expression::ImageLoad { image, coordinate, array_index, sample, level } => {
            [image, coordinate].into_iter().for_each(&mut *f);
            [array_index, sample, level].into_iter().filter_map(Option::as_mut).for_each(f);
        }
        Expression::ImageQuery { image, query } => {
            f(image);
            if let ImageQuery::Size { level: Some(level) } = query {
                f(level);
            }
        }
        other => return Err(format!("no WebGL2 shader has this expression: {other:?}")),
    }
    Ok(())
}

#[cfg(test)]
mod tests;
