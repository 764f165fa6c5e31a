//! A chain made ready for computing: bodies about their centres of mass, and hinges that know
//! their two sides.

use crate::chain::{About, Body, Chain, Element, End, Frame, Hinge, HingeKind};
use crate::rotation::{self, Mat3, Vec3};

/// A chain as the solver sees it.
pub(crate) struct Mechanism {
    pub(crate) gravity: Vec3,
    pub(crate) bodies: Vec<Rigid>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) base: Base,
}

/// What the pose of the chain is reckoned from.
pub(crate) enum Base {
    /// The ground before the first hinge.
    Start,
    /// The ground after the last hinge.
    Finish,
    /// The first seven coordinates of the state.
    Floating,
}

/// A body, with everything counted from its centre of mass in body axes.
pub(crate) struct Rigid {
    pub(crate) mass: f64,
    pub(crate) inertia: Mat3,
    pub(crate) input: Vec3,
    pub(crate) output: Vec3,
    pub(crate) output_turn: Mat3,
}

/// The motion of a body's centre of mass and of its frame, in inertial axes.
#[derive(Clone)]
pub(crate) struct Motion {
    pub(crate) position: Vec3,
    pub(crate) rotation: Mat3,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Vec3,
}

/// A hinge, and where its entries are in coordinates and rates.
pub(crate) struct Joint {
    pub(crate) inboard: Side,
    pub(crate) outboard: Side,
    pub(crate) freedom: Freedom,
    pub(crate) first_coordinate: usize,
    pub(crate) first_rate: usize,
}

/// What a hinge leaves free.
pub(crate) enum Freedom {
    None,
    /// Turning about this unit vector.
    About(Vec3),
    AnyTurn,
}

/// A place on a body or on the ground.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Side {
    Ground { position: Vec3, rotation: Mat3 },
    Input(usize),
    Output(usize),
}

/// The motion of a [`Side`] in inertial axes.
#[derive(Clone)]
pub(crate) struct Place {
    /// The body the place is fixed to, unless it is the ground.
    pub(crate) body: Option<usize>,
    /// From the body's centre of mass to the place.
    pub(crate) arm: Vec3,
    pub(crate) position: Vec3,
    pub(crate) rotation: Mat3,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Vec3,
}

impl Mechanism {
    /// Reads a chain.
    ///
    /// # Panics
    ///
    /// Panics when hinges and bodies do not alternate as the ends of the chain demand.
    pub(crate) fn new(chain: &Chain) -> Mechanism {
        let base = match (&chain.start, &chain.finish) {
            (End::Held(_), End::Free) => Base::Start,
            (End::Free, End::Held(_)) => Base::Finish,
            (End::Free, End::Free) => Base::Floating,
            (End::Held(_), End::Held(_)) => panic!("chain {}: both ends are held", chain.name),
        };
        let (first_coordinate, first_rate) =
            if matches!(base, Base::Floating) { (7, 6) } else { (0, 0) };
        let gravity = Vec3::from(chain.gravity);
        let bodies = chain.bodies().map(Rigid::new).collect();
        let joints = joints_of(chain, first_coordinate, first_rate);
        Mechanism { gravity, bodies, joints, base }
    }

    /// Returns how a place moves when the bodies move as given.
    pub(crate) fn place(&self, side: &Side, motions: &[Motion]) -> Place {
        match *side {
            Side::Ground { position, rotation } => Place::at_rest(position, rotation),
            Side::Input(body) => {
                Place::on(body, &motions[body], &self.bodies[body].input, &Mat3::identity())
            }
            Side::Output(body) => {
                let rigid = &self.bodies[body];
                Place::on(body, &motions[body], &rigid.output, &rigid.output_turn)
            }
        }
    }

    /// Returns every connection point in written order.
    pub(crate) fn connection_points(&self) -> Vec<Side> {
        let on_bodies =
            (0..self.bodies.len()).flat_map(|body| [Side::Input(body), Side::Output(body)]);
        let mut points: Vec<Side> = on_bodies.collect();
        match self.base {
            Base::Start => points.insert(0, self.joints[0].inboard),
            Base::Finish => points.push(self.joints[self.joints.len() - 1].outboard),
            Base::Floating => {}
        }
        points
    }

    /// Returns the kinetic energy in J.
    pub(crate) fn kinetic_energy(&self, motions: &[Motion]) -> f64 {
        let of_body = |(rigid, motion): (&Rigid, &Motion)| {
            let spin = motion.rotation.transpose() * motion.spin;
            0.5 * rigid.mass * motion.velocity.norm_squared()
                + 0.5 * spin.dot(&(rigid.inertia * spin))
        };
        self.bodies.iter().zip(motions).map(of_body).sum()
    }

    /// Returns the potential energy in J, zero with every centre of mass at the inertial origin.
    pub(crate) fn potential_energy(&self, motions: &[Motion]) -> f64 {
        let of_body =
            |(rigid, motion): (&Rigid, &Motion)| -rigid.mass * self.gravity.dot(&motion.position);
        self.bodies.iter().zip(motions).map(of_body).sum()
    }
}

/// Pairs every hinge with the places it joins.
fn joints_of(chain: &Chain, mut coordinate: usize, mut rate: usize) -> Vec<Joint> {
    let mut joints = Vec::new();
    let mut join = |hinge: &Hinge, inboard: Side, outboard: Side| {
        joints.push(Joint {
            inboard,
            outboard,
            freedom: Freedom::new(&hinge.kind),
            first_coordinate: coordinate,
            first_rate: rate,
        });
        coordinate += hinge.kind.coordinates();
        rate += hinge.kind.freedoms();
    };
    let misplaced = |name: &str| -> ! {
        panic!("chain {}: {name} is not where hinges and bodies alternate", chain.name)
    };
    let mut reached = ground(&chain.start);
    let mut waiting: Option<&Hinge> = None;
    let mut bodies = 0;
    for element in &chain.elements {
        match (element, waiting.take(), reached) {
            (Element::Hinge(hinge), None, Some(_)) => waiting = Some(hinge),
            (Element::Body(_), Some(hinge), Some(inboard)) => {
                join(hinge, inboard, Side::Input(bodies));
                reached = Some(Side::Output(bodies));
                bodies += 1;
            }
            (Element::Body(_), None, None) => {
                reached = Some(Side::Output(bodies));
                bodies += 1;
            }
            (Element::Hinge(hinge), ..) => misplaced(&hinge.name),
            (Element::Body(body), ..) => misplaced(&body.name),
        }
    }
    match (waiting, ground(&chain.finish), reached) {
        (Some(hinge), Some(finish), Some(inboard)) => join(hinge, inboard, finish),
        (None, None, Some(_)) => {}
        _ => misplaced("the finish"),
    }
    joints
}

/// Returns the place an end is held at, if it is.
fn ground(end: &End) -> Option<Side> {
    match end {
        End::Free => None,
        End::Held(Frame { position, rpy_degrees }) => Some(Side::Ground {
            position: Vec3::from(*position),
            rotation: rotation::from_rpy_degrees(rpy_degrees),
        }),
    }
}

impl Rigid {
    fn new(body: &Body) -> Rigid {
        let [xx, yy, zz, xy, xz, yz] = body.inertia;
        let com = Vec3::from(body.com);
        let given = Mat3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let offset = rotation::cross_matrix(&com);
        let inertia = match body.about {
            About::Com => given,
            // Steiner: about the input point the inertia is greater by -m [c×]².
            About::Input => given + body.mass * offset * offset,
        };
        Rigid {
            mass: body.mass,
            inertia,
            input: -com,
            output: Vec3::from(body.output.position) - com,
            output_turn: rotation::from_rpy_degrees(&body.output.rpy_degrees),
        }
    }
}

impl Freedom {
    fn new(kind: &HingeKind) -> Freedom {
        match kind {
            HingeKind::Weld => Freedom::None,
            HingeKind::Pin { axis } => Freedom::About(Vec3::from(*axis).normalize()),
            HingeKind::Ball => Freedom::AnyTurn,
        }
    }

    /// Returns the directions, fixed in the inboard frame, about which the hinge cannot turn.
    pub(crate) fn locked_directions(&self) -> Vec<Vec3> {
        match self {
            Freedom::None => vec![Vec3::x(), Vec3::y(), Vec3::z()],
            Freedom::About(axis) => {
                // The axis of the frame least along the pin gives the best conditioned normals.
                let across = axis.cross(&Vec3::ith(axis.iamin(), 1.0)).normalize();
                vec![across, axis.cross(&across)]
            }
            Freedom::AnyTurn => Vec::new(),
        }
    }
}

impl Place {
    pub(crate) fn at_rest(position: Vec3, rotation: Mat3) -> Place {
        let rest = Vec3::zeros();
        Place { body: None, arm: rest, position, rotation, velocity: rest, spin: rest }
    }

    fn on(body: usize, motion: &Motion, arm: &Vec3, turn: &Mat3) -> Place {
        let arm = motion.rotation * arm;
        Place {
            body: Some(body),
            arm,
            position: motion.position + arm,
            rotation: motion.rotation * turn,
            velocity: motion.velocity + motion.spin.cross(&arm),
            spin: motion.spin,
        }
    }

    /// Returns the part of the place's acceleration that depends on the velocities alone.
    pub(crate) fn centripetal(&self) -> Vec3 {
        self.spin.cross(&self.spin.cross(&self.arm))
    }
}
