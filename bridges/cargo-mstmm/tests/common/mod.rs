//! Helpers of the tests.
#![allow(dead_code, reason = "not all tests use all helpers")]

use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Returns the root of the checkout.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Starts the program as cargo does, and returns its exit code, its standard output and its standard error.
pub fn program(
    arguments: impl IntoIterator<Item = impl AsRef<OsStr>>,
    input: &str,
) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cargo-mstmm"));
    command.arg("mstmm").args(arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    // The program may end without having read its input.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    let output = child.wait_with_output().expect("the program ends");
    let [result, messages] =
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("UTF-8"));
    (output.status.code().expect("it ends by itself"), result, messages)
}

/// Random numbers by SplitMix64; the seed is printed, and `MSTMM_SEED` sets it.
pub struct Random(u64);

impl Random {
    /// Begins with a seed from `MSTMM_SEED` or with 0.
    pub fn new() -> Self {
        let seed = std::env::var("MSTMM_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
        println!("MSTMM_SEED={seed}");
        Random(seed)
    }

    /// Returns a number below a bound.
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (bits ^ (bits >> 31)) as usize % bound.max(1)
    }
}
