//! Static analysis of an image.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use object::{Object, ObjectSection, ObjectSegment, ObjectSymbol, SectionKind, SymbolKind};
use rustc_demangle::demangle;

use crate::thumb::{self, Function};

/// The function that is analysed: `image::step`.
const STEP: &str = "image::step";

/// The sizes of an image, and the stack and loops of its step.
#[derive(Clone, Debug, Default)]
pub struct Image {
    /// Bytes in the flash, and bytes of data in RAM.
    pub flash: u64,
    pub ram: u64,
    /// Bytes of code of the step with everything that it calls.
    pub code: u64,
    /// The largest stack depth of the step with everything that it calls, in bytes.
    pub stack: u32,
    /// The number of loops in each function of a step.
    pub loops: BTreeMap<String, usize>,
    /// All functions of the image.
    pub functions: BTreeSet<String>,
}

impl Image {
    /// Returns the functions of the image with one of these words in their names.
    pub fn named(&self, words: &[&str]) -> Vec<&str> {
        let has_any = |name: &&String| words.iter().any(|word| name.contains(word));
        self.functions.iter().filter(has_any).map(String::as_str).collect()
    }
}

/// Reads an image.
pub fn read(path: &Path) -> Result<Image> {
    let bytes = fs::read(path)?;
    let file = object::File::parse(&*bytes)?;
    let code = Code::of(&file)?;
    let step = code.step()?;
    let functions = code.reached(step)?;

    let data = |section: &object::Section| section.kind() == SectionKind::Data;
    let cleared = |section: &object::Section| section.kind() == SectionKind::UninitializedData;
    Ok(Image {
        flash: file.segments().map(|segment| segment.file_range().1).sum(),
        ram: file.sections().filter(|s| data(s) || cleared(s)).map(|s| s.size()).sum(),
        code: functions.keys().map(|address| u64::from(code.symbols[address].size)).sum(),
        stack: deepest(step, &functions, &mut Vec::new())?,
        loops: (functions.iter().filter(|(_, function)| function.loops > 0))
            .map(|(address, function)| (code.symbols[address].name.clone(), function.loops))
            .collect(),
        functions: code.names,
    })
}

/// A function of an image.
struct Symbol {
    name: String,
    size: u32,
}

/// The code of an image.
struct Code<'data> {
    symbols: BTreeMap<u32, Symbol>,
    /// Several if functions with the same instructions were merged.
    names: BTreeSet<String>,
    /// The starts of code and of data: the mapping symbols of the ELF for the Arm architecture.
    kinds: BTreeMap<u32, bool>,
    start: u32,
    bytes: &'data [u8],
}

impl<'data> Code<'data> {
    fn of(file: &object::File<'data>) -> Result<Self> {
        let text = file.section_by_name(".text").context("the image has no code")?;
        let (mut symbols, mut names) = (BTreeMap::<u32, Symbol>::new(), BTreeSet::new());
        let mut kinds = BTreeMap::new();
        for symbol in file.symbols() {
            let (name, address) = (symbol.name()?, symbol.address() as u32);
            if name.starts_with("$t") || name.starts_with("$d") {
                kinds.insert(address, name.starts_with("$t"));
            } else if symbol.kind() == SymbolKind::Text {
                // The last bit of an address marks Thumb code.
                let (name, size) = (format!("{:#}", demangle(name)), symbol.size() as u32);
                names.insert(name.clone());
                let known = symbols.entry(address & !1).or_insert(Symbol { name, size });
                known.size = known.size.max(size);
            }
        }
        Ok(Self { symbols, names, kinds, start: text.address() as u32, bytes: text.data()? })
    }

    /// Returns the address of the step.
    fn step(&self) -> Result<u32> {
        let steps = self.symbols.iter().filter(|(_, symbol)| symbol.name.starts_with(STEP));
        let [(&step, _)] = steps.collect::<Vec<_>>()[..] else {
            bail!("{STEP} is not one function")
        };
        Ok(step)
    }

    /// Returns the function at an address and all functions that it calls, directly or indirectly.
    fn reached(&self, from: u32) -> Result<BTreeMap<u32, Function>> {
        let (mut reached, mut waiting) = (BTreeMap::new(), vec![from]);
        while let Some(address) = waiting.pop() {
            if reached.contains_key(&address) {
                continue;
            }
            let symbol = self.symbols.get(&address);
            let symbol = symbol.with_context(|| format!("no function begins at {address:#x}"))?;
            ensure!(symbol.size > 0, "the end of {} is unknown", symbol.name);
            let function = thumb::function(&self.parts(address, symbol.size)?);
            if let Some(address) = function.unknown.first() {
                bail!("the effect of {} at {address:#x} is unknown", symbol.name);
            }
            waiting.extend(&function.calls);
            reached.insert(address, function);
        }
        Ok(reached)
    }

    /// Returns the parts of a function that are code.
    fn parts(&self, address: u32, size: u32) -> Result<Vec<(u32, &'data [u8])>> {
        let end = address + size;
        let last_before = self.kinds.range(..=address).next_back();
        let mut starts = vec![(address, last_before.is_none_or(|(_, &is_code)| is_code))];
        let inside = self.kinds.range(address + 1..end);
        starts.extend(inside.map(|(&address, &is_code)| (address, is_code)));
        let ends = starts.iter().skip(1).map(|&(address, _)| address).chain([end]);
        let pieces = starts.iter().zip(ends).filter(|((_, is_code), _)| *is_code);
        pieces
            .map(|(&(start, _), end)| {
                let range = (start - self.start) as usize..(end - self.start) as usize;
                Ok((start, self.bytes.get(range).context("a function lies outside the code")?))
            })
            .collect()
    }
}

/// Returns the largest stack depth of a function: its frame and that of the deepest function it calls.
fn deepest(at: u32, functions: &BTreeMap<u32, Function>, way: &mut Vec<u32>) -> Result<u32> {
    ensure!(!way.contains(&at), "the function at {at:#x} calls itself");
    way.push(at);
    let function = &functions[&at];
    let mut below = 0;
    for &call in &function.calls {
        below = below.max(deepest(call, functions, way)?);
    }
    way.pop();
    Ok(function.frame + below)
}
