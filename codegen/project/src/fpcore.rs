//! FPCore 2.0 (fpbench.org/spec/fpcore-2.0.html), as FPBench and Herbie write benchmarks: cores to definitions with domains.
//!
//! A core is read as the real function that it means, not as the roundings of the format that it names.

mod condition;
mod core;
mod expression;
mod mistake;
mod name;
mod number;
mod operation;
mod read;
mod scope;

pub use self::core::Core;
pub use mistake::CoreMistake;

/// The cores of a text, and everything that is wrong with the others.
#[must_use]
pub fn cores(text: &str) -> (Vec<Core>, Vec<CoreMistake>) {
    let (nodes, torn) = read::nodes(text);
    let mut mistakes: Vec<CoreMistake> = torn.into_iter().collect();
    if nodes.is_empty() && mistakes.is_empty() {
        let remedy = "write one, e.g. (FPCore f (x y) (sqrt (+ (* x x) (* y y))))";
        mistakes.push(CoreMistake::new("there is no FPCore in the file", remedy, 0..0));
    }
    let (mut cores, mut callable) = (Vec::new(), Vec::new());
    for node in &nodes {
        match core::core(node, text, &callable) {
            Ok((core, named)) => {
                cores.push(core);
                callable.extend(named);
            }
            Err(mistake) => mistakes.push(mistake),
        }
    }
    (cores, mistakes)
}

#[cfg(test)]
mod tests;
