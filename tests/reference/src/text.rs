//! A chain written in the description language of the project.

use crate::chain::{About, Body, Chain, Dimension, Element, End, Frame, Gravity};
use crate::hinge::Source;
use crate::load::{Axes, BodyPoint, Load, Spring, SpringEnd};
use crate::route::{NamedPoint, Place};
use crate::text_hinge;

impl Chain {
    /// Returns the chain in the description language; all numbers are parsed to the same values.
    ///
    /// `method` is the name after `method =`; the line is omitted if there is none. Every body has a
    /// separate type, named like the body in CamelCase.
    pub fn to_macro_text(&self, method: Option<&str>) -> String {
        let route = |(start, elements, finish)| {
            let ends = [self.end(start), self.end(finish)].map(Option::into_iter);
            let [start, finish] = ends;
            start.chain(self.steps(elements)).chain(finish).collect::<Vec<_>>().join(" -> ")
        };
        self.text_with_routes(method, self.routes().map(route))
    }

    /// Returns the chain in the description language, with these routes.
    pub(crate) fn text_with_routes(
        &self,
        method: Option<&str>,
        routes: impl Iterator<Item = String>,
    ) -> String {
        let word = match self.dimension {
            Dimension::Space => "",
            Dimension::Plane => "plane ",
            Dimension::Line => "line ",
        };
        let mut lines = vec![format!("pub {word}chain {} {{", self.name)];
        if let Some(method) = method {
            lines.push(format!("    method = {method};"));
        }
        lines.push(match &self.gravity {
            Gravity::Constant(gravity) => format!("    gravity = {} m/s^2;", self.vector(gravity)),
            Gravity::Input => "    gravity = input;".to_owned(),
        });
        lines.extend(self.bodies().map(|body| self.body_type(body, &Factors::default())));
        lines.extend(routes.map(|route| format!("    {route};")));
        lines.extend(self.blocks());
        lines.push("}\n".to_owned());
        lines.join("\n")
    }

    /// Returns the blocks of hinges, loads and springs.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = String> {
        let loads = self.loads.iter().map(|load| self.load_section(load));
        let springs = self.springs.iter().map(|spring| self.spring_section(spring));
        self.hinges().filter_map(text_hinge::section_of).chain(loads).chain(springs)
    }

    /// Returns the texts of elements.
    pub(crate) fn steps(&self, elements: &[Element]) -> Vec<String> {
        let step = |element: &Element| match element {
            Element::Body(body) => format!("{} {}", camel_case(&body.name), body.name),
            Element::Hinge(hinge) => {
                format!("{} {}", text_hinge::word(&hinge.kind, self.dimension), hinge.name)
            }
        };
        elements.iter().map(step).collect()
    }

    /// Returns the text of an end, nothing for a free end.
    pub(crate) fn end(&self, end: &End) -> Option<String> {
        match end {
            End::Free => None,
            End::Held(place) if *place == Frame::IDENTITY => Some("ground".to_owned()),
            End::Held(place) => Some(format!("ground at {}", self.frame(place))),
            End::Moving { name } => Some(format!("moving {name}")),
            End::Place(Place { body, point }) => Some(format!("{body}.{point}")),
        }
    }

    /// Returns the type of a body, whose numbers are multiplied by parameters.
    pub(crate) fn body_type(&self, body: &Body, factors: &Factors) -> String {
        let mut fields = vec![
            format!("mass = {}{:?} kg", factors.size, body.mass),
            format!("com = {} m", self.scaled_vector(&body.com, factors)),
            format!("output = {}", self.scaled_frame(&body.output, factors)),
        ];
        fields.extend(self.inertia(body, factors).map(|inertia| format!("inertia = {inertia}")));
        let point = |point: &NamedPoint| {
            format!("point {} = {}", point.name, self.scaled_frame(&point.frame, factors))
        };
        fields.extend(body.points.iter().map(point));
        let spots = self.loads.iter().map(|load| (&load.body, &load.at));
        let spots = spots.chain(self.springs.iter().map(|spring| (&spring.body, &spring.at)));
        let spots = spots.chain(self.springs.iter().filter_map(|spring| match &spring.to {
            SpringEnd::Ground(_) => None,
            SpringEnd::Body { body, at } => Some((body, at)),
        }));
        for (on, spot) in spots {
            if let BodyPoint::Named { name, position } = spot {
                let point = format!("point {name} = {} m", self.vector(position));
                let is_new = !fields.contains(&point) && body.place(name).is_none();
                if *on == body.name && is_new {
                    fields.push(point);
                }
            }
        }
        let lines: Vec<String> = fields.iter().map(|field| format!("        {field};")).collect();
        format!("    body {} {{\n{}\n    }}", camel_case(&body.name), lines.join("\n"))
    }

    fn inertia(&self, body: &Body, Factors { side, size }: &Factors) -> Option<String> {
        let about = match body.about {
            About::Input => "input",
            About::Com => "com",
        };
        let [xx, yy, zz, xy, xz, yz] = body.inertia;
        let inertia = match self.dimension {
            Dimension::Space if [xy, xz, yz] == [0.0; 3] => {
                format!("diag({size}{xx:?}, {size}{yy:?}, {size}{zz:?})")
            }
            Dimension::Space => format!(
                "tensor({size}{xx:?}, {size}{yy:?}, {size}{zz:?}, {size}{side}{xy:?}, {size}{xz:?}, \
                 {size}{side}{yz:?})"
            ),
            Dimension::Plane => format!("{size}{zz:?}"),
            Dimension::Line => return None,
        };
        Some(format!("{inertia} kg*m^2 about {about}"))
    }

    fn load_section(&self, load: &Load) -> String {
        let mut fields = vec![format!("on = {}", load.body)];
        if load.at != BodyPoint::Com {
            fields.push(format!("at = {}", self.spot(&load.at)));
        }
        fields.extend(source("force", &load.force, |force| format!("{} N", self.vector(force))));
        fields.extend(source("torque", &load.torque, |torque| match self.dimension {
            Dimension::Space => format!("{} N*m", self.vector(torque)),
            Dimension::Plane | Dimension::Line => format!("{:?} N*m", torque[2]),
        }));
        if load.axes == Axes::Body && self.dimension != Dimension::Line {
            fields.push("axes = body".to_owned());
        }
        section("load", &load.name, &fields)
    }

    fn spring_section(&self, spring: &Spring) -> String {
        let to = match &spring.to {
            SpringEnd::Ground(position) => format!("{} m", self.vector(position)),
            SpringEnd::Body { body, at } => format!("{body}.{}", self.spot(at)),
        };
        let mut fields = vec![
            format!("on = {}", spring.body),
            format!("at = {}", self.spot(&spring.at)),
            format!("to = {to}"),
        ];
        let numbers = [
            ("stiffness", spring.stiffness, "N/m"),
            ("damping", spring.damping, "N*s/m"),
            ("length", spring.length, "m"),
        ];
        let given = numbers.iter().filter(|(_, number, _)| *number != 0.0);
        fields.extend(given.map(|(field, number, unit)| format!("{field} = {number:?} {unit}")));
        fields.extend(source("force", &spring.force, |force| format!("{force:?} N")));
        section("spring", &spring.name, &fields)
    }

    /// Returns the text of a point of a body.
    fn spot(&self, spot: &BodyPoint) -> String {
        match spot {
            BodyPoint::Com => "com".to_owned(),
            BodyPoint::Input => "input".to_owned(),
            BodyPoint::Output => "output".to_owned(),
            BodyPoint::At(position) => format!("{} m", self.vector(position)),
            BodyPoint::Named { name, .. } => name.clone(),
        }
    }

    fn frame(&self, frame: &Frame) -> String {
        self.scaled_frame(frame, &Factors::default())
    }

    fn scaled_frame(&self, frame: &Frame, factors: &Factors) -> String {
        let position = format!("{} m", self.scaled_vector(&frame.position, factors));
        let [roll, pitch, yaw] = frame.rpy_degrees;
        match self.dimension {
            _ if frame.rpy_degrees == [0.0; 3] => position,
            Dimension::Space => format!("{position} turned rpy({roll:?}, {pitch:?}, {yaw:?}) deg"),
            Dimension::Plane | Dimension::Line => format!("{position} turned {yaw:?} deg"),
        }
    }

    /// Returns the components that the chain's dimension has.
    fn vector(&self, components: &[f64; 3]) -> String {
        self.scaled_vector(components, &Factors::default())
    }

    fn scaled_vector(&self, [x, y, z]: &[f64; 3], Factors { side, .. }: &Factors) -> String {
        match self.dimension {
            Dimension::Space => format!("[{x:?}, {side}{y:?}, {z:?}]"),
            Dimension::Plane => format!("[{x:?}, {side}{y:?}]"),
            Dimension::Line => format!("{x:?}"),
        }
    }
}

/// What the numbers of a body's type are multiplied by: empty, or a parameter and an asterisk.
#[derive(Default)]
pub(crate) struct Factors {
    /// The factor of y components, and of products of inertia with y.
    pub(crate) side: String,
    /// The factor of the mass and of the moments of inertia.
    pub(crate) size: String,
}

/// Returns the block of something that has a name.
pub(crate) fn section(word: &str, name: &str, fields: &[String]) -> String {
    let fields: Vec<String> = fields.iter().map(|field| format!("{field};")).collect();
    format!("    {word} {name} {{ {} }}", fields.join(" "))
}

/// Returns the field of a value that is constant or an input.
pub(crate) fn source<T>(
    field: &str,
    source: &Source<T>,
    constant: impl Fn(&T) -> String,
) -> Option<String> {
    match source {
        Source::None => None,
        Source::Constant(value) => Some(format!("{field} = {}", constant(value))),
        Source::Input => Some(format!("{field} = input")),
    }
}

/// Returns a snake_case name in CamelCase.
pub(crate) fn camel_case(name: &str) -> String {
    let capitalised = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    name.split('_').map(capitalised).collect()
}
