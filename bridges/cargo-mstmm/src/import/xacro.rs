//! Files of xacro, the macro language of URDF, which must be expanded first.

use super::error::Result;
use super::xml::Element;

/// The error for a file that is not expanded.
pub const MESSAGE: &str =
    "this is a xacro file: run `xacro FILE.xacro > FILE.urdf` of ROS first, and import FILE.urdf";

/// Refuses elements of xacro, and attributes with its expressions such as `${width}` and `$(arg name)`.
///
/// An expanded file may still declare the namespace.
pub fn refuse(root: Element) -> Result<()> {
    let is_xacro = |element: &Element| {
        let is_macro = element.namespace().is_some_and(|name| name.contains("xacro"));
        is_macro || element.values().any(|value| value.contains("${") || value.contains("$("))
    };
    root.descendants().find(is_xacro).map_or(Ok(()), |element| Err(element.error(MESSAGE)))
}
