//! The properties of a random chain.

use crate::chain::Dimension;
use crate::random::Random;

/// The ends of a random chain: the start first, then the finish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The start is held and the finish free.
    HeldFree,
    /// Both ends are free: the chain floats.
    FreeFree,
    /// The start is free and the finish held.
    FreeHeld,
    /// Both ends are held: the chain is closed.
    HeldHeld,
    /// The motion of the start is prescribed and the finish is free.
    MovingFree,
    /// The start is free and the motion of the finish is prescribed.
    FreeMoving,
    /// The start is held and the motion of the finish is prescribed: the chain is closed.
    HeldMoving,
    /// The motion of the start is prescribed and the finish is held: the chain is closed.
    MovingHeld,
    /// The motions of both ends are prescribed: the chain is closed.
    MovingMoving,
}

/// The kinds of hinges a random chain may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HingeChoice {
    /// Bodies welded together.
    Weld,
    /// Pins about axes of all directions.
    Pin,
    /// Balls.
    Ball,
    /// Sliders along axes of all directions.
    Slider,
    /// Screws about axes of all directions.
    Screw,
    /// Cylindrical hinges about axes of all directions.
    Cylindrical,
    /// Universal hinges, whose axes need not be perpendicular.
    Universal,
    /// Gimbals, whose axes need not be perpendicular.
    Gimbal,
    /// Planar hinges.
    Planar,
    /// Floating hinges, without constraints.
    Floating,
    /// Elastic hinges.
    Elastic,
}

/// The properties of a random chain. The probabilities are for each hinge or body.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// The space in which the chain moves.
    pub dimension: Dimension,
    /// Whether a chain in space lies in the plane of x and y. If the chain is closed, its loop
    /// constraints are then redundant. It must have neither elastic hinges nor moving ends, which
    /// would leave the plane.
    pub flat: bool,
    /// The number of bodies.
    pub bodies: usize,
    /// How the ends are attached.
    pub ends: Ends,
    /// The kinds of hinges to choose from. Kinds that the dimension does not have are ignored.
    pub kinds: Vec<HingeChoice>,
    /// The probability of a motor.
    pub motors: f64,
    /// The probability that a motor's effort is constant instead of an input.
    pub constant_motors: f64,
    /// The probability of springs, dampers, friction, limits and rotors.
    pub passive: f64,
    /// The probability of a prescribed motion.
    pub prescribed: f64,
    /// The probability of a load.
    pub loads: f64,
    /// The probability of a spring to the ground.
    pub springs: f64,
    /// The probability that gravity is an input.
    pub gravity_inputs: f64,
}

impl Ends {
    /// All of them.
    pub const ALL: [Ends; 9] = [
        Ends::HeldFree,
        Ends::FreeFree,
        Ends::FreeHeld,
        Ends::HeldHeld,
        Ends::MovingFree,
        Ends::FreeMoving,
        Ends::HeldMoving,
        Ends::MovingHeld,
        Ends::MovingMoving,
    ];

    /// The ends of chains that are not closed.
    pub const OPEN: [Ends; 5] =
        [Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld, Ends::MovingFree, Ends::FreeMoving];

    /// The ends of closed chains.
    pub const CLOSED: [Ends; 4] =
        [Ends::HeldHeld, Ends::HeldMoving, Ends::MovingHeld, Ends::MovingMoving];

    /// Returns whether a chain with these ends is closed.
    pub fn closed(self) -> bool {
        Ends::CLOSED.contains(&self)
    }

    pub(crate) fn free_start(self) -> bool {
        matches!(self, Ends::FreeFree | Ends::FreeHeld | Ends::FreeMoving)
    }

    pub(crate) fn free_finish(self) -> bool {
        matches!(self, Ends::HeldFree | Ends::FreeFree | Ends::MovingFree)
    }
}

impl HingeChoice {
    /// All of them.
    pub const ALL: [HingeChoice; 11] = [
        HingeChoice::Weld,
        HingeChoice::Pin,
        HingeChoice::Ball,
        HingeChoice::Slider,
        HingeChoice::Screw,
        HingeChoice::Cylindrical,
        HingeChoice::Universal,
        HingeChoice::Gimbal,
        HingeChoice::Planar,
        HingeChoice::Floating,
        HingeChoice::Elastic,
    ];

    /// Returns whether a dimension has hinges of this kind.
    pub fn exists_in(self, dimension: Dimension) -> bool {
        use HingeChoice::{Elastic, Floating, Pin, Planar, Slider, Weld};
        match dimension {
            Dimension::Space => true,
            Dimension::Plane => matches!(self, Weld | Pin | Slider | Planar | Floating | Elastic),
            Dimension::Line => matches!(self, Weld | Slider | Floating | Elastic),
        }
    }
}

impl Recipe {
    /// A chain in space with input motors in half of its hinges and constant gravity.
    pub fn plain(bodies: usize, ends: Ends, kinds: &[HingeChoice]) -> Recipe {
        Recipe {
            dimension: Dimension::Space,
            flat: false,
            bodies,
            ends,
            kinds: kinds.to_vec(),
            motors: 0.5,
            constant_motors: 0.0,
            passive: 0.0,
            prescribed: 0.0,
            loads: 0.0,
            springs: 0.0,
            gravity_inputs: 0.0,
        }
    }

    /// A chain in which everything may occur.
    pub fn rich(dimension: Dimension, bodies: usize, ends: Ends, kinds: &[HingeChoice]) -> Recipe {
        Recipe {
            dimension,
            constant_motors: 0.3,
            passive: 0.5,
            prescribed: 0.15,
            loads: 0.3,
            springs: 0.2,
            gravity_inputs: 0.2,
            ..Recipe::plain(bodies, ends, kinds)
        }
    }

    /// Any chain of up to `bodies` bodies, in which everything may occur.
    pub fn any(random: &mut Random, bodies: usize) -> Recipe {
        let dimensions = [
            Dimension::Space,
            Dimension::Space,
            Dimension::Space,
            Dimension::Plane,
            Dimension::Line,
        ];
        let dimension = *random.choose(&dimensions);
        let bodies = 1 + random.below(bodies);
        let ends = *random.choose(&Ends::ALL);
        Recipe::rich(dimension, bodies, ends, &HingeChoice::ALL)
    }
}
