//! The frames of a body that its kinematics report by name: its output, its centre of mass and its named
//! points, in the body frame.

use super::{Body, BodyId, Chain, Dimension, Frame, NamedPoint, Role, Value};

/// A frame of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyFrame {
    /// The output.
    Output,
    /// The centre of mass, which has the axes of the body.
    Com,
    /// A named point, by its index in [`Body::points`].
    Point(usize),
}

/// The values of a frame that a dimension has.
pub struct FrameValues<'a> {
    /// Its origin.
    pub position: Vec<&'a Value>,
    /// Its rotation: the rows of the matrix in space, cosine and sine in the plane; empty for the centre of
    /// mass.
    pub rotation: Vec<&'a Value>,
}

impl FrameValues<'_> {
    /// Returns all values.
    pub fn all(&self) -> impl Iterator<Item = &Value> {
        self.position.iter().chain(&self.rotation).copied()
    }

    /// Returns whether a parameter changes any value.
    pub fn changes(&self) -> bool {
        self.all().any(Value::changes)
    }
}

impl Chain {
    /// Returns the bodies on the routes, without moving ends and boundaries of repeated parts.
    pub fn physical_bodies(&self) -> impl Iterator<Item = BodyId> {
        self.bodies.enumerate().filter(|(_, body)| body.role == Role::Physical).map(|(id, _)| id)
    }

    /// Returns the values of a frame.
    pub fn frame_values<'a>(&self, body: &'a Body, frame: BodyFrame) -> FrameValues<'a> {
        let of_frame = |frame: &'a Frame| FrameValues {
            position: self.positions(&frame.position),
            rotation: match self.dimension {
                Dimension::Space => frame.rotation.iter().flatten().collect(),
                Dimension::Plane => vec![&frame.rotation[0][0], &frame.rotation[1][0]],
                Dimension::Line => Vec::new(),
            },
        };
        match frame {
            BodyFrame::Output => of_frame(&body.output),
            BodyFrame::Point(index) => of_frame(&body.points[index].frame),
            BodyFrame::Com => {
                FrameValues { position: self.positions(&body.com), rotation: Vec::new() }
            }
        }
    }

    fn positions<'a>(&self, position: &'a [Value; 3]) -> Vec<&'a Value> {
        self.dimension.translations().iter().map(|&axis| &position[axis]).collect()
    }

    /// Returns all frames of the bodies on the routes that parameters change, in order.
    pub fn changing_frames(&self) -> Vec<(BodyId, BodyFrame, FrameValues<'_>)> {
        let of_body = |id: BodyId| {
            let body = &self.bodies[id];
            let frames =
                body.frames().map(move |frame| (id, frame, self.frame_values(body, frame)));
            frames.filter(|(_, _, values)| values.changes())
        };
        self.physical_bodies().flat_map(of_body).collect()
    }
}

impl Body {
    /// Returns the positions and rotations of the frames that its results have by name, in the body frame: first the centre of
    /// mass, whose axes are those of the body.
    pub fn own_frames(&self) -> impl Iterator<Item = (&[Value; 3], Option<&[[Value; 3]; 3]>)> {
        let points = self.points.iter().map(|NamedPoint { frame, .. }| frame);
        let points = points.map(|frame| (&frame.position, Some(&frame.rotation)));
        std::iter::once((&self.com, None)).chain(points)
    }

    /// Returns the frames of the body.
    pub fn frames(&self) -> impl Iterator<Item = BodyFrame> + use<> {
        let points = (0..self.points.len()).map(BodyFrame::Point);
        [BodyFrame::Output, BodyFrame::Com].into_iter().chain(points)
    }
}
