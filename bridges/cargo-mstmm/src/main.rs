//! `cargo mstmm`: see the readme.

use cargo_mstmm::commands::{check, export, header, import, new, python, show};
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
    New(new::New),
    Check(check::Check),
    Show(show::Show),
    Import(import::Import),
    Export(export::Export),
    Header(header::Header),
    Python(python::Python),
}

fn main() -> ExitCode {
    let mut words: Vec<_> = std::env::args_os().collect();
    if words.get(1).is_none_or(|word| word != "mstmm") {
        // Started without cargo.
        words.insert(words.len().min(1), "mstmm".into());
    }
    let Cargo::Mstmm(arguments) = Cargo::parse_from(words);
    let result = match &arguments.command {
        Command::New(arguments) => new::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::Show(arguments) => show::run(arguments),
        Command::Import(arguments) => import::run(arguments),
        Command::Export(arguments) => export::run(arguments),
        Command::Header(arguments) => header::run(arguments),
        Command::Python(arguments) => python::run(arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    }
}
