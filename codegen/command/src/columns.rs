//! Tables of text, whose names and numbers are never broken, so that they can be copied: columns for terminals of any width,
//! and tables that fit the terminal if their words do.

use comfy_table::{ColumnConstraint, ContentArrangement, Table, Width, presets};

/// Rows below their header, every column as wide as its widest entry, the last one as long as it is.
pub fn text<const N: usize>(header: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    let rows: Vec<[String; N]> = [header.map(str::to_owned)].into_iter().chain(rows).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..N).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}"));
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text.push('\n');
    }
    text
}

/// A table as wide as the terminal, or wider if its words need that: lines break between words only.
pub fn table<const N: usize>(header: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    drawn(header, rows, Table::new())
}

fn drawn<const N: usize>(header: [&str; N], rows: impl IntoIterator<Item = [String; N]>, mut table: Table) -> String {
    let rows: Vec<[String; N]> = rows.into_iter().collect();
    table.load_style(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_header(header).add_rows(&rows);
    for (at, column) in table.column_iter_mut().enumerate() {
        let texts = rows.iter().map(|row| row[at].as_str()).chain([header[at]]);
        let widest = texts.flat_map(str::split_whitespace).map(|word| word.chars().count()).max().unwrap_or(0);
        let width = column.padding_width() + u16::try_from(widest).unwrap_or(u16::MAX / 2);
        column.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(width)));
    }
    table.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers_are_whole_in_every_terminal() {
        let row =
            ["waypoints::quadratic_linear_quadratic", "t1", "x = 0.5 (0x1p-1)\ny = 0.25 (0x1p-2)"].map(str::to_owned);
        let header = ["kernel", "a result of it", "worst inputs"];
        let of_width = |columns: u16| {
            let mut table = Table::new();
            table.set_width(columns);
            drawn(header, [row.clone()], table)
        };
        for columns in [10, 40, 70, 80, 200] {
            let text = of_width(columns);
            for word in header.iter().copied().chain(row.iter().map(String::as_str)).flat_map(str::split_whitespace) {
                assert!(text.split_whitespace().any(|whole| whole == word), "{word} is broken:\n{text}");
            }
            let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
            assert!(columns < 70 || widest <= usize::from(columns), "{widest} columns of {columns}:\n{text}");
        }
        // no wider than its words, the room beside each and two lines between them
        assert_eq!(of_width(200).lines().next().map(|line| line.chars().count()), Some(37 + 14 + 17 + 3 * 2 + 2));
    }

    #[test]
    fn columns_stand_below_each_other() {
        let rows = [["a".to_owned(), "\u{b2}".to_owned()], ["long::name".to_owned(), String::new()]];
        assert_eq!(text(["name", "x"], rows), "name        x\na           \u{b2}\nlong::name\n");
    }
}
