//! From a kernel to its table: the same program as data, with as few registers as are alive at once.

mod registers;

use closedform_arith::limits::{MAX_HELD, MAX_REGISTERS};
use closedform_arith::table::{Instruction, Source, Sum, Table};

use crate::compensated::Part;
use crate::kernel::{BinaryOp, CompensatedExpr, Condition, Expr, Kernel};
use registers::Registers;

/// A table that owns its parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lowered {
    /// The instructions.
    pub instructions: Vec<Instruction>,
    /// The numbers that they name.
    pub numbers: Vec<f64>,
    /// The exact sums that they name.
    pub sums: Vec<LoweredSum>,
    /// How many conditions there are.
    pub conditions: usize,
    /// How many registers.
    pub registers: usize,
}

/// An exact sum that owns its parts.
#[derive(Clone, Debug, PartialEq)]
pub struct LoweredSum {
    /// Its operands.
    pub operands: Vec<Source>,
    /// Its terms in their compact form.
    pub terms: Vec<u8>,
}

impl Lowered {
    /// Calls `run` with the table.
    pub fn with<T>(&self, run: impl FnOnce(&Table) -> T) -> T {
        let sums: Vec<Sum> = self.sums.iter().map(|LoweredSum { operands, terms }| Sum { operands, terms }).collect();
        let Self { instructions, numbers, conditions, registers, .. } = self;
        run(&Table { instructions, numbers, sums: &sums, conditions: *conditions, registers: *registers })
    }
}

/// The table of a kernel; `None` where it would need more registers than tables have, or more places for conditions.
#[must_use]
pub fn lowered(kernel: &Kernel) -> Option<Lowered> {
    let mut lowering = Lowering::of(kernel);
    for slot in 0..kernel.inputs.len() {
        lowering.input(slot)?;
    }
    for require in &kernel.requires {
        lowering.condition(&require.condition)?;
        lowering.pop(Instruction::Require);
        lowering.end_of_statement();
    }
    for step in &kernel.lets {
        lowering.step(&step.value)?;
    }
    for value in kernel.output.values() {
        let value = lowering.value(value)?;
        lowering.put(Instruction::Return(value.register))?;
        lowering.release(value);
        lowering.end_of_statement();
    }
    lowering.table.registers = lowering.registers.most();
    lowering.table.conditions = kernel.requires.len();
    (lowering.table.registers <= MAX_REGISTERS).then_some(lowering.table)
}

/// Where a value is.
#[derive(Clone, Copy)]
struct Place {
    register: u8,
    /// Whether nothing else needs it: neither an input nor a step.
    temporary: bool,
}

struct Lowering {
    table: Lowered,
    registers: Registers,
    /// The registers of inputs and steps, while they are needed.
    slots: Vec<Option<u8>>,
    /// The statement in which each slot is needed last, if any.
    last: Vec<Option<usize>>,
    /// How many statements have ended: conditions, steps and results.
    statement: usize,
    /// How many conditions are on their stack.
    held: usize,
}

impl Lowering {
    fn of(kernel: &Kernel) -> Self {
        let mut last = vec![None; kernel.inputs.len() + kernel.lets.len()];
        let mut note = |statement: usize, expr: &Expr| {
            if let Expr::Name(name) = expr
                && let Some(last) = last.get_mut(name.slot)
            {
                *last = Some(statement);
            }
        };
        let conditions = kernel.requires.len();
        for (position, require) in kernel.requires.iter().enumerate() {
            require.condition.visit(&mut |expr| note(position, expr));
        }
        let values = kernel.lets.iter().map(|step| &step.value).chain(kernel.output.values());
        for (position, value) in values.enumerate() {
            value.visit(&mut |expr| note(conditions + position, expr));
        }
        let (table, registers) = (Lowered::default(), Registers::default());
        Lowering { table, registers, slots: Vec::new(), last, statement: 0, held: 0 }
    }

    /// `None` where jumps could not name the instruction.
    fn put(&mut self, instruction: Instruction) -> Option<()> {
        self.table.instructions.push(instruction);
        u16::try_from(self.table.instructions.len()).ok().map(|_| ())
    }

    fn input(&mut self, slot: usize) -> Option<()> {
        let needed = self.last.get(slot).is_some_and(Option::is_some);
        let register = if needed { Some(self.registers.take()?) } else { None };
        self.slots.push(register);
        register.map_or(Some(()), |register| self.put(Instruction::Input(register, u8::try_from(slot).ok()?)))
    }

    /// A step, unless nothing needs it.
    fn step(&mut self, value: &Expr) -> Option<()> {
        let needed = self.last.get(self.slots.len()).is_some_and(Option::is_some);
        let register = if needed { Some(self.owned(value)?) } else { None };
        self.slots.push(register);
        self.end_of_statement();
        Some(())
    }

    /// Gives back the registers of slots that nothing needs any more.
    fn end_of_statement(&mut self) {
        for (slot, last) in self.slots.iter_mut().zip(&self.last) {
            if *last == Some(self.statement)
                && let Some(register) = slot.take()
            {
                self.registers.release(register);
            }
        }
        self.statement += 1;
    }

    fn release(&mut self, place: Place) {
        if place.temporary {
            self.registers.release(place.register);
        }
    }

    /// A value in a register of its own.
    fn owned(&mut self, expr: &Expr) -> Option<u8> {
        let place = self.value(expr)?;
        if place.temporary {
            return Some(place.register);
        }
        let register = self.registers.take()?;
        self.put(Instruction::Copy(register, place.register))?;
        Some(register)
    }

    fn fresh(&mut self, instruction: impl FnOnce(u8) -> Instruction) -> Option<Place> {
        let register = self.registers.take()?;
        self.put(instruction(register))?;
        Some(Place { register, temporary: true })
    }

    fn value(&mut self, expr: &Expr) -> Option<Place> {
        match expr {
            Expr::Literal { value, .. } => {
                let number = self.number(*value)?;
                self.fresh(|register| Instruction::Number(register, number))
            }
            Expr::Pi(_) => self.fresh(Instruction::Pi),
            Expr::Name(name) => Some(Place { register: (*self.slots.get(name.slot)?)?, temporary: false }),
            Expr::Neg(inner) => self.unary(inner, Instruction::Negate),
            Expr::Call(function, inner) => self.unary(inner, |to, a| Instruction::Call(to, a, *function)),
            Expr::Binary { op, left, right } => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                self.binary(left, right, operation(*op))
            }
            Expr::Extreme { largest, items } => self.extreme(*largest, items),
            Expr::If { condition, then, otherwise } => self.choice(condition, then, otherwise),
            Expr::Compensated(expression) => self.compensated(expression),
            Expr::Residual(inner) => self.value(inner),
            Expr::PositiveRoot(coefficients) => self.root(coefficients),
        }
    }

    fn number(&mut self, value: f64) -> Option<u16> {
        let known = self.table.numbers.iter().position(|number| number.to_bits() == value.to_bits());
        let position = known.unwrap_or(self.table.numbers.len());
        if known.is_none() {
            self.table.numbers.push(value);
        }
        u16::try_from(position).ok()
    }

    fn unary(&mut self, inner: &Expr, instruction: impl FnOnce(u8, u8) -> Instruction) -> Option<Place> {
        let inner = self.value(inner)?;
        if !inner.temporary {
            return self.fresh(|to| instruction(to, inner.register));
        }
        self.put(instruction(inner.register, inner.register))?;
        Some(inner)
    }

    /// What takes two values puts what it makes in the place of one that nothing else needs.
    fn binary(&mut self, left: Place, right: Place, instruction: fn(u8, u8, u8) -> Instruction) -> Option<Place> {
        let (a, b) = (left.register, right.register);
        match (left.temporary, right.temporary) {
            (false, false) => self.fresh(|to| instruction(to, a, b)),
            (true, _) => {
                self.put(instruction(a, a, b))?;
                self.release(right);
                Some(left)
            }
            (false, true) => {
                self.put(instruction(b, a, b))?;
                Some(right)
            }
        }
    }

    fn extreme(&mut self, largest: bool, items: &[Expr]) -> Option<Place> {
        let instruction = if largest { Instruction::Larger } else { Instruction::Smaller };
        let (first, others) = items.split_first()?;
        let first = self.value(first)?;
        others.iter().try_fold(first, |best, next| {
            let next = self.value(next)?;
            self.binary(best, next, instruction)
        })
    }

    fn choice(&mut self, condition: &Condition, then: &Expr, otherwise: &Expr) -> Option<Place> {
        self.condition(condition)?;
        let unless = self.table.instructions.len();
        self.pop(Instruction::Unless(0));
        let register = self.registers.take()?;
        self.branch(register, then)?;
        let jump = self.table.instructions.len();
        self.put(Instruction::Jump(0))?;
        self.go_on_here(unless, Instruction::Unless)?;
        self.branch(register, otherwise)?;
        self.go_on_here(jump, Instruction::Jump)?;
        Some(Place { register, temporary: true })
    }

    fn branch(&mut self, to: u8, value: &Expr) -> Option<()> {
        let value = self.value(value)?;
        self.put(Instruction::Copy(to, value.register))?;
        self.release(value);
        Some(())
    }

    /// Makes a jump go to the next instruction.
    fn go_on_here(&mut self, from: usize, jump: fn(u16) -> Instruction) -> Option<()> {
        let here = u16::try_from(self.table.instructions.len()).ok()?;
        *self.table.instructions.get_mut(from)? = jump(here);
        Some(())
    }

    /// Coefficients stand in registers one after another.
    fn root(&mut self, coefficients: &[Expr]) -> Option<Place> {
        let first = self.registers.take_row(coefficients.len())?;
        let row = (first..).take(coefficients.len());
        for (register, coefficient) in row.clone().zip(coefficients) {
            self.branch(register, coefficient)?;
        }
        let count = u8::try_from(coefficients.len()).ok()?;
        self.put(Instruction::PositiveRoot(first, first, count))?;
        row.skip(1).for_each(|register| self.registers.release(register));
        Some(Place { register: first, temporary: true })
    }

    fn compensated(&mut self, expression: &CompensatedExpr) -> Option<Place> {
        let value = self.value(&expression.value)?;
        if matches!(Part::of(&expression.value), Part::Operand(_)) || !value.temporary {
            return Some(value);
        }
        let operands: Vec<Source> =
            expression.operands.iter().map(|operand| self.source(operand)).collect::<Option<_>>()?;
        let sum = u16::try_from(self.table.sums.len()).ok()?;
        self.table.sums.push(LoweredSum { operands, terms: expression.compact_terms().to_vec() });
        self.put(Instruction::Exactly(value.register, sum))?;
        Some(value)
    }

    fn source(&mut self, operand: &Expr) -> Option<Source> {
        match operand {
            Expr::Literal { value, .. } => self.number(*value).map(Source::Literal),
            Expr::Name(name) => self.slots.get(name.slot).copied().flatten().map(Source::Register),
            _ => None,
        }
    }

    fn condition(&mut self, condition: &Condition) -> Option<()> {
        match condition {
            Condition::Compare { op, left, right } => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                self.put(Instruction::Compare(*op, left.register, right.register))?;
                self.release(left);
                self.release(right);
                self.held += 1;
                (self.held <= MAX_HELD).then_some(())
            }
            Condition::And(left, right) => self.both(left, right, Instruction::And),
            Condition::Or(left, right) => self.both(left, right, Instruction::Or),
            Condition::Not(inner) => {
                self.condition(inner)?;
                self.put(Instruction::Not)
            }
        }
    }

    /// What joins two conditions takes one from their stack.
    fn both(&mut self, left: &Condition, right: &Condition, join: Instruction) -> Option<()> {
        self.condition(left)?;
        self.condition(right)?;
        self.pop(join);
        Some(())
    }

    /// An instruction that takes a condition from their stack.
    fn pop(&mut self, instruction: Instruction) {
        self.table.instructions.push(instruction);
        self.held -= 1;
    }
}

fn operation(op: BinaryOp) -> fn(u8, u8, u8) -> Instruction {
    match op {
        BinaryOp::Add => Instruction::Add,
        BinaryOp::Sub => Instruction::Subtract,
        BinaryOp::Mul => Instruction::Multiply,
        BinaryOp::Div => Instruction::Divide,
    }
}
