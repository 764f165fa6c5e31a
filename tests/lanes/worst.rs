//! One decision for all lanes: that of the worst lane.

use mstmm::description::Origin;
use mstmm::wide::f64x8;
use mstmm::{ChainState, Dopri5, Error, Rk4, Scalar};

use super::chains::{Afloat, Arm, Balls, Loop, Parallelogram, Thin};
use super::numbers::{Lanes, numbers, of_lane, pack, same_bits};
use super::sample::{Case, Sample, each, wide};

type W = f64x8;
const LANES: usize = 8;

/// How far chains are integrated, in s, to which tolerance of a step, and what all steps together
/// leave at the end, past stops and friction at speeds that change sign.
const DURATION: f64 = 0.25;
const TOLERANCE: f64 = 1e-12;
const LEFT: f64 = 1e-8;

fn cases<C, S>(seed: u64) -> (Case<C>, Vec<Case<S>>)
where
    C: Sample<Scalar = W>,
    S: Sample<Scalar = f64>,
{
    let each = each(seed, LANES, 1e-3);
    (wide(seed, &each), each)
}

/// The end, the work done, and a state within the last step.
fn integrated<C: Sample<Scalar: Lanes>>(case: &Case<C>) -> Result<[Vec<f64>; 3], Error> {
    let Case { chain, state: start, inputs, .. } = case;
    let (mut state, mut within) = (start.clone(), start.clone());
    state.set_time(Scalar::constant(0.0));
    let tolerance = Scalar::constant(TOLERANCE);
    let mut dopri5 = Dopri5::new(tolerance, tolerance);
    let end = Scalar::constant(DURATION);
    dopri5.advance_to(chain, &mut state, end, |_, _| inputs.clone())?;
    dopri5.interpolate(chain, Scalar::constant(DURATION - 1e-5), &mut within)?;
    let statistics = dopri5.statistics();
    let work = [statistics.accepted, statistics.rejected, statistics.evaluations];
    Ok([numbers(&state), work.map(|count| count as f64).into(), numbers(&within)])
}

fn step_size_control<C, S>(name: &str)
where
    C: Sample<Scalar = W>,
    S: Sample<Scalar = f64>,
{
    let (mut wide, each) = cases::<C, S>(3);
    let [end, work, within] = integrated(&wide).expect("steps");
    let mut most = 0.0_f64;
    for (lane, case) in each.iter().enumerate() {
        let [end_alone, work_alone, within_alone] = integrated(case).expect("steps");
        most = most.max(work_alone[0]);
        for (found, alone) in [(&end, &end_alone), (&within, &within_alone)] {
            let found = of_lane(found, lane, LANES);
            let off = found.iter().zip(alone).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < LEFT && found.len() == alone.len(), "{name}, lane {lane}: {off:e}");
        }
    }
    // The lane that decides may be another one in every step.
    assert!(work[0] >= most, "{name}: {} steps, alone up to {most}", work[0]);

    // The same state with the same numbers in every lane is as good as alone.
    let alone = &each[0];
    wide.state = pack(&[(); LANES].map(|()| alone.state.clone()));
    let (chain, inputs) = (C::default(), wide.chain.no_inputs());
    let same = Case { chain, inputs, ..wide };
    let (chain, state) = (S::default(), alone.state.clone());
    let alone = Case { inputs: chain.no_inputs(), chain, state, step: alone.step };
    let [end, work, within] = integrated(&same).expect("steps");
    let [end_alone, work_alone, within_alone] = integrated(&alone).expect("steps");
    assert_eq!(work, work_alone, "{name}");
    for lane in 0..LANES {
        assert!(same_bits(&of_lane(&end, lane, LANES), &end_alone), "{name}, lane {lane}");
        assert!(same_bits(&of_lane(&within, lane, LANES), &within_alone), "{name}, lane {lane}");
    }
}

#[test]
fn the_worst_lane_chooses_the_step() {
    step_size_control::<Arm<W>, Arm<f64>>("Arm");
    step_size_control::<Balls<W>, Balls<f64>>("Balls");
    step_size_control::<Afloat<W>, Afloat<f64>>("Afloat");
    step_size_control::<Loop<W>, Loop<f64>>("Loop");
}

/// Lanes that are closed already are still corrected, by rounding errors.
#[test]
fn assembling_goes_on_until_all_lanes_are_closed() {
    fn check<C: Sample<Scalar = W>, S: Sample<Scalar = f64>>(name: &str) {
        let (wide, each) = cases::<C, S>(4);
        let mut starts: Vec<S::State> = each.iter().map(|case| case.state.clone()).collect();
        // The first lane is closed, the others less and less.
        for (lane, start) in starts.iter_mut().enumerate() {
            start.coordinates_mut().iter_mut().for_each(|q| *q += 0.02 * lane as f64);
        }
        let mut state: C::State = pack(&starts);
        wide.chain.assemble(&mut state, &wide.inputs).expect("a chain that can be closed");
        for (lane, (mut alone, case)) in starts.into_iter().zip(&each).enumerate() {
            case.chain.assemble(&mut alone, &case.inputs).expect("a chain that can be closed");
            let found = of_lane(&numbers(&state), lane, LANES);
            let off = found.iter().zip(numbers(&alone)).map(|(a, b)| (a - b).abs());
            let off = off.fold(0.0, f64::max);
            assert!(off < 1e-10, "{name}, lane {lane}: {off:e}");
        }
        // One lane that cannot be closed leaves all as they were.
        state.coordinates_mut()[0] = W::from_lanes(|lane| if lane == 5 { f64::NAN } else { 1.0 });
        let before = numbers(&state);
        let outcome = wide.chain.assemble(&mut state, &wide.inputs);
        assert_eq!(outcome, Err(Error::NotFinite(Origin::Coordinate(0))), "{name}");
        assert!(same_bits(&before, &numbers(&state)), "{name}");
    }
    check::<Loop<W>, Loop<f64>>("Loop");
    check::<Parallelogram<W>, Parallelogram<f64>>("Parallelogram");
}

/// Every function fails with the error, leaves states unchanged and returns no results.
fn fails<C: Sample<Scalar = W>>(case: &Case<C>, expected: Error, name: &str) {
    let Case { chain, state, inputs, step } = case;
    let mut rate = C::State::zero_position();
    assert_eq!(chain.derivative_into(state, inputs, &mut rate), Err(expected), "{name}");
    let mut at = chain.workspace();
    // Some of these chains have no answer anywhere.
    let before = chain.solve_into(&chain.initial_state(), &chain.no_inputs(), &mut at);
    assert_eq!(before.is_ok(), at != chain.workspace(), "{name}");
    assert_eq!(chain.solve_into(state, inputs, &mut at), Err(expected), "{name}");
    assert!(at == chain.workspace(), "{name}");
    let mut after = state.clone();
    let found = Rk4::new(*step).step(chain, &mut after, |_, _| inputs.clone());
    assert_eq!(found, Err(expected), "{name}");
    let found = Dopri5::new(1e-6, 1e-6).step(chain, &mut after, |_, _| inputs.clone());
    assert_eq!(found, Err(expected), "{name}");
    assert!(same_bits(&numbers(state), &numbers(&after)), "{name}");
}

#[test]
fn one_lane_that_is_not_finite_fails_for_all() {
    for lane in 0..LANES {
        let (case, _) = cases::<Balls<W>, Balls<f64>>(5);
        assert!(case.chain.accelerations(&case.state, &case.inputs).is_ok());
        let spoil = |number: &mut W, by: f64| {
            *number = W::from_lanes(|index| if index == lane { by } else { number.lane(index) });
        };
        for by in [f64::NAN, f64::INFINITY] {
            let (mut case, _) = cases::<Balls<W>, Balls<f64>>(5);
            spoil(&mut case.state.coordinates_mut()[5], by);
            fails(
                &case,
                Error::NotFinite(Origin::Coordinate(5)),
                &format!("coordinate, lane {lane}"),
            );
            let (mut case, _) = cases::<Balls<W>, Balls<f64>>(5);
            spoil(&mut case.state.rates_mut()[8], by);
            fails(&case, Error::NotFinite(Origin::Rate(8)), &format!("rate, lane {lane}"));
            let (mut case, _) = cases::<Balls<W>, Balls<f64>>(5);
            spoil(&mut case.inputs.a.y, by);
            fails(&case, Error::NotFinite(Origin::Input(1)), &format!("input, lane {lane}"));
        }
    }
}

#[test]
fn one_singular_lane_fails_for_all() {
    for thin in 0..LANES {
        let (mut case, _) = cases::<Thin<W>, Thin<f64>>(6);
        let thickness = W::from_lanes(|lane| if lane == thin { 1e-22 } else { 0.01 });
        case.chain.set_thickness(thickness).expect("a thin rod");
        fails(&case, Error::Singular { hinge: "loose" }, &format!("lane {thin}"));
    }
}

#[test]
fn a_value_refused_in_one_lane_changes_none() {
    for odd in 0..LANES {
        let mut arm = Arm::<W>::new();
        arm.set_payload(W::constant(2.0)).expect("a payload");
        for refused in [-1.5, f64::NAN] {
            let payload = W::from_lanes(|lane| if lane == odd { refused } else { 1.0 });
            let outcome = arm.set_payload(payload);
            let is_refused =
                matches!(outcome, Err(Error::InvalidParameter { name: "payload", .. }));
            assert!(is_refused, "lane {odd}, {refused}: {outcome:?}");
        }
        assert_eq!(arm.parameters().payload(), W::constant(2.0));
    }
}
