//! The judges are judged: right kernels pass, every mutant is caught by the judge whose matter it is.

mod batches;
mod mutants;
mod right;

use closedform::Kernel;
use closedform_tests::algebra::check_golden;
use closedform_tests::check::{Judge, check};
use closedform_tests::contract::Contract;
use closedform_tests::coverage::{Family, GOLDEN_VALUES};
use closedform_tests::failure::Failure;
use closedform_tests::golden::{self, GoldenValue};
use closedform_tests::hunt::hunt;
use closedform_tests::inputs::{Maker, Points};
use closedform_tests::laws::{Law, check_inverse};
use closedform_tests::reference::References;
use closedform_tests::scaling::check_scaling;
use closedform_tests::{shapes, strategy};

/// Points for each maker, and those at edges; the seed is always the same.
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
    golden::parse(right::GOLDEN).expect("golden values of the samples parse")
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
        |steps| hunt(&judge, &starts, steps, SEED).expect("bounds are kept").expect("starts are judged").score;
    assert!(climbed(300) > 1.5 * climbed(0), "{} from {}", climbed(300), climbed(0));
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
fn kernels_that_do_not_undo_each_other_are_told() {
    let distance = judge(&right::distance::KERNEL);
    let inverse = |kernel| {
        let first = judge(kernel);
        check_inverse((&first, "t"), (&distance, "x"), &[], &points(&first, Maker::Logarithmic))
    };
    assert_eq!(inverse(&right::time_to_reach::KERNEL), Ok(()));
    assert!(inverse(&mutants::coefficient::KERNEL).is_err());
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
    assert_eq!(whole().gaps(), [""; 0]);
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
        let gaps = family.gaps().join("\n");
        assert!(gaps.contains(expected), "{gaps:?} lacks {expected:?}");
    }
}
