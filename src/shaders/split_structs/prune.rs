//! Takes out what a split left unused: members of a struct argument that a function does not read, members of
//! a returned struct that no caller reads, variables that are only written.

use std::collections::{HashMap, HashSet};

use naga::{
    Arena, Block, Expression, Function, Handle, Literal, LocalVariable, Module, Statement, SwitchCase,
};

use super::{Result, operands};

/// What is known of a function that was split.
#[derive(Debug, Default)]
pub(super) struct FunctionFacts {
    /// For each argument, whether the split made it, so that it may go.
    pub droppable: Vec<bool>,
    /// Index of the first argument that a returned struct is written to.
    pub first_out: usize,
    /// Variables that the split made.
    pub split_locals: HashSet<Handle<LocalVariable>>,
    /// Names of expressions, and whether the source gave that very name.
    pub names: Vec<(Handle<Expression>, String, bool)>,
}

/// What is known of a module's functions.
#[derive(Debug, Default)]
pub(super) struct Facts {
    pub functions: HashMap<Handle<Function>, FunctionFacts>,
    pub entry_points: Vec<FunctionFacts>,
}

/// Which arguments of each function are used.
type Used = HashMap<Handle<Function>, Vec<bool>>;

pub(super) fn prune(module: &mut Module, facts: Facts) -> Result<()> {
    // The least set that is closed: nothing that the split made is used until something that is used reads
    // it.
    let mut used: Used =
        facts.functions.iter().map(|(&h, f)| (h, f.droppable.iter().map(|d| !d).collect())).collect();
    loop {
        let mut found = Vec::new();
        for (handle, function) in module.functions.iter() {
            let own = &facts.functions[&handle];
            let live = Live::of(function, own, Some(&used[&handle]), &facts, &used)?;
            for (expression, kind) in function.expressions.iter() {
                if let Expression::FunctionArgument(i) = *kind
                    && live.expressions[expression.index()]
                {
                    found.push((handle, i as usize));
                }
            }
            found.extend(live.results);
            // What a caller passes on to a function that writes it.
            visit(&function.body, &mut |statement| {
                let Statement::Call { function: callee, arguments, .. } = statement else { return };
                for (argument, used) in arguments.iter().zip(&used[callee]) {
                    if let Expression::FunctionArgument(i) = function.expressions[*argument]
                        && *used
                    {
                        found.push((handle, i as usize));
                    }
                }
            });
        }
        for (entry, own) in module.entry_points.iter().zip(&facts.entry_points) {
            found.extend(Live::of(&entry.function, own, None, &facts, &used)?.results);
        }
        let mut changed = false;
        for (function, argument) in found {
            if let Some(used) = used.get_mut(&function).and_then(|u| u.get_mut(argument)) {
                changed |= !*used;
                *used = true;
            }
        }
        if !changed {
            break;
        }
    }
    for (handle, function) in module.functions.iter_mut() {
        apply(function, &facts.functions[&handle], Some(&used[&handle]), &facts, &used)?;
    }
    for (entry, own) in module.entry_points.iter_mut().zip(&facts.entry_points) {
        apply(&mut entry.function, own, None, &facts, &used)?;
    }
    Ok(())
}

/// What of a function is used.
struct Live {
    expressions: Vec<bool>,
    /// Variables that are read. Those that only a call writes are not among them.
    locals: HashSet<Handle<LocalVariable>>,
    /// Arguments of other functions whose written value is read here.
    results: Vec<(Handle<Function>, usize)>,
}

/// The variable or argument that a pointer leads to.
pub(super) fn target(expressions: &Arena<Expression>, mut pointer: Handle<Expression>) -> &Expression {
    while let Expression::Access { base, .. } | Expression::AccessIndex { base, .. } = expressions[pointer] {
        pointer = base;
    }
    &expressions[pointer]
}

/// Calls `f` with every statement, those inside others too.
pub(super) fn visit(block: &Block, f: &mut dyn FnMut(&Statement)) {
    for statement in block {
        f(statement);
        match statement {
            Statement::Block(inner) => visit(inner, f),
            Statement::If { accept, reject, .. } => [accept, reject].into_iter().for_each(|b| visit(b, f)),
            Statement::Switch { cases, .. } => cases.iter().for_each(|c| visit(&c.body, f)),
            Statement::Loop { body, continuing, .. } => {
                [body, continuing].into_iter().for_each(|b| visit(b, f))
            }
            _ => {}
        }
    }
}

impl Live {
    fn of(
        function: &Function,
        own: &FunctionFacts,
        own_used: Option<&Vec<bool>>,
        facts: &Facts,
        used: &Used,
    ) -> Result<Self> {
        let arena = &function.expressions;
        let mut live =
            Self { expressions: vec![false; arena.len()], locals: HashSet::new(), results: Vec::new() };
        let inits = function.local_variables.iter().filter_map(|(_, local)| local.init);
        inits.for_each(|init| live.expressions[init.index()] = true);
        let mut error = Ok(());
        loop {
            visit(&function.body, &mut |statement| {
                live.statement(statement, function, own, own_used, facts, used)
            });
            let known = live.locals.len();
            // Operands come before what uses them: one sweep backwards marks all.
            for (handle, expression) in arena.iter().rev() {
                if !live.expressions[handle.index()] {
                    continue;
                }
                if let Expression::LocalVariable(local) = *expression {
                    live.locals.insert(local);
                }
                let mark = &mut |operand: &mut Handle<Expression>| live.expressions[operand.index()] = true;
                error = error.and(operands(&mut expression.clone(), mark));
            }
            // What is read makes what is written to it used.
            if live.locals.len() == known {
                break;
            }
        }
        live.results.clear();
        visit(&function.body, &mut |statement| {
            let Statement::Call { function: callee, arguments, .. } = statement else { return };
            for (i, argument) in arguments.iter().enumerate().skip(facts.functions[callee].first_out) {
                let read = match arena[*argument] {
                    Expression::LocalVariable(local) => live.locals.contains(&local),
                    Expression::FunctionArgument(i) => own_used.is_none_or(|used| used[i as usize]),
                    _ => true,
                };
                if read {
                    live.results.push((*callee, i));
                }
            }
        });
        error.map(|()| live)
    }

    fn statement(
        &mut self,
        statement: &Statement,
        function: &Function,
        own: &FunctionFacts,
        own_used: Option<&Vec<bool>>,
        facts: &Facts,
        used: &Used,
    ) {
        let mut mark = |handle: Handle<Expression>| self.expressions[handle.index()] = true;
        match statement {
            Statement::If { condition: one, .. }
            | Statement::Switch { selector: one, .. }
            | Statement::Loop { break_if: Some(one), .. }
            | Statement::Return { value: Some(one) } => mark(*one),
            Statement::Store { pointer, value }
                if stores(target(&function.expressions, *pointer), own, own_used, &self.locals) =>
            {
                mark(*pointer);
                mark(*value);
            }
            Statement::Call { function, arguments, .. } => {
                let first_out = facts.functions[function].first_out;
                for (argument, used) in arguments[..first_out].iter().zip(&used[function]) {
                    if *used {
                        mark(*argument);
                    }
                }
            }
            _ => {}
        }
    }
}

/// Whether what is stored there is used.
fn stores(
    target: &Expression,
    own: &FunctionFacts,
    own_used: Option<&Vec<bool>>,
    live: &HashSet<Handle<LocalVariable>>,
) -> bool {
    match *target {
        Expression::LocalVariable(local) => !own.split_locals.contains(&local) || live.contains(&local),
        Expression::FunctionArgument(i) => own_used.is_none_or(|used| used[i as usize]),
        _ => true,
    }
}

/// Takes what is not used out of a function, and gives names to what is.
fn apply(
    function: &mut Function,
    own: &FunctionFacts,
    own_used: Option<&Vec<bool>>,
    facts: &Facts,
    used: &Used,
) -> Result<()> {
    let live = Live::of(function, own, own_used, facts, used)?;
    let mut kept = live.locals.clone();
    kept.extend(function.local_variables.iter().map(|(h, _)| h).filter(|h| !own.split_locals.contains(h)));
    visit(&function.body, &mut |statement| {
        let Statement::Call { function: callee, arguments, .. } = statement else { return };
        for (argument, used) in arguments.iter().zip(&used[callee]) {
            if let Expression::LocalVariable(local) = function.expressions[*argument]
                && *used
            {
                kept.insert(local);
            }
        }
    });
    let body = std::mem::take(&mut function.body);
    function.body = block(body, &|statement| match statement {
        Statement::Store { pointer, .. } => {
            stores(target(&function.expressions, *pointer), own, own_used, &live.locals)
        }
        Statement::Call { function, arguments, .. } => {
            let mut used = used[function].iter();
            arguments.retain(|_| used.next() == Some(&true));
            true
        }
        _ => true,
    });
    // A function that returns nothing may end without saying so.
    if function.result.is_none() && matches!(function.body.last(), Some(Statement::Return { value: None })) {
        let last = function.body.len() - 1;
        function.body.cull(last..);
    }

    let mut locals = HashMap::new();
    let mut variables = Arena::new();
    for (handle, local) in function.local_variables.iter().filter(|(h, _)| kept.contains(h)) {
        let span = function.local_variables.get_span(handle);
        locals.insert(handle, variables.append(local.clone(), span));
    }
    function.local_variables = variables;
    let keeps = |i: usize| own_used.is_none_or(|used| used[i]);
    let mut place = 0;
    let places: Vec<_> = (0..function.arguments.len())
        .map(|i| {
            place += u32::from(keeps(i));
            place.saturating_sub(1)
        })
        .collect();
    for (_, expression) in function.expressions.iter_mut() {
        // Nothing uses it any more where it was taken out.
        const NOTHING: Expression = Expression::Literal(Literal::Bool(false));
        *expression = match *expression {
            Expression::LocalVariable(local) => {
                locals.get(&local).map_or(NOTHING, |&l| Expression::LocalVariable(l))
            }
            Expression::FunctionArgument(i) if keeps(i as usize) => {
                Expression::FunctionArgument(places[i as usize])
            }
            Expression::FunctionArgument(_) => NOTHING,
            _ => continue,
        };
    }
    let mut index = 0;
    function.arguments.retain(|_| {
        index += 1;
        keeps(index - 1)
    });
    name(function, own, &live)
}

/// Calls `f` with each use of an expression, by another one or by a statement.
pub(super) fn uses(function: &Function, f: &mut dyn FnMut(Handle<Expression>)) -> Result<()> {
    for (_, expression) in function.expressions.iter() {
        operands(&mut expression.clone(), &mut |operand| f(*operand))?;
    }
    visit(&function.body, &mut |statement| match statement {
        Statement::If { condition: one, .. }
        | Statement::Switch { selector: one, .. }
        | Statement::Loop { break_if: Some(one), .. }
        | Statement::Return { value: Some(one) } => f(*one),
        Statement::Store { pointer, value } => [*pointer, *value].into_iter().for_each(&mut *f),
        Statement::Call { arguments, .. } => arguments.iter().copied().for_each(&mut *f),
        _ => {}
    });
    Ok(())
}

fn name(function: &mut Function, own: &FunctionFacts, live: &Live) -> Result<()> {
    let mut counts = vec![0; function.expressions.len()];
    // What is not used counts too: at worst a number that is used once gets a name.
    uses(function, &mut |handle| counts[handle.index()] += 1)?;
    for (handle, name, given) in &own.names {
        let expression = &function.expressions[*handle];
        // naga's writer makes a variable of each of these; a name for another would make one more.
        let variable = matches!(expression, Expression::Load { .. } | Expression::ImageLoad { .. });
        let wanted = *given || variable || (counts[handle.index()] > 1 && !expression.needs_pre_emit());
        if live.expressions[handle.index()] && wanted && !function.named_expressions.contains_key(handle) {
            function.named_expressions.insert(*handle, name.clone());
        }
    }
    Ok(())
}

/// A block less the statements that `keep` refuses, which may change those that it keeps.
fn block(old: Block, keep: &dyn Fn(&mut Statement) -> bool) -> Block {
    let mut new = Block::with_capacity(old.len());
    for (mut statement, span) in old.span_into_iter() {
        if !keep(&mut statement) {
            continue;
        }
        let statement = match statement {
            Statement::Block(inner) => Statement::Block(block(inner, keep)),
            Statement::If { condition, accept, reject } => {
                Statement::If { condition, accept: block(accept, keep), reject: block(reject, keep) }
            }
            Statement::Switch { selector, cases } => {
                let case = |c: SwitchCase| SwitchCase { body: block(c.body, keep), ..c };
                Statement::Switch { selector, cases: cases.into_iter().map(case).collect() }
            }
            Statement::Loop { body, continuing, break_if } => {
                Statement::Loop { body: block(body, keep), continuing: block(continuing, keep), break_if }
            }
            other => other,
        };
        new.push(statement, span);
    }
    new
}
