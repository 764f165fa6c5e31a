//! What a body's description does not have cannot be read: an output, a centre of mass on a line, points. Forces are read from
//! the points of a hinge.

use mstmm::prelude::*;

mstmm_chain! {
    chain Space {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }
    plane chain Plane {
        body Rod {
            mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com; output = [1, 0] m;
            point tip = [1, 0] m;
        }
        body Last {
            mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com;
            point tip = [1, 0] m;
        }
        ground -> repeat 3 { pin joint -> Rod rod } -> pin hook -> Last last;
    }
    plane chain Once {
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com; }
        ground -> repeat 1 { pin joint -> Rod rod };
    }
    line chain Line {
        body Car { mass = 1 kg; output = 1 m; }
        body Last { mass = 1 kg; com = 0.5 m; }
        ground -> slider first -> Car car -> slider second -> Last last;
    }
    line chain Fewer {
        results = velocities;
        body Car { mass = 1 kg; com = 0.5 m; }
        ground -> slider first -> Car car;
    }
    plane chain FewerInThePlane {
        results = [velocities, z];
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com; point tip = [1, 0] m; }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {
    let at = Space::<f64>::new().workspace();
    at.rod().output();
    at.rod().tip();
    at.joint().force();
    at.joint().torque();

    let at = Plane::<f64>::new().workspace();
    at.rod(1).map(|rod| rod.output());
    at.last().tip();
    at.last().output();
    at.last().tpi();

    let at = Once::<f64>::new().workspace();
    at.rod(0).map(|rod| rod.output());

    let at = Line::<f64>::new().workspace();
    at.car().output();
    at.car().com();
    at.last().com();
    at.last().output();

    let at = Fewer::<f64>::new().workspace();
    at.car().com().velocity();
    at.car().com().position();
    at.car().com().acceleration();

    let at = FewerInThePlane::<f64>::new().workspace();
    at.rod().tip().angular_velocity();
    at.rod().tip().velocity();
    at.rod().com().acceleration();
}
