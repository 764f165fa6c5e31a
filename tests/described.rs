//! `Described`: names, units, starts and inertia compared with what accessors, setters and states say.

#[path = "described/answers.rs"]
mod answers;
#[path = "described/displacements.rs"]
mod displacements;
#[path = "described/geometry.rs"]
mod geometry;
#[path = "described/inertia.rs"]
mod inertia;
#[path = "described/lists.rs"]
mod lists;
#[path = "described/models.rs"]
mod models;
#[path = "described/names.rs"]
mod names;
#[path = "described/not_finite.rs"]
mod not_finite;
#[path = "described/results.rs"]
mod results;
#[path = "described/shapes.rs"]
mod shapes;
#[path = "described/values.rs"]
mod values;
