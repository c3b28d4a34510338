//! The judges are judged: right kernels pass, every mutant is caught by the judge whose matter it is.

mod batches;
mod bounded;
mod bounds;
mod mutants;
mod right;

use std::path::Path;

use closedform::Kernel;
use closedform_tests::algebra::check_golden;
use closedform_tests::check::{Judge, check};
use closedform_tests::climb::climb;
use closedform_tests::contract::Contract;
use closedform_tests::coverage::{Family, GOLDEN_VALUES};
use closedform_tests::failure::Failure;
use closedform_tests::golden::{self, GoldenValue};
use closedform_tests::inputs::{Maker, Points};
use closedform_tests::laws::chain::Chain;
use closedform_tests::laws::motion::Motion;
use closedform_tests::laws::{Law, check_inverse};
use closedform_tests::reference::References;
use closedform_tests::scaling::check_scaling;
use closedform_tests::sweep::sweep;
use closedform_tests::{as_written, fast, kept, shapes, strategy};

/// Points for each maker, and those at edges; the random seed is always the same.
const POINTS: usize = 200;
const EDGES: usize = 1_000;
const SEED: u64 = 1;

fn references() -> References {
    References::parse(right::REFERENCES).expect("references of the samples parse")
}

fn judge(kernel: &'static Kernel) -> Judge {
    Judge::new(kernel, &references()).expect("samples have references")
}

fn golden() -> Vec<GoldenValue> {
    golden::parse(Path::new("sample.tsv"), right::GOLDEN).expect("golden values of the samples parse")
}

fn points(judge: &Judge, maker: Maker) -> Points {
    judge.space.inside(maker, SEED, POINTS)
}

/// The first maker whose points find the kernel guilty.
fn caught(kernel: &'static Kernel) -> Option<(Maker, Box<Failure>)> {
    let judge = judge(kernel);
    Maker::ALL.into_iter().find_map(|maker| Some((maker, check(&judge, &points(&judge, maker)).err()?)))
}

#[test]
fn right_kernels_keep_their_bounds() {
    for kernel in right::ALL {
        assert!(caught(kernel).is_none(), "{}", caught(kernel).unwrap().1);
    }
}

#[test]
fn mutants_break_their_bounds() {
    for kernel in mutants::WRONG.into_iter().chain(mutants::INACCURATE) {
        assert!(caught(kernel).is_some(), "{kernel:?} passed");
    }
}

#[test]
fn a_sweep_catches_lost_digits() {
    let swept = |kernel| {
        let judge = judge(kernel);
        let list = Maker::ALL.map(|maker| points(&judge, maker).list).concat();
        sweep(&judge, &Points { origin: "every maker".to_owned(), list }, SEED, 10 * POINTS)
    };
    for kernel in right::ALL {
        assert_eq!(swept(kernel).map(|swept| swept.points), Ok(10 * POINTS));
    }
    for kernel in mutants::INACCURATE {
        assert!(swept(kernel).is_err(), "{kernel:?} passed");
    }
}

#[test]
fn golden_values_tell_wrong_algebra_from_lost_digits() {
    for kernel in right::ALL.into_iter().chain(mutants::INACCURATE) {
        assert_eq!(check_golden(&judge(kernel), &golden()).map(|judged| judged > 0), Ok(true));
    }
    for kernel in mutants::WRONG {
        assert!(check_golden(&judge(kernel), &golden()).is_err(), "{kernel:?} passed");
    }
}

#[test]
fn a_failure_tells_how_to_replay_it() {
    let judge = judge(&mutants::sign::KERNEL);
    let inputs = Points { origin: "by hand".to_owned(), list: vec![vec![3.0, 1.0, 8.0]] };
    let text = check(&judge, &inputs).expect_err("the sign is wrong").to_string();
    let expected = "\
sample::sign breaks the bound of `sign`
  v          3.0 = 0x1.8p+1
  a          1.0 = 0x1p+0
  x          8.0 = 0x1p+3
  expected   2.000000000000000000000000000000000000000 = 0x1p+1
  actual     -8.0 = -0x1p+3
  error      22517998136852480.000 ulp, bound 3 ulp
  from       by hand
  replay     closedform eval sample::sign v=0x1.8p+1 a=0x1p+0 x=0x1p+3 --digits 40";
    assert_eq!(text, expected);
}

#[test]
fn shrunk_failures_are_simple() {
    let sign = judge(&mutants::sign::KERNEL);
    let text = strategy::shrink(&sign, Maker::Logarithmic, 10).expect_err("the sign is wrong");
    assert!(text.contains("v          1.0 =") && text.contains("a          1.0 ="), "{text}");
    assert_eq!(strategy::shrink(&judge(&right::time_to_reach::KERNEL), Maker::Logarithmic, 10), Ok(()));
}

#[test]
fn climbs_end_higher_than_they_start() {
    let judge = judge(&right::time_to_reach::KERNEL);
    let starts = judge.space.inside(Maker::Bits, SEED, 4);
    let climbed =
        |steps| climb(&judge, &starts, steps, SEED).expect("bounds are kept").expect("starts are judged").score;
    assert!(climbed(300) > 1.5 * climbed(0), "{} from {}", climbed(300), climbed(0));
}

#[test]
fn a_kernel_must_not_be_worse_than_its_formula_as_written() {
    let worse = |kernel| {
        Maker::SAMPLINGS.iter().find_map(|maker| {
            let judge = judge(kernel);
            as_written::check(&judge, &points(&judge, *maker)).err()
        })
    };
    for kernel in right::ALL {
        assert_eq!(worse(kernel), None);
    }
    let text = worse(&mutants::branches_swapped::KERNEL).expect("the formula as written is right where v < 0");
    assert!(
        text.contains("where the formula as written is") && text.contains("closedform eval sample::branches_swapped"),
        "{text}"
    );
}

#[test]
fn kept_inputs_that_do_not_fit_or_got_worse_are_told() {
    let judge = judge(&right::distance::KERNEL);
    let told = |line: &str| {
        let kept = kept::parse(Path::new("sample.tsv"), line).expect("a line");
        let own = kept::complaints(&judge, &kept);
        own.into_iter().chain(kept::strangers(&["sample::distance"], &kept)).collect::<Vec<_>>().join("\n")
    };
    let inputs = "v=0x1.8p+0 a=0x1p+0 t=0x1.5555555555555p-2";
    assert_eq!(told(&format!("sample::distance\tdistance\t0.500\t{inputs}")), "");
    for (line, says) in [
        (format!("sample::distance\tdistance\t0.001\t{inputs}"), "ulp off where 0.001 ulp were kept"),
        (format!("sample::other\tdistance\t0.500\t{inputs}"), "no such kernel"),
        (format!("sample::distance\tother\t0.500\t{inputs}"), "no worst input of `distance`"),
        ("sample::distance\tdistance\t0.500\tv=0x1p+0 a=0x1p+0".to_owned(), "the inputs are others"),
        ("sample::distance\tdistance\t0.500\tv=0x1p+0 a=-0x1p+0 t=0x1p+0".to_owned(), "outside the domain"),
    ] {
        let told = told(&line);
        assert!(told.contains(says) && told.contains("closedform verify --search 60s --keep"), "{told}");
    }
}

#[test]
fn one_point_without_digits_is_enough() {
    let sum = judge(&mutants::plain_sum::KERNEL);
    let points = |list| Points { origin: "by hand".to_owned(), list };
    let easy = vec![vec![1.0, 2.0, 1.0]; 19];
    assert_eq!(check(&sum, &points(easy.clone())).map(|report| report.points).ok(), Some(19));
    let cancelling = vec![-1.1, 0.7, 2.0 * 1.1 / 0.7];
    assert!(check(&sum, &points([easy, vec![cancelling]].concat())).is_err());
}

#[test]
fn a_wrong_domain_is_told() {
    let domain = |kernel| {
        let judge = judge(kernel);
        let (inside, outside) = (judge.space.inside(Maker::Edges, SEED, EDGES), judge.space.outside(SEED, EDGES));
        [inside, outside].iter().try_for_each(|points| shapes::check_domain(&judge, points))
    };
    for kernel in right::ALL {
        assert_eq!(domain(kernel), Ok(()));
    }
    for kernel in mutants::WRONG_DOMAIN {
        assert!(domain(kernel).is_err(), "{kernel:?} passed");
    }
}

#[test]
fn fast_calls_are_judged() {
    let fast = |kernel| {
        let judge = judge(kernel);
        let kept = Maker::ALL.into_iter().try_for_each(|maker| fast::check(&judge, &points(&judge, maker)).map(drop));
        kept.and(fast::check_batch(&judge, &points(&judge, Maker::Reals)))
    };
    for kernel in right::ALL {
        assert_eq!(fast(kernel), Ok(()));
    }
    // a coefficient that is wrong in its last digits is within the promise
    for kernel in mutants::WRONG.into_iter().filter(|kernel| kernel.info.name != "sample::coefficient") {
        assert!(fast(kernel).is_err(), "{kernel:?} passed");
    }
    assert!(fast(&batches::OFF_BY_ONE_BIT).is_err());
}

#[test]
fn wrong_batches_and_singles_are_told() {
    let batch = |kernel| {
        let judge = judge(kernel);
        shapes::check_batch(&judge, &points(&judge, Maker::Reals))
    };
    assert_eq!(batch(&right::distance::KERNEL), Ok(()));
    assert!(batch(&batches::OFF_BY_ONE_BIT).is_err());
    let single = |kernel| {
        let judge = judge(kernel);
        shapes::check_single(&judge, &points(&judge, Maker::Logarithmic)).map(|judged| 2 * judged > POINTS)
    };
    assert_eq!(single(&right::time_to_reach::KERNEL), Ok(true));
    assert!(single(&mutants::operator::KERNEL).is_err());
}

#[test]
fn broken_laws_are_told() {
    let law = |kernel, text| {
        let judge = judge(kernel);
        Law::new(text).check(&judge, &["t"], &points(&judge, Maker::Logarithmic))
    };
    assert_eq!(law(&right::time_to_reach::KERNEL, "x = v*t+a*t^2/2"), Ok(()));
    assert!(law(&mutants::coefficient::KERNEL, "x = v*t+a*t^2/2").is_err());
    assert!(law(&right::time_to_reach::KERNEL, "x = v*t+a*t^2/3").is_err());
    assert_eq!(law(&right::time_to_reach::KERNEL, "x <= 0 or t > 0"), Ok(()));
    assert!(law(&mutants::sign::KERNEL, "x <= 0 or t > 0").is_err());
}

#[test]
fn comparisons_allow_what_the_bounds_do() {
    let law = |kernel, text| {
        let judge = judge(kernel);
        Law::new(text).check(&judge, &["v", "a"], &points(&judge, Maker::Logarithmic))
    };
    for text in ["a*t^2 <= x", "x <= a*t^2", "a*t^2 >= x", "x >= a*t^2"] {
        assert_eq!(law(&right::ramps::KERNEL, text), Ok(()));
    }
    for text in ["a*t^2 < x", "a*t^2 > x", "a*t^2 <= x and t > 0", "1000000000000*a*t^2 <= 999999999999*x"] {
        assert!(law(&right::ramps::KERNEL, text).is_err(), "{text}");
    }
    assert_eq!(law(&mutants::peak_too_high::KERNEL, "a*t^2 >= x"), Ok(()));
    assert!(law(&mutants::peak_too_high::KERNEL, "a*t^2 <= x").is_err());
}

#[test]
fn kernels_that_do_not_undo_each_other_are_told() {
    let distance = judge(&right::distance::KERNEL);
    let inverse = |kernel| {
        let first = judge(kernel);
        check_inverse((&first, "t"), (&distance, "x"), &[], &points(&first, Maker::Logarithmic))
    };
    assert_eq!(inverse(&right::time_to_reach::KERNEL), Ok(()));
    assert!(inverse(&mutants::coefficient::KERNEL).is_err());
}

/// Demands a move of the results of a kernel, by these names.
fn closes(kernel: &'static Kernel, results: &[&'static str], motion: &Motion) -> Result<usize, String> {
    let judge = judge(kernel);
    Chain::new(&judge, results).check(&points(&judge, Maker::Logarithmic), &[motion])
}

#[test]
fn moves_that_do_not_close_are_told() {
    let reach = Motion::from(["0", "v", "a"]).jerk("t", "0", ["x", "v+a*t", "a"]);
    assert_eq!(closes(&right::time_to_reach::KERNEL, &["t"], &reach), Ok(POINTS));
    for kernel in mutants::WRONG {
        // One kernel is wrong only where v vanishes, one only by what is nothing at these times.
        let hidden = [&mutants::zero::KERNEL, &mutants::offset::KERNEL].iter().any(|other| other.info == kernel.info);
        assert_eq!(closes(kernel, &["t"], &reach).is_err(), !hidden, "{kernel:?}");
    }
    let ramps = |fall| {
        let half = Motion::from(["0", "0", "0"]).jerk("t", "v/t^2", ["x/6", "v/2", "a"]);
        half.jerk("t", fall, ["x", "v", "0"])
    };
    assert_eq!(closes(&right::ramps::KERNEL, &["v", "a"], &ramps("-v/t^2")), Ok(POINTS));
    for (kernel, what) in mutants::WRONG_MOVES {
        let told = closes(kernel, &["v", "a"], &ramps("-v/t^2")).expect_err("the move does not close");
        assert!(told.contains(what), "{told}");
    }
    let told = closes(&right::ramps::KERNEL, &["v", "a"], &ramps("-v/(2*t^2)")).expect_err("it falls too slowly");
    assert!(told.contains("position after segment 2"), "{told}");
}

#[test]
fn moves_of_more_kernels_follow_their_errors() {
    // What `ramp` makes of the time is off with it, so that the distance by one and by the other agree.
    let (reach, ramp) = (judge(&right::time_to_reach::KERNEL), judge(&right::ramp::KERNEL));
    let mut points = points(&reach, Maker::Logarithmic);
    points.list.retain(|inputs| inputs[2] > 0.0);
    let all = Ok(points.list.len());
    let chain = || Chain::new(&reach, &["t"]).then(&ramp, &["d", "w"]);
    let moves = |end| Motion::from(["0", "v", "0"]).jerk("t", "a/t", [end, "v+w", "a"]);
    assert_eq!(chain().check(&points, &[&moves("v*t+d")]), all);
    assert_eq!(chain().check(&points, &[&Law::new("6*d = 2*(x-v*t)")]), all);
    assert!(chain().check(&points, &[&moves("v*t+2*d")]).is_err());
    let wrong = Chain::new(&judge(&mutants::coefficient::KERNEL), &["t"]).then(&ramp, &["d", "w"]);
    assert!(wrong.check(&points, &[&Law::new("6*d = 2*(x-v*t)")]).is_err());
}

#[test]
fn chains_that_leave_their_domains_are_told() {
    let (distance, reach) = (judge(&right::distance::KERNEL), judge(&right::time_to_reach::KERNEL));
    let points = points(&distance, Maker::Logarithmic);
    let out = Chain::new(&distance, &["d"]).define("x", "-1000000000").then(&reach, &["t0"]);
    let told = out.check(&points, &[&Law::new("t0 > 0")]).expect_err("no point stays");
    assert!(told.contains("only 0 of 200 points stay"), "{told}");
}

#[test]
fn numbers_without_unit_break_the_scaling() {
    let scaling = |kernel| check_scaling(kernel, &points(&judge(kernel), Maker::Bits));
    for kernel in right::ALL {
        assert_eq!(scaling(kernel), Ok(()));
    }
    assert!(scaling(&mutants::unit::KERNEL).is_err());
    assert!(scaling(&mutants::offset::KERNEL).is_err());
}

#[test]
fn gaps_are_told() {
    let info = right::time_to_reach::KERNEL.info;
    let contract = Contract { name: info.name.to_owned(), worksheets: vec!["reach".to_owned()] };
    let whole = || Family {
        name: "sample".to_owned(),
        kernels: vec![info],
        contracts: vec![contract.clone()],
        references: References::parse("reach(v,a,x):=0$").expect("it parses"),
        golden: vec![golden().remove(0); GOLDEN_VALUES],
    };
    let gaps_in = |family: &Family| {
        let own = family.kernels.iter().flat_map(|info| family.gaps_of(info));
        own.chain(family.strangers()).collect::<Vec<_>>()
    };
    assert_eq!(gaps_in(&whole()), [""; 0]);
    let other = References::parse("other(v):=0$").expect("it parses");
    let gaps = [
        (Family { kernels: vec![], ..whole() }, "without a kernel"),
        (Family { contracts: vec![], ..whole() }, "no contract"),
        (Family { contracts: vec![Contract { worksheets: vec![], ..contract.clone() }], ..whole() }, "its contract"),
        (Family { references: References::parse("").expect("it parses"), ..whole() }, "no reference"),
        (Family { references: other, ..whole() }, "reference `other` without a kernel"),
        (Family { golden: whole().golden.split_off(1), ..whole() }, "only 23 golden values"),
        (Family { kernels: vec![mutants::unbounded::KERNEL.info], ..whole() }, "no bound"),
    ];
    for (family, expected) in gaps {
        let gaps = gaps_in(&family).join("\n");
        assert!(gaps.contains(expected), "{gaps:?} lacks {expected:?}");
    }
}
