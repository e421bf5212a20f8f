//! Makes functions anew, with an expression for each member where there was one for a struct.

use std::collections::{HashMap, HashSet};

use naga::{
    AddressSpace, Block, Expression, Function, FunctionArgument, FunctionResult, Handle, LocalVariable,
    Range, Span, Statement, SwitchCase, Type, TypeInner, UniqueArena,
};

use super::prune::{self, FunctionFacts};
use super::{Known, Member, Result, Tree, joined, member_name, operands, shape};

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

/// A function made anew without structs, and what is known of it.
pub(super) fn rewrite(
    types: &mut UniqueArena<Type>,
    known: &Known,
    old: &Function,
    entry: bool,
) -> Result<(Function, FunctionFacts)> {
    Rewriter::new(types, known, old, entry)?.run()
}

/// Makes one function anew.
struct Rewriter<'a> {
    types: &'a mut UniqueArena<Type>,
    known: &'a Known,
    old: &'a Function,
    /// How often each old expression is used.
    uses: HashMap<Handle<Expression>, usize>,
    entry: bool,
    new: Function,
    facts: FunctionFacts,
    values: HashMap<Handle<Expression>, Value>,
    /// What stands for each argument, and for each variable: a pointer to it or to its members.
    arguments: Vec<Tree<u32>>,
    locals: HashMap<Handle<LocalVariable>, Tree<Expression>>,
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
        known: &'a Known,
        old: &'a Function,
        entry: bool,
    ) -> Result<Self> {
        let new = Function {
            name: old.name.clone(),
            diagnostic_filter_leaf: old.diagnostic_filter_leaf,
            ..Default::default()
        };
        let mut uses = HashMap::new();
        prune::uses(old, &mut |handle| *uses.entry(handle).or_default() += 1)?;
        Ok(Self {
            types,
            known,
            old,
            uses,
            entry,
            new,
            facts: FunctionFacts::default(),
            values: HashMap::new(),
            arguments: Vec::new(),
            locals: HashMap::new(),
            outs: Vec::new(),
            pending: Vec::new(),
            loads: HashSet::new(),
        })
    }

    fn run(&mut self) -> Result<(Function, FunctionFacts)> {
        let old = self.old;
        for argument in &old.arguments {
            let tree = self.argument(argument)?;
            self.arguments.push(tree);
        }
        self.facts.first_out = self.new.arguments.len();
        self.result();
        let returned = (!self.outs.is_empty()).then(|| self.returned_variable()).flatten();
        let mut body = Block::new();
        for (handle, local) in old.local_variables.iter() {
            if returned == Some(handle) {
                self.written_in_place(handle, local, &mut body)?;
            } else {
                self.local(handle, local)?;
            }
        }
        let mut rest = self.block(&old.body)?;
        body.append(&mut rest);
        self.new.body = body;
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
            let name = Some(joined(base, &member.path)).filter(|name| !name.is_empty());
            self.new.arguments.push(FunctionArgument { name, ty, binding });
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

    /// The one struct variable that is returned, if any is.
    fn returned_variable(&self) -> Option<Handle<LocalVariable>> {
        let mut found = HashSet::new();
        prune::visit(&self.old.body, &mut |statement| {
            if let Statement::Return { value: Some(value) } = statement
                && let Expression::Load { pointer } = self.old.expressions[*value]
                && let Expression::LocalVariable(local) = self.old.expressions[pointer]
            {
                found.insert(local);
            }
        });
        let mut found = found.into_iter();
        found.next().filter(|_| found.next().is_none())
    }

    /// No variable for what is returned: its members are the arguments that they are written to in the end.
    fn written_in_place(
        &mut self,
        handle: Handle<LocalVariable>,
        local: &LocalVariable,
        body: &mut Block,
    ) -> Result<()> {
        let span = self.old.local_variables.get_span(handle);
        let shape = shape(self.types, local.ty);
        let values = match local.init {
            Some(init) => self.constant_value(init, true)?,
            None => shape.map(&mut |member| self.operand(Expression::ZeroValue(member.ty), span)),
        };
        self.flush(body, span);
        for (&pointer, value) in self.outs.iter().zip(values.leaves()) {
            body.push(Statement::Store { pointer, value: value.handle }, span);
        }
        let mut outs = self.outs.iter().map(|&out| self.new.expressions[out].clone());
        let tree = shape.map(&mut |_| outs.next()).complete().ok_or("a result without its members")?;
        self.locals.insert(handle, tree);
        Ok(())
    }

    /// A variable for each member.
    fn local(&mut self, handle: Handle<LocalVariable>, local: &LocalVariable) -> Result<()> {
        let shape = shape(self.types, local.ty);
        let split = matches!(shape, Tree::Members(_));
        let init = local.init.map(|init| self.constant_value(init, false)).transpose()?;
        let mut inits = init.iter().flat_map(Tree::leaves).map(|o| o.handle).collect::<Vec<_>>().into_iter();
        let base = local.name.as_deref().unwrap_or_default();
        let span = self.old.local_variables.get_span(handle);
        let tree = shape.map(&mut |member: &Member| {
            let name = Some(joined(base, &member.path)).filter(|name| !name.is_empty());
            let new = LocalVariable { name, ty: member.ty, init: inits.next() };
            let new = self.new.local_variables.append(new, span);
            if split {
                self.facts.split_locals.insert(new);
            }
            Expression::LocalVariable(new)
        });
        self.locals.insert(handle, tree);
        Ok(())
    }

    /// A constant expression, which a variable is initialised with. Emitted with the next [`Self::flush`] if
    /// `emits`; the initial value of a variable is written before anything is emitted.
    fn constant_value(&mut self, handle: Handle<Expression>, emits: bool) -> Result<Value> {
        let expression = &self.old.expressions[handle];
        if expression.needs_pre_emit() {
            return self.value(handle);
        }
        if let Expression::Compose { ty, components } = expression
            && self.is_struct(*ty)
        {
            let names = self.member_names(*ty).into_iter();
            let own = |(name, c): (String, &Handle<Expression>)| Ok((name, self.constant_value(*c, emits)?));
            return Ok(Tree::Members(names.zip(components).map(own).collect::<Result<_>>()?));
        }
        let new = self.with_operands(handle, &mut |this, operand| this.constant_value(operand, emits))?;
        let span = self.old.expressions.get_span(handle);
        Ok(leaf(if emits { self.push(new, span) } else { self.new.expressions.append(new, span) }))
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
        let mut statements = old.span_iter().peekable();
        let mut before = None;
        while let Some((statement, &span)) = statements.next() {
            match statement {
                Statement::Call { function, arguments, result } => {
                    let next = statements.peek().map(|(next, _)| *next);
                    if self.call(*function, arguments, *result, next, span, &mut block)? {
                        statements.next();
                    }
                }
                Statement::Return { value: Some(value) } => {
                    self.returned(*value, before, span, &mut block)?
                }
                _ => self.statement(statement, span, &mut block)?,
            }
            before = Some(statement);
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
            Statement::Break | Statement::Continue | Statement::Kill | Statement::Return { value: None } => {
                statement.clone()
            }
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
            other => return Err(format!("no WebGL2 shader has this statement: {other:?}")),
        };
        block.push(new, span);
        Ok(())
    }

    /// Returns a value; a struct's members are written where they go. `before`: the statement before it.
    fn returned(
        &mut self,
        value: Handle<Expression>,
        before: Option<&Statement>,
        span: Span,
        block: &mut Block,
    ) -> Result<()> {
        let tree = self.value(value)?;
        let members: Vec<_> = tree.leaves().into_iter().map(|o| o.handle).collect();
        let value = match (&tree, &self.old.result) {
            (Tree::Members(_), Some(result)) if self.entry => {
                let compose = self.push(Expression::Compose { ty: result.ty, components: members }, span);
                self.flush(block, span);
                Some(compose)
            }
            (Tree::Members(_), _) if !self.outs.is_empty() => {
                // Nothing happens between a load and a return that follows it.
                let fresh =
                    matches!(before, Some(Statement::Emit(range)) if range.clone().any(|h| h == value));
                for (&pointer, &value) in self.outs.iter().zip(&members) {
                    let loaded = match self.new.expressions[value] {
                        Expression::Load { pointer } => Some(&self.new.expressions[pointer]),
                        _ => None,
                    };
                    let there = fresh && loaded == Some(&self.new.expressions[pointer]);
                    if !there {
                        block.push(Statement::Store { pointer, value }, span);
                    }
                }
                None
            }
            _ => members.first().copied(),
        };
        block.push(Statement::Return { value }, span);
        Ok(())
    }

    /// Calls a function. Whether that did what the statement after it says, too.
    fn call(
        &mut self,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
        next: Option<&Statement>,
        span: Span,
        block: &mut Block,
    ) -> Result<bool> {
        let mut new = Vec::new();
        for argument in arguments {
            new.extend(self.value(*argument)?.leaves().into_iter().map(|o| o.handle));
        }
        let known = self.known;
        let shape = known.results.get(&function);
        let members = shape.map(Tree::leaves).unwrap_or_default();
        let (Some(shape), Some(result), 2..) = (shape, result, members.len()) else {
            let own = result.map(|_| self.push(Expression::CallResult(function), span));
            block.push(Statement::Call { function, arguments: new, result: own }, span);
            if let (Some(result), Some(own)) = (result, own) {
                // A struct with one member is still a struct.
                let one = Operand { handle: own, points_to: None };
                self.values.insert(result, shape.map_or(Tree::Leaf(one), |s| s.map(&mut |_| one)));
            }
            return Ok(false);
        };
        // Written at once where it goes, if that is all that it is for, and if no argument may point there.
        let points = |&argument: &Handle<Expression>| {
            let root = prune::target(&self.old.expressions, argument);
            match *root {
                Expression::LocalVariable(_) => true,
                Expression::FunctionArgument(i) => {
                    matches!(self.types[self.old.arguments[i as usize].ty].inner, TypeInner::Pointer { .. })
                }
                _ => false,
            }
        };
        let sole = self.uses.get(&result) == Some(&1) && !arguments.iter().any(points);
        match next {
            Some(Statement::Store { pointer, value })
                if sole
                    && *value == result
                    && matches!(self.old.expressions[*pointer], Expression::LocalVariable(_)) =>
            {
                new.extend(self.value(*pointer)?.leaves().into_iter().map(|o| o.handle));
                block.push(Statement::Call { function, arguments: new, result: None }, span);
                return Ok(true);
            }
            Some(Statement::Return { value: Some(value) })
                if sole && *value == result && !self.outs.is_empty() =>
            {
                new.extend(&self.outs);
                block.push(Statement::Call { function, arguments: new, result: None }, span);
                block.push(Statement::Return { value: None }, span);
                return Ok(true);
            }
            _ => {}
        }
        let base = self.old.named_expressions.get(&result).unwrap_or(&known.names[&function]);
        let mut pointers = Vec::new();
        for member in members {
            let local = LocalVariable { name: Some(joined(base, &member.path)), ty: member.ty, init: None };
            let local = self.new.local_variables.append(local, span);
            self.facts.split_locals.insert(local);
            pointers.push(self.push(Expression::LocalVariable(local), span));
        }
        new.extend(&pointers);
        block.push(Statement::Call { function, arguments: new, result: None }, span);
        let load = |pointer| self.push(Expression::Load { pointer }, span);
        let loads: Vec<_> = pointers.into_iter().map(load).collect();
        self.flush(block, span);
        self.loads.extend(&loads);
        let mut loads = loads.into_iter();
        let tree = shape.map(&mut |_| loads.next().map(|handle| Operand { handle, points_to: None }));
        self.values.insert(result, tree.complete().ok_or("a call's result has lost members")?);
        Ok(false)
    }

    /// The new value of an old expression that is in scope.
    fn value(&mut self, handle: Handle<Expression>) -> Result<Value> {
        if let Some(value) = self.values.get(&handle) {
            return Ok(value.clone());
        }
        let span = self.old.expressions.get_span(handle);
        let value = match self.old.expressions[handle] {
            Expression::Constant(constant) => match self.known.constants.get(&constant) {
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
                tree.map(&mut |place| self.operand(place.clone(), span))
            }
            Expression::GlobalVariable(global) => {
                let handle = self.push(Expression::GlobalVariable(global), span);
                Tree::Leaf(self.pointer_to(handle, self.known.globals[&global]))
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
                    let handle =
                        self.push(Expression::AccessIndex { base: base.handle, index: *index }, span);
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
