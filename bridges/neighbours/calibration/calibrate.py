"""Calibrates payload and friction of an arm from a recorded motion with noise, by least squares of scipy over the wheel of
`arm.chain`."""

import argparse
import pathlib

import numpy as np
from arm import Arm
from arm.gradients import sensitivities
from scipy.optimize import least_squares
from scipy.stats import t

STEP, STEPS = 0.01, 400
# Encoders: standard deviation in rad.
NOISE = 1e-3
TRUE = {"payload": 1.8, "reach": 0.08, "damping": 0.8, "friction": 1.1}


def torques(time):
    """Returns the torques of the experiment in N m, with which the arm swings below its shoulder."""
    phases = np.array([[0.0, 1.0], [0.5, 2.0], [1.0, 3.0]])
    frequencies = np.array([[0.4, 1.1], [0.5, 0.9], [0.7, 1.3]])
    sizes = np.array([[6.0, 4.0], [14.0, 8.0], [5.0, 3.0]])
    waves = np.sin(2 * np.pi * frequencies[..., None] * time + phases[..., None])
    return np.ascontiguousarray((sizes[..., None] * waves).sum(axis=1).T)


START = np.array([0.0, np.pi / 2, 0.0, 0.0, 0.0, 0.0])


def record(seed, path):
    """Writes the experiment to a CSV file: time, torques and measured angles."""
    time = STEP * np.arange(STEPS + 1)
    given = torques(time)
    angles = Arm(**TRUE).rollout(START, given[:-1], STEP, STEPS)[:, :3]
    measured = angles + np.random.default_rng(seed).normal(0, NOISE, angles.shape)
    names = ["time", *(f"{name}.torque" for name in ("base", "shoulder", "elbow")), *Arm.coordinates]
    np.savetxt(path, np.column_stack([time, given, measured]), delimiter=",", header=",".join(names), comments="")


class Fit:
    """The residuals of a recorded motion, divided by the noise, and their exact derivatives.

    Unknown are all parameters of the model, and the angles and rates at the start. Only the first `steps` steps count.
    """

    def __init__(self, path, steps=STEPS):
        table = np.loadtxt(path, delimiter=",", skiprows=1)[: steps + 1]
        self.given, self.measured = np.ascontiguousarray(table[:-1, 1:4]), table[:, 4:7]
        self.names = [*Arm.parameters, *Arm.coordinates, *Arm.rates]

    def split(self, unknown):
        count = len(Arm.parameters)
        return Arm(**dict(zip(Arm.parameters, unknown[:count]))), unknown[count:]

    def residuals(self, unknown):
        model, start = self.split(unknown)
        angles = model.rollout(start, self.given, STEP, len(self.given))[:, :3]
        return ((angles - self.measured) / NOISE).ravel()

    def jacobian(self, unknown):
        model, start = self.split(unknown)
        trajectory = model.rollout(start, self.given, STEP, len(self.given))
        by_start, by_parameters = sensitivities(model, trajectory, self.given, STEP)
        together = np.concatenate([by_parameters, by_start], axis=2)
        return together[:, :3].reshape(-1, together.shape[2]) / NOISE


def calibrate(path):
    """Returns names, estimates, halves of their 95 % intervals, and the standard deviation of the residuals in rad."""
    unknown = np.array([Arm().get(name) for name in Arm.parameters])
    unknown = np.concatenate([unknown, Fit(path).measured[0], np.zeros(3)])
    # With wrong parameters a long motion is so far off that its residuals lead nowhere; a short one is not.
    for steps in (STEPS // 8, STEPS // 4, STEPS // 2, STEPS):
        fit = Fit(path, steps)
        # Levenberg and Marquardt's method.
        found = least_squares(fit.residuals, unknown, fit.jacobian, method="lm", x_scale="jac", max_nfev=100)
        unknown = found.x
    free = len(found.fun) - len(found.x)
    variance = found.fun @ found.fun / free
    deviations = np.sqrt(variance * np.diag(np.linalg.inv(found.jac.T @ found.jac)))
    return fit.names, found.x, t.ppf(0.975, free) * deviations, NOISE * np.sqrt(variance)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", default=".", help="the folder for the recorded motion")
    parser.add_argument("--seed", type=int, default=2, help="of the noise")
    given = parser.parse_args()
    path = pathlib.Path(given.output) / "motion.csv"
    record(given.seed, path)
    names, values, halves, noise = calibrate(path)
    for name, value, half in zip(names, values, halves):
        if name in TRUE:
            unit = Arm.parameters.units[names.index(name)]
            print(f"{name:10} {value:9.5f} ± {half:.5f} {unit:8} (true: {TRUE[name]})")
    print(f"residuals: {1e3 * noise:.4f} mrad")


if __name__ == "__main__":
    main()
