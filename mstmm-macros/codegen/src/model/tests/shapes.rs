//! Shapes of bodies in the model.

use super::{chain, edited};
use crate::model::{Geometry, Shape};

/// The shapes of the rod of the example, which has these shapes.
fn shapes(of_rod: &str) -> Vec<Shape> {
    let source = edited(&[("mass = 2 kg;", &format!("mass = 2 kg; shape = {of_rod};"))]);
    let (mut chain, _) = chain(&source);
    let rod = chain.bodies.enumerate().find(|(_, body)| body.path == "rod").map(|(id, _)| id);
    std::mem::take(&mut chain.bodies[rod.expect("the rod")].shapes)
}

fn only(of_rod: &str) -> Shape {
    let shapes = shapes(of_rod);
    assert_eq!(shapes.len(), 1);
    shapes.into_iter().next().expect("a shape")
}

#[test]
fn geometries_are_in_metres() {
    let geometry = |text: &str| only(text).geometry;
    assert_eq!(geometry("box([1, 2, 3] mm)"), Geometry::Box([1e-3, 2e-3, 3e-3]));
    assert_eq!(geometry("box([10 cm, 2 m, 3 m])"), Geometry::Box([0.1, 2.0, 3.0]));
    // The order of names has no meaning.
    let cylinder = Geometry::Cylinder([0.05, 0.3]);
    assert_eq!(geometry("cylinder(radius = 5 cm, length = 0.3 m)"), cylinder);
    assert_eq!(geometry("cylinder(length = 0.3 m, radius = 5 cm)"), cylinder);
    let capsule = Geometry::Capsule([0.5, 2.0]);
    assert_eq!(geometry("capsule(radius = 1/2, length = (1 + 1) m)"), capsule);
    assert_eq!(geometry("sphere(radius = PI)"), Geometry::Sphere(std::f64::consts::PI));
    assert_eq!(geometry("mesh(\"a/b.stl\")"), Geometry::Mesh("a/b.stl".into()));
    assert_eq!(geometry("mesh(r#\"a\"b\"#)"), Geometry::Mesh("a\"b".into()));
}

#[test]
fn places_are_in_the_body_frame() {
    let here = only("sphere(radius = 1)");
    assert_eq!((here.position, here.orientation), ([0.0; 3], [1.0, 0.0, 0.0, 0.0]));
    let there = only("sphere(radius = 1) at [1, 2, -3] cm turned rpy(180, 0, 0) deg");
    assert_eq!(there.position, [0.01, 0.02, -0.03]);
    assert_eq!(there.orientation, [0.0, 1.0, 0.0, 0.0]);
    // Any length is a rotation; shapes have unit quaternions.
    let longer = only("sphere(radius = 1) turned quaternion(0, 0, 3, 4)");
    assert_eq!(longer.orientation, [0.0, 0.0, 0.6, 0.8]);
}

#[test]
fn a_body_has_several_shapes_in_their_order() {
    let of_rod = shapes("[sphere(radius = 1), sphere(radius = 2) at [0, 1, 0] m,]");
    let radii: Vec<_> = of_rod.iter().map(|shape| shape.geometry.clone()).collect();
    assert_eq!(radii, [Geometry::Sphere(1.0), Geometry::Sphere(2.0)]);
    assert_eq!(of_rod[1].position, [0.0, 1.0, 0.0]);
}

#[test]
fn planes_and_lines_place_shapes_in_their_dimension_or_in_space() {
    let first = |source: &str| {
        let (chain, _) = chain(source);
        let (_, body) = chain.bodies.enumerate().next().expect("a body");
        body.shapes[0].clone()
    };
    let plane = |shape: &str| {
        first(&format!(
            "plane chain A {{ body Rod {{ mass = 1; com = [1, 0]; inertia = 1 about com; shape = \
             {shape}; }} ground -> pin a -> Rod rod; }}"
        ))
    };
    let turned = plane("box([1, 1, 1] m) at [1, 2] m turned 180 deg");
    assert_eq!((turned.position, turned.orientation), ([1.0, 2.0, 0.0], [0.0, 0.0, 0.0, 1.0]));
    let turned = plane("box([1, 1, 1] m) at [1, 2, 3] m turned rpy(0, 180, 0) deg");
    assert_eq!((turned.position, turned.orientation), ([1.0, 2.0, 3.0], [0.0, 0.0, 1.0, 0.0]));
    let line = |shape: &str| {
        first(&format!(
            "line chain A {{ body Car {{ mass = 1; shape = {shape}; }} ground -> slider a -> Car \
             car; }}"
        ))
    };
    assert_eq!(line("sphere(radius = 1) at 2 m").position, [2.0, 0.0, 0.0]);
    let turned = line("sphere(radius = 1) at [1, 2, 3] m turned rpy(0, 180, 0) deg");
    assert_eq!((turned.position, turned.orientation), ([1.0, 2.0, 3.0], [0.0, 0.0, 1.0, 0.0]));
}
