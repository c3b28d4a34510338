//! The page of verdicts, for an engineer to read: counts, the worst errors first, then every output in order.

mod table;
mod text;
mod worst;

use std::fmt::Write as _;

use super::judge::{Judged, Verdict};
use super::sheet::Sheet;
use text::prose;

pub use table::listed;

/// A file with what was found of its rows.
type JudgedSheet<'a> = (&'a Sheet, Vec<Judged>);

const HEAD: &str = "<!-- written by `closedform derive` from the files in errata/; do not edit -->
# Errata of the printed derivations

Every formula that they print, against what its input cell gives when Maxima runs it again. Maxima has computed
every verdict: two forms are equal if the difference of each pair of their entries simplifies to 0, and they differ if
they have other values at the example; a right form satisfies the equations that it solves exactly. The formulas,
repairs and proofs stand in `errata/NAME.toml`, the cells as run again in `errata/NAME.mac`.

| verdict | outputs | meaning |
|---|---:|---|
";

/// The page.
pub(super) fn print(sheets: &[JudgedSheet]) -> String {
    let mut page = HEAD.to_owned();
    let rows = || sheets.iter().flat_map(|(sheet, _)| &sheet.rows);
    for verdict in Verdict::ALL {
        let count = rows().filter(|row| row.verdict == verdict).count();
        let _ = writeln!(page, "| {verdict} | {count} | {} |", meaning(verdict));
    }
    let _ = writeln!(page, "| | {} | |", rows().count());
    page += &worst::section(sheets);
    for (sheet, judged) in sheets {
        let _ = write!(page, "\n## {}\n\nFrom {}: ", prose(&sheet.title), prose(&sheet.source));
        let _ = write!(page, "[{0}.toml](errata/{0}.toml), [{0}.mac](errata/{0}.mac).\n\n", sheet.name);
        page += &table::table(sheet, judged);
    }
    page
}

fn meaning(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Equal => "the derivation prints what the cell gives, and that is right",
        Verdict::Repaired => "it does after the repair of an obvious slip of the print",
        Verdict::Garbled => "it does, but the printed text has more than one obvious slip",
        Verdict::Elided => "the derivation does not show it; what Maxima gives is written out",
        Verdict::WorksheetError => "what the cell gives is not true; the right form is proved",
    }
}
