//! What Maxima's own functions and packages do to a worksheet, by name.

use closedform_maxima::Expr;

/// What to do where Maxima must compute.
pub(crate) const COMPUTE: &str = "a worksheet that computes needs Maxima: `closedform derive FILE` runs it and writes what it leaves; \
                                  then run this command again";

/// Packages of Maxima that define functions and no variables of ordinary names: loading them changes no formula.
const PACKAGES: [&str; 66] = [
    "abs_integrate",
    "absimp",
    "alt_display",
    "asympa",
    "augmented_lagrangian",
    "basic",
    "bernstein",
    "bffac",
    "bode",
    "cobyla",
    "coma",
    "contrib_ode",
    "ctensor",
    "descriptive",
    "diag",
    "distrib",
    "dlsode",
    "draw",
    "drawdf",
    "drawutils",
    "dynamics",
    "eigen",
    "ezunits",
    "f90",
    "facexp",
    "finance",
    "fft",
    "fractals",
    "functs",
    "graphs",
    "grobner",
    "hypergeometric",
    "implicit_plot",
    "interpol",
    "itensor",
    "lapack",
    "lbfgs",
    "linearalgebra",
    "lsquares",
    "makeOrders",
    "mactex",
    "minpack",
    "mnewton",
    "nchrpl",
    "newton1",
    "numericalio",
    "odepack",
    "operatingsystem",
    "opsubst",
    "ode2",
    "orthopoly",
    "plotdf",
    "rkf45",
    "romberg",
    "simplex",
    "simplify_sum",
    "solve_rec",
    "sqdnst",
    "stats",
    "stringproc",
    "symmetries",
    "to_poly_solve",
    "trgsmp",
    "vect",
    "wrstcse",
    "zeilberger",
];

/// Functions that only Maxima can evaluate.
const COMPUTING: [&str; 88] = [
    "addcol",
    "addrow",
    "adjoint",
    "apply1",
    "apply2",
    "applyb1",
    "augcoefmatrix",
    "changevar",
    "coefmatrix",
    "collectterms",
    "content",
    "demoivre",
    "divide",
    "echelon",
    "exponentialize",
    "genmatrix",
    "hessian",
    "hipow",
    "ident",
    "logcontract",
    "lopow",
    "lratsubst",
    "nroots",
    "nusum",
    "parse_string",
    "powerseries",
    "quotient",
    "ratcoef",
    "ratcoeff",
    "ratdenom",
    "ratnumer",
    "ratsubst",
    "realroots",
    "remainder",
    "risch",
    "romberg",
    "specint",
    "trigrat",
    "algsys",
    "assoc",
    "bfallroots",
    "allroots",
    "charpoly",
    "coeff",
    "combine",
    "contrib_ode",
    "curvefit",
    "denom",
    "desolve",
    "diff",
    "eigenvalues",
    "eigenvectors",
    "eliminate",
    "expandwrt",
    "find_root",
    "fourier",
    "gcd",
    "grad",
    "ic1",
    "ic2",
    "ilt",
    "imagpart",
    "integrate",
    "invert",
    "jacobian",
    "laplace",
    "ldefint",
    "limit",
    "linsolve",
    "lu_factor",
    "mnewton",
    "num",
    "ode2",
    "partfrac",
    "pade",
    "polarform",
    "quad_qags",
    "radcan",
    "rank",
    "realpart",
    "rectform",
    "residue",
    "resultant",
    "rootscontract",
    "solve",
    "taylor",
    "to_poly_solve",
    "tlimit",
];

/// Functions that give their first argument in another form, of the same value.
const FORMS: [&str; 25] = [
    "bfloat",
    "distrib",
    "expand",
    "expandwrt",
    "facsum",
    "factor",
    "factorsum",
    "float",
    "fullratsimp",
    "gfactor",
    "horner",
    "intosum",
    "multthru",
    "numer",
    "rat",
    "ratdisrep",
    "ratexpand",
    "ratsimp",
    "scsimp",
    "simplify_sum",
    "trigexpand",
    "trigreduce",
    "trigsimp",
    "xthru",
    "factcomb",
];

/// Those among them that replace floats by fractions near them.
const RATIONAL: [&str; 12] = [
    "facsum",
    "factor",
    "factorsum",
    "fullratsimp",
    "gfactor",
    "horner",
    "rat",
    "ratdisrep",
    "ratexpand",
    "ratsimp",
    "scsimp",
    "trigsimp",
];

/// Flags of `ev` that give another form of the same value, besides the functions that do.
const FLAGS: [&str; 20] = [
    "%emode",
    "%enumer",
    "algebraic",
    "demoivre",
    "expand",
    "exponentialize",
    "factor",
    "factorflag",
    "float",
    "halfangles",
    "keepfloat",
    "logexpand",
    "numer",
    "ratalgdenom",
    "ratfac",
    "ratprint",
    "ratsimpexpons",
    "simp",
    "simpsum",
    "sumexpand",
];

/// Words by which `ev` evaluates otherwise.
const EVALUATIONS: [&str; 7] = ["derivlist", "eval", "infeval", "noeval", "nouns", "pred", "rescan"];

/// Functions that change what their arguments stand for, or lists that they are given.
const CHANGING: [&str; 12] = [
    "array",
    "atvalue",
    "fillarray",
    "gradef",
    "let",
    "numerval",
    "pop",
    "push",
    "rearray",
    "setelmx",
    "tellrat",
    "translate",
];

/// Functions that change what arithmetic means, or run what cannot be read here.
const SWEEPING: [&str; 11] = [
    "autoload",
    "batch_stream",
    "compile_file",
    "demo",
    "eval_string",
    "eval_string_lisp",
    "load_lisp",
    "restore",
    "simp_off",
    "tellsimp",
    "tellsimpafter",
];

/// Functions that read another file as statements.
const LOADING: [&str; 5] = ["batch", "batchload", "load", "loadfile", "setup_autoload"];

/// Settings under which arithmetic means something else.
const SETTINGS: [(&str, &str); 4] =
    [("simp", "false"), ("listarith", "false"), ("radexpand", "all"), ("doallmxops", "false")];

/// Whether a statement ends Maxima.
pub(crate) fn ends_maxima(statement: &Expr) -> bool {
    matches!(statement.as_call(), Some(("quit", _)))
}

pub(crate) fn is_package(name: &str) -> bool {
    let name = name.strip_suffix(".mac").or_else(|| name.strip_suffix(".lisp")).unwrap_or(name);
    PACKAGES.contains(&name)
}

/// Whether only Maxima can evaluate a call of the function.
pub(crate) fn computes(name: &str) -> bool {
    COMPUTING.contains(&name)
}

pub(super) fn is_form(name: &str) -> bool {
    FORMS.contains(&name)
}

pub(super) fn rounds_floats(name: &str) -> bool {
    RATIONAL.contains(&name)
}

pub(super) fn is_flag(name: &str) -> bool {
    FLAGS.contains(&name) || is_form(name)
}

pub(super) fn is_evaluation(name: &str) -> bool {
    EVALUATIONS.contains(&name)
}

pub(super) fn is_changing(name: &str) -> bool {
    CHANGING.contains(&name)
}

pub(super) fn is_sweeping(name: &str) -> bool {
    SWEEPING.contains(&name)
}

pub(crate) fn is_loading(name: &str) -> bool {
    LOADING.contains(&name)
}

pub(super) fn changes_arithmetic(setting: &str, value: &str) -> bool {
    SETTINGS.contains(&(setting, value))
}

/// Functions that are obeyed without a word.
pub(super) fn is_obeyed(name: &str) -> bool {
    [
        "assume",
        "describe",
        "forget",
        "kill",
        "remvalue",
        "remfunction",
        "local",
        "reset",
        "matchdeclare",
        "defrule",
        "depends",
    ]
    .contains(&name)
        || closedform_maxima::declares_operator(name)
}
