//! Items of parameters that are lists: each is a parameter itself.

use std::ops::Range;

use closedform_maxima::Expr;

use super::evaluate::{Evaluator, PARAMETER, because_of};
use super::state::{Evaluated, Refusal};
use super::tree::{self, small, symbol};

const REMEDY: &str = "give each of its items a parameter";

impl Evaluator {
    /// `v[1]` of a parameter `v`, or of an item of one.
    pub(super) fn item_of(&mut self, parameter: &str, indices: &[Expr], span: &Range<usize>) -> Evaluated {
        let (list, mut places) =
            self.items.get(parameter).cloned().unwrap_or_else(|| (parameter.to_owned(), Vec::new()));
        let Some(own) = indices.iter().map(small).collect::<Option<Vec<i64>>>() else {
            let what = format!("the parameter `{list}` is a list of which an item is taken whose place is not known");
            let unknown: Vec<&Expr> = indices.iter().collect();
            return Err(because_of(&unknown, Refusal::new(what, REMEDY, span)).into());
        };
        places.extend(own);
        let indices: Vec<Expr> = places.iter().map(|place| tree::number(*place, span)).collect();
        let name = self.subscripts.of(&list, &indices);
        let item = symbol(&format!("{PARAMETER}{name}"), span);
        self.items.insert(name, (list, places));
        Ok(item)
    }

    /// Parameters, those of which items are taken in a value by these, in the order of their places.
    pub(super) fn with_items(&self, parameters: Vec<String>, value: &Expr) -> Result<Vec<String>, Refusal> {
        let named = tree::names(value);
        let is_there = |name: &str| named.iter().any(|other| other.strip_prefix(PARAMETER) == Some(name));
        let mut all = Vec::new();
        for parameter in parameters {
            let items = self.items.iter().filter(|(name, (of, _))| *of == parameter && is_there(name));
            let mut items: Vec<(&Vec<i64>, &String)> = items.map(|(name, (_, places))| (places, name)).collect();
            items.sort();
            // what stands inside another comes right after it
            let has_items = items.windows(2).any(|pair| pair[1].0.starts_with(pair[0].0));
            match (items.is_empty(), has_items || is_there(&parameter)) {
                (true, _) => all.push(parameter),
                (false, false) => all.extend(items.into_iter().map(|(_, name)| name.clone())),
                (false, true) => {
                    let what = format!("the parameter `{parameter}` is a list in one place and a number in another");
                    return Err(Refusal::new(what, REMEDY, &value.span));
                }
            }
        }
        Ok(all)
    }
}
