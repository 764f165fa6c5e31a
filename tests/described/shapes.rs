//! The shapes of bodies.

use mstmm::description::{Geometry, Shape};
use mstmm::nalgebra::{Quaternion, Rotation3, UnitQuaternion, Vector3};
use mstmm::{Described, mstmm_chain};

mstmm_chain! {
    /// A trunk with legs that are mirrored, and a tail of repeated links.
    chain Animal {
        body Trunk {
            mass = 2 kg;
            com = [0, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
            point left = [0.2, 0.1, 0] m;
            point right = [0.2, -0.1, 0] m;
            point tail = [-0.3, 0, 0] m;
            shape = [
                box([0.6, 0.2, 0.1] m),
                mesh("meshes/head \"a\".stl") at [30 cm, 0 m, 5 cm - 1 mm]
                    turned rpy(10, -20, 130) deg,
            ];
        }
        part Leg(side, thickness) {
            body Thigh {
                mass = 0.5 kg;
                com = [0, 0, -0.1] m;
                inertia = diag(0.02, 0.02, 0.001) kg*m^2 about com;
                shape = capsule(radius = thickness, length = 0.2 m)
                    at [0, side*2 cm, -0.1 m] turned rpy(side*10, 0, 0) deg;
            }
            pin(x) hip -> Thigh thigh;
        }
        body Link {
            mass = 0.1 kg;
            com = [-0.05, 0, 0] m;
            output = [-0.1, 0, 0] m;
            inertia = diag(1e-6, 1e-4, 1e-4) kg*m^2 about com;
            shape = cylinder(radius = 1 cm, length = 10 cm) at [-5, 0, 0] cm turned quaternion(1, 0, 1, 0);
        }
        body Tip { mass = 0.1 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*cm^2 about com; }
        Trunk trunk;
        trunk.left -> Leg(1, 3 cm) left;
        trunk.right -> Leg(-1, 2 cm) right;
        trunk.tail -> repeat 1000 { pin(z) joint -> Link link } -> weld end -> Tip tip;
    }

    plane chain Swing {
        body Seat {
            mass = 1 kg;
            com = [0, -1] m;
            inertia = 0.1 kg*m^2 about com;
            shape = [sphere(radius = 0.1 m) at [0, -1] m turned 90 deg, sphere(radius = 1) at [0, 1, 2] m];
        }
        ground -> pin a -> Seat seat;
    }
}

fn shapes(name: &str) -> &'static [Shape] {
    let bodies = Animal::<f64>::DESCRIPTION.bodies();
    bodies.get(bodies.index(name).expect(name)).expect(name).shapes()
}

fn rotation(shape: &Shape) -> UnitQuaternion<f64> {
    let [w, x, y, z] = shape.orientation;
    let quaternion = Quaternion::new(w, x, y, z);
    // Four squares of rounded entries.
    assert!((quaternion.norm() - 1.0).abs() < 4.0 * f64::EPSILON, "{shape:?}");
    UnitQuaternion::new_unchecked(quaternion)
}

#[test]
fn shapes_are_what_was_written() {
    let [trunk, head] = shapes("trunk") else { panic!("two shapes") };
    assert_eq!(trunk.geometry, Geometry::Box([0.6, 0.2, 0.1]));
    assert_eq!((trunk.position, trunk.orientation), ([0.0; 3], [1.0, 0.0, 0.0, 0.0]));
    assert_eq!(head.geometry, Geometry::Mesh("meshes/head \"a\".stl"));
    // Two rounded terms.
    let expected = Vector3::new(0.3, 0.0, 0.049);
    assert!((Vector3::from(head.position) - expected).norm() < f64::EPSILON);
    // Rotations about fixed axes, x first.
    let [roll, pitch, yaw] = [10.0_f64, -20.0, 130.0].map(f64::to_radians);
    let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
    let expected = about(Vector3::z_axis(), yaw)
        * about(Vector3::y_axis(), pitch)
        * about(Vector3::x_axis(), roll);
    let difference = rotation(head).to_rotation_matrix().matrix() - expected.matrix();
    // Products of a few rounded sines and cosines.
    assert!(difference.amax() < 16.0 * f64::EPSILON, "{difference}");
}

/// The orientation rotates components of the frame of the shape into the body frame, in which the axis of the link is x.
#[test]
fn axes_of_cylinders_are_z_of_their_frame() {
    let [link] = shapes("link[7]") else { panic!("one shape") };
    assert_eq!(link.geometry, Geometry::Cylinder { radius: 0.01, length: 0.1 });
    let axis = rotation(link) * Vector3::z();
    assert!((axis - Vector3::x()).norm() < 4.0 * f64::EPSILON, "{axis}");
    assert_eq!(shapes("link[999]"), shapes("link[0]"));
    assert!(shapes("tip").is_empty());
}

#[test]
fn shapes_of_parts_have_their_arguments() {
    for (name, side, radius) in [("left.thigh", 1.0, 0.03), ("right.thigh", -1.0, 0.02)] {
        let [thigh] = shapes(name) else { panic!("one shape") };
        assert_eq!(thigh.geometry, Geometry::Capsule { radius, length: 0.2 });
        assert_eq!(thigh.position, [0.0, side * 0.02, -0.1]);
        let half = (side * 5.0_f64).to_radians();
        let expected = [half.cos(), half.sin(), 0.0, 0.0];
        let close = thigh.orientation.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(close, "{thigh:?}");
    }
}

#[test]
fn plane_chains_place_shapes_in_the_plane_or_in_space() {
    let seat = Swing::<f64>::DESCRIPTION.bodies().get(0).expect("the seat");
    let [first, second] = seat.shapes() else { panic!("two shapes") };
    assert_eq!(first.position, [0.0, -1.0, 0.0]);
    let turned = rotation(first) * Vector3::x();
    assert!((turned - Vector3::y()).norm() < 4.0 * f64::EPSILON, "{turned}");
    assert_eq!(second.position, [0.0, 1.0, 2.0]);
}
