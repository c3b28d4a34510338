//! The clock of a raster: times as whole numbers of ticks, or in seconds where there is no tick.

use crate::error::PlanError;

/// Counts ticks, or seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Clock {
    tick: Option<Tick>,
    /// How many ticks, at least, lie between two rows.
    coarse: f64,
}

/// A tick as the decimal that it is written as: `digits * 10^-places`, where both are small enough.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Tick {
    seconds: f64,
    decimal: Option<(f64, f64)>,
}

/// Whole numbers up to here are exact.
const EXACT: f64 = (1_u64 << 53) as f64;

impl Clock {
    /// With a tick, and the shortest time of a row; without a tick, that is the tick.
    pub(crate) fn new(tick: Option<f64>, shortest: f64) -> Self {
        let coarse = tick.map_or(1.0, |tick| ceil(shortest / tick).max(1.0));
        let tick = tick.or((shortest > 0.0).then_some(shortest));
        Self { tick: tick.map(Tick::new), coarse }
    }

    /// The least count that is no shorter than a time, of as many ticks as rows are apart.
    pub(crate) fn up(&self, time: f64) -> f64 {
        match self.tick {
            Some(tick) => ceil(time / tick.seconds / self.coarse) * self.coarse,
            None => time,
        }
    }

    /// The largest such count that is no longer than a time.
    pub(crate) fn down(&self, time: f64) -> f64 {
        match self.tick {
            Some(tick) => (time / tick.seconds / self.coarse * (1.0 + ROUNDING)).floor() * self.coarse,
            None => time,
        }
    }

    /// What makes a count the next longer one; nothing without a tick.
    pub(crate) fn step(&self) -> f64 {
        if self.tick.is_some() { self.coarse } else { 0.0 }
    }

    /// A count in seconds: the number nearest to so many times the decimal that the tick is written as.
    pub(crate) fn seconds(&self, count: f64) -> f64 {
        self.tick.map_or(count, |tick| tick.times(count))
    }

    /// Below what two counts are one.
    pub(crate) fn same(&self, period: f64) -> f64 {
        if self.tick.is_some() { 0.5 } else { 16.0 * f64::EPSILON * period }
    }

    /// Whether all counts of a raster are exact.
    pub(crate) fn check(&self, count: f64) -> Result<(), PlanError> {
        match self.tick {
            Some(tick) if count >= EXACT => {
                let remedy = "give a longer tick: the raster has more of them than 2^53";
                Err(PlanError::Input { name: "tick", value: tick.seconds, remedy })
            }
            _ => Ok(()),
        }
    }
}

/// What the rounding of a quotient and of the time itself may add.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

fn ceil(ratio: f64) -> f64 {
    (ratio * (1.0 - ROUNDING)).ceil()
}

impl Tick {
    fn new(seconds: f64) -> Self {
        // the shortest decimal that reads back to it
        let text = format!("{seconds:e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let whole: String = digits.chars().filter(char::is_ascii_digit).collect();
        let behind = whole.len() as i32 - 1 - exponent.parse::<i32>().unwrap_or(0);
        let decimal = match (whole.parse::<f64>(), behind) {
            (Ok(whole), 0..=22) if whole < EXACT => Some((whole, 10_f64.powi(behind))),
            _ => None,
        };
        Self { seconds, decimal }
    }

    /// Numerator and denominator are exact where they are whole numbers below 2^53 and 10^22: then the quotient is rounded
    /// once.
    fn times(self, count: f64) -> f64 {
        match self.decimal {
            Some((whole, power)) if whole * count.abs() < EXACT && count.fract() == 0.0 => count * whole / power,
            _ => count * self.seconds,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_the_numbers_nearest_to_multiples_of_a_decimal() {
        let clock = Clock::new(Some(0.00025), 0.0);
        assert_eq!(clock.seconds(13.0), 0.00325);
        for count in 0..100_000_u32 {
            let decimal: f64 = format!("{}e-5", 25 * count).parse().expect("a number");
            assert_eq!(clock.seconds(f64::from(count)), decimal);
        }
        assert_eq!(clock.up(0.00325), 13.0);
        assert_eq!(clock.up(0.003_250_000_1), 14.0);
        assert_eq!(Clock::new(Some(2e-3), 5e-3).up(7e-3), 6.0);
        assert_eq!(Clock::new(None, 0.0).up(0.1), 0.1);
        assert_eq!(Clock::new(Some(3.0), 0.0).seconds(7.0), 21.0);
    }
}
