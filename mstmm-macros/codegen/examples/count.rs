//! Prints the operation counts of the chains in a file: `cargo run --example count -- FILE`.
use mstmm_codegen::{compile, model};
fn main() {
    let path = std::env::args().nth(1).expect("a file with chains");
    let text = std::fs::read_to_string(path).expect("a readable file");
    let chains = model::read(text.parse().expect("tokens")).expect("chains");
    for (chain, _) in &chains {
        let layout = model::Layout::of(chain);
        for method in [None, Some(model::Method::Riccati), Some(model::Method::Transfer)] {
            let mut chain = chain.clone();
            chain.method = method;
            let start = std::time::Instant::now();
            let programs = compile::programs(&chain, &layout);
            println!(
                "{} {:?} {:?}: {} ({}), solve {} ({:?})",
                chain.name,
                programs.method,
                programs.axes,
                programs.accelerations.cost().arithmetic(),
                programs.accelerations.cost(),
                programs.solution.cost().arithmetic(),
                start.elapsed()
            );
            if method == Some(model::Method::Riccati) {
                for s in &programs.accelerations.sections {
                    println!("   {:50} {}", s.title, s.cost());
                }
            }
        }
    }
}
