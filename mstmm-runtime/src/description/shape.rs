//! Shapes of bodies, for pictures only.

/// A shape of a body, for pictures only: it has no influence on the dynamics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// The geometry, in the frame of the shape.
    pub geometry: Geometry,
    /// The origin of the frame of the shape in m, body frame.
    pub position: [f64; 3],
    /// The unit quaternion w, x, y, z that rotates components in the frame of the shape into the body frame.
    pub orientation: [f64; 4],
}

/// The geometry of a shape.
///
/// Boxes, cylinders, capsules and spheres are centred at the origin of the frame of the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry {
    /// A box with these lengths of its edges along x, y and z, in m.
    Box([f64; 3]),
    /// A cylinder about z.
    Cylinder {
        /// The radius in m.
        radius: f64,
        /// The length along z in m.
        length: f64,
    },
    /// A cylinder about z with half a sphere at each end.
    Capsule {
        /// The radius in m.
        radius: f64,
        /// The length of the cylinder along z in m, without the half spheres.
        length: f64,
    },
    /// A sphere.
    Sphere {
        /// The radius in m.
        radius: f64,
    },
    /// The path or the address of a file with a mesh, as the description has it. Its lengths are in m.
    Mesh(&'static str),
}
