//! Every shape of a call keeps its promise, and other units change nothing but the unit.

use closedform::Aim;
use closedform_tests::budget::budget;
use closedform_tests::check::Judge;
use closedform_tests::harness::Said;
use closedform_tests::inputs::{Maker, Points};
use closedform_tests::random::seed;
use closedform_tests::scaling::check_scaling;
use closedform_tests::{fast, shapes, tables};

/// Outside the domain results are NaN, and `checked` names the condition.
pub fn domain(judge: &Judge) -> Said {
    let inside = judge.space.inside(Maker::Edges, seed(), budget().edges);
    let extreme = judge.space.inside(Maker::Extreme, seed(), budget().points);
    let outside = judge.space.outside(seed(), budget().edges);
    [inside, extreme, outside].iter().try_for_each(|points| shapes::check_domain(judge, points))?;
    Ok(String::new())
}

/// `checked` names the results that `f64` cannot hold.
pub fn range(judge: &Judge) -> Said {
    shapes::check_range(judge, &judge.space.inside(Maker::Extreme, seed(), budget().points))?;
    Ok(String::new())
}

/// Only finite inputs are taken.
pub fn finite(judge: &Judge) -> Said {
    shapes::check_finite(judge, &judge.space.inside(Maker::Logarithmic, seed(), 1))?;
    Ok(String::new())
}

/// Batches have the bits of single calls.
pub fn batch(judge: &Judge) -> Said {
    let inside = Maker::ALL.map(|maker| judge.space.inside(maker, seed(), budget().points).list);
    let list = [inside.concat(), judge.space.outside(seed(), budget().points).list].concat();
    shapes::check_batch(judge, &Points { origin: format!("every maker, seed {}", seed()), list })?;
    Ok(String::new())
}

/// Fast calls keep their promise, their batches have the bits of single ones, and certified errors are no smaller than true ones.
pub fn fast(judge: &Judge) -> Said {
    let made = Maker::ALL.map(|maker| judge.space.inside(maker, seed(), budget().points));
    let outside = judge.space.outside(seed(), budget().points);
    let mut worst = 0.0_f64;
    for points in made.iter().chain([&outside]) {
        worst = worst.max(fast::check(judge, points)?);
        fast::check_batch(judge, points)?;
    }
    Ok(format!("{worst:e}"))
}

/// Single precision is the double, rounded once.
pub fn single(judge: &Judge) -> Said {
    let points = judge.space.inside(Maker::Logarithmic, seed(), budget().points);
    let judged = shapes::check_single(judge, &points)?;
    if 2 * judged <= points.list.len() {
        return Err(format!("{}: only {judged} points judged", judge.kernel.info.name));
    }
    Ok(String::new())
}

/// Other units scale the results, bit for bit.
pub fn units(judge: &Judge) -> Said {
    // In other units, extreme results lose digits, and extreme inputs are not finite.
    let mut makers = Maker::ALL.into_iter().filter(|maker| *maker != Maker::Extreme);
    makers.try_for_each(|maker| check_scaling(judge.kernel, &judge.space.inside(maker, seed(), budget().laws)))?;
    Ok(String::new())
}

/// Tables decide the domain, and hold the exact results within the errors that they state.
pub fn table(judge: &Judge) -> Said {
    let points = |maker| judge.space.inside(maker, seed(), budget().points);
    let inside = Maker::ALL.into_iter().map(points);
    let outside = judge.space.outside(seed(), budget().points);
    let judged: usize = inside
        .chain([outside])
        .flat_map(|points| [Aim::Certified, Aim::Nearest].map(|aim| tables::check(judge, &points, aim)))
        .sum::<Result<_, _>>()?;
    if judged < budget().points {
        return Err(format!("{}: only {judged} results judged", judge.kernel.info.name));
    }
    Ok(format!("{judged} results"))
}
