//! Bennett's linkage whose lengths, or whose scale, are parameters.

use super::bennett::bennett;
use super::linkage::Linkage;
use super::states::compared;

macro_rules! bennett_with {
    ($riccati:ident $transfer:ident { $($parameters:tt)* } $first:tt $second:tt $closing:tt) => {
        linkage! { @chains $riccati $transfer d {
            gravity = [1.0, -2.0, -9.5] m/s^2;
            $($parameters)*
            body Crank {
                mass = 1.015625 kg;
                com = [0.25, -0.25, -0.0625] m;
                inertia = tensor(
                    0.083984375, 0.107421875, 0.125, 0.009765625, 0.01171875, 0.005859375
                ) kg*m^2 about com;
                output = $first turned quaternion(2, 1, 0, 0);
            }
            body Coupler {
                mass = 2.3125 kg;
                com = [-0.109375, -0.21875, 0.171875] m;
                inertia = tensor(
                    0.078125, 0.1328125, 0.12890625, 0.005859375, 0.0078125, -0.017578125
                ) kg*m^2 about com;
                output = $second turned quaternion(3, 1, 0, 0);
            }
            body Rocker {
                mass = 2.140625 kg;
                com = [0.125, -0.046875, -0.09375] m;
                inertia = tensor(
                    0.11328125, 0.13671875, 0.083984375, 0.001953125, -0.017578125, -0.017578125
                ) kg*m^2 about com;
                output = $first turned quaternion(2, 1, 0, 0);
            }
            ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
                -> pin d -> ground at $closing turned quaternion(3, -1, 0, 0);
            hinge a { start = 0.5; }
            hinge b { start = -3.0395445366338680; }
            hinge c { start = -0.5; }
            hinge d { start = 3.0395445366338680; }
        } }
    };
}

bennett_with! {
    Sized SizedByTransfer { param first = 0.703125 m; param second = 0.52734375 m; }
    [first, 0, 0] [second, 0, 0] [-second, 0, 0]
}
bennett_with! {
    Scaled ScaledByTransfer { param scale = 1; }
    [0.703125 * scale, 0, 0] [0.52734375 * scale, 0, 0] [-0.52734375 * scale, 0, 0]
}

/// The same linkage with other lengths: its angles are the same.
fn scaled(factor: f64) -> Linkage {
    let mut linkage = bennett();
    for link in &mut linkage.links {
        link.output.position = link.output.position.map(|x| x * factor);
    }
    linkage.to.position = linkage.to.position.map(|x| x * factor);
    linkage
}

/// Powers of two, so that the proportion stays exact.
const FACTORS: [f64; 5] = [1.0 / 64.0, 0.125, 1.0, 2.0, 8.0];

#[test]
fn lengths_are_parameters() {
    for factor in FACTORS {
        let (mut first, mut second) = (Sized::<f64>::new(), SizedByTransfer::<f64>::new());
        first.set_first(0.703125 * factor).expect("a length");
        first.set_second(0.52734375 * factor).expect("a length");
        second.set_first(0.703125 * factor).expect("a length");
        second.set_second(0.52734375 * factor).expect("a length");
        compared(&first, &scaled(factor));
        compared(&second, &scaled(factor));
    }
}

#[test]
fn the_scale_is_a_parameter() {
    for factor in FACTORS {
        let (mut first, mut second) = (Scaled::<f64>::new(), ScaledByTransfer::<f64>::new());
        first.set_scale(factor).expect("a scale");
        second.set_scale(factor).expect("a scale");
        compared(&first, &scaled(factor));
        compared(&second, &scaled(factor));
    }
}
