//! Parameters: numbers and names that a program sets, and what the controller says of itself.

use std::collections::HashMap;

use super::error::Problem;

/// Parameters that each call of a sub-program has for itself: #1 to #33 of Fanuc, of which LinuxCNC has 30.
pub(super) const ARGUMENTS: usize = 33;

/// The most parameters that a program may set.
const MOST: usize = 1 << 20;

/// What the controller says of itself: numbers as #5420, names as #<_x>.
pub(super) trait Controller {
    /// Of a numbered parameter that belongs to the controller.
    fn number(&self, number: u32) -> Option<f64>;
    /// Of a name without its `_`.
    fn name(&self, name: &str) -> Option<f64>;
}

/// What belongs to one call.
#[derive(Debug)]
struct Local {
    arguments: [f64; ARGUMENTS],
    names: HashMap<String, f64>,
}

/// All parameters.
#[derive(Debug)]
pub(super) struct Parameters {
    numbers: HashMap<u32, f64>,
    globals: HashMap<String, f64>,
    locals: Vec<Local>,
}

impl Parameters {
    /// With those that are given.
    pub(super) fn new(given: &[(String, f64)]) -> Self {
        let mut parameters = Self { numbers: HashMap::new(), globals: HashMap::new(), locals: Vec::new() };
        parameters.enter([0.0; ARGUMENTS]);
        for (name, value) in given {
            match name.parse::<u32>() {
                Ok(number) => _ = parameters.set(number, *value),
                // Given ones are known in all sub-programs.
                Err(_) => _ = parameters.globals.insert(plain(name), *value),
            }
        }
        parameters
    }

    /// A sub-program begins, with these arguments.
    pub(super) fn enter(&mut self, arguments: [f64; ARGUMENTS]) {
        self.locals.push(Local { arguments, names: HashMap::new() });
    }

    /// It ends.
    pub(super) fn leave(&mut self) {
        if self.locals.len() > 1 {
            self.locals.pop();
        }
    }

    /// The value of a number; 0 where it has none.
    pub(super) fn number(&self, number: u32, controller: &dyn Controller) -> f64 {
        if let Some(argument) = argument(number) {
            return self.local().map_or(0.0, |local| local.arguments[argument]);
        }
        match self.numbers.get(&number) {
            Some(value) => *value,
            None => controller.number(number).unwrap_or(0.0),
        }
    }

    /// The value of a name, if it has one.
    pub(super) fn name(&self, name: &str, controller: &dyn Controller) -> Option<f64> {
        if let Some(value) = self.local().and_then(|local| local.names.get(name)) {
            return Some(*value);
        }
        let own = || name.strip_prefix('_').and_then(|name| controller.name(name));
        self.globals.get(name).copied().or_else(own)
    }

    /// Gives a number its value.
    pub(super) fn set(&mut self, number: u32, value: f64) -> Result<(), Problem> {
        if let (Some(argument), Some(local)) = (argument(number), self.locals.last_mut()) {
            local.arguments[argument] = value;
            return Ok(());
        }
        self.numbers.insert(number, value);
        self.few()
    }

    /// Gives a name its value: one that begins with `_` is known everywhere.
    pub(super) fn set_name(&mut self, name: &str, value: f64) -> Result<(), Problem> {
        let names = match self.locals.last_mut() {
            Some(local) if !name.starts_with('_') => &mut local.names,
            _ => &mut self.globals,
        };
        names.insert(name.to_owned(), value);
        self.few()
    }

    fn few(&self) -> Result<(), Problem> {
        if self.numbers.len() + self.globals.len() + self.local().map_or(0, |local| local.names.len()) <= MOST {
            return Ok(());
        }
        Err(Problem::Limit { what: "parameters", most: MOST as u64, remedy: "this is a loop that never ends" })
    }

    fn local(&self) -> Option<&Local> {
        self.locals.last()
    }
}

/// A name as it is compared: lower case, without blanks.
pub(super) fn plain(name: &str) -> String {
    name.chars().filter(|letter| !letter.is_whitespace()).flat_map(char::to_lowercase).collect()
}

fn argument(number: u32) -> Option<usize> {
    (1..=ARGUMENTS as u32).contains(&number).then(|| number as usize - 1)
}

/// The parameters of G65 by their letters, as Fanuc has them.
pub(super) fn arguments(words: &[Option<f64>; 26]) -> [f64; ARGUMENTS] {
    const NUMBERS: [(char, usize); 21] = [
        ('A', 1),
        ('B', 2),
        ('C', 3),
        ('I', 4),
        ('J', 5),
        ('K', 6),
        ('D', 7),
        ('E', 8),
        ('F', 9),
        ('H', 11),
        ('M', 13),
        ('Q', 17),
        ('R', 18),
        ('S', 19),
        ('T', 20),
        ('U', 21),
        ('V', 22),
        ('W', 23),
        ('X', 24),
        ('Y', 25),
        ('Z', 26),
    ];
    let mut arguments = [0.0; ARGUMENTS];
    for (letter, number) in NUMBERS {
        arguments[number - 1] = words[usize::from(letter as u8 - b'A')].unwrap_or(0.0);
    }
    arguments
}
