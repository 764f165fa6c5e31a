"""A study: a container crane moves its load by 30 m in gusts; how far does the load swing, and what does the hook carry?
Needs the wheel of `gantry.chain`."""

import numpy as np
from gantry import Gantry

# The trolley moves by DISTANCE in MOVE seconds; the study ends at END. In calm air the load hardly swings after such a move.
DISTANCE, MOVE, END, STEP = 30.0, 17.4, 40.0, 0.01
EVERY = 5
# Air, and the side of the container that faces the wind, with its drag coefficient.
DENSITY, AREA, DRAG = 1.25, 2.6 * 2.4, 1.3
# The length of the gusts in m (the integral scale of the turbulence), and the number of its waves.
SCALE, WAVES = 80.0, 24


def sample(rng):
    drawn = {
        "mean_wind": 8.0 * rng.weibull(2.0),
        "turbulence": rng.uniform(0.1, 0.2),
        "load_mass": rng.uniform(4e3, 25e3),
        "gusts": float(rng.integers(2**32)),
    }
    return drawn


def trolley(time):
    """Returns position, rate and acceleration of the trolley: a polynomial of degree five, at rest at both ends."""
    s = np.clip(time / MOVE, 0.0, 1.0)
    position = DISTANCE * s**3 * (10 - 15 * s + 6 * s**2)
    rate = DISTANCE * 30 * s**2 * (1 - s) ** 2 / MOVE
    return position, rate, DISTANCE * 60 * s * (1 - s) * (1 - 2 * s) / MOVE**2


def wind(mean, turbulence, seed, time):
    """Returns the speed of the wind in m/s at all times: the mean and waves of random phases with Kaimal's spectrum.

    Amplitudes are those of bands of equal width in the logarithm of the frequency, from 0.003 to 0.5 Hz.
    """
    rng = np.random.default_rng(seed)
    edges = np.geomspace(0.003, 0.5, WAVES + 1)
    frequency = np.sqrt(edges[1:] * edges[:-1])
    length = SCALE / max(mean, 0.1)
    density = 4 * length / (1 + 6 * frequency * length) ** (5 / 3)
    amplitude = turbulence * mean * np.sqrt(2 * density * np.diff(edges))
    phases = rng.uniform(0, 2 * np.pi, WAVES)
    return mean + (amplitude * np.cos(2 * np.pi * np.outer(time, frequency) + phases)).sum(axis=1)


def inputs(samples, row, time):
    """Returns the inputs of all steps: motion of the trolley, force of the wind."""
    speed = wind(samples["mean_wind"][row], samples["turbulence"][row], int(samples["gusts"][row]), time)
    force = 0.5 * DENSITY * DRAG * AREA * speed * np.abs(speed)
    position, rate, acceleration = trolley(time)
    values = {
        "rail.state.position": position, "rail.state.velocity": rate, "rail.acceleration": acceleration,
        "wind.force.x": force, "wind.force.y": np.zeros_like(time),
    }
    return np.stack([values[name] for name in Gantry.inputs], axis=1)


def motion(samples, row):
    """Returns model, trajectory and inputs of one sample; the trajectory has each fifth state."""
    model = Gantry(load_mass=samples["load_mass"][row])
    given = inputs(samples, row, STEP * np.arange(round(END / STEP) + 1))
    states = model.rollout(model.initial(), given[:-1], STEP, len(given) - 1, every=EVERY, threads=1)
    return model, states, np.ascontiguousarray(given[::EVERY])


def simulate(samples):
    count = len(samples["load_mass"])
    swing, left, force, unsafe = (np.empty(count) for _ in range(4))
    late = round(MOVE / STEP) // EVERY
    for row in range(count):
        model, states, given = motion(samples, row)
        points = model.solve(states, given, threads=1)["points"]
        hook = points["load.input"]
        aside = np.abs(hook["position"][:, 0] - points["trolley.input"]["position"][:, 0])
        swing[row], left[row] = aside.max(), aside[late:].max()
        force[row] = np.linalg.norm(hook["force"], axis=1).max()
        unsafe[row] = float(left[row] > 0.5)
    return {"swing": swing, "swing_after": left, "hook_force": force, "swing_after_above_half_metre": unsafe}


def page(path, seed=1):
    """Writes a page that shows the motion of the first sample of a study with this seed."""
    drawn = {name: [value] for name, value in sample(np.random.default_rng([seed, 0])).items()}
    model, states, given = motion(drawn, 0)
    model.record(states, given, STEP * EVERY).write_html(path, title="A container crane in gusts")


if __name__ == "__main__":
    page("gantry.html")
    print("gantry.html shows the first sample")
