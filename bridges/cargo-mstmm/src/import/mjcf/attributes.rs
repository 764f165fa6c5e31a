//! The attributes of elements with those of their default classes, and the settings of the compiler.

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};
use std::collections::HashMap;

use super::super::error::{ImportError, Result};
use super::super::xml::Element;

/// The attributes of an element, and those of its default classes, innermost first.
pub struct Attributes<'a> {
    elements: Vec<Element<'a>>,
}

impl<'a> Attributes<'a> {
    /// Returns the attributes of an element without default classes.
    pub fn only(element: Element<'a>) -> Self {
        Attributes { elements: vec![element] }
    }

    /// Returns the element.
    pub fn element(&self) -> Element<'a> {
        self.elements[0]
    }

    /// Returns the text of an attribute. Names are those of single elements.
    pub fn text(&self, name: &str) -> Option<&'a str> {
        // A class cannot name its joints.
        let elements = if name == "name" { &self.elements[..1] } else { &self.elements[..] };
        elements.iter().find_map(|element| element.attribute(name))
    }

    /// Returns one of several words, if the attribute is present. Other words are errors.
    pub fn keyword(&self, name: &str, words: &[&str]) -> Result<Option<&'a str>> {
        let element = self.elements.iter().find(|element| element.attribute(name).is_some());
        element.map_or(Ok(None), |element| element.keyword(name, words))
    }

    /// Returns the finite numbers of an attribute; none if it is absent.
    pub fn numbers_of(&self, name: &str) -> Result<Vec<f64>> {
        let Some(element) = self.elements.iter().find(|it| it.attribute(name).is_some()) else {
            return Ok(Vec::new());
        };
        element.numbers(name)
    }

    /// Returns the numbers of an attribute; none if it is absent.
    pub fn numbers<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>> {
        let numbers = self.numbers_of(name)?;
        if numbers.is_empty() {
            return Ok(None);
        }
        let count = numbers.len();
        let wrong = |_| self.element().error(format!("`{name}` has {count} numbers, not {N}"));
        <[f64; N]>::try_from(numbers).map(Some).map_err(wrong)
    }

    /// Returns the form of the orientation and its numbers. Any form of the element overrides those of its classes.
    pub fn orientation(&self) -> Result<Option<(&'static str, Vec<f64>)>> {
        for element in &self.elements {
            let forms = FORMS.into_iter().filter(|form| element.attribute(form).is_some());
            match forms.collect::<Vec<_>>()[..] {
                [] => {}
                [form] => return Ok(Some((form, element.numbers(form)?))),
                [first, second, ..] => {
                    let message =
                        format!("`{first}` and `{second}` are two orientations: keep one");
                    return Err(element.error(message));
                }
            }
        }
        Ok(None)
    }

    /// Returns three numbers.
    pub fn vector(&self, name: &str, default: [f64; 3]) -> Result<Vector3<f64>> {
        Ok(self.numbers(name)?.unwrap_or(default).into())
    }
}

/// The forms of an orientation.
const FORMS: [&str; 5] = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];

/// Returns how many numbers a form of an orientation has.
fn count(form: &str) -> usize {
    match form {
        "quat" | "axisangle" => 4,
        "xyaxes" => 6,
        _ => 3,
    }
}

/// The default classes of a file.
pub struct Defaults<'a> {
    /// The elements `default` of each class, from it to the main class.
    classes: HashMap<&'a str, Vec<Element<'a>>>,
}

/// The name of the class that all elements have.
const MAIN: &str = "main";

impl<'a> Defaults<'a> {
    /// Reads the elements `default` of a file.
    pub fn read(root: Element<'a>) -> Result<Self> {
        let mut classes = HashMap::new();
        let mut waiting: Vec<(Element<'a>, Vec<Element<'a>>)> =
            root.children("default").map(|element| (element, Vec::new())).collect();
        while let Some((element, outer)) = waiting.pop() {
            let class = match element.attribute("class") {
                Some(class) => class,
                None if outer.is_empty() => MAIN,
                None => return Err(element.error("a class in a class has no attribute `class`")),
            };
            let chain: Vec<Element<'a>> = [&[element], &outer[..]].concat();
            waiting.extend(element.children("default").map(|inner| (inner, chain.clone())));
            // The root class may have a name, and is the main class.
            if outer.is_empty() {
                classes.insert(MAIN, chain.clone());
            }
            classes.insert(class, chain);
        }
        Ok(Defaults { classes })
    }

    /// Returns the attributes of an element: its own, those of its class, or else of the class of its body.
    pub fn of(
        &self,
        element: Element<'a>,
        tag: &str,
        of_body: Option<&'a str>,
    ) -> Result<Attributes<'a>> {
        let mut elements = vec![element];
        if element.tag() == "freejoint" {
            return Ok(Attributes { elements });
        }
        let class = element.attribute("class").or(of_body);
        match self.classes.get(class.unwrap_or(MAIN)) {
            Some(chain) => elements.extend(chain.iter().filter_map(|class| class.child(tag))),
            None => {
                if let Some(class) = class {
                    return Err(element.error(format!("the class `{class}` does not exist")));
                }
            }
        }
        Ok(Attributes { elements })
    }
}

/// The words of an attribute that is true or false.
pub const BOOL: [&str; 2] = ["true", "false"];

/// The words of an attribute that may depend on others.
pub const BOOL_OR_AUTO: [&str; 3] = ["true", "false", "auto"];

/// The settings of the element `compiler`.
pub struct Compiler {
    /// Angles within this of whole degrees are these.
    pub snap: f64,
    in_degrees: bool,
    euler: Vec<char>,
    /// Whether a range limits a joint without `limited`.
    pub limits_alone: bool,
}

impl Compiler {
    /// Reads the elements `compiler` of a file.
    pub fn read(root: Element, snap: f64) -> Result<Self> {
        let mut read =
            Compiler { snap, in_degrees: true, euler: "xyz".chars().collect(), limits_alone: true };
        for compiler in root.children("compiler") {
            refuse_masses(compiler)?;
            if let Some(unit) = compiler.keyword("angle", &["degree", "radian"])? {
                read.in_degrees = unit == "degree";
            }
            if let Some(sequence) = compiler.attribute("eulerseq") {
                read.euler = sequence.chars().collect();
                let is_axis = |letter: &char| "xyzXYZ".contains(*letter);
                if read.euler.len() != 3 || !read.euler.iter().all(is_axis) {
                    return Err(compiler.error("`eulerseq` is not three axes"));
                }
            }
            if let Some(limits) = compiler.keyword("autolimits", &BOOL)? {
                read.limits_alone = limits == "true";
            }
        }
        Ok(read)
    }

    /// Returns an angle in rad.
    pub fn angle(&self, angle: f64) -> f64 {
        if self.in_degrees { angle.to_radians() } else { angle }
    }

    /// Returns the rotation of the orientation that an element has in any of its forms.
    pub fn orientation(&self, element: &Attributes) -> Result<Matrix3<f64>> {
        let Some((form, numbers)) = element.orientation()? else { return Ok(Matrix3::identity()) };
        let error = |reason: &str| -> ImportError { element.element().error(reason) };
        let unit = |vector: Vector3<f64>| {
            Unit::try_new(vector, 1e-12).ok_or_else(|| error("an axis of the orientation is zero"))
        };
        let rotation = match (form, &numbers[..]) {
            ("quat", &[w, x, y, z]) => {
                let unit = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-12);
                let unit = unit.ok_or_else(|| error("the quaternion is zero"))?;
                unit.to_rotation_matrix().into_inner()
            }
            ("axisangle", &[x, y, z, angle]) => {
                let axis = unit(Vector3::new(x, y, z))?;
                Rotation3::from_axis_angle(&axis, self.angle(angle)).into_inner()
            }
            ("euler", &[first, second, third]) => self.by_euler([first, second, third]),
            ("xyaxes", &[a, b, c, d, e, f]) => {
                let x = unit(Vector3::new(a, b, c))?;
                let y = Vector3::new(d, e, f);
                let y = unit(y - *x * x.dot(&y))?;
                Matrix3::from_columns(&[*x, *y, x.cross(&y)])
            }
            ("zaxis", &[x, y, z]) => to_axis(&unit(Vector3::new(x, y, z))?),
            _ => {
                let (found, expected) = (numbers.len(), count(form));
                let message = format!("`{form}` has {found} numbers, not {expected}");
                return Err(error(&message));
            }
        };
        Ok(rotation)
    }

    /// Returns the position and the rotation of the line `fromto` of a site: its middle, with z towards its start.
    pub fn line(&self, site: &Attributes) -> Result<Option<(Vector3<f64>, Matrix3<f64>)>> {
        let Some([a, b, c, d, e, f]) = site.numbers("fromto")? else { return Ok(None) };
        if site.vector("pos", [0.0; 3])? != Vector3::zeros() {
            return Err(site.element().error("`fromto` and `pos` are two positions: keep one"));
        }
        let (start, end) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
        let axis = Unit::try_new(start - end, 1e-12);
        let axis = axis.ok_or_else(|| site.element().error("`fromto` has no length"))?;
        Ok(Some(((start + end) / 2.0, to_axis(&axis))))
    }

    /// Returns the rotation by three angles about the axes of `eulerseq`.
    fn by_euler(&self, angles: [f64; 3]) -> Matrix3<f64> {
        let mut rotation = Matrix3::identity();
        for (letter, angle) in self.euler.iter().zip(angles) {
            let axis = match letter.to_ascii_lowercase() {
                'x' => Vector3::x_axis(),
                'y' => Vector3::y_axis(),
                _ => Vector3::z_axis(),
            };
            let next = Rotation3::from_axis_angle(&axis, self.angle(angle)).into_inner();
            // Lower case: axes that move with the rotations.
            let moves = letter.is_ascii_lowercase();
            rotation = if moves { rotation * next } else { next * rotation };
        }
        rotation
    }
}

/// Refuses settings by which masses and frames are not those of the file.
fn refuse_masses(compiler: Element) -> Result<()> {
    let refused = |reason: &str| -> Result<()> { Err(compiler.error(reason)) };
    if compiler.keyword("coordinate", &["local", "global"])? == Some("global") {
        refused("`coordinate=\"global\"` is not read")?;
    }
    if compiler.keyword("inertiafromgeom", &BOOL_OR_AUTO)? == Some("true") {
        refused("`inertiafromgeom=\"true\"`: masses of geoms are not read")?;
    }
    if compiler.keyword("balanceinertia", &BOOL)? == Some("true") {
        refused("`balanceinertia` changes tensors, and is not read")?;
    }
    for setting in ["boundmass", "boundinertia", "settotalmass"] {
        if compiler.number(setting, 0.0)? > 0.0 {
            refused(&format!("`{setting}` changes masses, and is not read"))?;
        }
    }
    Ok(())
}

/// Returns the shortest rotation from z to an axis.
fn to_axis(axis: &Unit<Vector3<f64>>) -> Matrix3<f64> {
    // Half a turn is about x as in MuJoCo.
    let half = || Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI);
    let rotation = Rotation3::rotation_between(&Vector3::z(), axis);
    rotation.unwrap_or_else(half).into_inner()
}
