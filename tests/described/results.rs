//! Workspaces that are read by index, compared with the accessors that the names say.

use super::models::{Crawler, FourBar, Kinds, Raft, Rope, Train};
use mstmm::description::PointResult;
use mstmm::nalgebra::Vector3;
use mstmm::{ChainState, Described, GeneratedChain};

/// Moves all rates of the start, and drives all inputs.
pub fn solved<C: Described<Scalar = f64>>(chain: &C) -> (C::State, C::Workspace) {
    let mut state = chain.initial_state();
    for (index, rate) in state.rates_mut().iter_mut().enumerate() {
        *rate = 0.1 + 0.01 * index as f64;
    }
    let mut values = vec![0.0; C::DESCRIPTION.inputs().len()];
    for (index, (value, input)) in values.iter_mut().zip(C::DESCRIPTION.inputs().iter()).enumerate()
    {
        *value = 0.2 + 0.1 * index as f64;
        if input.unit == "1" {
            *value = input.start.expect("a start");
        }
    }
    let inputs = C::inputs_from_slice(&values).expect("as many values as inputs");
    let mut at = GeneratedChain::workspace(chain);
    chain.assemble(&mut state, &inputs).expect("an assembled chain");
    GeneratedChain::solve_into(chain, &state, &inputs, &mut at).expect("accelerations");
    (state, at)
}

/// All lists have as many entries as their names, and only they have.
fn lists_are_complete<C: Described<Scalar = f64>>(chain: &C) {
    let (it, (_, at)) = (C::DESCRIPTION, solved(chain));
    assert_eq!(C::accelerations(&at).len(), it.accelerations().len());
    assert_eq!(C::efforts(&at).len(), it.efforts().len());
    assert_eq!(it.accelerations().len(), it.rates().len());
    assert!(it.accelerations().iter().chain(it.efforts().iter()).all(|it| it.start.is_none()));
    assert!(C::energies(&at).is_some());
    let counts = [it.points().len(), it.springs().len()];
    assert!((0..counts[0]).all(|index| C::point(&at, index).is_some()));
    assert!((0..counts[1]).all(|index| C::spring(&at, index).is_some()));
    assert!(C::point(&at, counts[0]).is_none() && C::spring(&at, counts[1]).is_none());
}

#[test]
fn workspaces_have_what_is_described() {
    lists_are_complete(&Kinds::new());
    lists_are_complete(&Crawler::new());
    lists_are_complete(&Raft::new());
    lists_are_complete(&Train::new());
    lists_are_complete(&Rope::new());
    lists_are_complete(&FourBar::new());
}

macro_rules! read {
    ($of:ty, $at:ident: $($name:literal $list:ident = $value:expr;)*) => { $(
        let index = <$of>::DESCRIPTION.$list().index($name).expect($name);
        assert_eq!($value, <$of as Described>::$list(&$at)[index], $name);
    )* };
}

#[test]
fn accelerations_and_efforts_are_those_of_accessors() {
    let (_, at) = solved(&Kinds::new());
    read! { Kinds<f64>, at:
        "a.acceleration" accelerations = at.a().acceleration();
        "b.acceleration.linear" accelerations = at.b().acceleration()[0];
        "b.acceleration.angular" accelerations = at.b().acceleration()[1];
        "c.acceleration.y" accelerations = at.c().acceleration()[1];
        "e.acceleration.linear.y" accelerations = at.e().acceleration()[1];
        "e.acceleration.angular" accelerations = at.e().acceleration()[2];
        "g.acceleration.z" accelerations = at.g().acceleration()[2];
        "h.acceleration.angular.x" accelerations = at.h().acceleration()[3];
        "a.effort" efforts = at.a().effort();
        "b.effort.torque" efforts = at.b().effort()[1];
        "c.effort.x" efforts = at.c().effort()[0];
        "shaker.effort" efforts = at.shaker().effort();
        "g.effort.y" efforts = at.g().effort()[1];
        "h.effort.force.z" efforts = at.h().effort()[2];
        "h.effort.torque.z" efforts = at.h().effort()[5];
    }
    assert!(at.shaker().effort() != 0.0 && at.h().effort()[5] != 0.0);
    let (_, at) = solved(&Crawler::new());
    read! { Crawler<f64>, at:
        "trunk.acceleration.linear.y" accelerations = at.accelerations()[1];
        "b[2].acceleration" accelerations = at.b(2).expect("b").acceleration();
        "a[1].acceleration.z" accelerations = at.a(1).expect("a").acceleration()[2];
        "b[1].effort" efforts = at.b(1).expect("b").effort();
        "right.knee.effort" efforts = at.right_knee().effort();
    }
    let (_, at) = solved(&Train::new());
    read! { Train<f64>, at:
        "a.acceleration" accelerations = at.a().acceleration();
        "b.effort" efforts = at.b().effort();
    }
}

#[test]
fn gravity_is_what_was_written_or_driven() {
    assert_eq!(Crawler::<f64>::gravity(&solved(&Crawler::new()).1), [0.0, -9.8, 0.0]);
    assert_eq!(Rope::<f64>::gravity(&solved(&Rope::new()).1), [0.0; 3]);
    let it = Kinds::<f64>::DESCRIPTION;
    let first = it.input("gravity.x").expect("an input");
    let expected = [0, 1, 2].map(|k| 0.2 + 0.1 * (first + k) as f64);
    assert_eq!(Kinds::<f64>::gravity(&solved(&Kinds::new()).1), expected);
}

#[test]
fn springs_are_those_of_accessors() {
    let (_, at) = solved(&Crawler::new());
    let of = |name: &str| {
        Crawler::<f64>::spring(&at, Crawler::<f64>::DESCRIPTION.spring(name).expect(name))
            .expect(name)
    };
    assert_eq!(of("cord").length(), at.cord().length());
    assert_eq!(of("cord").force(), <[f64; 3]>::from(at.cord().force()));
    let tie = at.tie(2).expect("a spring");
    assert_eq!(of("tie[2]").tension(), tie.tension());
    assert_eq!(of("tie[2]").length_rate(), tie.length_rate());
    assert!(tie.tension() > 0.0);
}

#[test]
fn points_are_those_of_accessors() {
    let (state, at) = solved(&Crawler::new());
    let of = |name: &str| {
        Crawler::<f64>::point(&at, Crawler::<f64>::DESCRIPTION.point(name).expect(name))
            .expect("a point")
    };
    let point = at.link(1).expect("a link").input();
    let rows = of("link[1].input").orientation.expect("an orientation");
    let expected = PointResult {
        position: Some(point.position().into()),
        orientation: Some(rows),
        velocity: Some(point.velocity().into()),
        angular_velocity: Some(point.angular_velocity().into()),
        acceleration: Some(point.acceleration().into()),
        angular_acceleration: Some(point.angular_acceleration().into()),
        moment: Some(point.moment().into()),
        force: Some(point.force().into()),
    };
    assert_eq!(of("link[1].input"), expected);
    for (row, expected) in rows.iter().zip(point.orientation().matrix().row_iter()) {
        assert_eq!(Vector3::from(*row), expected.transpose());
    }
    let energy = Crawler::<f64>::energies(&at).expect("energies");
    assert_eq!((energy.kinetic, energy.potential), (at.kinetic_energy(), at.potential_energy()));
    let direct = Crawler::<f64>::new().energy(&state);
    assert!((energy.total() - direct.total()).abs() < 1e-12 * direct.total().abs().max(1.0));
}

/// Points of a plane are rotated about z; those of a line are not.
#[test]
fn points_of_planes_and_lines_are_in_space() {
    let (_, at) = solved(&Raft::new());
    let index = Raft::<f64>::DESCRIPTION.point("third.output").expect("a point");
    let (found, point) = (Raft::<f64>::point(&at, index).expect("a point"), at.third().output());
    let flat = |v: mstmm::nalgebra::Vector2<f64>| Some([v.x, v.y, 0.0]);
    let (cosine, sine) = point.cos_sin();
    assert_eq!(found.position, flat(point.position()));
    let rows = [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(found.orientation, Some(rows));
    assert_eq!(found.velocity, flat(point.velocity()));
    assert_eq!(found.angular_velocity, Some([0.0, 0.0, point.angular_velocity()]));
    assert_eq!(found.acceleration, flat(point.acceleration()));
    assert_eq!(found.moment, Some([0.0, 0.0, point.moment()]));
    assert_eq!(found.force, flat(point.force()));
    let (_, at) = solved(&Train::new());
    let index = Train::<f64>::DESCRIPTION.point("second.output").expect("a point");
    let (found, point) = (Train::<f64>::point(&at, index).expect("a point"), at.second().output());
    assert_eq!(found.position, Some([point.position(), 0.0, 0.0]));
    assert_eq!(found.force, Some([point.force(), 0.0, 0.0]));
    assert_eq!(found.moment, Some([0.0; 3]));
}

mstmm::mstmm_chain! {
    /// It computes poses only.
    chain Posing {
        results = poses;
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
        spring tie { on = rod.com; to = [0, 0, 1] m; stiffness = 1; }
    }
}

#[test]
fn omitted_results_are_none() {
    let (_, at) = solved(&Posing::new());
    let point = Posing::<f64>::point(&at, 1).expect("a point");
    assert!(point.position.is_some() && point.orientation.is_some());
    assert!(point.velocity.is_none() && point.acceleration.is_none() && point.force.is_none());
    assert!(Posing::<f64>::energies(&at).is_none() && Posing::<f64>::spring(&at, 0).is_none());
}
