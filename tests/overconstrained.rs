//! Overconstrained linkages: closed chains of pins that move although they have at least as many constraints
//! as rates, compared with an independent reference in twice the precision.

#[path = "support/double_double_scalar.rs"]
mod double_double;
mod overconstrained {
    #[macro_use]
    mod face;
    mod algebra;
    mod bennett;
    mod bricard;
    mod checks;
    mod configuration;
    mod four_bars;
    mod goldberg;
    mod linkage;
    mod motion;
    mod nearby;
    mod newton_euler;
    mod reference;
    mod sarrus;
    mod scaled;
    mod states;
    mod svd;
    mod weak;
}
