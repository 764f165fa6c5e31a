//! Messages name the cause of a mistake, once, and their advice can be followed.

use super::each_error_once::expect_hinge;

#[test]
fn a_suggested_unit_has_the_same_size() {
    let start = |unit: &str, error: &str| {
        expect_hinge("pin", &format!("start = 1 {unit};"), &[(unit, error)]);
    };
    start("mdeg", "unknown unit `mdeg`");
    start("dam", "unknown unit `dam`");
    start("degs", "unknown unit `degs`; did you mean `deg`?");
    start("MM", "unknown unit `MM`; units are case-sensitive: `mm`, `Mm`");
}
