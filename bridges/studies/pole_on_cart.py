"""A study: the force in the joint of a cart-pole that falls, with uncertain masses, length and start."""

import numpy as np
from mstmm_robots import CartPole


def sample(rng):
    return {
        "bob_mass": rng.normal(0.1, 0.01),
        "length": rng.uniform(0.45, 0.55),
        "angle": rng.uniform(-0.2, 0.2),
        "rate": rng.normal(0, 0.1),
    }


def simulate(samples):
    count = len(samples["angle"])
    peak, fallen = np.empty(count), np.empty(count)
    for row in range(count):
        model = CartPole(bob_mass=samples["bob_mass"][row], length=samples["length"][row])
        x = model.initial()
        x[1], x[3] = samples["angle"][row], samples["rate"][row]
        trajectory = model.rollout(x, None, 2e-3, 1000, every=10, threads=1)
        force = model.solve(trajectory, threads=1)["points"]["bob.input"]["force"]
        peak[row] = np.linalg.norm(force, axis=1).max()
        fallen[row] = float((np.abs(trajectory[:, 1]) > np.pi / 2).any())
    return {"peak_force": peak, "fallen": fallen}
