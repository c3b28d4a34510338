//! Blocks of rows of a batch: parts of a slice, cut without a division and without a way to panic.

/// Rows that are computed together: what they need stays in the fastest cache.
pub const BLOCK: usize = 256;

/// Flags of which it is asked together whether any is raised.
const GROUP: usize = 16;

/// Where flags are raised.
#[inline]
pub fn raised(flags: &[u64; BLOCK]) -> impl Iterator<Item = usize> {
    let groups =
        flags.chunks_exact(GROUP).enumerate().filter(|(_, group)| group.iter().fold(0, |any, flag| any | flag) != 0);
    groups.flat_map(|(at, group)| {
        let raised = group.iter().enumerate().filter(|(_, flag)| **flag != 0);
        raised.map(move |(place, _)| at * GROUP + place)
    })
}

/// The blocks of inputs; the last one may be shorter.
#[derive(Debug)]
pub struct Blocks<'a>(pub &'a [f64]);

impl<'a> Iterator for Blocks<'a> {
    type Item = &'a [f64];

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (block, rest) = self.0.split_at_checked(BLOCK).unwrap_or((self.0, &[]));
        self.0 = rest;
        (!block.is_empty()).then_some(block)
    }
}

/// The blocks of results; the last one may be shorter.
#[derive(Debug)]
pub struct BlocksMut<'a>(pub &'a mut [f64]);

impl<'a> Iterator for BlocksMut<'a> {
    type Item = &'a mut [f64];

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let all = core::mem::take(&mut self.0);
        if all.len() <= BLOCK {
            return (!all.is_empty()).then_some(all);
        }
        let (block, rest) = all.split_at_mut_checked(BLOCK)?;
        self.0 = rest;
        Some(block)
    }
}
