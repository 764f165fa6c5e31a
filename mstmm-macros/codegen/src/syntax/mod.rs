//! What was written, with spans: parse errors only, no meaning.
//!
//! ```text
//! chain  := attributes visibility [`space`] `chain` Name `{` item* `}`
//! item   := `gravity` `=` vector `;`  |  `method` `=` word `;`  |  `param` name `=` number `;`
//!         | `body` name,… `{` field* `}`  |  `hinge` name,… `{` field* `}`  |  route `;`
//! field  := name `=` value `;`
//! value  := number | vector [`turned` form] | form
//! route  := stop (`->` stop)*
//! stop   := `ground` [`at` vector] [`turned` form] | word [`(` value,… `)`] [name]
//! vector := `[` number,… `]` [unit]
//! form   := word `(` number,… `)` [unit] [`about` word]
//! number := product ((`+` | `-`) product)*
//! product := factor ((`*` | `/`) factor)* [unit]
//! factor := `-`* primary [`^` integer]
//! primary := literal | name | path | function `(` number,… `)` | `(` number `)`
//! unit   := symbol [`^` integer] ((`*` | `/`) symbol [`^` integer])*
//! ```

mod attribute;
mod chain;
mod cursor;
mod field;
mod number;
mod route;
mod surface;
mod tree;
mod unit;

pub use number::FUNCTIONS;
pub use surface::Surface;
pub use tree::*;

use proc_macro2::TokenStream;
use syn::buffer::TokenBuffer;

use crate::diag::Diagnostics;

/// Reads all chains of one macro call. What could be read comes back, mistakes or not.
pub fn parse(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Vec<ChainDef> {
    let buffer = TokenBuffer::new2(tokens);
    let mut input = cursor::Cursor::new(buffer.begin());
    let mut chains = Vec::new();
    if input.is_empty() {
        diagnostics.push(input.unexpected("`chain Name { … }`"));
    }
    while !input.is_empty() {
        chains.extend(chain::chain(&mut input, diagnostics));
    }
    chains
}
