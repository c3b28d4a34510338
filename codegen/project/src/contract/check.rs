//! From TOML to a contract: everything that can be wrong with one.

use std::collections::BTreeMap;
use std::ops::Range;

use closedform_syntax::Dimension;
use toml::Spanned;

use super::super::domain::{Condition, Domain};
use super::error::{Mistake, span};
use super::names::{RustNameError, module_name, rust_name, type_name};
use super::{Contract, FamilyInfo, Input, KernelContract, ResultContract, TYPICAL, raw};

/// The contract, or all its mistakes.
pub(super) fn check(raw: raw::Contract, family: Option<String>, text: &str) -> Result<Contract, Vec<Mistake>> {
    let mut checker = Checker { text, mistakes: Vec::new() };
    checker.mistakes.extend(family.and_then(family_name));
    checker.not_empty(&raw.family.title, "the title of the family", "say in one line what the family is about");
    checker.inputs(&raw.inputs);
    let domains = checker.kernels(&raw);
    checker.unused_inputs(&raw);
    let contract = contract(raw, domains);
    if checker.mistakes.is_empty() { Ok(contract) } else { Err(checker.mistakes) }
}

fn family_name(name: String) -> Option<Mistake> {
    let cause = module_name(&name).err()?;
    Some(Mistake::FamilyName { name, cause })
}

struct Checker<'a> {
    text: &'a str,
    mistakes: Vec<Mistake>,
}

impl Checker<'_> {
    fn inputs(&mut self, inputs: &BTreeMap<Spanned<String>, raw::Input>) {
        for (maxima, input) in inputs {
            self.maxima_name(maxima);
            self.rust_name(&input.name, rust_name);
            self.unit(&input.unit);
            input.typical.iter().for_each(|typical| self.typical(typical));
        }
        let mut in_file_order: Vec<_> = inputs.values().map(|input| &input.name).collect();
        in_file_order.sort_by_key(|name| name.span().start);
        self.unique("the Rust name", in_file_order);
    }

    /// Checks all kernels, and reads their domains.
    fn kernels(&mut self, raw: &raw::Contract) -> Vec<Domain> {
        if raw.kernel.is_empty() {
            self.mistakes.push(Mistake::NoKernel);
        }
        let domains =
            raw.kernel.iter().map(|kernel| self.kernel(kernel.span(), kernel.get_ref(), &raw.inputs)).collect();
        let kernels = || raw.kernel.iter().map(Spanned::get_ref);
        self.unique("the kernel", kernels().map(|kernel| &kernel.name));
        self.unique("the struct", kernels().filter_map(|kernel| kernel.returns.as_ref()));
        self.unique("the worksheet function", kernels().flat_map(|k| &k.result).map(|result| &result.worksheet));
        domains
    }

    fn kernel(
        &mut self,
        place: Range<usize>,
        kernel: &raw::Kernel,
        inputs: &BTreeMap<Spanned<String>, raw::Input>,
    ) -> Domain {
        self.rust_name(&kernel.name, rust_name);
        if kernel.inputs.get_ref().is_empty() {
            let remedy = "list the Maxima names of the arguments, in their order";
            self.mistakes.push(Mistake::Empty { what: "the list of inputs", remedy, span: span(kernel.inputs.span()) });
        }
        for input in kernel.inputs.get_ref() {
            self.known_input(kernel, input, inputs);
        }
        self.unique("the input", kernel.inputs.get_ref());
        self.results(place, kernel);
        self.domain(kernel)
    }

    fn known_input(
        &mut self,
        kernel: &raw::Kernel,
        input: &Spanned<String>,
        inputs: &BTreeMap<Spanned<String>, raw::Input>,
    ) {
        if !inputs.keys().any(|known| known.get_ref() == input.get_ref()) {
            let nearest = nearest(input.get_ref(), inputs.keys().map(|name| name.get_ref().as_str()));
            self.mistakes.push(Mistake::UnknownInput {
                kernel: kernel.name.get_ref().clone(),
                input: input.get_ref().clone(),
                nearest: nearest.map(str::to_owned),
                span: span(input.span()),
            });
        }
    }

    /// The domain, without conditions that cannot be read.
    fn domain(&mut self, kernel: &raw::Kernel) -> Domain {
        let inputs = maxima_names(kernel);
        let mut conditions = Vec::new();
        for text in &kernel.domain {
            match Condition::parse(text.get_ref(), &inputs) {
                Ok(condition) => conditions.push((text.get_ref().clone(), condition)),
                Err(cause) => {
                    let span = span(self.inside(text, cause.span()));
                    self.mistakes.push(Mistake::Condition { kernel: kernel.name.get_ref().clone(), cause, span });
                }
            }
        }
        Domain::new(inputs, conditions)
    }

    /// The place in the file of a part of a string; the whole string where TOML escapes moved its letters.
    fn inside(&self, text: &Spanned<String>, part: Option<Range<usize>>) -> Range<usize> {
        let string = text.span();
        let inner = string.start + 1..string.end.saturating_sub(1);
        let spelt_out = self.text.get(inner.clone()) == Some(text.get_ref().as_str());
        match part {
            Some(part) if spelt_out => inner.start + part.start..inner.start + part.end,
            _ => string,
        }
    }

    fn results(&mut self, place: Range<usize>, kernel: &raw::Kernel) {
        for result in &kernel.result {
            self.rust_name(&result.name, rust_name);
            self.maxima_name(&result.worksheet);
            self.unit(&result.unit);
        }
        self.unique("the result", kernel.result.iter().map(|result| &result.name));
        let name = kernel.name.get_ref().clone();
        match (kernel.result.len(), &kernel.returns) {
            (0, _) => self.mistakes.push(Mistake::NoResult { kernel: name, span: span(place) }),
            (1, None) => (),
            (1, Some(returns)) => self.mistakes.push(Mistake::NeedlessStruct {
                kernel: name,
                returns: returns.get_ref().clone(),
                span: span(returns.span()),
            }),
            (_, Some(returns)) => self.rust_name(returns, type_name),
            (results, None) => {
                let span = span(kernel.name.span());
                self.mistakes.push(Mistake::NoStruct { kernel: name, results, span });
            }
        }
    }

    fn unused_inputs(&mut self, raw: &raw::Contract) {
        for input in raw.inputs.keys() {
            let taken = |kernel: &Spanned<raw::Kernel>| maxima_names(kernel.get_ref()).contains(input.get_ref());
            if !raw.kernel.is_empty() && !raw.kernel.iter().any(taken) {
                self.mistakes.push(Mistake::UnusedInput { input: input.get_ref().clone(), span: span(input.span()) });
            }
        }
    }

    fn rust_name(&mut self, name: &Spanned<String>, check: fn(&str) -> Result<(), RustNameError>) {
        if let Err(cause) = check(name.get_ref()) {
            self.mistakes.push(Mistake::Name { name: name.get_ref().clone(), cause, span: span(name.span()) });
        }
    }

    fn maxima_name(&mut self, name: &Spanned<String>) {
        let letter = |c: char| c.is_ascii_alphabetic() || c == '_' || c == '%';
        let rest = |c: char| letter(c) || c.is_ascii_digit();
        if !name.get_ref().starts_with(letter) || !name.get_ref().chars().all(rest) {
            self.mistakes.push(Mistake::MaximaName { name: name.get_ref().clone(), span: span(name.span()) });
        }
    }

    fn unit(&mut self, unit: &Spanned<String>) {
        if unit.get_ref().trim().is_empty() {
            self.not_empty(unit, "the unit", "write the unit, or \"1\" where there is none");
        } else if let Err(cause) = Dimension::of_unit(unit.get_ref()) {
            let place = self.inside(unit, Some(cause.span.clone()));
            self.mistakes.push(Mistake::Unit { unit: unit.get_ref().clone(), cause, span: span(place) });
        }
    }

    fn not_empty(&mut self, text: &Spanned<String>, what: &'static str, remedy: &'static str) {
        if text.get_ref().trim().is_empty() {
            self.mistakes.push(Mistake::Empty { what, remedy, span: span(text.span()) });
        }
    }

    fn typical(&mut self, typical: &Spanned<[f64; 2]>) {
        let [low, high] = *typical.get_ref();
        if !(0.0 < low && low <= high && high.is_finite()) {
            self.mistakes.push(Mistake::Typical { low, high, span: span(typical.span()) });
        }
    }

    fn unique<'a>(&mut self, what: &'static str, names: impl IntoIterator<Item = &'a Spanned<String>>) {
        let mut seen: BTreeMap<&str, Range<usize>> = BTreeMap::new();
        for name in names {
            match seen.get(name.get_ref().as_str()) {
                Some(first) => self.mistakes.push(Mistake::Duplicate {
                    what,
                    name: name.get_ref().clone(),
                    first: span(first.clone()),
                    span: span(name.span()),
                }),
                None => _ = seen.insert(name.get_ref(), name.span()),
            }
        }
    }
}

/// What is written, with the domains of its kernels.
fn contract(raw: raw::Contract, domains: Vec<Domain>) -> Contract {
    let few_roundings = raw.family.few_roundings;
    let kernels = raw.kernel.into_iter().zip(domains);
    let kernels = kernels.map(|(raw, domain)| kernel(raw.into_inner(), domain, few_roundings));
    Contract {
        family: FamilyInfo { title: raw.family.title.into_inner(), source: raw.family.source },
        inputs: raw.inputs.into_iter().map(|(name, input)| (name.into_inner(), self::input(input))).collect(),
        kernels: kernels.collect(),
    }
}

fn input(raw: raw::Input) -> Input {
    Input {
        name: raw.name.into_inner(),
        unit: raw.unit.into_inner(),
        typical: raw.typical.map_or(TYPICAL, Spanned::into_inner),
        doc: raw.doc,
    }
}

fn kernel(raw: raw::Kernel, domain: Domain, few_roundings: bool) -> KernelContract {
    KernelContract {
        inputs: maxima_names(&raw),
        name: raw.name.into_inner(),
        doc: raw.doc,
        source: raw.source,
        domain,
        branch: raw.branch,
        few_roundings: raw.few_roundings.unwrap_or(few_roundings),
        one_division: raw.one_division,
        edges: raw.edges,
        returns: raw.returns.map(Spanned::into_inner),
        results: raw.result.into_iter().map(result).collect(),
    }
}

fn result(raw: raw::Result) -> ResultContract {
    ResultContract { name: raw.name.into_inner(), worksheet: raw.worksheet.into_inner(), unit: raw.unit.into_inner() }
}

fn maxima_names(kernel: &raw::Kernel) -> Vec<String> {
    kernel.inputs.get_ref().iter().map(|name| name.get_ref().clone()).collect()
}

/// The listed name that differs only in case and underscores, if there is one.
fn nearest<'a>(name: &str, mut listed: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let plain = |name: &str| name.replace('_', "").to_lowercase();
    listed.find(|known| plain(known) == plain(name))
}
