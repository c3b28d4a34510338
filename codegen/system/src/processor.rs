//! Processor time of other processes: unlike elapsed time it does not depend on what else the machine does.

use std::fs;
use std::time::Duration;

use rustix::param::clock_ticks_per_second;

/// What all processes of a group have used, and their children that have ended; `None` where the system does not tell.
#[must_use]
pub fn time_of_group(group: u32) -> Option<Duration> {
    let processes =
        fs::read_dir("/proc").ok()?.flatten().filter_map(|entry| stat(&entry.file_name().to_string_lossy()));
    let used: Vec<u64> = processes.filter(|stat| stat.group == group).map(|stat| stat.ticks).collect();
    (!used.is_empty()).then(|| duration(used.iter().sum()))
}

/// What a process has used, and its children that have ended; `None` where the system does not tell.
#[must_use]
pub fn time_of(process: u32) -> Option<Duration> {
    stat(&process.to_string()).map(|stat| duration(stat.ticks))
}

fn duration(ticks: u64) -> Duration {
    Duration::from_millis(ticks * 1000 / clock_ticks_per_second().max(1))
}

struct Stat {
    group: u32,
    ticks: u64,
}

fn stat(process: &str) -> Option<Stat> {
    process.parse::<u32>().ok()?;
    read(&fs::read_to_string(format!("/proc/{process}/stat")).ok()?)
}

/// Linux: the second field, the name, stands in parentheses and may contain any; what counts comes after it.
fn read(text: &str) -> Option<Stat> {
    let fields: Vec<&str> = text.rsplit_once(')')?.1.split_whitespace().collect();
    let number = |at: usize| fields.get(at)?.parse::<u64>().ok();
    let ticks = (11..15).map(number).sum::<Option<u64>>()?; // user, system, and both of ended children
    Some(Stat { group: u32::try_from(number(2)?).ok()?, ticks })
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use std::time::Instant;

    #[test]
    fn a_name_may_be_anything() {
        let stat = read("7 (a) (b 1) S 1 42 3 4 5 6 7 8 9 10 100 20 3 4 11 12").unwrap();
        assert_eq!((stat.group, stat.ticks), (42, 127));
        assert!(read("7 (a) S 1 x").is_none() && read("").is_none());
    }

    #[test]
    fn work_counts_and_waiting_does_not() {
        let own = std::process::id();
        let (start, before) = (Instant::now(), time_of(own).unwrap());
        while time_of(own).unwrap() < before + Duration::from_millis(50) {
            assert!(start.elapsed() < Duration::from_secs(60));
        }
        assert!(time_of_group(u32::MAX).is_none());
    }
}
