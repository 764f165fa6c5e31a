mstmm::mstmm_chain! {
    chain Weighed {
        results = energies;
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }

    plane chain Gauged {
        results = z;
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com; }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {
    let joint = Weighed::<f64>::new().workspace().rod().input();
    joint.position();
    joint.angular_velocity();
    joint.z();

    let at = Gauged::<f64>::new().workspace();
    at.joint().output().cos_sin();
    at.kinetic_energy();
}
