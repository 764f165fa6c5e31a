//! The connection points of a chain.

use super::EvalContext;
use crate::model::{Attachment, Element, HingeId};

/// The location of a connection point.
pub struct ConnectionPoint {
    pub attachment: Attachment,
    /// The hinge at the point, if there is one, and whether the point is on its outboard side.
    pub hinge: Option<(HingeId, bool)>,
}

/// Returns all connection points in route order; those of a repeated part once.
pub fn connection_points<S>(context: &EvalContext<S>) -> Vec<ConnectionPoint> {
    let chain = context.chain;
    let mut points: Vec<ConnectionPoint> = Vec::new();
    let add =
        |points: &mut Vec<ConnectionPoint>, number: usize, point: ConnectionPoint| match points
            .get_mut(number)
        {
            // The entry of a body's end is replaced by that of the hinge there.
            Some(known) if known.hinge.is_none() => *known = point,
            Some(_) => {}
            None => points.push(point),
        };
    // At the boundary of a repeated part, the wrench is that of the weld at the boundary.
    let side = |hinge: HingeId, attachment: &Attachment, outboard: bool| {
        let weld = chain.repeat_boundary(attachment).map(|seam| chain.weld_of(seam));
        weld.map_or(
            ConnectionPoint { attachment: attachment.clone(), hinge: Some((hinge, outboard)) },
            |weld| ConnectionPoint {
                attachment: chain.hinges[weld].inboard.clone(),
                hinge: Some((weld, false)),
            },
        )
    };
    for (number, element) in chain.elements.iter().enumerate() {
        let (input, output) = match *element {
            Element::Hinge(index) => {
                let hinge = &chain.hinges[index];
                (side(index, &hinge.inboard, false), side(index, &hinge.outboard, true))
            }
            Element::Body(index) => {
                let output = Attachment::Output(index);
                let last = chain.hinges.position(|hinge| {
                    hinge.inboard == output && chain.repeat_boundary(&hinge.outboard).is_some()
                });
                (
                    ConnectionPoint { attachment: Attachment::Input(index), hinge: None },
                    ConnectionPoint { attachment: output, hinge: last.map(|weld| (weld, false)) },
                )
            }
        };
        add(&mut points, number, input);
        add(&mut points, number + 1, output);
    }
    points
}
