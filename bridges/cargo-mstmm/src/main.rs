//! `cargo mstmm`: see the readme.

use cargo_mstmm::commands::import;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Cargo calls the program with its name as the first argument.
#[derive(Parser)]
#[command(name = "cargo", bin_name = "cargo")]
enum Cargo {
    Mstmm(Arguments),
}

/// Tools for the chains of the crate `mstmm`.
#[derive(clap::Args)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Import(import::Import),
}

fn main() -> ExitCode {
    let Cargo::Mstmm(arguments) = Cargo::parse();
    let result = match &arguments.command {
        Command::Import(arguments) => import::run(arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    }
}
