//! The page of verdicts, for an engineer to read: counts, the worst errors first, then every output in order.

mod table;
mod text;
mod worst;

use std::fmt::Write as _;

use super::judge::{Judged, Verdict};
use super::sheet::Sheet;
use text::prose;

pub use table::listed;

/// A scan with what was found of its rows.
type JudgedSheet<'a> = (&'a Sheet, Vec<Judged>);

const HEAD: &str = "<!-- written by `closedform derive` from the files in scan/; do not edit -->
# The verdict on the scans

Every formula that the scans print, against what its input cell gives when Maxima runs it again. Maxima has computed
every verdict: two forms are equal if the difference of each pair of their entries simplifies to 0, and they differ if
they have other values at the example; a right form satisfies the equations that it solves exactly. The formulas,
repairs and proofs stand in `scan/NAME.toml`, the cells as run again in `scan/NAME.mac`.

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
        let _ = write!(page, "[{0}.toml](scan/{0}.toml), [{0}.mac](scan/{0}.mac).\n\n", sheet.name);
        page += &table::table(sheet, judged);
    }
    page
}

fn meaning(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Equal => "the scan prints what the cell gives, and that is right",
        Verdict::Repaired => "it does after the repair of an obvious slip of the scan",
        Verdict::Garbled => "it does, but the printed text has more than one obvious slip",
        Verdict::Elided => "the scan does not show it; what Maxima gives is written out",
        Verdict::WorksheetError => "what the cell gives is not true; the right form is proved",
    }
}
