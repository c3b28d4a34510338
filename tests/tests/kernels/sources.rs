//! A kernel against what it comes from: Maxima's numbers, its own text, and the files that it needs.

use closedform_tests::algebra::check_golden;
use closedform_tests::check::Judge;
use closedform_tests::coverage::Family;
use closedform_tests::harness::Said;
use closedform_tests::printing::check_printing;
use closedform_tests::{bounds, golden as golden_values, worksheets};

/// The program, run in MPFR, has Maxima's own numbers to all their digits.
pub fn golden(judge: &Judge) -> Said {
    let info = judge.kernel.info;
    match check_golden(judge, &golden_values::load(info.family))? {
        0 => Err(format!("{}: no golden values", info.name)),
        judged => Ok(format!("{judged} golden values")),
    }
}

/// The bounds that users link are those that the kernel's text proves.
pub fn proof(judge: &Judge) -> Said {
    let info = judge.kernel.info;
    let proved = bounds::proved(info.name).map_err(|refused| format!("{}: {refused}", info.name))?;
    let proved: Vec<(&str, Option<f64>)> =
        proved.iter().map(|bound| (bound.result.as_str(), Some(bound.ulp))).collect();
    let linked: Vec<(&str, Option<f64>)> = info.results.iter().map(|result| (result.name, result.bound_ulp)).collect();
    if proved != linked {
        return Err(format!("{}: the text proves {proved:?}, users link {linked:?}", info.name));
    }
    Ok(format!("{proved:?}"))
}

/// The kernel has its contract, references, enough golden values and bounds.
pub fn complete(judge: &Judge) -> Said {
    let gaps = Family::load(judge.kernel.info.family, &[judge.kernel.info]).gaps_of(judge.kernel.info);
    if gaps.is_empty() { Ok(String::new()) } else { Err(gaps.join("\n")) }
}

/// The reference expressions survive parsing and printing.
pub fn reference(judge: &Judge) -> Said {
    let info = judge.kernel.info;
    let text = worksheets::read(info.family, "ref");
    for result in info.results {
        let begins = format!("{}(", result.worksheet);
        let line = text.lines().find(|line| line.starts_with(&begins));
        let line = line.ok_or_else(|| format!("{}: no reference `{}`", info.name, result.worksheet))?;
        check_printing(line).map_err(|broken| format!("{}: `{}` {broken}", info.name, result.worksheet))?;
    }
    Ok(String::new())
}
