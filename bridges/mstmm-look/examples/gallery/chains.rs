//! Chains that are looked at: a crane, a dog, a four-bar linkage, a train and a large tree.

use mstmm::prelude::*;

mstmm_chain! {
    /// A crane on two springy cylinders; its load swings.
    pub plane chain Crane {
        gravity = [0, -9.81] m/s^2;
        body Boom { mass = 400 kg; com = [2, 0] m; output = [4, 0] m; inertia = 550 kg*m^2 about com; }
        body Jib { mass = 200 kg; com = [1.5, 0] m; output = [3, 0] m; inertia = 150 kg*m^2 about com; }
        body Load { mass = 500 kg; com = [0, -2] m; inertia = 60 kg*m^2 about com; }
        ground -> pin foot -> Boom boom -> pin knuckle -> Jib jib -> pin hook -> Load load;
        hinge foot { start = 60 deg; rest = 62 deg; }
        hinge knuckle { start = -40 deg; rest = -40 deg; }
        hinge foot, knuckle { stiffness = 1 MN*m/rad; damping = 20 kN*m*s/rad; }
        hinge hook { start = -60 deg; }
    }

    /// A dog in a springy harness; its legs, neck and tail swing.
    pub chain Dog {
        gravity = [0, 0, -9.81] m/s^2;
        body Trunk {
            mass = 12 kg; com = [0, 0, 0] m; inertia = diag(0.1, 0.4, 0.42) kg*m^2 about com;
            point fl = [0.3, 0.12, -0.05] m; point fr = [0.3, -0.12, -0.05] m;
            point hl = [-0.3, 0.12, -0.05] m; point hr = [-0.3, -0.12, -0.05] m;
            point neck = [0.36, 0, 0.08] m; point tail = [-0.36, 0, 0.06] m;
        }
        body Head {
            mass = 1.5 kg; com = [0.12, 0, 0.1] m; output = [0.2, 0, 0.15] m;
            inertia = diag(0.005, 0.006, 0.006) kg*m^2 about com;
        }
        body Tail { mass = 0.2 kg; com = [-0.12, 0, 0] m; inertia = diag(0.0001, 0.001, 0.001) kg*m^2 about com; }
        part Leg(side) {
            body Thigh {
                mass = 0.9 kg; com = [0, side*0.01, -0.12] m; output = [0, side*0.02, -0.25] m;
                inertia = diag(0.006, 0.006, 0.001) kg*m^2 about com;
            }
            body Shank {
                mass = 0.35 kg; com = [0, 0, -0.11] m; output = [0, 0, -0.24] m;
                inertia = diag(0.002, 0.002, 0.0002) kg*m^2 about com;
            }
            universal(x, y) hip -> Thigh thigh -> pin(y) knee -> Shank shank;
            hinge hip { stiffness = 25 N*m/rad; damping = 0.8; start = [side * 4 deg, 35 deg]; rest = [0, 20 deg]; }
            hinge knee { torque = input; stiffness = 20; damping = 0.5; start = -70 deg; rest = -40 deg; }
        }
        Trunk trunk;
        trunk.fl -> Leg(1) fl; trunk.fr -> Leg(-1) fr; trunk.hl -> Leg(1) hl; trunk.hr -> Leg(-1) hr;
        trunk.neck -> pin(y) neck -> Head head;
        trunk.tail -> ball root -> Tail tail;
        hinge neck { stiffness = 20; damping = 0.6; start = 20 deg; }
        hinge root { stiffness = 0.5; damping = 0.02; start = rpy(0, 20, 30) deg; }
        spring harness { on = trunk; at = com; to = [0, 0, 1.6] m; stiffness = 400; damping = 20; length = 0.6 m; }
        body trunk { start = [0, 0, 0.7] m turned rpy(5, 8, 0) deg; start_rate = [0.6, 0.2, 0]; }
    }

    /// A four-bar linkage with a driven crank.
    pub plane chain FourBar {
        gravity = [0, -9.81] m/s^2;
        body Crank { mass = 1 kg; com = [0.2, 0] m; inertia = 0.02 kg*m^2 about com; output = [0.4, 0] m; }
        body Coupler { mass = 2 kg; com = [0.6, 0.15] m; inertia = 0.3 kg*m^2 about com; output = [1.2, 0] m; }
        body Rocker { mass = 1.5 kg; com = [0.4, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.8, 0] m; }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker -> pin d
            -> ground at [1.1, 0] m;
        hinge a { start = 1.2; start_rate = 6; torque = input; }
        hinge b { start = -1.0; }
        hinge c { start = -1.7; }
    }

    /// A train of three cars.
    pub line chain Train {
        body Car { mass = 20 t; output = 15 m; }
        Car first -> elastic a -> Car second -> elastic b -> Car last;
        hinge a, b { stiffness = 1e6 N/m; damping = 2e4; }
        body first { start_velocity = 2 m/s; }
        load engine { on = first; force = input; }
    }

    /// A tree of fifty bodies: a trunk and three arms of links.
    pub chain Tree {
        gravity = [0, 0, -9.81] m/s^2;
        body Trunk {
            mass = 8 kg; com = [0, 0, 0.3] m; inertia = diag(0.4, 0.4, 0.1) kg*m^2 about com;
            output = [0, 0, 0.6] m; point left = [0, 0.2, 0.4] m; point right = [0, -0.2, 0.4] m;
        }
        body Link { mass = 0.6 kg; com = [0.06, 0, 0.01] m; output = [0.12, 0, 0] m; inertia = diag(1e-3, 2e-3, 2e-3) kg*m^2 about com; }
        ground -> pin(z) root -> Trunk trunk -> repeat 17 { universal(y, z) a -> Link up };
        trunk.left -> repeat 16 { universal(y, z) b -> Link left };
        trunk.right -> repeat 16 { universal(z, y) c -> Link right };
        hinge root { start_rate = 2; damping = 0.1; }
        hinge a, b, c { stiffness = 4; damping = 0.02; }
        hinge b { start = [4 deg, 3 deg]; }
    }
}
