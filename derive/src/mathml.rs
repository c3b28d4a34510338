//! LaTeX as MathML, which browsers set without a library: what `closedform` prints of formulas, and little more.
//!
//! What is not known here gives nothing: a page without its formula set is better than one with a wrong one.

mod read;
mod symbol;

use read::Reader;

/// Formulas, separated by `\\`, as a part of a page; `None` where a part of one is not known.
pub fn formulas(latex: &str) -> Option<String> {
    let rows = Reader::new(latex).rows()?;
    if rows.iter().all(String::is_empty) {
        return None;
    }
    let set = |row: &String| format!("<math display=\"block\" style=\"margin: 0.8em 0\"><mrow>{row}</mrow></math>");
    Some(format!("\n<div style=\"overflow-x: auto\">{}</div>\n", rows.iter().map(set).collect::<String>()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tags of one formula.
    fn one(latex: &str) -> Option<String> {
        Reader::new(latex).rows().map(|rows| rows.join(" | "))
    }

    #[test]
    fn what_formulas_are_made_of_becomes_tags() {
        for (latex, tags) in [
            ("x", "<mi>x</mi>"),
            ("2.5", "<mn>2.5</mn>"),
            (r"a+b", "<mi>a</mi><mo>+</mo><mi>b</mi>"),
            (r"-a", "<mo>−</mo><mi>a</mi>"),
            (r"\frac{1}{x}", "<mfrac><mrow><mn>1</mn></mrow><mrow><mi>x</mi></mrow></mfrac>"),
            (r"\sqrt{x}", "<msqrt><mrow><mi>x</mi></mrow></msqrt>"),
            (r"\sqrt[3]{x}", "<mroot><mrow><mi>x</mi></mrow><mrow><mn>3</mn></mrow></mroot>"),
            (r"x^{2}", "<msup><mi>x</mi><mrow><mn>2</mn></mrow></msup>"),
            (r"x_{1}^{2}", "<msubsup><mi>x</mi><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></msubsup>"),
            (r"t_{\mathrm{Out}}", "<msub><mi>t</mi><mrow><mi mathvariant=\"normal\">Out</mi></mrow></msub>"),
            (r"\tau\,a", "<mi>τ</mi><mspace width=\"0.17em\"/><mi>a</mi>"),
            (r"2\cdot 3", "<mn>2</mn><mo>⋅</mo><mn>3</mn>"),
            (r"\left(x\right)", "<mrow><mo>(</mo><mi>x</mi><mo>)</mo></mrow>"),
            (r"\left|x\right|", "<mrow><mo>|</mo><mi>x</mi><mo>|</mo></mrow>"),
            (r"\left\{x\right\}", "<mrow><mo>{</mo><mi>x</mi><mo>}</mo></mrow>"),
            (r"a < b \land c", "<mi>a</mi><mo>&lt;</mo><mi>b</mi><mo>∧</mo><mi>c</mi>"),
            (r"\max\left(a, b\right)", "<mi>max</mi><mrow><mo>(</mo><mi>a</mi><mo>,</mo><mi>b</mi><mo>)</mo></mrow>"),
            (r"a \\ b", "<mi>a</mi> | <mi>b</mi>"),
            (r"\text{if }\%", "<mtext>if </mtext><mi>%</mi>"),
            (
                r"\begin{cases}a & b \\ c & d\end{cases}",
                "<mrow><mo>{</mo><mtable columnalign=\"left\"><mtr><mtd><mi>a</mi></mtd><mtd><mi>b</mi></mtd></mtr>\
                 <mtr><mtd><mi>c</mi></mtd><mtd><mi>d</mi></mtd></mtr></mtable></mrow>",
            ),
        ] {
            assert_eq!(one(latex).as_deref(), Some(tags), "{latex}");
        }
    }

    #[test]
    fn what_is_not_known_gives_nothing() {
        for latex in
            [r"\unknown", r"\frac{1}", r"{x", r"x}", r"\left(x", r"x^", r"x^{2}^{3}", r"\right)", r"&", "\\", ""]
        {
            assert_eq!(formulas(latex), None, "{latex}");
        }
        assert_eq!(formulas(&"{".repeat(100_000)), None);
        assert_eq!(formulas(&r"\sqrt{".repeat(100_000)), None);
    }
}
