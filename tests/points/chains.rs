//! Chains with centres of mass and named points, and what is read of them.

use mstmm::{BodyPoint, GeneratedChain, LinePoint, PlanePoint, Point, Scalar, mstmm_chain};

pub const GRAVITY: [f64; 3] = [1.0, -9.8, 2.0];
/// Masses in kg.
pub const LINK: f64 = 1.5;
pub const TOOL: f64 = 2.0;

/// The motion of a point.
pub struct Motion<T> {
    pub position: Vec<T>,
    pub velocity: Vec<T>,
    pub acceleration: Vec<T>,
}

impl<T> Motion<T> {
    pub fn of(point: &impl Moves<T>) -> Self {
        let [position, velocity, acceleration] = point.motion();
        Motion { position, velocity, acceleration }
    }

    pub fn parts(&self) -> [&[T]; 3] {
        [&self.position, &self.velocity, &self.acceleration]
    }
}

/// A point of any dimension.
pub trait Moves<T> {
    /// Position, velocity and acceleration.
    fn motion(&self) -> [Vec<T>; 3];
}

impl<T: Scalar> Moves<T> for BodyPoint<Point<T>> {
    fn motion(&self) -> [Vec<T>; 3] {
        let all = [self.position(), self.velocity(), self.acceleration()];
        all.map(|vector| vector.as_slice().into())
    }
}

impl<T: Scalar> Moves<T> for BodyPoint<PlanePoint<T>> {
    fn motion(&self) -> [Vec<T>; 3] {
        let all = [self.position(), self.velocity(), self.acceleration()];
        all.map(|vector| vector.as_slice().into())
    }
}

impl<T: Scalar> Moves<T> for BodyPoint<LinePoint<T>> {
    fn motion(&self) -> [Vec<T>; 3] {
        [self.position(), self.velocity(), self.acceleration()].map(|number| vec![number])
    }
}

/// A chain whose points are read.
pub trait Read: GeneratedChain {
    /// The chain with its parameters away from their defaults.
    fn prepared() -> Self;
    /// The motion of all its centres of mass and named points.
    fn read(at: &Self::Workspace) -> Vec<Motion<Self::Scalar>>;
}

/// A chain by both methods, and what is read of it.
macro_rules! both {
    (
        $kind:ident $name:ident $transfer:ident { $($items:tt)* }
        |$chain:ident| $set:block
        |$at:ident| [$($point:expr),* $(,)?]
    ) => {
        mstmm_chain! { pub $kind chain $name { method = riccati; $($items)* } }
        mstmm_chain! { pub $kind chain $transfer { method = transfer; $($items)* } }
        both!(@read $name |$chain| $set |$at| [$($point),*]);
        both!(@read $transfer |$chain| $set |$at| [$($point),*]);
    };
    (@read $name:ident |$chain:ident| $set:block |$at:ident| [$($point:expr),*]) => {
        impl<T: Scalar> Read for $name<T> {
            #[allow(unused_mut)]
            fn prepared() -> Self {
                let mut $chain = Self::new();
                $set
                $chain
            }

            fn read($at: &Self::Workspace) -> Vec<Motion<T>> {
                vec![$(Motion::of(&$point)),*]
            }
        }
    };
}

const REFUSED: &str = "a value that is refused";
const ABSENT: &str = "no body of this number";

both! {
    space Arm ArmByTransfer {
        gravity = [1, -9.8, 2] m/s^2;
        param reach = 1 m;
        param tilt = 10 deg;
        body Link {
            mass = 1.5 kg;
            com = [reach / 2, 0.1 m, -0.05 m];
            output = [reach, 0, 0.2 m] turned rpy(tilt, -30 deg, 50 deg);
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point end = [reach, 0, 0.2 m];
            point mark = [0.1, -0.2, 0.3] m;
        }
        body Tool {
            mass = 2 kg;
            com = [0.3, 0, 0.1] m;
            inertia = tensor(0.2, 0.3, 0.4, 0.01, 0.02, -0.03) kg*m^2 about com;
            point tip = [0.5, 0.2, 0.1] m;
        }
        ground at [0, 1, 0] m turned rpy(10, 20, 30) deg
            -> ball shoulder -> Link upper -> weld glue -> Link glued
            -> universal(y, z) elbow -> Tool tool;
    }
    |chain| {
        chain.set_reach(T::constant(0.75)).expect(REFUSED);
        chain.set_tilt(T::constant(0.5)).expect(REFUSED);
    }
    |at| [
        at.upper().com(), at.upper().end(), at.upper().mark(), at.glued().com(),
        at.glued().end(), at.glued().mark(), at.tool().com(), at.tool().tip(),
    ]
}

both! {
    space Repeated RepeatedByTransfer {
        gravity = [1, -9.8, 2] m/s^2;
        param reach[3] = 1 m;
        param width = 0.1 m;
        body Link {
            mass = 1.5 kg;
            com = [0.4, 0.1, 0] m;
            output = [1, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point edge = [0.2 m, width, -width];
        }
        body Hand {
            mass = 1 kg;
            com = [reach / 4, 0, 0.1 m];
            output = [reach, 0, 0];
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point thumb = [reach, 0.3 m, 0];
            point palm = [0.1, 0.2, 0.3] m;
        }
        ground -> pin(y) base -> Link first
            -> repeat 3 { ball joint -> Link link -> pin(x) wrist -> Hand hand }
            -> slider(z) last -> Link end;
    }
    |chain| {
        chain.set_reach(|index| T::constant(0.5 + 0.25 * index as f64)).expect(REFUSED);
        chain.set_width(T::constant(0.3)).expect(REFUSED);
    }
    |at| [
        at.first().com(), at.first().edge(),
        at.link(0).expect(ABSENT).com(), at.link(1).expect(ABSENT).edge(),
        at.link(2).expect(ABSENT).com(), at.link(2).expect(ABSENT).edge(),
        at.hand(0).expect(ABSENT).com(), at.hand(0).expect(ABSENT).thumb(),
        at.hand(1).expect(ABSENT).palm(), at.hand(2).expect(ABSENT).com(),
        at.hand(2).expect(ABSENT).thumb(), at.hand(2).expect(ABSENT).palm(),
        at.end().com(), at.end().edge(),
    ]
}

both! {
    space Written WrittenByTransfer {
        gravity = [1, -9.8, 2] m/s^2;
        param width = 0.1 m;
        body Link {
            mass = 1.5 kg;
            com = [0.4, 0.1, 0] m;
            output = [1, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point edge = [0.2 m, width, -width];
        }
        body HandA {
            mass = 1 kg;
            com = [0.125, 0, 0.1] m;
            output = [0.5, 0, 0] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point thumb = [0.5, 0.3, 0] m;
        }
        body HandB {
            mass = 1 kg;
            com = [0.1875, 0, 0.1] m;
            output = [0.75, 0, 0] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point palm = [0.1, 0.2, 0.3] m;
        }
        body HandC {
            mass = 1 kg;
            com = [0.25, 0, 0.1] m;
            output = [1, 0, 0] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
            point thumb = [1, 0.3, 0] m;
            point palm = [0.1, 0.2, 0.3] m;
        }
        ground -> pin(y) base -> Link first
            -> ball joint_a -> Link link_a -> pin(x) wrist_a -> HandA hand_a
            -> ball joint_b -> Link link_b -> pin(x) wrist_b -> HandB hand_b
            -> ball joint_c -> Link link_c -> pin(x) wrist_c -> HandC hand_c
            -> slider(z) last -> Link end;
    }
    |chain| { chain.set_width(T::constant(0.3)).expect(REFUSED); }
    |at| [
        at.first().com(), at.first().edge(), at.link_a().com(), at.link_b().edge(),
        at.link_c().com(), at.link_c().edge(), at.hand_a().com(), at.hand_a().thumb(),
        at.hand_b().palm(), at.hand_c().com(), at.hand_c().thumb(), at.hand_c().palm(),
        at.end().com(), at.end().edge(),
    ]
}

both! {
    space Thrown ThrownByTransfer {
        gravity = [1, -9.8, 2] m/s^2;
        param reach = 0.4 m;
        body Link {
            mass = 1.5 kg;
            com = [reach, 0.1 m, 0];
            output = [1, 0, 0.2] m;
            inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
        }
        body Last { mass = 1.5 kg; com = [0.1, 0.2, 0.3] m; inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com; }
        Link first -> ball a -> Link second -> pin([1, 2, 3]) b -> Last third;
    }
    |chain| { chain.set_reach(T::constant(0.6)).expect(REFUSED); }
    |at| [at.first().com(), at.second().com(), at.third().com()]
}

both! {
    plane Rope RopeByTransfer {
        gravity = [0, -9.8] m/s^2;
        param knot[4] = 0.1 m;
        body Rod {
            mass = 1 kg;
            com = [0.5 m, knot];
            output = [1, 0] m turned 20 deg;
            inertia = 1/12 kg*m^2 about com;
            point knob = [0.5 m, -knot];
        }
        body Weight { mass = 2 kg; com = [0, -0.1] m; inertia = 0.1 kg*m^2 about com; }
        ground -> repeat 4 { pin joint -> Rod rod } -> slider hook -> Weight weight;
    }
    |chain| { chain.set_knot(|index| T::constant(0.1 * index as f64)).expect(REFUSED); }
    |at| [
        at.rod(0).expect(ABSENT).com(), at.rod(1).expect(ABSENT).com(),
        at.rod(3).expect(ABSENT).com(), at.rod(3).expect(ABSENT).knob(), at.weight().com(),
    ]
}

both! {
    plane Rods RodsByTransfer {
        gravity = [0, -9.8] m/s^2;
        param a = 0.1 m;
        param b = 0.1 m;
        param c = 0.1 m;
        param d = 0.1 m;
        body A { mass = 1 kg; com = [0.5 m, a]; output = [1, 0] m turned 20 deg; inertia = 1/12 kg*m^2 about com; }
        body B { mass = 1 kg; com = [0.5 m, b]; output = [1, 0] m turned 20 deg; inertia = 1/12 kg*m^2 about com; }
        body C { mass = 1 kg; com = [0.5 m, c]; output = [1, 0] m turned 20 deg; inertia = 1/12 kg*m^2 about com; }
        body D {
            mass = 1 kg; com = [0.5 m, d]; output = [1, 0] m turned 20 deg; inertia = 1/12 kg*m^2 about com;
            point knob = [0.5 m, -d];
        }
        body Weight { mass = 2 kg; com = [0, -0.1] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin first -> A rod_a -> pin second -> B rod_b -> pin third -> C rod_c
            -> pin fourth -> D rod_d -> slider hook -> Weight weight;
    }
    |chain| {
        chain.set_a(T::constant(0.0)).expect(REFUSED);
        chain.set_b(T::constant(0.1)).expect(REFUSED);
        chain.set_c(T::constant(0.2)).expect(REFUSED);
        chain.set_d(T::constant(0.1 * 3.0)).expect(REFUSED);
    }
    |at| [
        at.rod_a().com(), at.rod_b().com(), at.rod_d().com(), at.rod_d().knob(),
        at.weight().com(),
    ]
}

both! {
    line Train TrainByTransfer {
        gravity = -9.8 m/s^2;
        param reach = 0.2 m;
        body Car { mass = 1 kg; com = reach; output = 0.5 m; point mark = 2 * reach; }
        ground -> slider first -> Car engine -> repeat 3 { elastic link -> Car car };
        hinge link { stiffness = 10 N/m; }
    }
    |chain| { chain.set_reach(T::constant(0.3)).expect(REFUSED); }
    |at| [
        at.engine().com(), at.engine().mark(), at.car(0).expect(ABSENT).com(),
        at.car(2).expect(ABSENT).mark(),
    ]
}

both! {
    line Cars CarsByTransfer {
        gravity = -9.8 m/s^2;
        param reach = 0.2 m;
        body Car { mass = 1 kg; com = reach; output = 0.5 m; point mark = 2 * reach; }
        ground -> slider first -> Car engine
            -> elastic link_a -> Car car_a -> elastic link_b -> Car car_b -> elastic link_c -> Car car_c;
        hinge link_a, link_b, link_c { stiffness = 10 N/m; }
    }
    |chain| { chain.set_reach(T::constant(0.3)).expect(REFUSED); }
    |at| [at.engine().com(), at.engine().mark(), at.car_a().com(), at.car_c().mark()]
}

both! {
    plane Loop LoopByTransfer {
        gravity = [0, -9.8] m/s^2;
        param side = 0.1 m;
        body Crank { mass = 1 kg; com = [0.2 m, side]; output = [0.4, 0] m; inertia = 0.02 kg*m^2 about com; }
        body Rod {
            mass = 2 kg; com = [0.5 m, side]; output = [1, 0] m; inertia = 0.2 kg*m^2 about com;
            point side = [0.5 m, 2 * side];
        }
        ground -> pin a -> Crank crank -> pin b -> Rod rod -> pin c -> Crank rocker
            -> pin d -> ground at [0.9, 0.1] m;
        hinge a { start = 60 deg; }
        hinge b { start = -60 deg; }
        hinge c { start = -120 deg; }
    }
    |chain| { chain.set_side(T::constant(0.15)).expect(REFUSED); }
    |at| [at.crank().com(), at.rod().com(), at.rod().side(), at.rocker().com()]
}

both! {
    plane Plain PlainByTransfer {
        param reach = 1 m;
        body Rod {
            mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com;
            point end = [0, reach];
        }
        ground -> pin joint -> Rod rod;
    }
    |chain| {}
    |at| [at.rod().end()]
}

both! {
    plane Many ManyByTransfer {
        param reach = 1 m;
        body Rod {
            mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com;
            point end = [0, reach];
        }
        ground -> repeat 3 { pin joint -> Rod rod };
    }
    |chain| {}
    |at| [at.rod(1).expect(ABSENT).end()]
}

macro_rules! fewer {
    ($($name:ident { $($results:tt)* })*) => { $(
        mstmm_chain! { pub chain $name {
            $($results)*
            gravity = [0, -9.8, 0] m/s^2;
            param reach = 1 m;
            body Rod {
                mass = 1 kg;
                com = [reach / 2, 0, 0.1 m];
                inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                point end = [reach, 0.5 m, 0];
            }
            ground -> ball joint -> Rod rod;
        } }
    )* };
}

fewer! {
    Everything {}
    Poses { results = poses; }
    Watched { results = [poses, velocities]; }
}

mstmm_chain! {
    pub chain Carried {
        gravity = [0, -9.8, 0] m/s^2;
        param reach = 1 m;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [reach, 0.1 m, 0.2 m];
            inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
            point end = [reach, 0.1 m, 0.2 m];
        }
        moving deck -> ball joint -> Rod rod;
    }
}
