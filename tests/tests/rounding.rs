//! Every kernel keeps its bound, and every shape of a call its promise, on inputs chosen where it hurts.

use closedform_tests::budget::budget;
use closedform_tests::check::{Judge, Report, check};
use closedform_tests::failure::Failure;
use closedform_tests::hunt::hunt;
use closedform_tests::inputs::{Maker, Points};
use closedform_tests::random::seed;
use closedform_tests::sweep::sweep;
use closedform_tests::{kept, kernels, parallel, plain, shapes, strategy, table};

/// Demands something of every kernel, in parallel; all failures are told.
fn demand(work: impl Fn(&Judge) -> Result<(), String> + Sync) {
    let failures: Vec<String> =
        parallel::map(&kernels::judges(), |judge| work(judge).err()).into_iter().flatten().collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n\n"));
}

/// What comes out at the kept worst inputs and at the points of all makers.
fn measure(judge: &Judge) -> Result<Report, Box<Failure>> {
    let mut report = check(judge, &kept::points(judge, &kept::load()))?;
    for maker in Maker::ALL {
        report.merge(check(judge, &judge.space.inside(maker, seed(), budget().points))?);
    }
    Ok(report)
}

#[test]
fn bounds_are_kept() {
    let judges = kernels::judges();
    let (mut reports, mut failures) = (Vec::new(), Vec::new());
    for measured in parallel::map(&judges, measure) {
        match measured {
            Ok(report) => reports.push(report),
            Err(failure) => failures.push(failure.to_string()),
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n\n"));
    println!("{}", table::render(&judges, &reports));
}

#[test]
fn kept_worst_inputs_got_no_worse() {
    let complaints = kept::complaints(&kernels::judges(), &kept::load());
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n\n"));
}

#[test]
fn no_kernel_is_worse_than_its_plain_form() {
    demand(|judge| {
        let mut points = Maker::SAMPLINGS.map(|maker| judge.space.inside(maker, seed(), budget().points)).to_vec();
        points.push(kept::points(judge, &kept::load()));
        points.iter().try_for_each(|points| plain::check_plain(judge, points))
    });
}

#[test]
fn climbs_stay_below_bounds() {
    demand(|judge| {
        let mut starts = judge.space.inside(Maker::Bits, seed(), budget().climbs);
        starts.list.extend(kept::points(judge, &kept::load()).list);
        let summit = hunt(judge, &starts, budget().steps, seed()).map_err(|failure| failure.to_string())?;
        let summit = summit.ok_or_else(|| format!("{}: no climb can start", judge.kernel.info.name))?;
        println!("{:<40} {:.3} of its bound at {:?}", judge.kernel.info.name, summit.score, summit.inputs);
        Ok(())
    });
}

#[test]
fn bounds_are_kept_or_shrunk() {
    demand(|judge| {
        let makers = Maker::ALL.into_iter().filter(|maker| judge.space.has(*maker));
        { makers }.try_for_each(|maker| strategy::shrink(judge, maker, budget().points as u32 / 4))
    });
}

#[test]
fn outside_the_domain_is_nan_and_named() {
    demand(|judge| {
        let inside = judge.space.inside(Maker::Edges, seed(), budget().edges);
        let extreme = judge.space.inside(Maker::Extreme, seed(), budget().points);
        let outside = judge.space.outside(seed(), budget().edges);
        [inside, extreme, outside].iter().try_for_each(|points| shapes::check_domain(judge, points))
    });
}

#[test]
fn results_that_f64_cannot_hold_are_named() {
    demand(|judge| shapes::check_range(judge, &judge.space.inside(Maker::Extreme, seed(), budget().points)));
}

#[test]
fn only_finite_inputs_are_taken() {
    demand(|judge| shapes::check_finite(judge, &judge.space.inside(Maker::Logarithmic, seed(), 1)));
}

#[test]
fn batches_have_the_bits_of_single_calls() {
    demand(|judge| {
        let inside = Maker::ALL.map(|maker| judge.space.inside(maker, seed(), budget().points).list);
        let list = [inside.concat(), judge.space.outside(seed(), budget().points).list].concat();
        shapes::check_batch(judge, &Points { origin: format!("every maker, seed {}", seed()), list })
    });
}

#[test]
fn faithful_results_are_less_than_one_ulp_off() {
    demand(|judge| {
        let mut points: Vec<Points> =
            Maker::ALL.into_iter().map(|maker| judge.space.inside(maker, seed(), budget().points)).collect();
        points.push(kept::points(judge, &kept::load()));
        let worst = points.iter().map(|points| shapes::check_faithful(judge, points)).collect::<Result<Vec<_>, _>>()?;
        println!("{:<40} {:.3} ulp", judge.kernel.info.name, worst.into_iter().fold(0.0, f64::max));
        Ok(())
    });
}

#[test]
fn a_sweep_finds_no_broken_promise() {
    let (judges, kept_inputs) = (kernels::judges(), kept::load());
    let swept = parallel::map(&judges, |judge| {
        let mut list = Maker::ALL.map(|maker| judge.space.inside(maker, seed(), 200).list).concat();
        list.extend(kept::points(judge, &kept_inputs).list);
        let around = Points { origin: format!("every maker, seed {}", seed()), list };
        sweep(judge, &around, seed(), budget().sweep)
    });
    for (judge, swept) in judges.iter().zip(&swept) {
        println!("{:<40} {swept:?}", judge.kernel.info.name);
    }
    let failures: Vec<String> = swept.into_iter().filter_map(Result::err).collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n\n"));
}

#[test]
fn single_precision_is_rounded_once() {
    demand(|judge| {
        let points = judge.space.inside(Maker::Logarithmic, seed(), budget().points);
        let judged = shapes::check_single(judge, &points)?;
        let enough = 2 * judged > points.list.len();
        enough.then_some(()).ok_or_else(|| format!("{}: only {judged} points judged", judge.kernel.info.name))
    });
}
