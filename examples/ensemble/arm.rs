//! The random properties of an arm, and its final position.

use mstmm::Error;
use mstmm_reference::Random;

use crate::chain::{Panda, PandaState, TARGET};
use crate::lanes::Lanes;

/// The payload, a box of uniform density, and the start of the joints relative to the target, at rest.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// Mass of the payload in kg.
    mass: f64,
    /// Centre of the box from the middle of the flange, in m.
    centre: [f64; 3],
    /// Edge lengths of the box in m.
    edges: [f64; 3],
    /// Start angles relative to the target in rad.
    start: [f64; 7],
}

impl Arm {
    /// Returns `count` random arms, which depend only on the seed.
    pub fn random(seed: u64, count: usize) -> Vec<Self> {
        let first = Random::new(seed).bits();
        let arm = |index| {
            let mut random = Random::new(first.wrapping_add(index));
            let mut between = |low, high| random.between(low, high);
            Self {
                mass: between(0.1, 3.0),
                centre: [between(-0.05, 0.05), between(-0.05, 0.05), between(0.0, 0.1)],
                edges: [(); 3].map(|()| between(0.05, 0.3)),
                start: [(); 7].map(|()| between(-0.3, 0.3)),
            }
        };
        (0..count as u64).map(arm).collect()
    }

    /// Returns a chain with one arm per lane, and its start. If there are fewer arms than lanes, the last
    /// arm fills the other lanes.
    pub fn chain<T: Lanes>(arms: &[Self]) -> Result<(Panda<T>, PandaState<T>), Error> {
        let lanes = |number: &dyn Fn(&Self) -> f64| {
            T::from_lanes(|lane| number(&arms[lane.min(arms.len() - 1)]))
        };
        let moment = |a: usize, b: usize| {
            lanes(&|arm| arm.mass / 12.0 * (arm.edges[a].powi(2) + arm.edges[b].powi(2)))
        };
        let mut chain = Panda::new();
        chain.set_payload(lanes(&|arm| arm.mass))?;
        chain.set_x(lanes(&|arm| arm.centre[0]))?;
        chain.set_y(lanes(&|arm| arm.centre[1]))?;
        chain.set_z(lanes(&|arm| arm.centre[2]))?;
        chain.set_xx(moment(1, 2))?;
        chain.set_yy(moment(2, 0))?;
        chain.set_zz(moment(0, 1))?;
        let mut state = chain.initial_state();
        let angle = |joint: usize| lanes(&|arm| TARGET[joint] + arm.start[joint]);
        state.q = std::array::from_fn(angle).into();
        Ok((chain, state))
    }
}

/// The final position of an arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Angles of the joints in rad.
    pub angles: [f64; 7],
    /// Position of the flange relative to its target, in m.
    pub offset: [f64; 3],
}

impl End {
    /// Returns the final position of the arm in each lane.
    pub fn of_lanes<T: Lanes>(
        chain: &Panda<T>,
        state: &PandaState<T>,
    ) -> Result<impl Iterator<Item = Self> + use<T>, Error> {
        let mut at = chain.workspace();
        let mut flange = |state: &PandaState<T>| {
            chain.solve_into(state, &chain.no_inputs(), &mut at)?;
            Ok(at.l7().output().position())
        };
        let target = PandaState { q: TARGET.map(T::constant).into(), ..PandaState::default() };
        let (angles, offset) = (state.q, flange(state)? - flange(&target)?);
        let of_lane = move |lane| Self {
            angles: angles.map(|angle| angle.lane(lane)).into(),
            offset: [offset.x, offset.y, offset.z].map(|way| way.lane(lane)),
        };
        Ok((0..T::LANES).map(of_lane))
    }

    /// Returns the distance of the flange from its target, in m.
    pub fn distance(&self) -> f64 {
        norm(self.offset)
    }

    /// Returns the distance between two flanges, in m.
    pub fn apart(&self, other: &Self) -> f64 {
        norm(std::array::from_fn(|axis| self.offset[axis] - other.offset[axis]))
    }
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
