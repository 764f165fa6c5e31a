"""A study: how far from its target does a Panda stop whose controller does not know its payload?

The programs in `payloads` and `mpi` are the same study in Rust, with the same hash.
"""

import numpy as np
from mstmm_robots import LoadedPanda

STEP, STEPS = 4e-3, 250
JOINTS = 7


def sample(rng):
    """A box of uniform density as the payload, and the start of the joints relative to the target."""
    drawn = {"mass": rng.uniform(0.1, 3.0)}
    for name, low, high in (("x", -0.05, 0.05), ("y", -0.05, 0.05), ("z", 0.0, 0.1)):
        drawn[name] = rng.uniform(low, high)
    for name in ("edge_x", "edge_y", "edge_z"):
        drawn[name] = rng.uniform(0.05, 0.3)
    for joint in range(JOINTS):
        drawn[f"start_{joint + 1}"] = rng.uniform(-0.3, 0.3)
    return drawn


def flange(model, x):
    return model.solve(x, threads=1)["points"]["load.input"]["position"]


def simulate(samples):
    # The controller holds the target with the payload of the description.
    nominal = LoadedPanda()
    target = nominal.initial()
    torques = nominal.gravity_efforts(target, threads=1)
    goal = flange(nominal, target)
    mass = samples["mass"]
    squares = [samples[f"edge_{axis}"] * samples[f"edge_{axis}"] for axis in "xyz"]
    moments = [mass / 12 * (squares[a] + squares[b]) for a, b in ((1, 2), (2, 0), (0, 1))]
    ends = np.empty((len(mass), 2 * JOINTS))
    offsets = np.empty((len(mass), 3))
    for row in range(len(mass)):
        xx, yy, zz = (float(moment[row]) for moment in moments)
        x, y, z = (float(samples[axis][row]) for axis in "xyz")
        model = LoadedPanda(payload=float(mass[row]), x=x, y=y, z=z, xx=xx, yy=yy, zz=zz)
        ends[row] = target
        ends[row, :JOINTS] += [samples[f"start_{joint + 1}"][row] for joint in range(JOINTS)]
        model.step(ends[row], torques, STEP, STEPS, threads=1)
        offsets[row] = flange(model, ends[row]) - goal
    x, y, z = offsets.T
    return {"distance": np.sqrt(x * x + y * y + z * z), "height": z}
