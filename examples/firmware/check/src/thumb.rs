//! A decoder for the Thumb-2 instructions that branch or use the stack (Armv7-M Architecture Reference
//! Manual, DDI 0403, chapter A5).

use std::collections::{BTreeMap, BTreeSet};

/// The effect of an instruction on control flow and stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    /// Continues with the next instruction.
    Other,
    /// Pushes this number of bytes on the stack.
    Push(u32),
    /// Calls the function at an address.
    Call(u32),
    /// Branches to an address, or continues if a condition does not hold.
    Branch { to: u32, conditional: bool },
    /// Makes this number of following instructions conditional.
    IfThen(u32),
    /// Returns to the caller, or stops.
    End,
    /// Branches to an address, or moves the stack pointer by a number, known only at run time.
    Unknown,
}

/// The effects of a function's instructions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Function {
    /// The sum of all bytes that it pushes: an upper bound of its stack depth.
    pub frame: u32,
    /// The addresses of the functions that it calls, or branches to at its end.
    pub calls: BTreeSet<u32>,
    /// The number of instructions that can be reached again from themselves.
    pub loops: usize,
    /// The addresses of instructions with an unknown effect; also where execution continues beyond
    /// the end, and where a loop pushes on the stack.
    pub unknown: BTreeSet<u32>,
}

/// The successors of an instruction within its function.
type Edges = BTreeMap<u32, Vec<u32>>;

/// Analyses a function from its parts: code without the data in between, with the address of each.
pub fn function(parts: &[(u32, &[u8])]) -> Function {
    let inside = |to: u32| {
        parts.iter().any(|(start, code)| (*start..*start + code.len() as u32).contains(&to))
    };
    let (mut function, mut edges) = (Function::default(), Edges::new());
    let mut pushes = Vec::new();
    for &(start, code) in parts {
        let (mut at, mut left_of_block) = (start, 0);
        while let Some((instruction, length)) = decode(&code[(at - start) as usize..], at) {
            let next = at + length;
            let always = left_of_block == 0;
            left_of_block = u32::saturating_sub(left_of_block, 1);
            let goes_on = match instruction {
                Instruction::Branch { conditional, .. } => conditional || !always,
                Instruction::End => !always,
                // A call at the very end does not return.
                Instruction::Call(_) => inside(next),
                _ => true,
            };
            match instruction {
                Instruction::Push(bytes) => {
                    function.frame += bytes;
                    pushes.push(at);
                }
                Instruction::IfThen(count) => left_of_block = count,
                Instruction::Unknown => _ = function.unknown.insert(at),
                Instruction::Branch { to, .. } if inside(to) => {
                    edges.entry(at).or_default().push(to)
                }
                Instruction::Call(to) | Instruction::Branch { to, .. } => {
                    _ = function.calls.insert(to)
                }
                Instruction::Other | Instruction::End => (),
            }
            if goes_on {
                edges.entry(at).or_default().push(next);
            }
            at = next;
        }
    }
    function
        .unknown
        .extend(pushes.into_iter().filter(|push| reached(&edges, *push).contains(push)));
    if let Some(&(entry, _)) = parts.first() {
        function.unknown.extend(reached(&edges, entry).into_iter().filter(|&at| !inside(at)));
        function.loops = loops(&edges, entry);
    }
    function
}

/// Returns the number of back edges in a depth-first search.
fn loops(edges: &Edges, entry: u32) -> usize {
    let none = Vec::new();
    let onward = |at: u32| edges.get(&at).unwrap_or(&none).iter();
    let (mut seen, mut on_the_way, mut heads) =
        (BTreeSet::from([entry]), BTreeSet::from([entry]), BTreeSet::new());
    let mut way = vec![(entry, onward(entry))];
    while let Some((at, rest)) = way.last_mut() {
        match rest.next() {
            Some(&to) if on_the_way.contains(&to) => _ = heads.insert(to),
            Some(&to) if seen.insert(to) => {
                on_the_way.insert(to);
                way.push((to, onward(to)));
            }
            Some(_) => (),
            None => {
                on_the_way.remove(at);
                way.pop();
            }
        }
    }
    heads.len()
}

/// Returns all instructions reachable from an instruction.
fn reached(edges: &Edges, from: u32) -> BTreeSet<u32> {
    let (mut reached, mut waiting) = (BTreeSet::new(), vec![from]);
    while let Some(at) = waiting.pop() {
        let onward = edges.get(&at).into_iter().flatten();
        waiting.extend(onward.filter(|&&to| reached.insert(to)));
    }
    reached
}

/// Decodes the instruction at the start of `code`, which is at an address, and returns its length in
/// bytes.
fn decode(code: &[u8], at: u32) -> Option<(Instruction, u32)> {
    let half = |index: usize| {
        let bytes = code.get(2 * index..2 * index + 2)?;
        Some(u32::from(u16::from_le_bytes([bytes[0], bytes[1]])))
    };
    let first = half(0)?;
    // A5.1: these begin instructions of two halfwords.
    if matches!(first >> 11, 0b11101..=0b11111) {
        Some((wide(first, half(1)?, at), 4))
    } else {
        Some((narrow(first, at), 2))
    }
}

/// Section A5.2.
fn narrow(code: u32, at: u32) -> Instruction {
    use Instruction::*;
    // A branch offset is relative to the instruction after the next.
    let target = |offset: i32| at.wrapping_add(4).wrapping_add_signed(offset);
    let low = code & 0xff;
    match code >> 8 {
        // BX and BLX: to the link register is a return.
        0x47 if code & 0x80 == 0 && (code >> 3) & 0xf == 14 => End,
        0x47 => Unknown,
        // ADD and MOV of high registers, to the stack pointer or the program counter.
        0x44 | 0x46 if matches!((code >> 4) & 8 | code & 7, 13 | 15) => Unknown,
        // SUB of a constant from the stack pointer, and PUSH.
        0xb0 if low >= 0x80 => Push((low & 0x7f) * 4),
        0xb4 | 0xb5 => Push((low.count_ones() + (code >> 8 & 1)) * 4),
        // POP with the program counter.
        0xbd => End,
        0xbf if low & 0xf != 0 => IfThen(4 - low.trailing_zeros()),
        // UDF, permanently undefined, and SVC, whose handler may use any amount of stack.
        0xde => End,
        0xdf => Unknown,
        0xd0..=0xdd => Branch { to: target(signed(low, 8) * 2), conditional: true },
        0xe0..=0xe7 => Branch { to: target(signed(code & 0x7ff, 11) * 2), conditional: false },
        // CBZ and CBNZ.
        0xb1 | 0xb3 | 0xb9 | 0xbb => {
            let offset = (code >> 9 & 1) << 6 | (code >> 3 & 0x1f) << 1;
            Branch { to: target(offset as i32), conditional: true }
        }
        _ => Other,
    }
}

/// Section A5.3.
fn wide(first: u32, second: u32, at: u32) -> Instruction {
    use Instruction::*;
    let target = |offset: i32| at.wrapping_add(4).wrapping_add_signed(offset);
    let [low, destination] = [second & 0xff, second >> 8 & 0xf];
    match (first, second) {
        // POP with the program counter, other loads of it or of the stack pointer, and branches by
        // tables.
        (0xe8bd, _) if second & 0x8000 != 0 => End,
        (0xf85d, 0xfb04) => End,
        _ if first & 0xfe50 == 0xe810 && second & 0x8000 != 0 => Unknown,
        (0xf850..=0xf85f | 0xf8d0..=0xf8df, _) if matches!(second >> 12, 13 | 15) => Unknown,
        (0xe8d0..=0xe8df, _) if second & 0xffe0 == 0xf000 => Unknown,
        // Stores and loads with writeback that move the stack pointer down: of many registers,
        // which is PUSH, of one, of two, and of vectors, among them VPUSH.
        _ if first & 0xffef == 0xe92d => Push(second.count_ones() * 4),
        _ if first & 0xfe8f == 0xf80d && second & 0x0b00 == 0x0900 => Push(low),
        _ if first & 0xfeef == 0xe86d => Push(low * 4),
        _ if first & 0xfeaf == 0xec2d => Push(low * 4),
        // SUB and ADD of a constant to the stack pointer itself; other constants and registers that
        // it is computed from; MSR to it, or to what selects it.
        (0xf1ad | 0xf5ad, _) if second & 0x8f00 == 0x0d00 => Push(expanded(first, second)),
        (0xf2ad | 0xf6ad, _) if second & 0x8f00 == 0x0d00 => Push(immediate(first, second)),
        (0xf10d | 0xf50d | 0xf20d | 0xf60d, _) if second & 0x8f00 == 0x0d00 => Other,
        (0xf000..=0xf7ff, _) if second & 0x8000 == 0 && destination == 13 => Unknown,
        (0xea00..=0xebff, _) if destination == 13 => Unknown,
        (0xf380..=0xf39f, _) if second >> 8 == 0x88 && matches!(low, 8 | 9 | 20) => Unknown,
        (0xf000..=0xf7ff, _) if second & 0x8000 != 0 => {
            let sign = first >> 10 & 1;
            let [j1, j2] = [second >> 13 & 1, second >> 11 & 1];
            let low = (second & 0x7ff) << 1;
            // Encoding T4 of B and T1 of BL: two more bits of the offset, inverted by the sign.
            let [i1, i2] = [j1, j2].map(|bit| !(bit ^ sign) & 1);
            let far = sign << 24 | i1 << 23 | i2 << 22 | (first & 0x3ff) << 12 | low;
            let near = sign << 20 | j2 << 19 | j1 << 18 | (first & 0x3f) << 12 | low;
            match (second >> 14 & 1, second >> 12 & 1) {
                (1, 1) => Call(target(signed(far, 25))),
                (0, 1) => Branch { to: target(signed(far, 25)), conditional: false },
                // Conditions 14 and 15 encode other instructions, none of which branches.
                (0, 0) if (first >> 6) & 0xf < 14 => {
                    Branch { to: target(signed(near, 21)), conditional: true }
                }
                _ => Other,
            }
        }
        _ => Other,
    }
}

/// Sign-extends a number of the given number of bits.
fn signed(number: u32, bits: u32) -> i32 {
    (number << (32 - bits)) as i32 >> (32 - bits)
}

/// Returns the twelve bits of a plain constant.
fn immediate(first: u32, second: u32) -> u32 {
    (first >> 10 & 1) << 11 | (second >> 12 & 7) << 8 | second & 0xff
}

/// Returns the value of a modified constant of twelve bits (ThumbExpandImm, A5.3.2).
fn expanded(first: u32, second: u32) -> u32 {
    let bits = immediate(first, second);
    let low = bits & 0xff;
    match bits >> 8 {
        0b0000 => low,
        0b0001 => low << 16 | low,
        0b0010 => low << 24 | low << 8,
        0b0011 => low * 0x0101_0101,
        _ => (0x80 | bits & 0x7f).rotate_right(bits >> 7),
    }
}

#[cfg(test)]
mod tests;
