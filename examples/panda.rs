// The Franka Emika Panda without its hand, joints 1 to 7, from its public URDF, with exact right angles.
// `include!` this file where `mstmm_chain!` is in scope.

/// Makes a chain of the arm with a motor in every joint. Optional arguments add parameters and `bodies`, the
/// rest of the `route` from the flange, and properties of `hinges`.
macro_rules! panda {
    (
        $(#[$doc:meta])*
        pub chain $name:ident {
            $(bodies { $($bodies:tt)* })?
            $(route { $($route:tt)* })?
            $(hinges { $($hinges:tt)* })?
        }
    ) => {
        mstmm_chain! {
            $(#[$doc])*
            pub chain $name {
                gravity = [0, 0, -9.81] m/s^2;
                $($($bodies)*)?
                body L1 {
                    mass = 4.970684; com = [0.003875, 0.002081, -0.04762];
                    output = [0.0, 0.0, 0.0] turned rpy(-90, 0, 0) deg;
                    inertia = tensor(0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169) about com;
                }
                body L2 {
                    mass = 0.646926; com = [-0.003141, -0.02872, 0.003495];
                    output = [0.0, -0.316, 0.0] turned rpy(90, 0, 0) deg;
                    inertia = tensor(0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704) about com;
                }
                body L3 {
                    mass = 3.228604; com = [0.027518, 0.039252, -0.066502];
                    output = [0.0825, 0.0, 0.0] turned rpy(90, 0, 0) deg;
                    inertia = tensor(0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805) about com;
                }
                body L4 {
                    mass = 3.587895; com = [-0.05317, 0.104419, 0.027454];
                    output = [-0.0825, 0.384, 0.0] turned rpy(-90, 0, 0) deg;
                    inertia = tensor(0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641) about com;
                }
                body L5 {
                    mass = 1.225946; com = [-0.011953, 0.041065, -0.038437];
                    output = [0.0, 0.0, 0.0] turned rpy(90, 0, 0) deg;
                    inertia = tensor(0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229) about com;
                }
                body L6 {
                    mass = 1.666555; com = [0.060149, -0.014117, -0.010517];
                    output = [0.088, 0.0, 0.0] turned rpy(90, 0, 0) deg;
                    inertia = tensor(0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341) about com;
                }
                body L7 {
                    mass = 0.735522; com = [0.010517, -0.004252, 0.061597];
                    output = [0.0, 0.0, 0.107];
                    inertia = tensor(0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741) about com;
                }
                ground at [0, 0, 0.333]
                    -> pin(z) j1 -> L1
                    -> pin(z) j2 -> L2
                    -> pin(z) j3 -> L3
                    -> pin(z) j4 -> L4
                    -> pin(z) j5 -> L5
                    -> pin(z) j6 -> L6
                    -> pin(z) j7 -> L7 $($($route)*)?;

                hinge j1, j2, j3, j4, j5, j6, j7 { torque = input; }
                $($($hinges)*)?
            }
        }
    };
}
