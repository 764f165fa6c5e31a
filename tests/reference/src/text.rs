//! A chain written in the description language of the project.

use crate::chain::{About, Body, Chain, Element, End, Frame, Hinge, HingeKind};

impl Chain {
    /// Writes the chain in the description language, with every number such that reading it gives
    /// the same number again.
    ///
    /// `method` is the name after `method =`; without one the line is left out. Every body has a
    /// type of its own, named like the body in CamelCase.
    pub fn to_macro_text(&self, method: Option<&str>) -> String {
        let mut lines = vec![format!("pub chain {} {{", self.name)];
        if let Some(method) = method {
            lines.push(format!("    method = {method};"));
        }
        lines.push(format!("    gravity = {} m/s^2;", vector(&self.gravity)));
        lines.extend(self.bodies().map(body_type));
        lines.push(format!("    {};", self.written_elements()));
        let motors = self.hinges().filter(|hinge| hinge.motor);
        lines.extend(motors.map(|hinge| format!("    hinge {} {{ torque = input; }}", hinge.name)));
        lines.push("}\n".to_owned());
        lines.join("\n")
    }

    /// Returns the elements from end to end, joined by arrows.
    fn written_elements(&self) -> String {
        let start = ground(&self.start).into_iter();
        let finish = ground(&self.finish).into_iter();
        let elements = self.elements.iter().map(|element| match element {
            Element::Body(body) => format!("{} {}", camel_case(&body.name), body.name),
            Element::Hinge(written) => hinge(written),
        });
        start.chain(elements).chain(finish).collect::<Vec<_>>().join(" -> ")
    }
}

fn body_type(body: &Body) -> String {
    let about = match body.about {
        About::Input => "input",
        About::Com => "com",
    };
    let [xx, yy, zz, xy, xz, yz] = body.inertia;
    let inertia = if [xy, xz, yz] == [0.0; 3] {
        format!("diag({xx:?}, {yy:?}, {zz:?})")
    } else {
        format!("tensor({xx:?}, {yy:?}, {zz:?}, {xy:?}, {xz:?}, {yz:?})")
    };
    [
        format!("    body {} {{", camel_case(&body.name)),
        format!("        mass = {:?} kg;", body.mass),
        format!("        com = {} m;", vector(&body.com)),
        format!("        output = {};", frame(&body.output)),
        format!("        inertia = {inertia} kg*m^2 about {about};"),
        "    }".to_owned(),
    ]
    .join("\n")
}

fn hinge(hinge: &Hinge) -> String {
    let kind = match hinge.kind {
        HingeKind::Weld => "weld".to_owned(),
        HingeKind::Ball => "ball".to_owned(),
        HingeKind::Pin { axis: [1.0, 0.0, 0.0] } => "pin(x)".to_owned(),
        HingeKind::Pin { axis: [0.0, 1.0, 0.0] } => "pin(y)".to_owned(),
        HingeKind::Pin { axis: [0.0, 0.0, 1.0] } => "pin(z)".to_owned(),
        HingeKind::Pin { axis } => format!("pin({})", vector(&axis)),
    };
    format!("{kind} {}", hinge.name)
}

/// Returns how an end is written: nothing where it is free.
fn ground(end: &End) -> Option<String> {
    match end {
        End::Free => None,
        End::Held(place) if *place == Frame::IDENTITY => Some("ground".to_owned()),
        End::Held(place) => Some(format!("ground at {}", frame(place))),
    }
}

fn frame(frame: &Frame) -> String {
    let position = format!("{} m", vector(&frame.position));
    let [roll, pitch, yaw] = frame.rpy_degrees;
    if frame.rpy_degrees == [0.0; 3] {
        position
    } else {
        format!("{position} turned rpy({roll:?}, {pitch:?}, {yaw:?}) deg")
    }
}

fn vector(components: &[f64; 3]) -> String {
    format!("{components:?}")
}

/// Returns a snake_case name in CamelCase.
fn camel_case(name: &str) -> String {
    let capitalised = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    name.split('_').map(capitalised).collect()
}
