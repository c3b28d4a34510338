//! Formulas for every rule: such as it is used on, and such as it is refused on.

/// Every rule, for a macro that makes a test for each.
macro_rules! for_each_rule {
    ($macro:ident) => {
        $macro! {
            certified
            compensated
            conjugate
            cube_conjugate
            cube_quotient
            differences_first
            distributed
            double_double
            factored
            fused
            known_sum
            merge_cubes
            merge_roots
            monotone_newton
            one_reciprocal
            same_sign_radicand
            sign_branch
            through_result
        }
    };
}

/// Formulas of a, b, c and d, with a number in place of `?`, one a result.
#[derive(Clone, Copy)]
pub struct Case {
    pub rule: &'static str,
    pub domain: &'static str,
    pub options: &'static str,
    pub formulas: &'static [&'static str],
    /// The bound that the rule leaves, and how many operations; no more are needed whatever the number is.
    pub worth: (f64, usize),
}

pub const fn case(rule: &'static str, domain: &'static str, formulas: &'static [&'static str]) -> Case {
    Case { rule, domain, options: "few_roundings = false\n", formulas, worth: (f64::INFINITY, usize::MAX) }
}

const fn used(
    rule: &'static str,
    domain: &'static str,
    formulas: &'static [&'static str],
    worth: (f64, usize),
) -> Case {
    Case { worth, ..case(rule, domain, formulas) }
}

const fn with(options: &'static str, case: Case) -> Case {
    Case { options, ..case }
}

pub const POSITIVE: &str = "a > 0;b > 0;c > 0;d > 0";
const FEW: &str = "few_roundings = true\n";
const FEW_AND_ONE: &str = "few_roundings = true\none_division = true\n";
const ONE_DIVISION: &str = "few_roundings = false\none_division = true\n";

/// Where conditions hold.
pub const USED: [Case; 102] = [
    used("compensated", "", &["?*a*b-c*d"], (0.51, 4)),
    used("compensated", POSITIVE, &["?*a^2*b-c"], (0.51, 4)),
    // never positive
    used("compensated", "a*b > c*d", &["?*c*d-?*a*b"], (2.01, 4)),
    used("conjugate", "a >= 0;b > 0", &["sqrt(?*a+b)-sqrt(?*a)"], (4.0, 6)),
    used("conjugate", POSITIVE, &["(sqrt(a^2+?*b)-a)/c"], (4.51, 8)),
    // the terms below the bar are negative
    used("conjugate", "a < 0;b > 0", &["sqrt(a^2+?*b)+a"], (4.51, 7)),
    used("cube-conjugate", POSITIVE, &["(?*a+b)^(1/3)-(?*a)^(1/3)"], (0.51, 9)),
    used("cube-conjugate", "a > 0;b > 0", &["(a*b)^(2/3)-?*a"], (0.51, 14)),
    used("cube-conjugate", "a < 0;b > 0", &["?*a^(1/3)+b^(1/3)"], (0.51, 10)),
    used("cube-quotient", "a # b", &["1/(a^(1/3)-b^(1/3))"], (0.51, 14)),
    used("cube-quotient", "a > 0;b < 0", &["c/((?*a)^(1/3)-b^(1/3))"], (3.34, 5)),
    // the term in the middle is opposed everywhere
    used("cube-quotient", "a > 0;b > 0", &["a^(2/3)-(a*b)^(1/3)+b^(2/3)"], (4.01, 5)),
    used("cube-quotient", "a > 0;b > 0", &["(a*b)^(1/3)-a^(2/3)-b^(2/3)"], (4.01, 5)),
    used("differences-first", "c > 0", &["?*a/c-?*b/c-d"], (2.01, 5)),
    used("differences-first", "c > 0;d > 0", &["?*a*c-?*b*c-d"], (0.51, 4)),
    // never positive, and turned with its differences
    used("differences-first", "c > 0;d > 0;?*a*c > ?*b*c+d", &["?*a*c-?*b*c-d"], (0.51, 4)),
    // plain steps in differences
    used("differences-first", "", &["(a-b)^4+3*(a-b)^2+?"], (0.51, 9)),
    used("differences-first", "", &["-?*(a-b)^4-3*(a-b)^2-5"], (0.51, 11)),
    used("distributed", POSITIVE, &["3*a*(5*b*sqrt(c)+c)"], (4.01, 7)),
    with(FEW, used("double-double", POSITIVE, &["a*b/sqrt(?*a+b*c)"], (0.51, 6))),
    used("factored", "a # b", &["(a^3-3*b*a^2+3*b^2*a-b^3)/(a-b)"], (3.0, 2)),
    used("factored", "a > 0", &["?*a*b+?*a*c"], (3.0, 3)),
    used("factored", POSITIVE, &["1/(a^2+2*?*a*b+?^2*b^2)"], (2.01, 6)),
    used("monotone-newton", POSITIVE, &["positive_root(x^3+?*a*x-b,x)"], (0.51, 13)),
    used("monotone-newton", POSITIVE, &["positive_root(c*x^4+?*a*x^2-b*x-d,x)"], (0.51, 19)),
    used("monotone-newton", POSITIVE, &["positive_root(x^3+(a+?*c)*x-b,x)"], (0.51, 99)),
    used("fused", POSITIVE, &["(?*a+b)*(b+c)*(c+d)/((a+c)*(b+d))"], (3.01, 10)),
    used("known-sum", "b > 0;a+b > 0", &["2*a+(2*?+3)*b"], (2.0, 4)),
    used("merge-cubes", "b # 0", &["(?*a*c^2/(4*%pi^2*b))^(1/3)"], (3.67, 7)),
    used("merge-cubes", "a # 0", &["?*(a*b)^(1/3)/a"], (2.67, 4)),
    used("merge-cubes", POSITIVE, &["a^(1/3)*(b+?*c)^(2/3)"], (3.01, 5)),
    used("merge-cubes", "a # 0", &["c*a^(1/3)/a"], (2.67, 4)),
    used("merge-cubes", "", &["a*3^(1/3)/3"], (2.34, 3)),
    // above the bar, where a may be 0
    used("merge-cubes", "", &["?*a*(a*b)^(1/3)"], (3.34, 4)),
    // a radicand with a root, which would cancel
    used("merge-cubes", POSITIVE, &["(sqrt(a^2+?*b)-a)^(2/3)*(c*d)^(1/3)"], (0.51, 11)),
    used("merge-roots", POSITIVE, &["sqrt(sqrt(a^2+?*b)-a)*sqrt(c)/c"], (0.51, 10)),
    used("merge-roots", POSITIVE, &["sqrt(a)*(sqrt(c)+?*b)/a"], (4.5, 6)),
    used("merge-roots", "a # 0;b > 0", &["?*sqrt(a^2*b)/a^2"], (3.0, 4)),
    // magnitudes that the root and the denominator have, the denominator, neither
    used("merge-roots", "a*b > 0;a # 0;b # 0", &["?*abs(a)*sqrt(a*b)/a^2"], (2.5, 3)),
    used("merge-roots", "a # 0;b > 0;c > 0", &["?*abs(a)*sqrt(b)*sqrt(c)/a^2"], (3.5, 4)),
    used("merge-roots", "b > 0;c > 0", &["?*abs(a)*sqrt(b)*sqrt(c)*a^2"], (4.51, 6)),
    // whole radicands below the bar, with a constant, with a square, and half of one
    used("merge-roots", "a+b > 0", &["sqrt(3*a+3*b)/(a+b)"], (3.0, 4)),
    used("merge-roots", "(a-b)^2*(c+d) > 0;c+d > 0", &["sqrt((a-b)^2*(c+d))/((a-b)^2*(c+d))"], (4.5, 6)),
    used("merge-roots", POSITIVE, &["?*sqrt((a+b)*(c+d))/(a+b)"], (3.5, 5)),
    used("merge-roots", "a > 0;b > 0", &["?*sqrt(a)*sqrt(b)/a"], (2.5, 3)),
    used("merge-roots", "a+b > 0", &["?*sqrt(a+b)/(a+b)"], (2.5, 3)),
    with(ONE_DIVISION, used("one-reciprocal", POSITIVE, &["?*a/(b*c^2)", "(a+?)/(b^3*c)"], (0.51, 13))),
    used(
        "same-sign-radicand",
        "a > 0;b > 0;c > 0;12*c > 4*a^2+6*a*b",
        &["(sqrt(9*b^2-12*a*b+4*a^2+96*c)-3*b-6*a)/?"],
        (4.51, 28),
    ),
    used("sign-branch", "b > 0", &["sqrt(a^2+?*b)-a"], (4.51, 8)),
    used("sign-branch", "b > 0", &["1/(sqrt(?*a^2+b)+a)"], (4.51, 11)),
    used("sign-branch", "b # 0", &["a^(1/3)+?*b"], (0.51, 12)),
    used("through-result", POSITIVE, &["(sqrt(b^2+2*a*c)-b)/c", "sqrt(b^2+2*a*c)-b"], (4.51, 9)),
    // both terms may be 0, and then so is the sum below the bar
    used("sign-branch", "a >= 0;b >= 0", &["sqrt(?*a)-sqrt(b)"], (4.51, 10)),
    used("sign-branch", "a >= 0;b >= 0", &["(?*a)^(1/3)-b^(1/3)"], (0.51, 11)),
    used("sign-branch", "", &["a^(1/3)-(?*b)^(1/3)"], (0.51, 11)),
    // the norm is 0
    used("sign-branch", "", &["abs(a)-a"], (0.5, 1)),
    used("certified", POSITIVE, &["?+max(a,2*b)"], (0.51, 0)),
    // a factor in common, a sum among products, a number beyond 53 bits, both signs of one polynomial
    used("compensated", "", &["6*a*b-4*?*c*d"], (0.51, 6)),
    used("compensated", "", &["(a+c)*b-?*d^2"], (0.51, 5)),
    used("compensated", "", &["12345678901234567891*a*b-?*c*d"], (0.51, 6)),
    used("compensated", "?*a*b > c*d", &["?*a*b-c*d", "c*d-?*a*b"], (0.51, 4)),
    used("cube-quotient", "a # 0;b # 0", &["a^(2/3)-(a*b)^(1/3)+b^(2/3)"], (4.01, 13)),
    used("differences-first", POSITIVE, &["?*a*c-?*b*c-d"], (0.51, 4)),
    used("distributed", "a > 0;b > 0;c > 0;d < 0", &["3*a*(5*b*sqrt(c)-d)"], (4.01, 7)),
    used("distributed", "a > 0;b < 0;c > 0;d > 0", &["3*a*(d-5*b*sqrt(c))"], (4.01, 7)),
    used("distributed", POSITIVE, &["3*a*(sqrt(c)+5*b*d)"], (4.0, 7)),
    used("distributed", POSITIVE, &["-3*a*(5*b*sqrt(c)+c)"], (4.01, 7)),
    used("distributed", POSITIVE, &["9007199254740881*a*(9007199254740847*b*sqrt(c)+c)"], (4.01, 8)),
    with(FEW, used("double-double", POSITIVE, &["?*sqrt(a)*sqrt(b)"], (0.51, 3))),
    used("double-double", POSITIVE, &["3*?*(sqrt(a)+b)*(sqrt(c)+d)"], (0.51, 7)),
    used("factored", "a > 0", &["a*b/3+a*c/3"], (3.0, 3)),
    used("factored", POSITIVE, &["(sqrt(a^2+?*b)-a)*(c+d)/b"], (4.51, 8)),
    with(FEW, used("fused", POSITIVE, &["(?*a+b)*(b+c)*(c+d)"], (0.51, 6))),
    with(FEW, used("fused", POSITIVE, &["-(?*a+b)*(b+c)*d"], (0.51, 5))),
    with(FEW, used("fused", POSITIVE, &["-sqrt((?*a+b)*(b+c)*(c+d))"], (1.51, 7))),
    used("fused", "b > 0", &["c*d*(sqrt(a^2+?*b)-a)"], (4.51, 12)),
    used("fused", POSITIVE, &["a*b*sqrt((3*?*a+b)*c*d)"], (3.51, 7)),
    used("known-sum", "b > 0;2*a+b > 0", &["4*a+(2*?+3)*b"], (2.0, 5)),
    used("known-sum", "b < 0;a+b < 0", &["2*a+(2*?+3)*b"], (2.0, 4)),
    used("merge-cubes", "", &["a*3^(2/3)*b^(1/3)"], (2.34, 3)),
    used("merge-roots", POSITIVE, &["sqrt(?*a)/a"], (2.5, 3)),
    used("merge-roots", "a+b > 0", &["?*sqrt(a+b)/(a+b)^2"], (4.5, 4)),
    used("monotone-newton", POSITIVE, &["positive_root(2*x^3+4*?*a*x-6*b,x)"], (0.51, 16)),
    used("monotone-newton", "b > 0", &["positive_root(x^3+?*a*x-b,x)"], (0.51, 13)),
    used("monotone-newton", "a > 0;b*c > d", &["positive_root(x^3+?*a*x-b*c+d,x)"], (0.51, 17)),
    with(ONE_DIVISION, used("one-reciprocal", POSITIVE, &["-a/(b*c^2)", "(a+?)/(b^3*c)"], (0.51, 12))),
    with(ONE_DIVISION, used("one-reciprocal", POSITIVE, &["(a+?)/(b^3*c)", "?*a/(b*c^2)"], (0.51, 13))),
    with(ONE_DIVISION, used("one-reciprocal", POSITIVE, &["a^5/c", "(a+?)/b^30"], (0.51, 26))),
    with(
        FEW_AND_ONE,
        used("one-reciprocal", "b > 0;c > 0", &["-(a-d)/(b*c^2)", "(a-?*d)/(b^3*c)", "(a*b-?*c*d)/(b*c)"], (0.51, 20)),
    ),
    used("sign-branch", "a > 0;c > 0", &["b*sqrt(c)+?*a"], (0.51, 11)),
    used("sign-branch", "c > 0", &["b*sqrt(c)+?*a"], (0.51, 11)),
    used("sign-branch", "a <= 0", &["a^(1/3)+(?*b)^(1/3)"], (0.51, 11)),
    used("certified", POSITIVE, &["max(a,b)/(?*c+d)"], (0.51, 0)),
    used("certified", POSITIVE, &["1/(?+max(a,b))^3"], (0.51, 0)),
    used("certified", POSITIVE, &["max(a,b)^13"], (0.51, 0)),
    used("certified", POSITIVE, &["if a > ?*b then c else d"], (0.51, 0)),
    used("fused", POSITIVE, &["sqrt(d)+3*?*a^2*b*c*d"], (2.01, 7)),
    used("fused", "a > 0;b < 0;c > 0;d > 0", &["sqrt(a)-3*?*b*c^2*d*a"], (2.01, 7)),
    used("merge-roots", "(a-b)^2*(c+d) > 0;c+d > 0", &["sqrt((a-b)^2*(c+d))/((a-b)*(c+d))"], (4.51, 8)),
    used("through-result", POSITIVE, &["sqrt(?*a*b)", "1/(sqrt(?*a*b)+d)"], (4.0, 5)),
    used("through-result", "d > 0", &["2*sqrt(a-b*c)", "1/(sqrt(a-b*c)+?*d)"], (3.51, 7)),
    used("through-result", POSITIVE, &["2*sqrt(b^2+?*c)", "a/sqrt(b^2+?*c)"], (3.0, 7)),
];

/// Where they do not: what the rule would make of these is wrong, cancels, or is not worth it.
pub const REFUSED: [Case; 71] = [
    // the terms agree in sign
    case("compensated", POSITIVE, &["?*a*b+c*d"]),
    // the terms of the root's sum agree in sign
    case("conjugate", "a >= 0;b > 0", &["sqrt(?*a+b)+sqrt(?*a)"]),
    // both terms may vanish together, and with them the sum below the bar
    case("conjugate", "a >= 0;b >= 0", &["sqrt(?*a)+sqrt(b)"]),
    // the terms agree in sign
    case("cube-conjugate", POSITIVE, &["(?*a+b)^(1/3)+(?*a)^(1/3)"]),
    case("cube-conjugate", "a < 0;b < 0", &["?*a^(1/3)+b^(1/3)"]),
    // the difference stands below the bar, which canonical forms free of it
    case("cube-conjugate", POSITIVE, &["1/((a+?*b)^(1/3)-a^(1/3))"]),
    // three terms, two of which stand against one
    case("cube-conjugate", POSITIVE, &["a^(1/3)+b^(1/3)-?*c^(1/3)"]),
    // the terms agree in sign
    case("cube-quotient", "a > b;b > 0", &["1/(a^(1/3)-b^(1/3))"]),
    // the term in the middle is a square, and the product is one of those around it
    case("cube-quotient", "a > 0;b # 0;c > 0", &["a^2*c^(2/3)+?*a*b*c+?^2*b^2*c*c^(1/3)"]),
    // these three terms are no squares with a product
    case("cube-quotient", POSITIVE, &["a^(2/3)-?*(a*b)^(1/3)+b^(2/3)+c"]),
    // h is left of a + h and b + h
    case("differences-first", "c > 0", &["5*a/c-7*b/c-d"]),
    // the factor has either sign, and so have the terms: their sum may be of terms of other signs than that of the formula
    case("distributed", "b > 0;c > 0", &["3*(a-d)*(5*b*sqrt(c)+c)"]),
    // a bound that is small enough
    case("double-double", POSITIVE, &["a*b/sqrt(?*a+b*c)"]),
    case("factored", POSITIVE, &["a^2+?*b"]),
    // no sum has factors
    case("factored", POSITIVE, &["?*a^2*b/c"]),
    // no contract asks for few roundings, and they are few
    case("fused", POSITIVE, &["?*a+b*c"]),
    // the domain does not give the sign of the sum
    case("known-sum", "b > 0;a-b > 0", &["?*a+7*b"]),
    case("known-sum", "b > 0", &["?*a+7*b"]),
    case("known-sum", "b > 0;a+b # 0", &["?*a+7*b"]),
    // each root stands alone
    case("merge-cubes", POSITIVE, &["a^(1/3)+?*b^(1/3)"]),
    // a square root is no cube root
    case("merge-cubes", POSITIVE, &["?*sqrt(a)*sqrt(b)"]),
    // each root stands alone
    case("merge-roots", POSITIVE, &["sqrt(?*a)+sqrt(b)"]),
    // below the root of a quotient, a would lose its sign
    case("merge-roots", "a*b > 0;a # 0", &["?*sqrt(a*b)/a"]),
    // no contract asks for it
    case("one-reciprocal", POSITIVE, &["?*a/(b*c^2)", "(a+?)/(b^3*c)"]),
    // there is but one quotient
    with(ONE_DIVISION, case("one-reciprocal", POSITIVE, &["?*a/(b*c^2)", "a+b"])),
    // the norm is positive: a^2 - n would cancel
    case("same-sign-radicand", "a > 0;b > 0;a^2 > ?*b", &["a-sqrt(a^2-?*b)"]),
    // the root has a coefficient: its radicand is another part of the norm
    case("same-sign-radicand", "a > 0;b > 0", &["a*sqrt(b^2-2*a*b+3*a^2)-b*a-?*a"]),
    case(
        "same-sign-radicand",
        "a > 0;b > 0;c > 0;128*c > 11*a^2+30*a*b-9*b^2",
        &["(2*sqrt(9*b^2-12*a*b+4*a^2+96*c)-3*b-7*a)/?"],
    ),
    // the sign is known
    case("sign-branch", "a > 0;b > 0", &["sqrt(a^2+?*b)-a"]),
    case("sign-branch", "a < 0;b > 0", &["sqrt(a^2+?*b)-a"]),
    // the root that they share is no square root
    case("through-result", POSITIVE, &["((b^3+2*a*c)^(1/3)-b)/c", "(b^3+2*a*c)^(1/3)-b"]),
    case("through-result", POSITIVE, &["((b^3+?*a*c)^(1/3)-b)/c", "(b^3+?*a*c)^(2/3)-b^2"]),
    // there are two roots
    case("through-result", POSITIVE, &["sqrt(d)+a", "(sqrt(b^2+?*a*c)-b)/c", "sqrt(b^2+?*a*c)-b+sqrt(d)"]),
    // a = u - ?*b would be of a factor of the relation that the result does not fulfil where a is negative
    case("through-result", "b > 0", &["abs(a)+?*b", "abs(a)"]),
    // u - d cancels
    case("through-result", POSITIVE, &["sqrt(b^2+?*c)+d", "sqrt(b^2+?*c)"]),
    // b in the denominator would become a difference in u that cancels
    case("through-result", "a > 0;b > 0;c > 0;b # c", &["sqrt(b^2+2*?*a*c)+b", "(sqrt(b^2+2*?*a*c)-b)/(c-b)"]),
    // another root
    case("through-result", POSITIVE, &["(sqrt(b^2+?*a*c)-b)/c", "sqrt(b^2+?*a*d)-b"]),
    // no sum of the direct form cancels and there is nothing to take from it
    case("through-result", POSITIVE, &["(sqrt(b^2+?*a*c)-b)/c", "a+b"]),
    case("certified", POSITIVE, &["a*b-?*c*d"]),
    // pi is not exact
    case("compensated", POSITIVE, &["%pi*a-?*b"]),
    // one of the terms has either sign
    case("conjugate", "b > 0", &["sqrt(a^2+?*b)-a"]),
    case("conjugate", "a >= 0;b >= 0", &["sqrt(?*a)-sqrt(b)"]),
    used("conjugate", "", &["abs(a)-a"], (0.5, 1)),
    case("cube-conjugate", "b # 0", &["a^(1/3)+?*b"]),
    case("cube-conjugate", "a >= 0;b >= 0", &["(?*a)^(1/3)-b^(1/3)"]),
    used("cube-conjugate", "", &["(4*a^2*(abs(a)-a))^(1/3)-abs(a)+a"], (4.67, 8)),
    case("cube-quotient", POSITIVE, &["(c-sqrt(d))*(a^(2/3)-?*(a*b)^(1/3)+?^2*b^(2/3))"]),
    case("cube-quotient", "a > 0;b > 0;c >= 0;d >= 0", &["(?*c+sqrt(d))*(a^(2/3)-(a*b)^(1/3)+b^(2/3))"]),
    with(FEW, case("double-double", POSITIVE, &["?*sqrt(a)"])),
    case("double-double", POSITIVE, &["sqrt(a)*(sqrt(c)+?*b)/a"]),
    with(FEW, case("fused", POSITIVE, &["sqrt(a*b)"])),
    case("fused", POSITIVE, &["a*d*sqrt((?*a+b)*c)"]),
    case("known-sum", "b > 0;c > 0;a-b-c > 0", &["?*a-b-?*c"]),
    case("known-sum", "b > 0;a+b > 0", &["(?+3)*a+3*b"]),
    used("merge-cubes", "", &["b*a^(1/3)+?*a^(2/3)"], (0.51, 15)),
    case("merge-cubes", POSITIVE, &["(sqrt(a^2+?*b)-a)^(1/3)*c"]),
    used("merge-roots", "a*b > 0;a # 0", &["?*abs(a)*sqrt(a*b)/a"], (4.5, 5)),
    case("merge-roots", "a+b >= 0", &["?*sqrt(a+b)*(a+b)"]),
    used("merge-roots", POSITIVE, &["?*a*sqrt(a*b)"], (3.5, 4)),
    used("merge-roots", "a # 0;b > 0", &["?*sqrt(a^2*b)/a"], (4.0, 5)),
    case("merge-roots", "", &["?*abs(a)*b"]),
    with(ONE_DIVISION, case("one-reciprocal", "a > 0;b > 1;b < 10;c > 0", &["?*a/b^34", "(a+?)/(b^34*c)"])),
    case("same-sign-radicand", POSITIVE, &["sqrt(a^2+?*b)-a"]),
    case("same-sign-radicand", POSITIVE, &["sqrt(a^2-2*a*sqrt(c)+c+?*d)+sqrt(c)-a"]),
    case("sign-branch", POSITIVE, &["a^(1/3)+b^(1/3)-?*c^(1/3)"]),
    case("through-result", POSITIVE, &["sqrt(d)+a", "sqrt(b^2+?*c)+sqrt(d)+a"]),
    case("through-result", POSITIVE, &["a+b", "sqrt(b^2+?*a*c)-b"]),
    case("through-result", POSITIVE, &["sqrt(b^2-b*d-?*c)", "sqrt(b^2-b*d-?*c)-b"]),
    case("through-result", POSITIVE, &["(sqrt(b^2+2*?*a*c)-b)/c", "sqrt(b^2+2*?*a*c)+b"]),
    used("fused", POSITIVE, &["c*d*sqrt(a+sqrt(b))+?*a+b"], (5.0, 8)),
    with(FEW, case("fused", POSITIVE, &["(?*a+b)^12"])),
];
