//! Inertia tensors.

use crate::model::condition::{Bound, Condition, Requirement};
use crate::model::lower::{BodyType, Draft, Spanned};
use crate::model::rules::MOMENT;
use crate::model::{Dimension, Inertia, Value};

/// The order of a tensor. That of URDF and SDF is xx, xy, xz, yy, yz, zz.
const ORDER: &str = "`tensor` has the order xx, yy, zz, xy, xz, yz";

/// Requires moments of inertia that are not negative.
pub(super) fn moments_are_not_negative(draft: &Draft) -> Vec<Requirement> {
    let moments = draft.types.all.iter().filter_map(|body| {
        let inertia = body.inertia.as_ref()?;
        let moments = inertia.value.tensor[..3].iter().enumerate();
        let order = if body.is_tensor() { format!("; {ORDER}") } else { String::new() };
        Some(moments.map(move |(index, moment)| {
            let at = body.inertia_entry(index).unwrap_or(inertia.at);
            let condition = MOMENT.condition(moment.clone(), at);
            let message = condition.message.map(|message| message + &order);
            vec![Condition { message, ..condition }]
        }))
    });
    moments.flatten().collect()
}

/// Requires that a distribution of mass with this inertia exists, about any point.
pub(super) fn inertias_are_physical(draft: &Draft) -> Vec<Requirement> {
    let bodies = draft.types.all.iter();
    bodies.filter_map(|body| Some(real(draft.space, body, body.inertia.as_ref()?))).collect()
}

/// Returns the end of a message: the order of a tensor, and its principal moments if they are known.
fn order(inertia: &Inertia) -> String {
    let Some([first, second, third]) = inertia.principal_moments() else {
        return format!("; {ORDER}");
    };
    let [first, second, third] = [first, second, third].map(three_digits);
    format!(
        "; {ORDER}; in this order the principal moments are {first}, {second} and {third} kg*m^2"
    )
}

/// Rounds a number to three digits.
fn three_digits(number: f64) -> f64 {
    format!("{number:.2e}").parse().unwrap_or(number)
}

fn real(space: Dimension, body: &BodyType, inertia: &Spanned<Inertia>) -> Requirement {
    let moments = inertia.value.tensor[..3].iter();
    let silent =
        |moment: &Value| Condition::silent(moment.clone(), Bound::NotBeNegative, inertia.at);
    let mut conditions: Requirement = moments.map(silent).collect();
    let mut require = |signs: Vec<Value>, message: &str| {
        let condition = |sign| Condition::new(sign, Bound::NotBeNegative, inertia.at, message);
        conditions.extend(signs.into_iter().map(condition));
    };
    let order = if body.is_tensor() { order(&inertia.value) } else { String::new() };
    let message = format!(
        "no real body has this inertia: a principal moment exceeds the sum of the other two{order}"
    );
    require(inertia.value.signs(space), &message);
    if let (Some(mass), Some(com)) = (&body.mass, &body.com) {
        let message = "this inertia about the input is too small for the mass and the centre of \
                       mass: is it `about com`?";
        require(inertia.value.central_signs(space, &mass.value, &com.value), message);
    }
    conditions
}
