//! The tables of a chain as values, for tools that write interfaces in other languages.

use super::description::{
    InputRow, QuantityKind, described_hinges, frames, indexed, input_rows, point_names,
};
use super::{ArrayLayouts, BodyReports, EmitContext, TypeNames, closure, docs, routes, sealed};
use crate::compile::compile;
use crate::examine::Findings;
use crate::ids::RepeatId;
use crate::model::{
    Answer, BodyId, Chain, Drive, DynamicParameter, Effort, Hinge, Input, InputKind, Layout, Value,
};
use crate::program::ArrayLayout;
use crate::syntax::Passthrough;
use proc_macro2::TokenStream;

/// The arrays of a chain with the names and the order of its description at run time.
#[derive(Clone, Debug)]
pub struct Tables {
    /// The doc comment of the chain, line by line.
    pub docs: Vec<String>,
    /// The routes, without arguments and with all parts written out.
    pub routes: Vec<String>,
    /// The coordinates `q` of the state.
    pub coordinates: NamedArray,
    /// The rates `v` of the state.
    pub rates: NamedArray,
    /// The scalars of all inputs.
    pub inputs: NamedArray,
    /// The fields of the inputs' type with the number of their scalars, if all are scalars or vectors; none if there
    /// are prescribed motions or repeated inputs.
    pub plain_inputs: Option<Vec<(String, usize)>>,
    /// The parameters.
    pub parameters: NamedArray,
    /// The connection points.
    pub points: NamedArray,
    /// The hinges; those of a repeated part are counted once.
    pub hinges: Vec<HingeRow>,
    /// The bodies; those of a repeated part are counted once.
    pub bodies: Vec<BodyRow>,
    /// The dynamic parameters: the columns of the regressor.
    pub dynamic_parameters: NamedArray,
    /// The bodies with a separate Jacobian `NAME_jacobian_into`: name and path.
    pub end_bodies: Vec<[String; 2]>,
    /// The functions of the chain.
    pub answers: Vec<Answer>,
    /// The number of scalars in the chain's type, which has no other fields.
    pub scalars: usize,
}

/// An array with the names of its entries.
#[derive(Clone, Debug)]
pub struct NamedArray {
    /// The length.
    pub length: usize,
    /// The entries; those of a repeated part are listed once.
    pub entries: Vec<Entry>,
}

/// An entry of an array, or one in each repetition of a part.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The name, such as `elbow.angle`, with `[]` for the index of a repetition.
    pub path: String,
    /// The unit as text, `1` for plain numbers; empty for points.
    pub unit: String,
    /// The index, in the first repetition.
    pub index: usize,
    /// The number of repetitions and the distance of their indices, for an entry of a repeated part.
    pub repeated: Option<[usize; 2]>,
    /// The value at the start with default parameters, or the default of a parameter; none if Rust constants decide.
    pub start: Option<f64>,
}

/// A hinge.
#[derive(Clone, Debug)]
pub struct HingeRow {
    /// The path as errors at run time have it: `fl.knee`, without the index of a repetition.
    pub path: String,
    /// The keyword of its kind.
    pub keyword: &'static str,
    /// The number of its repetitions.
    pub repetitions: usize,
    /// Whether its motion is prescribed.
    pub is_prescribed: bool,
    /// Whether a motor is an input.
    pub has_motor: bool,
}

/// A body.
#[derive(Clone, Debug)]
pub struct BodyRow {
    /// The path, without the index of a repetition.
    pub path: String,
    /// The number of its repetitions; none if it is not in a repeated part.
    pub repetitions: Option<usize>,
    /// Its frames: `input`, `output`, `com` and named points.
    pub frames: Vec<String>,
}

/// Returns the tables of a chain.
pub fn tables(chain: &Chain, passthrough: &Passthrough, findings: &Findings) -> Tables {
    let layout = Layout::of(chain);
    let compiled = compile(chain, findings, &layout);
    let cx = EmitContext {
        chain,
        passthrough,
        layout: &layout,
        compiled: &compiled,
        findings,
        names: TypeNames::of(chain),
        layouts: ArrayLayouts::of(chain, &layout, &compiled),
        body_reports: BodyReports::of(chain, &compiled.point_storage.of),
        unknowns: crate::ids::IdVec::default(),
        mstmm: &TokenStream::new(),
    };
    Tables {
        docs: docs::written(&passthrough.attributes),
        routes: routes::written(chain),
        coordinates: array(state_entries(&cx, true)),
        rates: array(state_entries(&cx, false)),
        inputs: array(input_entries(&cx)),
        plain_inputs: plain_inputs(&cx),
        parameters: array(parameter_entries(&cx)),
        points: array(point_entries(&cx)),
        hinges: described_hinges(&cx)
            .map(|(id, hinge)| {
                let repeat = cx.counted(chain.repeat_of_hinge(id));
                HingeRow {
                    path: hinge.path.clone(),
                    keyword: hinge.kind.spec().word,
                    repetitions: repeat.map_or(1, |(_, count)| count),
                    is_prescribed: hinge.is_prescribed(),
                    has_motor: has_motor(hinge),
                }
            })
            .collect(),
        bodies: chain.physical_bodies().map(|id| body(&cx, id)).collect(),
        dynamic_parameters: array(dynamic_parameter_entries(&cx)),
        end_bodies: compiled
            .jacobians
            .iter()
            .map(|&(body, _)| &chain.bodies[body])
            .map(|body| [body.name.to_string(), body.path.clone()])
            .collect(),
        answers: compiled.functions.iter().filter_map(|function| function.answer).collect(),
        scalars: scalars(&cx),
    }
}

fn body(cx: &EmitContext, id: BodyId) -> BodyRow {
    let body = &cx.chain.bodies[id];
    BodyRow {
        path: body.path.clone(),
        repetitions: cx.counted(cx.chain.repeat_of_body(id)).map(|(_, count)| count),
        frames: frames(body).into_iter().map(|(name, _)| name).collect(),
    }
}

fn has_motor(hinge: &Hinge) -> bool {
    match &hinge.drive {
        Drive::Efforts(efforts) => efforts.contains(&Effort::Input),
        Drive::Prescribed => false,
    }
}

/// An entry without its place.
struct Unplaced {
    path: String,
    unit: String,
    start: Option<f64>,
    repeat: Option<(RepeatId, usize)>,
}

fn array(unplaced: Vec<Unplaced>) -> NamedArray {
    let layout = ArrayLayout::of(unplaced.iter().map(|entry| (1, entry.repeat)));
    let place = |(number, entry): (usize, Unplaced)| {
        let segment = layout.segment_of(number);
        Entry {
            path: entry.path,
            unit: entry.unit,
            index: segment.offset + number - segment.first,
            repeated: entry.repeat.map(|(_, repetitions)| [repetitions, segment.count]),
            start: entry.start,
        }
    };
    NamedArray {
        length: layout.total,
        entries: unplaced.into_iter().enumerate().map(place).collect(),
    }
}

/// Returns names of the components of a path.
fn with_components<'a>(path: &'a str, components: &'a str) -> impl Iterator<Item = String> + 'a {
    let scalar = components.is_empty().then(|| path.to_owned());
    scalar.into_iter().chain(components.chars().map(move |component| format!("{path}.{component}")))
}

/// Returns the entries of the coordinates or of the rates.
fn state_entries(cx: &EmitContext, is_coordinates: bool) -> Vec<Unplaced> {
    let mut entries = Vec::new();
    for (id, hinge) in described_hinges(cx).filter(|(_, hinge)| !hinge.is_prescribed()) {
        let repeat = cx.counted(cx.chain.repeat_of_hinge(id));
        let path = indexed(&hinge.path, repeat.is_some());
        for group in hinge.kind.spec().groups {
            let (values, (components, kind)) = match is_coordinates {
                true => {
                    (&hinge.start[group.coordinates.clone()], QuantityKind::of_coordinates(group))
                }
                false => (&hinge.start_rate[group.rates.clone()], QuantityKind::of_rates(group)),
            };
            let path = format!("{path}.{}", group.names[usize::from(!is_coordinates)]);
            let named = with_components(&path, components).zip(values);
            entries.extend(named.map(|(path, value)| Unplaced {
                path,
                unit: kind.unit_and_maker().0.to_owned(),
                start: default(cx, value),
                repeat,
            }));
        }
    }
    entries
}

fn input_entries(cx: &EmitContext) -> Vec<Unplaced> {
    let mut entries = Vec::new();
    for InputRow { path, components, kind, repeat } in input_rows(cx) {
        let unit = kind.unit_and_maker().0;
        entries.extend(with_components(&path, components).enumerate().map(|(number, path)| {
            // The zero position of an orientation is w = 1.
            let start = f64::from(kind == QuantityKind::Orientation && number == 0);
            Unplaced { path, unit: unit.to_owned(), start: Some(start), repeat }
        }));
    }
    entries
}

fn plain_inputs(cx: &EmitContext) -> Option<Vec<(String, usize)>> {
    let field = |input: &Input| {
        let is_motion = matches!(input.what, InputKind::Motion(_));
        let is_plain = !is_motion && cx.chain.repeat_of_input(input.what).is_none();
        is_plain.then(|| (cx.chain.name_of_input(input.what).to_string(), input.range.len()))
    };
    cx.layout.inputs.iter().map(field).collect()
}

fn parameter_entries(cx: &EmitContext) -> Vec<Unplaced> {
    let entries = cx.chain.parameters.enumerate().map(|(id, parameter)| Unplaced {
        path: indexed(&parameter.name.to_string(), parameter.repetitions.is_some()),
        unit: if parameter.unit.is_empty() { "1".to_owned() } else { parameter.unit.clone() },
        start: default(cx, &parameter.default),
        repeat: cx.chain.repeat_of_parameter(id).zip(parameter.repetitions),
    });
    entries.collect()
}

fn point_entries(cx: &EmitContext) -> Vec<Unplaced> {
    let entry = |(path, repeat)| Unplaced { path, unit: String::new(), start: None, repeat };
    point_names(cx).into_iter().map(entry).collect()
}

fn dynamic_parameter_entries(cx: &EmitContext) -> Vec<Unplaced> {
    let entry = |parameter: DynamicParameter| {
        let (repeat, element) = match parameter {
            DynamicParameter::Inertial(body, _) => {
                (cx.chain.repeat_of_body(body), &cx.chain.bodies[body].path)
            }
            DynamicParameter::Passive(hinge, ..) => {
                (cx.chain.repeat_of_hinge(hinge), &cx.chain.hinges[hinge].path)
            }
        };
        let name = cx.chain.name_of_dynamic_parameter(parameter);
        // The index of a repetition follows the path of the element: `rod[3].mass`.
        let Some(quantity) = name.strip_prefix(&**element) else {
            bug!("`{name}` is not named after `{element}`")
        };
        let path = format!("{}{quantity}", indexed(element, repeat.is_some()));
        Unplaced { path, unit: String::new(), start: None, repeat: cx.counted(repeat) }
    };
    cx.chain.dynamic_parameters().into_iter().map(entry).collect()
}

/// Returns a value with default parameters.
fn default(cx: &EmitContext, value: &Value) -> Option<f64> {
    let defaults: Vec<Option<f64>> =
        cx.chain.parameters.iter().map(|parameter| parameter.default.at(&[])).collect();
    value.at(&defaults).filter(|number| number.is_finite())
}

/// Returns the number of scalars in the chain's type: parameters, the elimination steps of a closure, and slots.
fn scalars(cx: &EmitContext) -> usize {
    let parameters = cx.chain.parameters.iter();
    let parameters: usize = parameters.map(|parameter| parameter.repetitions.unwrap_or(1)).sum();
    let parts: usize = sealed::parts(cx).iter().map(|(_, layout)| layout.total).sum();
    parameters + closure::directions(cx).unwrap_or(0) + cx.slots(None).total + parts
}
