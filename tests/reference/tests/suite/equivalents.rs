//! Two descriptions of one mechanism give the same motion.

use crate::samples::{Case, assert_close, case, central_inertia_of, rich_cases};
use mstmm_reference::{
    About, Chain, Dimension, Element, End, Ends, Frame, FrameMotion, Hinge, HingeChoice, HingeKind,
    HingeMotion, Random, Recipe, Solution, Source,
};

/// Returns the ranges of a hinge's entries in the state: the coordinates, then the rates.
fn entries(chain: &Chain, name: &str) -> [std::ops::Range<usize>; 2] {
    let (mut q, mut v) = (chain.base_coordinates(), chain.base_dof_count());
    for hinge in chain.hinges() {
        let own = [q..q + hinge.coordinates(), v..v + hinge.dof_count()];
        if hinge.name == name {
            return own;
        }
        [q, v] = own.map(|range| range.end);
    }
    panic!("there is no hinge {name}")
}

/// Returns the case with one more hinge prescribed, with its free motion.
fn prescribe(case: &Case, free: &Solution, name: &str) -> Case {
    let [q, v] = entries(&case.chain, name);
    let mut prescribed =
        Case { chain: case.chain.clone(), state: case.state.clone(), drives: case.drives.clone() };
    let motion = HingeMotion {
        q: prescribed.state.q.drain(q).collect(),
        v: prescribed.state.v.drain(v.clone()).collect(),
        a: free.accelerations[v.clone()].to_vec(),
    };
    prescribed.drives.efforts.drain(v);
    let hinges = || case.chain.hinges();
    let place = hinges().take_while(|hinge| hinge.name != name).filter(|h| h.prescribed).count();
    prescribed.drives.motions.insert(place, motion);
    for element in &mut prescribed.chain.elements {
        match element {
            Element::Hinge(hinge) if hinge.name == name => {
                hinge.prescribed = true;
                hinge.linear.motor = Source::None;
                hinge.turning.motor = Source::None;
            }
            _ => {}
        }
    }
    prescribed
}

/// A hinge with its free motion prescribed needs the effort of its motor, and nothing else changes.
#[test]
fn prescribed_motions_need_the_efforts_of_free_ones() {
    for case in rich_cases() {
        let free = case.solve();
        let candidates = case.chain.hinges().enumerate().filter(|(_, hinge)| hinge.dof_count() > 0);
        for (number, hinge) in candidates {
            let driven = prescribe(&case, &free, &hinge.name).solve();
            let own = entries(&case.chain, &hinge.name)[1].clone();
            let mut others = free.accelerations.clone();
            others.drain(own);
            let size = free.accelerations.iter().fold(1.0_f64, |most, a| most.max(a.abs()));
            let name = format!("{} {}", case.chain.name, hinge.name);
            for (found, expected) in driven.accelerations.iter().zip(&others) {
                assert_close(*found, *expected, 1e-10 * size, &name);
            }
            let efforts = driven.efforts[number].iter().zip(&free.efforts[number]);
            for (found, expected) in efforts.filter(|_| driven.reactions_unique) {
                assert_close(*found, *expected, 1e-9 * size, &name);
            }
            assert_close(driven.kinetic_energy, free.kinetic_energy, 1e-12, &name);
            assert_close(driven.potential_energy, free.potential_energy, 1e-12, &name);
        }
    }
}

/// A moving frame is a floating hinge from the inertial frame whose motion is prescribed.
#[test]
fn moving_frames_are_prescribed_floating_hinges() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let recipe = Recipe::rich(Dimension::Space, 3, Ends::MovingFree, &HingeChoice::ALL);
        let mut moving = case(&mut random, &format!("Moving{seed}"), &recipe);
        let Element::Hinge(first) = &moving.chain.elements[0] else { unreachable!() };
        let name = first.name.clone();
        if !first.prescribed {
            let [q, v] = entries(&moving.chain, &name);
            moving.state.q.drain(q);
            moving.state.v.drain(v.clone());
            moving.drives.efforts.drain(v);
        } else {
            moving.drives.motions.remove(0);
        }
        let first = |chain: &mut Chain, kind: HingeKind, prescribed: bool| {
            let first = Hinge { prescribed, ..Hinge::new(&name, kind) };
            chain.elements[0] = Element::Hinge(first);
        };
        first(&mut moving.chain, HingeKind::Weld, false);

        let mut held = Case {
            chain: Chain { start: End::Held(Frame::IDENTITY), ..moving.chain.clone() },
            state: moving.state.clone(),
            drives: moving.drives.clone(),
        };
        first(&mut held.chain, HingeKind::Floating, true);
        let FrameMotion { position, orientation, velocity, rate, acceleration, rate_derivative } =
            moving.drives.start;
        let motion = HingeMotion {
            q: position.into_iter().chain(orientation).collect(),
            v: [velocity, rate].concat(),
            a: [acceleration, rate_derivative].concat(),
        };
        held.drives.motions.insert(0, motion);
        let (found, expected) = (held.solve(), moving.solve());
        for (a, b) in found.accelerations.iter().zip(&expected.accelerations) {
            assert_close(*a, *b, 1e-10, &moving.chain.name);
        }
        for (a, b) in found.points.iter().zip(&expected.points).skip(1) {
            for k in 0..3 {
                assert_close(a.acceleration[k], b.acceleration[k], 1e-10, &moving.chain.name);
                assert_close(a.force[k], b.force[k], 1e-10, &moving.chain.name);
                assert_close(a.moment[k], b.moment[k], 1e-10, &moving.chain.name);
            }
        }
    }
}

/// A plane or line chain moves like the same chain in space.
#[test]
fn lower_dimensions_move_as_in_space() {
    let elastic_in_plane =
        |case: &Case| case.chain.hinges().any(|hinge| hinge.kind == HingeKind::PlaneElastic);
    // In space a floating chain has other coordinates.
    let comparable = |case: &Case| {
        case.chain.dimension != Dimension::Space && !elastic_in_plane(case) && !case.chain.floats()
    };
    let mut compared = 0;
    for case in rich_cases().into_iter().filter(comparable) {
        let mut chain = case.chain.in_space();
        for element in &mut chain.elements {
            // No rotation uses these moments, but every body needs an inertia.
            if let Element::Body(body) = element {
                body.about = About::Com;
                let of_flat = central_inertia_of(&case, &body.name);
                body.inertia = [1.0, 1.0, of_flat, 0.0, 0.0, 0.0];
            }
        }
        let expected =
            Case { chain, state: case.state.clone(), drives: case.drives.clone() }.solve();
        let found = case.solve();
        compared += 1;
        let size = expected.accelerations.iter().fold(1.0_f64, |most, a| most.max(a.abs()));
        for (a, b) in found.accelerations.iter().zip(&expected.accelerations) {
            assert_close(*a, *b, 1e-10 * size, &case.chain.name);
        }
        assert_close(found.potential_energy, expected.potential_energy, 1e-13, &case.chain.name);
        assert_close(found.kinetic_energy, expected.kinetic_energy, 1e-13, &case.chain.name);
        let forces = found.points.iter().zip(&expected.points);
        for (a, b) in forces.filter(|_| expected.reactions_unique) {
            for k in 0..if case.chain.dimension == Dimension::Plane { 2 } else { 1 } {
                assert_close(a.force[k], b.force[k], 1e-9 * size, &case.chain.name);
            }
        }
    }
    assert!(compared > 30, "{compared}");
}
