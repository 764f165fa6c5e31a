//! Shapes of bodies, for pictures only.

/// A shape of a body. It has no influence on the dynamics.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The geometry, in the frame of the shape.
    pub geometry: Geometry,
    /// The origin of the frame of the shape in m, body frame.
    pub position: [f64; 3],
    /// The unit quaternion w, x, y, z that rotates components in the frame of the shape into the body frame.
    pub orientation: [f64; 4],
    /// Roll, pitch and yaw in rad as written, if the orientation is written so.
    pub angles: Option<[f64; 3]>,
}

/// The geometry of a shape, centred at the origin of its frame; lengths are in m.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A box, with the lengths of its edges.
    Box([f64; 3]),
    /// A cylinder about z: radius and length.
    Cylinder([f64; 2]),
    /// A cylinder about z with half a sphere at each end: radius, and length of the cylinder.
    Capsule([f64; 2]),
    /// A sphere, with its radius.
    Sphere(f64),
    /// The file of a mesh.
    Mesh(String),
}
