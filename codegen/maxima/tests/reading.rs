//! What texts are read as: spans, statements, definitions, exact numbers, LaTeX.

use closedform_maxima::exact::{self, ExactError};
use closedform_maxima::{
    DIGIT_LIMIT, Error, ExprKind, Terminator, definitions, parse_expression, parse_statements, print, to_latex,
    worksheet,
};
use num_bigint::BigInt;
use num_rational::BigRational;

#[test]
fn spans_cover_their_text() {
    let text = "a + (b*c) /* d */ ^2";
    let sum = parse_expression(text).expect("parses");
    assert_eq!(&text[sum.span.clone()], text);
    let ExprKind::Binary { right, .. } = sum.kind else { panic!("a sum") };
    assert_eq!(&text[right.span.clone()], "(b*c) /* d */ ^2");
    let ExprKind::Binary { left, .. } = right.kind else { panic!("a power") };
    assert_eq!(&text[left.span], "(b*c)");
}

#[test]
fn statements_have_labels_and_terminators() {
    let statements = parse_statements("(%i1) a:1;\n(%o12) b=2$ (%o3)+1; (%i4); f(x), x=1$").expect("parses");
    let read: Vec<_> = statements.iter().map(|s| (s.label.as_deref(), print(&s.expression), s.terminator)).collect();
    assert_eq!(
        read,
        [
            (Some("%i1"), "a:1".to_owned(), Terminator::Show),
            (Some("%o12"), "b=2".to_owned(), Terminator::Hide),
            (None, "%o3+1".to_owned(), Terminator::Show),
            (None, "%i4".to_owned(), Terminator::Show),
            (None, "f(x),x=1".to_owned(), Terminator::Hide),
        ]
    );
}

#[test]
fn continued_lines_are_joined() {
    assert_eq!(
        print(&parse_expression("12\\\n34 + ab\\\ncd + \"a\\\nb\" \\\n + 1").expect("parses")),
        "1234+abcd+\"ab\"+1"
    );
}

#[test]
fn a_number_has_its_digits_even_across_lines() {
    assert_eq!(print(&parse_expression("1\\\n.\\\n5e\\\n3").expect("parses")), "1.5e3");
    for text in ["1e\\\n", "1e\\\n+x", "2.5b\\\n;", "1e-\\\n", ".\\\n"] {
        parse_expression(text).expect_err(text);
    }
}

#[test]
fn a_byte_order_mark_is_passed_over_where_it_belongs() {
    let sheet = worksheet("\u{feff}f(x):=x$").expect("parses");
    assert_eq!(sheet.definitions[0].span, 3..10);
    worksheet("f(x):=\u{feff}x$").expect_err("in the middle it is a character that Maxima does not know");
}

#[test]
fn numbers_without_end_are_refused_at_once() {
    let longest = "9".repeat(DIGIT_LIMIT);
    parse_expression(&longest).expect("parses");
    for number in
        ["9".repeat(1_000_000), format!("0.{}", "3".repeat(1_000_000)), format!("{}b0", "1".repeat(1_000_000))]
    {
        let error = parse_expression(&number).expect_err("too many digits");
        assert!(matches!(error, Error::LongNumber { .. }), "{error}");
    }
}

#[test]
fn all_mistakes_are_reported() {
    let errors = parse_statements("a+;b$c*$d d;e$").expect_err("three mistakes").errors;
    assert_eq!(errors.iter().map(|error| error.span().start).collect::<Vec<_>>(), [2, 7, 10]);
}

#[test]
fn definitions_and_the_rest_are_told_apart() {
    let text = "load(facexp)$ f(x,y):=x+y$ define(g(t), t^2)$ h:3$ k([x]):=x$ a[i]:=i$ c():=1$";
    let sheet = worksheet(text).expect("parses");
    let heads: Vec<_> =
        sheet.definitions.iter().map(|d| format!("{}({})={}", d.name, d.parameters.join(","), d.body)).collect();
    assert_eq!(heads, ["f(x,y)=x+y", "g(t)=t^2", "c()=1"]);
    assert_eq!(&text[sheet.definitions[1].span.clone()], "define(g(t), t^2)");
    let others: Vec<_> = sheet.others.iter().map(ToString::to_string).collect();
    assert_eq!(others, ["load(facexp)$", "h:3$", "k([x]):=x$", "a[i]:=i$"]);
    definitions(text).expect_err("others are no definitions");
}

fn exactly(text: &str) -> Result<BigRational, ExactError> {
    exact::rational(&parse_expression(text).expect("parses"))
}

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(BigInt::from(numerator), BigInt::from(denominator))
}

#[test]
fn numbers_are_exact() {
    for (text, value) in [
        ("12", ratio(12, 1)),
        ("2.", ratio(2, 1)),
        (".5", ratio(1, 2)),
        ("0.1", ratio(3_602_879_701_896_397, 36_028_797_018_963_968)),
        ("2.e3", ratio(2000, 1)),
        ("1.25d+1", ratio(25, 2)),
        ("0.1b0", ratio(1, 10)),
        ("1.5B-3", ratio(3, 2000)),
        (".25b2", ratio(25, 1)),
        ("0b99", ratio(0, 1)),
    ] {
        assert_eq!(exactly(text), Ok(value), "{text}");
    }
    assert_eq!(exactly("1e999"), Err(ExactError::TooLarge { span: 0..5 }));
    assert_eq!(exactly("1b9999999999999999999"), Err(ExactError::TooLarge { span: 0..21 }));
    assert_eq!(exactly("1b99999"), Err(ExactError::TooLarge { span: 0..7 }));
    assert_eq!(exactly("x"), Err(ExactError::NotANumber { span: 0..1 }));
}

#[test]
fn latex_reads_like_mathematics() {
    for (text, latex) in [
        ("a/b", r"\frac{a}{b}"),
        ("-a/b*c", r"\frac{-a}{b}\,c"),
        ("2*3*x^2", r"2\cdot 3\,x^{2}"),
        ("x^(1/2)+y^(1/3)", r"\sqrt{x}+\sqrt[3]{y}"),
        ("(a+b)*(c-d)", r"\left(a+b\right)\,\left(c-d\right)"),
        ("a-(b-c)", r"a-\left(b-c\right)"),
        ("a*(-b)", r"a\,\left(-b\right)"),
        ("(-a)^2", r"\left(-a\right)^{2}"),
        ("(a^b)^c", r"\left(a^{b}\right)^{c}"),
        ("(a/b)^2", r"\left(\frac{a}{b}\right)^{2}"),
        ("sqrt(3*a2Max*d2Step)-tOut", r"\sqrt{3\,a_{2,\mathrm{Max}}\,d_{2,\mathrm{Step}}}-t_{\mathrm{Out}}"),
        ("delta+Delta_x+tau1+v0+tEdgeTotal", r"\delta+\Delta_{x}+\tau_{1}+v_{0}+t_{\mathrm{EdgeTotal}}"),
        ("height*%pi*%e^x", r"\mathrm{height}\,\pi\,e^{x}"),
        ("a<=b and not c#d", r"a\leq b\land \lnot c\neq d"),
        ("abs(x)+max(a,b)+sin(x)", r"\left|x\right|+\max\left(a, b\right)+\sin\left(x\right)"),
        ("positive_root(x^2-a,x)", r"\operatorname{root}_{x>0}\left(x^{2}-a\right)"),
        ("if a>0 then b else c", r"\begin{cases}b & \text{if } a>0 \\ c & \text{otherwise}\end{cases}"),
        ("f(x):=1.5e-3*x", r"f\left(x\right):=1.5\cdot 10^{-3}\,x"),
    ] {
        assert_eq!(to_latex(&parse_expression(text).expect(text)), latex, "{text}");
    }
}

#[test]
fn a_keyword_is_told_from_a_name() {
    for (text, word) in [
        ("f(do):=do^2", "do"),
        ("f(x,for):=x", "for"),
        ("f(if,x):=x", "if"),
        ("f(then):=then^2", "then"),
        ("x+else", "else"),
        ("x*(and)", "and"),
        ("2*not", "not"),
        ("f(x,while)", "while"),
    ] {
        let error = parse_expression(text).expect_err(text);
        assert!(matches!(error, Error::Keyword { word: found, .. } if found == word), "{text}: {error:?}");
        assert_eq!(&text[error.span()], word, "{text}");
        let drawn = format!("{:?}", miette::Report::new(error));
        let help = drawn.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(help.contains(&format!("`{word}` is a keyword of Maxima")) && help.contains("another one"), "{help}");
    }
    // a name here as in Maxima
    parse_expression("f(in):=in^2").expect("parses");
    assert!(matches!(parse_expression("2*)"), Err(Error::UnexpectedToken { .. })));
}

#[test]
fn what_is_wrong_does_not_hide_what_is_right() {
    let text = "a:1$ b+;c:2$ d:2\u{b7}e$ f d$ g:3$";
    let (statements, errors) = closedform_maxima::parse_what_can_be(text);
    let read: Vec<&str> = statements.iter().map(|statement| &text[statement.expression.span.clone()]).collect();
    assert_eq!(read, ["a:1", "c:2", "g:3"]);
    let places: Vec<usize> = errors.iter().map(|error| error.span().start).collect();
    assert_eq!(places, [7, 16, 23], "one a statement, in order: {errors:?}");
}

#[test]
fn declared_operators_are_calls_of_their_names() {
    let read = |text: &str| {
        let statements = parse_statements(text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
        print(&statements.last().expect("a statement").expression)
    };
    assert_eq!(read("infix(\"plus\")$ y: a*b plus c+1$"), "y:a*plus(b,c)+1");
    assert_eq!(read("infix(\"plus\", 90, 90)$ y: a*b plus c+1$"), "y:plus(a*b,c+1)");
    assert_eq!(read("nary(\"both\")$ y: a both b both c$"), "y:both(a,b,c)");
    assert_eq!(read("prefix(\"half\")$ y: half x+1$"), "y:half(x)+1");
    assert_eq!(read("postfix(\"percent\")$ y: 1+x percent$"), "y:1+percent(x)");
    assert_eq!(read("matchfix(\"open\", \"close\")$ y: open a, b close$"), "y:open(a,b)");
    assert_eq!(read("nofix(\"all_of\")$ y: all_of+1$"), "y:all_of()+1");
    assert_eq!(read("infix(\"plus\")$ \"plus\"(a,b) := a+b$"), "plus(a,b):=a+b");
    assert_eq!(read("infix(\"=>\")$ y: a => b$"), read("y: \\=\\>(a,b)$"), "the longest name counts");
    assert_eq!(read("load(\"vect\")$ y: a ~ grad b$"), read("y: \\~(a,grad(b))$"));
    assert_eq!(read("infix(\"+\")$ y: a+b$"), "y:a+b", "what Maxima has keeps its meaning");
    parse_statements("y: a ~ b$").expect_err("nobody has declared it");
    parse_statements("matchfix(\"open\", \"close\")$ y: open a$").expect_err("it is not closed");
}

#[test]
fn a_line_of_lisp_is_a_statement() {
    let statements = parse_statements("x: 1$\n:lisp (car |$x|)\ny: x$").expect("parses");
    let read: Vec<String> = statements.iter().map(|statement| print(&statement.expression)).collect();
    assert_eq!(read[1..], [print(&parse_expression("\\:lisp(\"(car |$x|)\")").expect("parses")), "y:x".to_owned()]);
    assert_eq!(print(&parse_expression("x :lisp").expect("parses")), "x:lisp", "elsewhere it is a name");
}

#[test]
fn a_line_that_asks_is_a_statement() {
    let read =
        |text: &str| parse_statements(text).expect("parses").iter().map(|it| print(&it.expression)).collect::<Vec<_>>();
    assert_eq!(read("x: 1$\n? sqrt;\n?? ab\ny: x$"), ["x:1", "describe(\"sqrt\")", "describe(\"ab\")", "y:x"]);
    assert_eq!(read("?car(x)$"), ["?car(x)"], "without a blank it is a name of Lisp");
    assert!(parse_statements("x ? y$").is_err(), "elsewhere it asks nothing");
}

#[test]
fn letters_are_what_maxima_takes_for_letters_and_nobody_for_an_operator() {
    for name in ["a\u{301}", "x\u{2081}", "\u{1f350}", "\u{3b1}\u{308}"] {
        assert_eq!(parse_expression(name).expect("parses").as_symbol(), Some(name));
    }
    for text in ["x\u{b2}", "x\u{2260}y", "x\u{b7}y", "x\u{2212}y", "x\u{207b}"] {
        assert!(parse_expression(text).is_err(), "{text}");
    }
}
