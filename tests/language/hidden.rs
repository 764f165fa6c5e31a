//! Names that private items of the generated code have, too.

use mstmm::{Described, mstmm_chain};

mstmm_chain! {
    pub plane chain P0 {
        answers = jacobian;
        param row_ = 1 kg;
        param parameter_ = 2 kg;
        body Keywords_ {
            mass = row_ + parameter_;
            com = [1, 0] m;
            output = [1, 0] m;
            inertia = 1 kg*m^2 about com;
            point frame = [2, 0] m;
            point common_ = [3, 0] m;
            point deref = [4, 0] m;
        }
        ground -> pin frame_ -> Keywords_ motions -> pin efforts -> Keywords_ columns
               -> pin correct -> Keywords_ numbers;
        motions.frame -> pin springs -> Keywords_ fmt;
        hinge frame_, efforts { torque = input; }
    }
}

#[test]
fn names_of_private_items_mean_nothing() -> Result<(), mstmm::Error> {
    let mut chain = P0::<f64>::new();
    for (index, value) in [3.0, 5.0].into_iter().enumerate() {
        chain.set_parameter(index, value)?;
    }
    assert_eq!((chain.parameters().row_(), chain.parameters().parameter_()), (3.0, 5.0));
    let (state, inputs) = (chain.initial_state(), chain.no_inputs());
    let kinematics = chain.kinematics(&state, &inputs)?;
    let body = kinematics.motions();
    let points = [body.frame(), body.common_(), body.deref(), body.at([5.0, 0.0])];
    assert_eq!(points.map(|point| point.position().x), [2.0, 3.0, 4.0, 5.0]);
    assert_eq!(kinematics.fmt().frame().position().x, 4.0);
    assert_eq!(body.frame().jacobian().column(0)[1], 2.0);
    Ok(())
}
