//! The errors of both methods for large mass ratios, on random chains against twice the precision. The docs of chains that
//! use `transfer` quote the bound that is tested here.

mod common;

use common::double_double::DoubleDouble;
use common::{compute, read};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::math::Scalar;
use mstmm_codegen::model::SolutionMethod;
use mstmm_reference::Random;
use std::fmt::Write;

/// A chain of bodies of similar size, a state, and the ratio of its largest mass to its smallest mass or 1 kg, whichever is
/// less.
struct Sample {
    text: String,
    q: Vec<f64>,
    v: Vec<f64>,
    ratio: f64,
}

/// Returns a sample whose masses span this number of powers of ten below the largest one.
fn sample(
    random: &mut Random,
    bodies: usize,
    (powers, largest): (f64, f64),
    balls: bool,
) -> Sample {
    let mut text = String::from("chain Far { gravity = [0, -9.8, 0];\n");
    let mut route = String::from("ground");
    let masses: Vec<f64> =
        (0..bodies).map(|_| largest * 10_f64.powf(random.between(-powers, 0.0))).collect();
    for (k, &mass) in masses.iter().enumerate() {
        let mut moment = |least: f64, most: f64| mass * random.between(least, most);
        let (xx, yy, zz) = (moment(0.05, 0.1), moment(0.1, 0.14), moment(0.1, 0.14));
        let (length, roll, pitch) =
            (random.between(0.5, 1.5), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        writeln!(
            text,
            "body B{k} {{ mass = {mass:e}; com = [{:e}, 0.1, 0.05]; inertia = diag({xx:e}, {yy:e}, \
             {zz:e}) about com; output = [{length:e}, 0, 0] turned rpy({roll:e}, {pitch:e}, 0); }}",
            length / 2.0
        )
        .expect("text can be written");
        let kind = if balls { "ball" } else { "pin(z)" };
        write!(route, " -> {kind} h{k} -> B{k} b{k}").expect("text can be written");
    }
    let quaternion = |random: &mut Random| {
        let all = [(); 4].map(|()| random.between(-1.0, 1.0));
        let length = all.iter().map(|x| x * x).sum::<f64>().sqrt();
        all.map(|x| x / length).to_vec()
    };
    let coordinates = |_| if balls { quaternion(random) } else { vec![random.between(-1.0, 1.0)] };
    let q = (0..bodies).flat_map(coordinates).collect();
    let rates = if balls { 3 * bodies } else { bodies };
    let v = (0..rates).map(|_| random.between(-1.0, 1.0)).collect();
    let extreme = |pick: fn(f64, f64) -> f64, start| masses.iter().copied().fold(start, pick);
    let ratio = extreme(f64::max, 0.0) / extreme(f64::min, 1.0);
    Sample { text: text + &route + "; }", q, v, ratio }
}

fn accelerations<S: Scalar>(sample: &Sample, method: SolutionMethod) -> Vec<S> {
    let chain = read(&sample.text);
    let efforts = vec![0.0; sample.v.len()];
    compute(&chain, (method, Axes::Body), &sample.q, &sample.v, &efforts).accelerations
}

/// Returns a trunk of this mass that is free, with a leg of three pins whose bodies have about 1 kg.
fn leg_on_a_trunk(random: &mut Random, mass: f64) -> Sample {
    let text = format!(
        "chain Dog {{
            gravity = [0, 0, -9.8];
            body Trunk {{
                mass = {mass:e};
                com = [0.05, 0.02, 0.01];
                inertia = tensor({:e}, {:e}, {:e}, {:e}, {:e}, 0) about com;
                output = [0.37, 0.2, -0.1] turned rpy(0, 90, 0) deg;
            }}
            body Hip {{
                mass = 2;
                com = [0.04, 0, 0.1];
                inertia = diag(0.05, 0.05, 0.01) about com;
                output = [0.1, 0, 0] turned rpy(90, 0, 0) deg;
            }}
            body Rod {{
                mass = 1;
                com = [0.15, 0.02, 0];
                inertia = diag(0.004, 0.03, 0.03) about com;
                output = [0.35, 0, 0];
            }}
            Trunk trunk -> pin(z) haa -> Hip hip -> pin(z) hfe -> Rod thigh -> pin(z) kfe -> Rod shank;
        }}",
        0.03 * mass,
        0.14 * mass,
        0.15 * mass,
        0.001 * mass,
        -0.003 * mass,
    );
    let mut q = vec![0.0; 3];
    let quaternion = [(); 4].map(|()| random.between(-1.0, 1.0));
    let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.extend(quaternion.map(|x| x / length));
    q.extend((0..3).map(|_| random.between(-2.0, 2.0)));
    let v = (0..9).map(|_| random.between(-2.0, 2.0)).collect();
    Sample { text, q, v, ratio: (2.0 / mass).max(mass) }
}

/// Returns the largest difference, relative to the largest acceleration.
fn error(found: &[f64], truth: &[DoubleDouble]) -> f64 {
    let size = truth.iter().fold(0.0_f64, |size, x| size.max(x.high.abs()));
    found.iter().zip(truth).map(|(x, t)| (x - t.high).abs() / size).fold(0.0, f64::max)
}

#[test]
fn transfer_loses_no_more_than_its_docs_say() {
    let first = std::env::var("MSTMM_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
    println!("from seed {first}");
    let lighter = [0.0, 1.0, 2.0, 4.0, 6.0].map(|powers| (powers, 1.0));
    let heavier = [(0.0, 1e-6), (0.0, 1e3), (0.0, 1e8), (3.0, 1e5)];
    for masses @ (powers, largest) in lighter.into_iter().chain(heavier) {
        let mut worst = [0.0_f64; 2];
        for seed in first..first + 30 {
            let mut random = Random::new(seed);
            for (bodies, balls) in
                [(2, false), (2, true), (5, false), (5, true), (9, false), (9, true)]
            {
                let sample = sample(&mut random, bodies, masses, balls);
                let truth = accelerations::<DoubleDouble>(&sample, SolutionMethod::Riccati);
                let riccati = error(&accelerations(&sample, SolutionMethod::Riccati), &truth);
                let transfer = error(&accelerations(&sample, SolutionMethod::Transfer), &truth);
                let limit = 100.0 * (10.0 + sample.ratio) * f64::EPSILON;
                assert!(
                    transfer < limit,
                    "seed {seed}: {transfer:e} of {limit:e}\n{}",
                    sample.text
                );
                worst = [worst[0].max(riccati), worst[1].max(transfer)];
            }
        }
        let [riccati, transfer] = worst;
        println!(
            "masses over 10^{powers} up to {largest:e}: riccati {riccati:.1e}, transfer {transfer:.1e}"
        );
    }
}

/// What remains of the errors on light trunks comes from base parameters: the leg transfers inertia to
/// the trunk. At the trunk's input instead of the leg's hinge, the errors are ten times as large.
#[test]
fn legs_on_light_and_heavy_trunks_keep_their_accuracy() {
    for mass in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
        let limit = (50.0 + 0.4 / mass) * f64::EPSILON;
        for seed in 0..20 {
            let sample = leg_on_a_trunk(&mut Random::new(seed), mass);
            let truth = accelerations::<DoubleDouble>(&sample, SolutionMethod::Riccati);
            let error = error(&accelerations(&sample, SolutionMethod::Riccati), &truth);
            assert!(error < limit, "{mass} kg, seed {seed}: {error:e} of {limit:e}");
        }
    }
}
