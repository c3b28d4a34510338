//! The planner that looks ahead, against a simulator of its own, and against what physics allows.

mod support;

use closedform_motion::plan::milling::{Arc, Arcs, Corner, Feed, Machine, Milling, Model, Move, Path, Row, Rules};
use support::Random;

const ACCELERATION: f64 = 500.0;

fn milling(rules: Rules) -> Milling {
    Milling::new(Machine { rapid: 100.0, ..Machine::default() }, Model::LookAhead(rules)).expect("a machine")
}

fn rows(milling: &Milling, moves: &[Move]) -> Vec<Row> {
    let mut timer = milling.timer();
    moves.iter().for_each(|one| timer.add(one).expect("timed"));
    timer.rest().expect("timed");
    std::iter::from_fn(|| timer.next_row()).collect()
}

fn total(rows: &[Row]) -> f64 {
    rows.iter().map(|row| row.time).sum()
}

/// Random paths: pieces of a millimetre or so, smooth or with corners, at random feeds.
fn path(random: &mut Random, count: usize) -> Vec<Move> {
    let (mut at, mut angle): ([f64; 3], f64) = ([0.0; 3], 0.0);
    let (smooth, short) = (random.between(0.0, 1.0), random.decades(-2.0, 1.0));
    (0..count)
        .map(|_| {
            angle += if random.unit() < smooth { random.between(-0.2, 0.2) } else { random.between(-3.1, 3.1) };
            let (length, rise) = (short * random.between(0.1, 2.0), random.between(-0.3, 0.3));
            let from = at;
            at = [at[0] + length * angle.cos(), at[1] + length * angle.sin(), at[2] + length * rise];
            let feed = if random.unit() < 0.1 { Feed::Rapid } else { Feed::Speed(random.decades(0.0, 2.0)) };
            Move::straight(from, at, feed)
        })
        .collect()
}

/// A cut of the simulator: its length, direction, speed and acceleration.
struct Piece {
    length: f64,
    direction: [f64; 3],
    speed: f64,
    acceleration: f64,
}

fn piece(one: &Move) -> Piece {
    let way: [f64; 3] = std::array::from_fn(|axis| one.to[axis] - one.from[axis]);
    let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
    let direction = way.map(|part| part / length);
    let acceleration = direction.iter().map(|part| ACCELERATION / part.abs()).fold(f64::INFINITY, f64::min);
    let speed = match one.feed {
        Feed::Speed(speed) => speed,
        _ => 100.0,
    };
    Piece { length, direction, speed, acceleration }
}

/// Jeon's rule as it is printed: with the angle between the legs, theta, R = d*sin(theta/2)/(1-sin(theta/2)).
fn corner(before: &Piece, after: &Piece, deviation: f64) -> f64 {
    let product: f64 = before.direction.iter().zip(after.direction).map(|(u, w)| u * w).sum();
    let theta = (-product).clamp(-1.0, 1.0).acos();
    let sine = (theta / 2.0).sin();
    let change: Vec<f64> = before.direction.iter().zip(after.direction).map(|(u, w)| w - u).collect();
    let norm = change.iter().map(|part| part * part).sum::<f64>().sqrt();
    let across = change.iter().map(|part| ACCELERATION * norm / part.abs()).fold(f64::INFINITY, f64::min);
    let feed = before.speed.min(after.speed);
    if sine >= 1.0 { feed } else { feed.min((across * deviation * sine / (1.0 - sine)).sqrt()) }
}

/// Times of all pieces: for each, the speeds are planned anew, from rest at the end of the last one that is known.
fn simulated(moves: &[Move], deviation: f64, ahead: usize) -> Vec<f64> {
    let pieces: Vec<Piece> = moves.iter().map(piece).collect();
    let mut entry = 0.0_f64;
    let time = |index: usize| {
        let known = (index + ahead).min(pieces.len() - 1);
        let mut exit = 0.0_f64;
        for later in (index + 1..=known).rev() {
            let one = &pieces[later];
            let reachable = (exit * exit + 2.0 * one.acceleration * one.length).sqrt();
            exit = reachable.min(corner(&pieces[later - 1], one, deviation));
        }
        let Piece { length, speed, acceleration, .. } = pieces[index];
        exit = exit.min((entry * entry + 2.0 * acceleration * length).sqrt());
        let top = ((entry * entry + exit * exit) / 2.0 + acceleration * length).sqrt().min(speed).max(entry).max(exit);
        let way = (2.0 * top * top - entry * entry - exit * exit) / (2.0 * acceleration);
        let time = (2.0 * top - entry - exit) / acceleration + (length - way).max(0.0) / top;
        entry = exit;
        time
    };
    (0..pieces.len()).map(time).collect()
}

#[test]
fn times_are_those_of_a_simulator() {
    let mut random = Random(1);
    for _ in 0..200 {
        let moves = path(&mut random, 120);
        let (deviation, ahead) = (random.decades(-3.0, -1.0), 1 + (random.unit() * 40.0) as usize);
        let rules = Rules { corner: Corner::Deviation(deviation), ahead, ..Rules::GRBL };
        let (found, expected) = (rows(&milling(rules), &moves), simulated(&moves, deviation, ahead));
        for (row, expected) in found.iter().zip(&expected) {
            // The printed rule loses half of the digits where the way goes nearly straight on.
            assert!((row.time - expected).abs() <= 1e-6 * expected, "{row:?} {expected}");
        }
    }
}

/// What must hold of every plan: speeds within feeds, changes within the acceleration, no jump, rest at both ends.
fn keeps_limits(rows: &[Row], what: &str) {
    let loose = 1.0 + 1e-9;
    assert_eq!((rows[0].entry, rows[rows.len() - 1].exit), (0.0, 0.0), "{what}");
    assert!(rows.windows(2).all(|pair| pair[0].exit == pair[1].entry), "{what}: a jump");
    for row in rows {
        let Piece { length, speed, acceleration, .. } = piece(&row.cut);
        let Row { entry, exit, peak, time, .. } = *row;
        assert!(peak <= speed * loose && entry <= peak * loose && exit <= peak * loose, "{what}: {row:?}");
        let change = (exit * exit - entry * entry).abs();
        assert!(change <= 2.0 * acceleration * length * loose, "{what}: {row:?}");
        let ramps = (2.0 * peak * peak - entry * entry - exit * exit) / (2.0 * acceleration);
        assert!(ramps <= length * loose, "{what}: {row:?}");
        // No faster than at the peak all the way.
        assert!(time * loose >= length / peak, "{what}: {row:?}");
    }
}

#[test]
fn no_plan_is_faster_than_physics_allows() {
    let mut random = Random(2);
    for index in 0..200 {
        let moves = path(&mut random, 60);
        let plan = rows(&milling(Rules::GRBL), &moves);
        keeps_limits(&plan, &index.to_string());
        // Never slower than with a stop at every point, never faster than without any corner.
        let stops = Milling::new(Machine::default(), Model::ExactStop).expect("a machine");
        let stops: f64 = rows(&stops, &moves).iter().map(|row| row.time).sum();
        let free: f64 = moves.iter().map(piece).map(|one| one.length / one.speed).sum();
        assert!((free..=stops * (1.0 + 1e-9)).contains(&total(&plan)), "{index}");
    }
}

#[test]
fn more_sight_is_never_slower() {
    let mut random = Random(3);
    for _ in 0..50 {
        let moves = path(&mut random, 100);
        let times: Vec<f64> = [1, 2, 4, 8, 16, 64, 256]
            .map(|ahead| total(&rows(&milling(Rules { ahead, ..Rules::GRBL }), &moves)))
            .to_vec();
        assert!(times.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-12)), "{times:?}");
    }
}

#[test]
fn a_line_in_pieces_takes_the_time_of_the_line() {
    let whole = rows(&milling(Rules::GRBL), &[Move::straight([0.0; 3], [100.0, 0.0, 0.0], Feed::Speed(50.0))]);
    assert!((total(&whole) - (100.0 / 50.0 + 50.0 / 500.0)).abs() < 1e-12);
    let at = |index: u32| [f64::from(index), 0.0, 0.0];
    let pieces: Vec<Move> = (0..100).map(|index| Move::straight(at(index), at(index + 1), Feed::Speed(50.0))).collect();
    let rules = Rules { ahead: 100, ..Rules::GRBL };
    assert!((total(&rows(&milling(rules), &pieces)) - total(&whole)).abs() < 1e-12);
}

#[test]
fn stairs_take_what_the_acceleration_allows() {
    // 20 moves of 2 mm, alternately X and Y, F1200: 2.8 s from rest to rest.
    let corner = |index: u32| [f64::from(2 * index.div_ceil(2)), f64::from(2 * (index / 2)), 0.0];
    let moves: Vec<Move> =
        (0..20).map(|index| Move::straight(corner(index), corner(index + 1), Feed::Speed(20.0))).collect();
    let time = total(&rows(&milling(Rules::GRBL), &moves));
    // The corner: a = 500*sqrt(2) across, R = 0.01*c/(1-c) with c = 1/sqrt(2).
    let c = 0.5_f64.sqrt();
    let v = (500.0 / c * 0.01 * c / (1.0 - c)).sqrt();
    let (first, inner) =
        (2.0 / 20.0 + (400.0 + (20.0 - v).powi(2)) / 20_000.0, 2.0 / 20.0 + 2.0 * (20.0 - v).powi(2) / 20_000.0);
    assert!((time - (2.0 * first + 18.0 * inner)).abs() < 1e-9, "{time}");
}

#[test]
fn arcs_by_chords_and_as_a_whole() {
    let centre = [10.0, 0.0, 0.0];
    let arc = Arc { radius: 10.0, angle: std::f64::consts::PI, height: 0.0, axis: 2, centre, clockwise: true };
    let half = Move { path: Path::Arc(arc), ..Move::straight([0.0; 3], [20.0, 0.0, 0.0], Feed::Speed(500.0)) };
    let length = 10.0 * std::f64::consts::PI;
    let chords = rows(&milling(Rules { ahead: 1000, ..Rules::GRBL }), &[half])[0];
    let whole = rows(&milling(Rules { arcs: Arcs::Whole, ..Rules::GRBL }), &[half])[0];
    // The chords are within 0.002 mm of the arc, so they are shorter by less than 0.02 %.
    assert!(chords.length < length && chords.length > 0.9998 * length, "{}", chords.length);
    assert!((whole.length - length).abs() < 1e-12);
    // On the arc v^2/r is within the limit; on the chords of grbl's default settings it is five times that: 0.01/0.002.
    assert!(whole.peak * whole.peak / 10.0 <= ACCELERATION * (1.0 + 1e-12));
    assert!(chords.peak * chords.peak / 10.0 <= 5.1 * ACCELERATION && chords.time < whole.time);
    // A line that goes on from the arc is no corner.
    let on = Move::straight([20.0, 0.0, 0.0], [20.0, -5.0, 0.0], Feed::Speed(30.0));
    let both = rows(&milling(Rules { arcs: Arcs::Whole, ..Rules::GRBL }), &[half, on]);
    assert!((both[0].exit - 30.0).abs() < 1e-9, "{:?}", both[0]);
}

#[test]
fn a_jerk_limit_costs_time_and_is_kept() {
    let line = [Move::straight([0.0; 3], [100.0, 0.0, 0.0], Feed::Speed(50.0))];
    let with = |jerk: f64| total(&rows(&milling(Rules { jerk, ..Rules::GRBL }), &line));
    // From rest to 50 mm/s: 50/500 + 500/j longer than v/a, for the whole line once a/j.
    assert!((with(10_000.0) - (2.1 + 0.05)).abs() < 1e-12, "{}", with(10_000.0));
    // So slow a growth that the acceleration limit is not reached: 2*sqrt(v/j) a ramp.
    let ramp = 2.0 * (50.0_f64 / 1000.0).sqrt();
    assert!((with(1000.0) - (2.0 + ramp)).abs() < 1e-12, "{}", with(1000.0));
    let mut random = Random(4);
    for _ in 0..50 {
        let moves = path(&mut random, 60);
        let time = |jerk: f64| total(&rows(&milling(Rules { jerk, ..Rules::GRBL }), &moves));
        let times = [f64::INFINITY, 1e7, 1e5, 1e4, 1e3].map(time);
        assert!(times.windows(2).all(|pair| pair[0] <= pair[1] * (1.0 + 1e-9)), "{times:?}");
        assert!((times[1] - times[0]).abs() < 0.05 * times[0] && times[4].is_finite());
    }
}

#[test]
fn classic_jerk_lets_axes_jump() {
    let leg = |from: [f64; 3], to: [f64; 3]| Move::straight(from, to, Feed::Speed(50.0));
    let turn = [leg([0.0; 3], [20.0, 0.0, 0.0]), leg([20.0, 0.0, 0.0], [20.0, 20.0, 0.0])];
    let rules = Rules { corner: Corner::Jump([10.0, 8.0, 0.3]), ..Rules::MARLIN };
    let plan = rows(&milling(rules), &turn);
    // From rest with the jump of X; in the corner X stops and Y starts, at most by 10 and 8.
    assert_eq!((plan[0].entry, plan[0].exit), (10.0, 8.0));
    let square = rows(&milling(Rules::KLIPPER), &turn);
    assert!((square[0].exit - 5.0).abs() < 1e-9, "{}", square[0].exit);
}

#[test]
fn rests_and_zero_moves() {
    let leg = |from: f64, to: f64| Move::straight([from, 0.0, 0.0], [to, 0.0, 0.0], Feed::Speed(20.0));
    let stop = Move { stops: true, ..leg(0.0, 10.0) };
    let plan = rows(&milling(Rules::GRBL), &[stop, leg(10.0, 10.0), leg(10.0, 20.0), leg(20.0, 20.0), leg(20.0, 30.0)]);
    let exits: Vec<f64> = plan.iter().map(|row| row.exit).collect();
    assert_eq!(exits, [0.0, 0.0, 20.0, 0.0, 0.0]);
    assert_eq!(plan.iter().map(|row| row.number).collect::<Vec<u64>>(), [1, 2, 3, 4, 5]);
    // E alone: from rest to rest.
    let mut push = leg(30.0, 30.0);
    push.others[6] = -5.0;
    let plan = rows(&milling(Rules::MARLIN), &[leg(20.0, 30.0), push, leg(30.0, 40.0)]);
    assert_eq!((plan[0].exit, plan[1].exit, plan[1].length), (0.0, 0.0, 5.0));
}

/// Times by the rules of Klipper's look-ahead queue (`toolhead.py`, `calc_junction` and `flush`), all moves in one flush, with
/// the corners of junction deviation. Squares of speeds, as there.
fn klipper(moves: &[Move], deviation: f64, ratio: f64) -> Vec<f64> {
    let pieces: Vec<Piece> = moves.iter().map(piece).collect();
    let delta: Vec<f64> = pieces.iter().map(|one| 2.0 * one.length * one.acceleration).collect();
    let smooth_delta: Vec<f64> = delta.iter().map(|delta| delta * (1.0 - ratio)).collect();
    let cruise: Vec<f64> = pieces.iter().map(|one| one.speed * one.speed).collect();
    let (mut max_start, mut max_smoothed) = (vec![0.0_f64], vec![0.0_f64]);
    for index in 1..pieces.len() {
        let corner = corner(&pieces[index - 1], &pieces[index], deviation);
        max_start.push((corner * corner).min(max_start[index - 1] + delta[index - 1]));
        max_smoothed.push(max_start[index].min(max_smoothed[index - 1] + smooth_delta[index - 1]));
    }
    // start, cruise and end of each move
    let mut junctions = vec![[0.0_f64; 3]; pieces.len()];
    let mut delayed: Vec<(usize, f64, f64)> = Vec::new();
    let (mut next_end, mut next_smoothed, mut peak) = (0.0_f64, 0.0_f64, 0.0_f64);
    for index in (0..pieces.len()).rev() {
        let reachable_start = next_end + delta[index];
        let start = max_start[index].min(reachable_start);
        let reachable_smoothed = next_smoothed + smooth_delta[index];
        let smoothed = max_smoothed[index].min(reachable_smoothed);
        if smoothed < reachable_smoothed {
            if smoothed + smooth_delta[index] > next_smoothed || !delayed.is_empty() {
                peak = cruise[index].min((smoothed + reachable_smoothed) * 0.5);
                let mut most = peak;
                for (later, start, end) in delayed.drain(..).rev() {
                    most = most.min(start);
                    junctions[later] = [start.min(most), most, end.min(most)];
                }
            }
            let top = ((start + reachable_start) * 0.5).min(cruise[index]).min(peak);
            junctions[index] = [start.min(top), top, next_end.min(top)];
        } else {
            delayed.push((index, start, next_end));
        }
        (next_end, next_smoothed) = (start, smoothed);
    }
    assert!(delayed.is_empty());
    let time = |(one, [start, top, end]): (&Piece, [f64; 3])| {
        let twice = 2.0 * one.acceleration;
        let even = one.length - (top - start) / twice - (top - end) / twice;
        (2.0 * top.sqrt() - start.sqrt() - end.sqrt()) / one.acceleration + even / top.sqrt()
    };
    pieces.iter().zip(junctions).map(time).collect()
}

#[test]
fn a_cruise_ratio_is_klippers() {
    let mut random = Random(3);
    let mut slower = 0;
    for _ in 0..300 {
        let moves = path(&mut random, 120);
        let (deviation, ratio) = (random.decades(-3.0, -1.0), random.between(0.05, 0.95));
        let rules = |cruise_ratio| Rules { corner: Corner::Deviation(deviation), cruise_ratio, ..Rules::KLIPPER };
        let found = rows(&milling(rules(ratio)), &moves);
        let expected = klipper(&moves, deviation, ratio);
        for (row, expected) in found.iter().zip(&expected) {
            assert!((row.time - expected).abs() <= 1e-6 * expected, "{ratio}: {row:?} {expected}");
        }
        let without = total(&rows(&milling(rules(0.0)), &moves));
        assert!(total(&found) >= without * (1.0 - 1e-9));
        slower += u32::from(total(&found) > 1.01 * without);
    }
    assert!(slower > 50, "{slower} of 300 paths know the ratio");
}

#[test]
fn a_short_move_cruises_half_of_its_way() {
    // 2 mm from rest to rest: it could reach the root of 500 * 2; half of the acceleration's way is left to it
    let one = Move::straight([0.0; 3], [2.0, 0.0, 0.0], Feed::Speed(1000.0));
    let row = rows(&milling(Rules::KLIPPER), &[one])[0];
    assert!((row.peak - 500.0_f64.sqrt()).abs() < 1e-12, "{row:?}");
    assert!((row.time - (2.0 * row.peak / 500.0 + 1.0 / row.peak)).abs() < 1e-12, "{row:?}");
}

#[test]
fn bad_rules_are_refused() {
    let refused = |rules: Rules| {
        let error = Milling::new(Machine::default(), Model::LookAhead(rules)).expect_err("refused");
        assert!(error.to_string().contains("make it"), "{error}");
    };
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        refused(Rules { corner: Corner::Deviation(value), ..Rules::GRBL });
        refused(Rules { corner: Corner::Jump([1.0, value, 1.0]), ..Rules::GRBL });
        refused(Rules { arcs: Arcs::Tolerance(value), ..Rules::GRBL });
    }
    refused(Rules { arcs: Arcs::Length(0.0), ..Rules::GRBL });
    refused(Rules { ahead: 0, ..Rules::GRBL });
    refused(Rules { jerk: 0.0, ..Rules::GRBL });
    refused(Rules { cruise_ratio: 1.0, ..Rules::GRBL });
    refused(Rules { jerk: 1e4, ..Rules::KLIPPER });
}
