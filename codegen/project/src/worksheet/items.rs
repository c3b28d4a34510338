//! Items of parameters that are lists: each is a parameter itself.

use std::ops::Range;

use closedform_maxima::Expr;

use super::arrays::item;
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

    /// `a[1]` of what is no list that is known: an item of a parameter, or a name.
    pub(super) fn element(&mut self, array: &Expr, indices: &[Expr], span: &Range<usize>) -> Evaluated {
        match array.as_symbol().map(|name| (name, name.strip_prefix(PARAMETER))) {
            Some((_, Some(parameter))) => self.item_of(parameter, indices, span),
            Some((name, None)) => Ok(symbol(&self.subscripts.of(name, indices), span)),
            None => Ok(item(array, indices, span)?),
        }
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
