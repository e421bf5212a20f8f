//! Splits every struct value of a naga module into scalars, vectors and matrices, so that no GLSL struct but
//! the uniform block is left in what a driver compiles.
//!
//! Common phone GPUs (Adreno up to the 6xx) keep the members of GLSL structs in 16 bits in WebGL, whatever
//! `highp` says: [KhronosGroup/WebGL#3351], [three.js#26805], and vello, which met the same on Android
//! ([vello#1604], [vello#1659]). The geometry here carries r² − R² up to 10⁷ km², which 16 bits cannot hold
//! (their largest number is 65504), and no desktop or software driver shows the fault. The WGSL keeps its
//! structs, for people; [`split_structs`] takes them out on the way to GLSL:
//!
//! * an argument becomes one argument a member, nested structs flattened, and a member that a function does not
//!   read is not handed to it;
//! * a local variable becomes one variable a member;
//! * a returned struct becomes arguments that the function writes (`ptr<function, T>`, GLSL's `inout`);
//! * what is loaded from a uniform block is loaded member by member.
//!
//! The operations and their order stay as they are, so that numbers are the same bit for bit. naga's writer
//! makes one more struct by itself, for an entry point with several outputs: [`split_outputs`] takes it out of
//! the text. [`super::struct_lint`] proves on the text that nothing was missed.
//!
//! [KhronosGroup/WebGL#3351]: https://github.com/KhronosGroup/WebGL/issues/3351
//! [three.js#26805]: https://github.com/mrdoob/three.js/issues/26805
//! [vello#1604]: https://github.com/linebender/vello/issues/1604
//! [vello#1659]: https://github.com/linebender/vello/issues/1659

mod outputs;
mod prune;

use std::collections::{HashMap, HashSet};

use naga::{
    AddressSpace, Arena, Binding, Block, Constant, Expression, Function, FunctionArgument, FunctionResult,
    GlobalVariable, Handle, LocalVariable, MathFunction, Module, Range, Span, Statement, SwitchCase, Type, TypeInner,
    UniqueArena,
};

pub use outputs::split_outputs;
use prune::Facts;

type Result<T> = std::result::Result<T, String>;

/// Takes struct values out of a module, see the [module](self). The module is compacted: what was not used is
/// gone from it. It is valid if it was valid before.
///
/// # Errors
/// A text that says what the pass does not handle: arrays of structs, structs in private or workgroup variables,
/// `modf` and `frexp` (whose results are structs), and statements that no WebGL2 shader can have.
pub fn split_structs(module: &mut Module) -> Result<()> {
    refuse(module)?;
    let constants = split_constants(module);
    let names: HashMap<_, _> = module.functions.iter().map(|(h, f)| (h, f.name.clone().unwrap_or_default())).collect();
    let mut results = HashMap::new();
    let mut facts = Facts::default();
    let Module { types, global_variables, functions, entry_points, .. } = module;
    // A function calls only those before it.
    for (handle, function) in functions.iter_mut() {
        let old = std::mem::take(function);
        let mut rewriter = Rewriter::new(types, global_variables, &constants, &names, &results, &old, false);
        let (new, own) = rewriter.run().map_err(|e| format!("function {}: {e}", names[&handle]))?;
        if let Some(result) = &old.result
            && let shape @ Tree::Members(_) = shape(types, result.ty)
        {
            results.insert(handle, shape);
        }
        *function = new;
        facts.functions.insert(handle, own);
    }
    for entry in entry_points.iter_mut() {
        let old = std::mem::take(&mut entry.function);
        let mut rewriter = Rewriter::new(types, global_variables, &constants, &names, &results, &old, true);
        let (new, own) = rewriter.run().map_err(|e| format!("entry point {}: {e}", entry.name))?;
        entry.function = new;
        facts.entry_points.push(own);
    }
    prune::prune(module, facts)?;
    naga::compact::compact(module, naga::compact::KeepUnused::No);
    Ok(())
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
            return Err(format!("variables of a module are split only in uniform blocks: {name} is a struct"));
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
            Self::Members(members) => Tree::Members(members.iter().map(|(n, m)| (n.clone(), m.map(f))).collect()),
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
    fn walk(types: &UniqueArena<Type>, ty: Handle<Type>, path: &str, binding: Option<&Binding>) -> Tree<Member> {
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

/// An expression of the new function; for a pointer to a struct in a uniform block, that struct's type.
#[derive(Clone, Copy, Debug)]
struct Operand {
    handle: Handle<Expression>,
    points_to: Option<Handle<Type>>,
}

type Value = Tree<Operand>;

fn leaf(handle: Handle<Expression>) -> Value {
    Tree::Leaf(Operand { handle, points_to: None })
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
        Expression::Select { condition, accept, reject } => [condition, accept, reject].into_iter().for_each(f),
        Expression::Math { fun: MathFunction::Modf | MathFunction::Frexp, .. } => {
            return Err("modf and frexp return structs, which cannot be split".into());
        }
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            [Some(arg), arg1.as_mut(), arg2.as_mut(), arg3.as_mut()].into_iter().flatten().for_each(f);
        }
        Expression::ImageSample { image, sampler, coordinate, array_index, offset, level, depth_ref, .. } => {
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

/// Makes one function anew.
struct Rewriter<'a> {
    types: &'a mut UniqueArena<Type>,
    globals: &'a Arena<GlobalVariable>,
    constants: &'a HashMap<Handle<Constant>, Tree<Handle<Constant>>>,
    names: &'a HashMap<Handle<Function>, String>,
    /// Of the functions before this one that return structs.
    results: &'a HashMap<Handle<Function>, Tree<Member>>,
    old: &'a Function,
    entry: bool,
    new: Function,
    facts: prune::FunctionFacts,
    values: HashMap<Handle<Expression>, Value>,
    arguments: Vec<Tree<u32>>,
    locals: HashMap<Handle<LocalVariable>, Tree<Handle<LocalVariable>>>,
    /// The arguments that a returned struct's members are written to.
    outs: Vec<Handle<Expression>>,
    /// Expressions made and not yet emitted.
    pending: Vec<Handle<Expression>>,
    /// Loads of what a call wrote: they have no name of their own, the variable has it.
    loads: HashSet<Handle<Expression>>,
}

impl<'a> Rewriter<'a> {
    fn new(
        types: &'a mut UniqueArena<Type>,
        globals: &'a Arena<GlobalVariable>,
        constants: &'a HashMap<Handle<Constant>, Tree<Handle<Constant>>>,
        names: &'a HashMap<Handle<Function>, String>,
        results: &'a HashMap<Handle<Function>, Tree<Member>>,
        old: &'a Function,
        entry: bool,
    ) -> Self {
        let new = Function {
            name: old.name.clone(),
            diagnostic_filter_leaf: old.diagnostic_filter_leaf,
            ..Default::default()
        };
        Self {
            types,
            globals,
            constants,
            names,
            results,
            old,
            entry,
            new,
            facts: prune::FunctionFacts::default(),
            values: HashMap::new(),
            arguments: Vec::new(),
            locals: HashMap::new(),
            outs: Vec::new(),
            pending: Vec::new(),
            loads: HashSet::new(),
        }
    }

    fn run(&mut self) -> Result<(Function, prune::FunctionFacts)> {
        let old = self.old;
        for argument in &old.arguments {
            let tree = self.argument(argument)?;
            self.arguments.push(tree);
        }
        self.facts.first_out = self.new.arguments.len();
        self.result();
        for (handle, local) in old.local_variables.iter() {
            self.local(handle, local)?;
        }
        self.new.body = self.block(&old.body)?;
        self.names();
        Ok((std::mem::take(&mut self.new), std::mem::take(&mut self.facts)))
    }

    /// An argument for each member.
    fn argument(&mut self, argument: &FunctionArgument) -> Result<Tree<u32>> {
        // A pointer to a struct becomes pointers to its members.
        let (ty, space) = match self.types[argument.ty].inner {
            TypeInner::Pointer { base, space } => (base, Some(space)),
            _ => (argument.ty, None),
        };
        let shape = shape(self.types, ty);
        let split = matches!(shape, Tree::Members(_));
        if split && space.is_some_and(|s| s != AddressSpace::Function) {
            return Err("pointers to structs are split only where they point to local variables".into());
        }
        let base = argument.name.as_deref().unwrap_or_default();
        Ok(shape.map(&mut |member: &Member| {
            let ty = match space {
                Some(space) if split => self.pointer(member.ty, space),
                Some(_) => argument.ty,
                None => member.ty,
            };
            let binding = if split { member.binding.clone() } else { argument.binding.clone() };
            self.new.arguments.push(FunctionArgument { name: Some(joined(base, &member.path)), ty, binding });
            // What a pointer is for is not asked: it stays.
            self.facts.droppable.push(split && !self.entry && space.is_none());
            self.new.arguments.len() as u32 - 1
        }))
    }

    fn pointer(&mut self, base: Handle<Type>, space: AddressSpace) -> Handle<Type> {
        self.types.insert(Type { name: None, inner: TypeInner::Pointer { base, space } }, Span::UNDEFINED)
    }

    /// What it returns: of a struct with several members, arguments to write them to.
    fn result(&mut self) {
        let Some(result) = &self.old.result else { return };
        let shape = shape(self.types, result.ty);
        let members = shape.leaves();
        if self.entry || matches!(shape, Tree::Leaf(_)) {
            self.new.result = Some(result.clone());
        } else if let [one] = members[..] {
            self.new.result = Some(FunctionResult { ty: one.ty, binding: None });
        } else {
            for member in members {
                let ty = self.pointer(member.ty, AddressSpace::Function);
                let index = self.new.arguments.len() as u32;
                let name = Some(joined("out", &member.path));
                self.new.arguments.push(FunctionArgument { name, ty, binding: None });
                self.facts.droppable.push(true);
                let handle = self.push(Expression::FunctionArgument(index), Span::UNDEFINED);
                self.outs.push(handle);
            }
        }
    }

    /// A variable for each member.
    fn local(&mut self, handle: Handle<LocalVariable>, local: &LocalVariable) -> Result<()> {
        let shape = shape(self.types, local.ty);
        let split = matches!(shape, Tree::Members(_));
        let init = local.init.map(|init| self.constant_value(init)).transpose()?;
        let mut inits = init.iter().flat_map(Tree::leaves).map(|o| o.handle).collect::<Vec<_>>().into_iter();
        let base = local.name.as_deref().unwrap_or_default();
        let span = self.old.local_variables.get_span(handle);
        let tree = shape.map(&mut |member: &Member| {
            let new = LocalVariable { name: Some(joined(base, &member.path)), ty: member.ty, init: inits.next() };
            let new = self.new.local_variables.append(new, span);
            if split {
                self.facts.split_locals.insert(new);
            }
            new
        });
        self.locals.insert(handle, tree);
        Ok(())
    }

    /// A constant expression, which a variable is initialised with before anything is emitted.
    fn constant_value(&mut self, handle: Handle<Expression>) -> Result<Value> {
        let expression = &self.old.expressions[handle];
        if expression.needs_pre_emit() {
            return self.value(handle);
        }
        if let Expression::Compose { ty, components } = expression
            && self.is_struct(*ty)
        {
            let names = self.member_names(*ty).into_iter();
            let own = |(name, c): (String, &Handle<Expression>)| Ok((name, self.constant_value(*c)?));
            return Ok(Tree::Members(names.zip(components).map(own).collect::<Result<_>>()?));
        }
        let new = self.with_operands(handle, &mut |this, operand| this.constant_value(operand))?;
        Ok(leaf(self.new.expressions.append(new, self.old.expressions.get_span(handle))))
    }

    /// An expression that is no struct, with its new operands.
    fn with_operands(
        &mut self,
        handle: Handle<Expression>,
        value: &mut dyn FnMut(&mut Self, Handle<Expression>) -> Result<Value>,
    ) -> Result<Expression> {
        let mut new = self.old.expressions[handle].clone();
        let mut error = None;
        operands(&mut new, &mut |operand| match value(self, *operand) {
            Ok(Tree::Leaf(own)) => *operand = own.handle,
            Ok(Tree::Members(_)) => {
                error = Some(format!("a struct where none is expected: {:?}", self.old.expressions[handle]));
            }
            Err(e) => error = Some(e),
        })?;
        error.map_or(Ok(new), Err)
    }

    /// A new expression, to be emitted with the next [`Self::flush`] if its kind is emitted at all.
    fn push(&mut self, expression: Expression, span: Span) -> Handle<Expression> {
        let emits = !expression.needs_pre_emit() && !matches!(expression, Expression::CallResult(_));
        let handle = self.new.expressions.append(expression, span);
        if emits {
            self.pending.push(handle);
        }
        handle
    }

    /// Emits what was made since the last time.
    fn flush(&mut self, block: &mut Block, span: Span) {
        let pending = std::mem::take(&mut self.pending);
        for run in pending.chunk_by(|a, b| b.index() == a.index() + 1) {
            if let (Some(&first), Some(&last)) = (run.first(), run.last()) {
                block.push(Statement::Emit(Range::new_from_bounds(first, last)), span);
            }
        }
    }

    fn block(&mut self, old: &Block) -> Result<Block> {
        let mut block = Block::with_capacity(old.len());
        for (statement, &span) in old.span_iter() {
            self.statement(statement, span, &mut block)?;
        }
        Ok(block)
    }

    fn statement(&mut self, statement: &Statement, span: Span, block: &mut Block) -> Result<()> {
        let new = match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    let value = self.expression(handle)?;
                    self.values.insert(handle, value);
                }
                self.flush(block, span);
                return Ok(());
            }
            Statement::Block(inner) => Statement::Block(self.block(inner)?),
            Statement::If { condition, accept, reject } => Statement::If {
                condition: self.one(*condition)?,
                accept: self.block(accept)?,
                reject: self.block(reject)?,
            },
            Statement::Switch { selector, cases } => {
                let selector = self.one(*selector)?;
                let case = |case: &SwitchCase| {
                    let body = self.block(&case.body)?;
                    Ok(SwitchCase { value: case.value, body, fall_through: case.fall_through })
                };
                Statement::Switch { selector, cases: cases.iter().map(case).collect::<Result<_>>()? }
            }
            Statement::Loop { body, continuing, break_if } => Statement::Loop {
                body: self.block(body)?,
                continuing: self.block(continuing)?,
                break_if: break_if.map(|b| self.one(b)).transpose()?,
            },
            Statement::Break | Statement::Continue | Statement::Kill => statement.clone(),
            Statement::Return { value } => Statement::Return { value: self.returned(*value, span, block)? },
            Statement::Store { pointer, value } => {
                let (pointers, values) = (self.value(*pointer)?, self.value(*value)?);
                let (pointers, values) = (pointers.leaves(), values.leaves());
                if pointers.len() != values.len() {
                    return Err("a store whose two sides have not the same members".into());
                }
                for (pointer, value) in pointers.into_iter().zip(values) {
                    block.push(Statement::Store { pointer: pointer.handle, value: value.handle }, span);
                }
                return Ok(());
            }
            Statement::Call { function, arguments, result } => {
                return self.call(*function, arguments, *result, span, block);
            }
            other => return Err(format!("no WebGL2 shader has this statement: {other:?}")),
        };
        block.push(new, span);
        Ok(())
    }

    /// Writes a returned struct's members where they go. What is left to return.
    fn returned(
        &mut self,
        value: Option<Handle<Expression>>,
        span: Span,
        block: &mut Block,
    ) -> Result<Option<Handle<Expression>>> {
        let Some(value) = value else { return Ok(None) };
        let tree = self.value(value)?;
        let members: Vec<_> = tree.leaves().into_iter().map(|o| o.handle).collect();
        match (&tree, &self.old.result) {
            (Tree::Members(_), Some(result)) if self.entry => {
                let compose = self.push(Expression::Compose { ty: result.ty, components: members }, span);
                self.flush(block, span);
                Ok(Some(compose))
            }
            (Tree::Members(_), _) if !self.outs.is_empty() => {
                for (&pointer, &value) in self.outs.iter().zip(&members) {
                    block.push(Statement::Store { pointer, value }, span);
                }
                Ok(None)
            }
            _ => Ok(members.first().copied()),
        }
    }

    fn call(
        &mut self,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
        span: Span,
        block: &mut Block,
    ) -> Result<()> {
        let mut new = Vec::new();
        for argument in arguments {
            new.extend(self.value(*argument)?.leaves().into_iter().map(|o| o.handle));
        }
        let results = self.results;
        let shape = results.get(&function);
        let members = shape.map(Tree::leaves).unwrap_or_default();
        if members.len() < 2 {
            let own = result.map(|_| self.push(Expression::CallResult(function), span));
            block.push(Statement::Call { function, arguments: new, result: own }, span);
            if let (Some(result), Some(own)) = (result, own) {
                // A struct with one member is still a struct.
                let one = Operand { handle: own, points_to: None };
                self.values.insert(result, shape.map_or(Tree::Leaf(one), |s| s.map(&mut |_| one)));
            }
            return Ok(());
        }
        let given = result.and_then(|r| self.old.named_expressions.get(&r));
        let base = given.unwrap_or(&self.names[&function]).clone();
        let mut pointers = Vec::new();
        for member in members {
            let local = LocalVariable { name: Some(joined(&base, &member.path)), ty: member.ty, init: None };
            let local = self.new.local_variables.append(local, span);
            self.facts.split_locals.insert(local);
            pointers.push(self.push(Expression::LocalVariable(local), span));
        }
        new.extend(&pointers);
        block.push(Statement::Call { function, arguments: new, result: None }, span);
        if let (Some(result), Some(shape)) = (result, shape) {
            let load = |pointer| self.push(Expression::Load { pointer }, span);
            let loads: Vec<_> = pointers.into_iter().map(load).collect();
            self.flush(block, span);
            self.loads.extend(&loads);
            let mut loads = loads.into_iter();
            let tree = shape.map(&mut |_| loads.next().map(|handle| Operand { handle, points_to: None }));
            self.values.insert(result, tree.complete().ok_or("a call's result has lost members")?);
        }
        Ok(())
    }

    /// The new value of an old expression that is in scope.
    fn value(&mut self, handle: Handle<Expression>) -> Result<Value> {
        if let Some(value) = self.values.get(&handle) {
            return Ok(value.clone());
        }
        let span = self.old.expressions.get_span(handle);
        let value = match self.old.expressions[handle] {
            Expression::Constant(constant) => match self.constants.get(&constant) {
                Some(tree) => tree.map(&mut |&c| self.operand(Expression::Constant(c), span)),
                None => leaf(self.push(Expression::Constant(constant), span)),
            },
            Expression::ZeroValue(ty) => {
                let shape = shape(self.types, ty);
                shape.map(&mut |member| self.operand(Expression::ZeroValue(member.ty), span))
            }
            Expression::FunctionArgument(index) => {
                let tree = self.arguments[index as usize].clone();
                tree.map(&mut |&i| self.operand(Expression::FunctionArgument(i), span))
            }
            Expression::LocalVariable(local) => {
                let tree = self.locals.get(&local).ok_or("an unknown local variable")?.clone();
                tree.map(&mut |&l| self.operand(Expression::LocalVariable(l), span))
            }
            Expression::GlobalVariable(global) => {
                let handle = self.push(Expression::GlobalVariable(global), span);
                Tree::Leaf(self.pointer_to(handle, self.globals[global].ty))
            }
            Expression::Literal(literal) => leaf(self.push(Expression::Literal(literal), span)),
            ref other => return Err(format!("it is used before it is emitted: {other:?}")),
        };
        self.values.insert(handle, value.clone());
        Ok(value)
    }

    fn operand(&mut self, expression: Expression, span: Span) -> Operand {
        Operand { handle: self.push(expression, span), points_to: None }
    }

    /// An operand that may point to a struct in a uniform block.
    fn pointer_to(&self, handle: Handle<Expression>, ty: Handle<Type>) -> Operand {
        Operand { handle, points_to: self.is_struct(ty).then_some(ty) }
    }

    /// The new value of what is no struct.
    fn one(&mut self, handle: Handle<Expression>) -> Result<Handle<Expression>> {
        match self.value(handle)? {
            Tree::Leaf(operand) => Ok(operand.handle),
            Tree::Members(_) => Err("a struct where none is expected".into()),
        }
    }

    /// Makes an expression that is being emitted.
    fn expression(&mut self, handle: Handle<Expression>) -> Result<Value> {
        let span = self.old.expressions.get_span(handle);
        match &self.old.expressions[handle] {
            Expression::Compose { ty, components } if self.is_struct(*ty) => {
                let names = self.member_names(*ty).into_iter();
                let own = |(name, c): (String, &Handle<Expression>)| Ok((name, self.value(*c)?));
                Ok(Tree::Members(names.zip(components).map(own).collect::<Result<_>>()?))
            }
            Expression::AccessIndex { base, index } => match self.value(*base)? {
                Tree::Members(members) => {
                    members.into_iter().nth(*index as usize).map(|(_, m)| m).ok_or("no such member".into())
                }
                Tree::Leaf(base) => {
                    let handle = self.push(Expression::AccessIndex { base: base.handle, index: *index }, span);
                    Ok(match base.points_to {
                        Some(ty) => Tree::Leaf(self.pointer_to(handle, self.member(ty, *index)?)),
                        None => leaf(handle),
                    })
                }
            },
            Expression::Load { pointer } => {
                let pointer = self.value(*pointer)?;
                self.load(&pointer, span)
            }
            Expression::Select { condition, accept, reject } => {
                let (accept, reject) = (self.value(*accept)?, self.value(*reject)?);
                let condition = self.one(*condition)?;
                let mut rejected = reject.leaves().into_iter();
                let tree = accept.map(&mut |accept| {
                    let (accept, reject) = (accept.handle, rejected.next()?.handle);
                    Some(self.operand(Expression::Select { condition, accept, reject }, span))
                });
                tree.complete().ok_or("a selection between different structs".into())
            }
            _ => {
                let new = self.with_operands(handle, &mut Self::value)?;
                Ok(leaf(self.push(new, span)))
            }
        }
    }

    fn is_struct(&self, ty: Handle<Type>) -> bool {
        matches!(self.types[ty].inner, TypeInner::Struct { .. })
    }

    /// Names of a struct's members; none for other types.
    fn member_names(&self, ty: Handle<Type>) -> Vec<String> {
        match &self.types[ty].inner {
            TypeInner::Struct { members, .. } => members.iter().map(member_name).collect(),
            _ => Vec::new(),
        }
    }

    fn member(&self, ty: Handle<Type>, index: u32) -> Result<Handle<Type>> {
        match &self.types[ty].inner {
            TypeInner::Struct { members, .. } => {
                members.get(index as usize).map(|m| m.ty).ok_or("no such member".into())
            }
            other => Err(format!("members of {other:?}")),
        }
    }

    /// Loads what is pointed to, member by member.
    fn load(&mut self, pointer: &Value, span: Span) -> Result<Value> {
        match pointer {
            Tree::Members(members) => {
                let own = |(name, m): &(String, Value)| Ok((name.clone(), self.load(m, span)?));
                Ok(Tree::Members(members.iter().map(own).collect::<Result<_>>()?))
            }
            &Tree::Leaf(Operand { handle, points_to: None }) => {
                Ok(leaf(self.push(Expression::Load { pointer: handle }, span)))
            }
            &Tree::Leaf(Operand { handle: base, points_to: Some(ty) }) => {
                let TypeInner::Struct { members, .. } = &self.types[ty].inner else {
                    return Err("a pointer to a struct that is none".into());
                };
                let members: Vec<_> = members.iter().map(|m| (member_name(m), m.ty)).collect();
                let mut loaded = Vec::new();
                for (index, (name, ty)) in (0..).zip(members) {
                    let handle = self.push(Expression::AccessIndex { base, index }, span);
                    let pointer = Tree::Leaf(self.pointer_to(handle, ty));
                    loaded.push((name, self.load(&pointer, span)?));
                }
                Ok(Tree::Members(loaded))
            }
        }
    }

    /// Names of what the old function had names for.
    fn names(&mut self) {
        for (handle, name) in &self.old.named_expressions {
            match self.values.get(handle) {
                Some(Tree::Leaf(one)) => self.facts.names.push((one.handle, name.clone(), true)),
                Some(tree @ Tree::Members(_)) => {
                    for (name, one) in tree.named(name) {
                        if !self.loads.contains(&one.handle) {
                            self.facts.names.push((one.handle, name, false));
                        }
                    }
                }
                None => {}
            }
        }
    }
}
