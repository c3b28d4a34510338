//! Names in C: the prefix of the crate, then family and kernel, then what of it.

use crate::error::BindError;
use crate::library::{Bound, Library, Quantity, plain};
use crate::names::{Scope, Symbols, identifier};

/// Keywords of C and C++, and words that are macros somewhere.
const KEYWORDS: [&str; 116] = [
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "complex",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "errno",
    "explicit",
    "export",
    "extern",
    "false",
    "far",
    "float",
    "for",
    "friend",
    "goto",
    "i386",
    "if",
    "imaginary",
    "inline",
    "int",
    "linux",
    "long",
    "main",
    "mutable",
    "namespace",
    "near",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "short",
    "signed",
    "size_t",
    "sizeof",
    "small",
    "static",
    "static_assert",
    "static_cast",
    "stderr",
    "stdin",
    "stdout",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "typeof_unqual",
    "union",
    "unix",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "I",
    "NULL",
    "NAN",
    "EOF",
    "INFINITY",
    "M_PI",
    "HUGE_VAL",
];

/// Names of arguments that every function may have besides those of its kernel.
const ARGUMENTS: [&str; 3] = ["result", "text", "size"];

/// The names of everything.
pub struct Names {
    /// What all names begin with.
    pub prefix: String,
    /// The name of the library for linkers, and of its crate.
    pub library: String,
    /// Those of the kernels, in order.
    pub kernels: Vec<KernelNames>,
}

/// The names of a kernel.
pub struct KernelNames {
    /// The default call.
    pub call: String,
    /// The faithful call.
    pub faithful: String,
    /// The checked call.
    pub checked: String,
    /// The call for many points.
    pub batch: String,
    /// The function that returns what is known.
    pub info: String,
    /// The struct of its results; `double` where there is one.
    pub returned: String,
    /// The function of the C99 source.
    pub tier1: String,
    /// The arguments for its inputs.
    pub inputs: Vec<String>,
    /// The arguments for its results.
    pub results: Vec<String>,
    /// The fields of the struct.
    pub fields: Vec<String>,
}

impl Names {
    /// The names of a library.
    ///
    /// # Errors
    ///
    /// When two things would have one name.
    pub fn new(library: &Library) -> Result<Self, BindError> {
        let prefix = identifier(&library.package.import);
        let mut symbols = Symbols::default();
        for own in ["view", "span", "input", "result", "info", "count", "at"] {
            symbols.take(&format!("{prefix}_{own}"), &format!("the {own} of the library"))?;
        }
        let kernels = library.kernels.iter().map(|kernel| KernelNames::new(&prefix, kernel)).collect::<Vec<_>>();
        for (kernel, names) in library.kernels.iter().zip(&kernels) {
            names
                .symbols()
                .iter()
                .try_for_each(|(symbol, what)| symbols.take(symbol, &format!("{what}{}", kernel.full_name())))?;
        }
        Ok(Self { library: format!("{prefix}_c"), prefix, kernels })
    }

    /// The prefix of constants.
    pub fn constants(&self) -> String {
        self.prefix.to_uppercase()
    }
}

impl KernelNames {
    fn new(prefix: &str, kernel: &Bound) -> Self {
        let own = format!("{}_{}", identifier(&kernel.family), identifier(plain(&kernel.name)));
        let symbol = |what: &str| format!("{prefix}_{own}{what}");
        let mut scope = Scope::new(&KEYWORDS);
        ARGUMENTS.iter().for_each(|argument| _ = scope.name(argument));
        let inputs = each(&kernel.inputs, |name| scope.name(name));
        let results = each(&kernel.results, |name| scope.name(&format!("{name}_out")));
        let mut fields = Scope::new(&KEYWORDS);
        Self {
            call: symbol(""),
            faithful: symbol("_faithful"),
            checked: symbol("_checked"),
            batch: symbol("_batch"),
            info: symbol("_info"),
            returned: if kernel.returned.is_some() { symbol("_results") } else { "double".to_owned() },
            tier1: format!("{prefix}_tier1_{own}"),
            inputs,
            results,
            fields: each(&kernel.results, |name| fields.name(name)),
        }
    }

    /// Every name that a whole program shares, and of what it is.
    fn symbols(&self) -> Vec<(&str, &'static str)> {
        let mut symbols = vec![
            (self.call.as_str(), ""),
            (&self.faithful, "the faithful call of "),
            (&self.checked, "the checked call of "),
            (&self.batch, "the batch of "),
            (&self.info, "what is known of "),
            (&self.tier1, "the C99 source of "),
        ];
        if self.returned != "double" {
            symbols.push((&self.returned, "the results of "));
        }
        symbols
    }
}

fn each(quantities: &[Quantity], name: impl FnMut(&str) -> String) -> Vec<String> {
    quantities.iter().map(|quantity| quantity.name.as_str()).map(name).collect()
}

/// A scope of C for the steps of a program, in which these names are taken.
pub fn scope_with(taken: &[String]) -> Scope<'static> {
    let mut scope = Scope::new(&KEYWORDS);
    taken.iter().for_each(|name| _ = scope.name(name));
    scope
}
