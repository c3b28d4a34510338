//! A kernel keeps its bound, and its faithful results theirs, on inputs chosen where it hurts.

use std::sync::LazyLock;

use closedform_tests::budget::budget;
use closedform_tests::check::{Judge, Report, check};
use closedform_tests::harness::Said;
use closedform_tests::inputs::{Maker, Points};
use closedform_tests::kept::{self, Kept};
use closedform_tests::random::seed;
use closedform_tests::{as_written, climb, shapes, strategy, sweep};

/// The worst inputs that are kept of all kernels.
static KEPT: LazyLock<Vec<Kept>> = LazyLock::new(kept::load);

/// The kept worst inputs, and the points of these makers.
fn points<'a>(judge: &'a Judge, makers: &'a [Maker]) -> impl Iterator<Item = Points> + 'a {
    let made = makers.iter().map(|maker| judge.space.inside(*maker, seed(), budget().points));
    [kept::points(judge, &KEPT)].into_iter().chain(made)
}

/// Every result keeps its bound at the kept worst inputs and at the points of all makers.
pub fn bound(judge: &Judge) -> Said {
    let mut report = Report::default();
    for points in points(judge, &Maker::ALL) {
        report.merge(check(judge, &points).map_err(|failure| failure.to_string())?);
    }
    Ok(report.told(judge))
}

/// The kept worst inputs are of this kernel and got no worse, and every result has some.
pub fn kept(judge: &Judge) -> Said {
    let complaints = kept::complaints(judge, &KEPT);
    if complaints.is_empty() { Ok(String::new()) } else { Err(complaints.join("\n\n")) }
}

/// The kernel is not worse by more than its bound than its formula as Maxima writes it.
pub fn formula(judge: &Judge) -> Said {
    points(judge, &Maker::SAMPLINGS).try_for_each(|points| as_written::check(judge, &points))?;
    Ok(String::new())
}

/// Climbs towards the worst input stay below the bound.
pub fn climb(judge: &Judge) -> Said {
    let mut starts = judge.space.inside(Maker::Bits, seed(), budget().climbs);
    starts.list.extend(kept::points(judge, &KEPT).list);
    let maximum = climb::climb(judge, &starts, budget().steps, seed()).map_err(|failure| failure.to_string())?;
    let maximum = maximum.ok_or_else(|| format!("{}: no climb can start", judge.kernel.info.name))?;
    Ok(format!("{:.3} of its bound at {:?}", maximum.score, maximum.inputs))
}

/// The bound is kept at points that are shrunk to round numbers where it is not.
pub fn shrunk(judge: &Judge) -> Said {
    let mut makers = Maker::ALL.into_iter().filter(|maker| judge.space.has(*maker));
    makers.try_for_each(|maker| strategy::shrink(judge, maker, budget().points as u32 / 4))?;
    Ok(String::new())
}

/// Faithful results are less than one ulp off.
pub fn faithful(judge: &Judge) -> Said {
    let mut worst = 0.0_f64;
    for points in points(judge, &Maker::ALL) {
        worst = worst.max(shapes::check_faithful(judge, &points)?);
    }
    Ok(format!("{worst:.3} ulp"))
}

/// Plain and faithful results keep their promises at very many points.
pub fn sweep(judge: &Judge) -> Said {
    let mut list = Maker::ALL.map(|maker| judge.space.inside(maker, seed(), 200).list).concat();
    list.extend(kept::points(judge, &KEPT).list);
    let around = Points { origin: format!("every maker, seed {}", seed()), list };
    let swept = sweep::sweep(judge, &around, seed(), budget().sweep)?;
    Ok(format!("{swept:?}"))
}
