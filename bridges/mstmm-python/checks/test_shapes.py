"""Results of any number of rows have the same shapes, also without rows and without degrees of freedom."""

import numpy as np
import pytest
from mstmm_robots import CartPole, FourBar, Hyq, Plate, Recording, Rope
from mstmm_robots.gradients import pullback, sensitivities

N, EVERY = 4, 2
METHODS = ("rk4", "semi_implicit_euler", "linearly_implicit_euler")


def calls(model, rows):
    """Returns the results of all functions of a model for states of the shape (rows, nx), or (nx,) for no number."""
    x, n, nu = model.initial(rows), len(model.rates), len(model.inputs)
    shape = x.shape[:-1]
    u, steps, given = np.zeros(shape + (nu,)), np.zeros(shape + (N, nu)), np.zeros(shape + (n,))
    results = {name: getattr(model, name)(x, u) for name in ("accelerations", "assemble", "solve")}
    results["nan"] = model.accelerations(x, u, errors="nan", threads=2)
    results["energy"] = model.energy(x)
    for method in METHODS:
        results[method] = model.rollout(x, steps, 1e-3, N, method=method)
        model.step(x.copy(), u, 1e-3, N, method=method)
    results["rollout"] = model.rollout(x, None, 1e-3, N, every=EVERY)
    results["no step"] = model.rollout(x, None, 1e-3, 0)
    for frame in model.frames[-1:]:
        results["kinematics"], results["jacobian"] = model.kinematics(frame, x), model.jacobian(frame, x, u)
    for name, _, is_there, given_len, _ in model._methods:
        if not is_there or name == "dynamic_parameters":
            continue
        function = getattr(model, name)
        if name == "push":
            results[name] = function(x, u), function(x, d_rates=given, d_inputs=np.zeros(nu))
        elif given_len or name in ("inverse_dynamics", "pull", "regressor") or name.endswith("_times"):
            results[name] = function(x, given), function(x, np.zeros(n), u)
        else:
            results[name] = function(x, u)
    if rows is not None:
        if "pull" in model.answers and any(name == "pull" and is_there for name, _, is_there, *_ in model._methods):
            trajectory = np.repeat(x[:, None], N + 1, axis=1)
            results["pullback"] = pullback(model, trajectory, steps, 1e-3, trajectory)
        recording = Recording(model)
        recording.record(x, u, 1e-3 * np.arange(rows))
        assert len(recording) == rows
    return dict(arrays(results, ""))


def arrays(value, path):
    """Yields all arrays of a result with their paths."""
    if isinstance(value, np.ndarray) or np.isscalar(value):
        yield path, np.shape(value)
    elif isinstance(value, tuple):
        yield from arrays(dict(enumerate(value)), path)
    else:
        for key, entry in (value if isinstance(value, dict) else vars(value)).items():
            yield from arrays(entry, f"{path}.{key}")


@pytest.mark.parametrize("Model", [CartPole, FourBar, Hyq, Plate, Rope])
def test_shapes_do_not_depend_on_the_number_of_rows(Model):
    model = Model()
    expected = {name: shape[1:] for name, shape in calls(model, 7).items()}
    for rows in (0, 1, None):
        own = () if rows is None else (rows,)
        # Gradients of rollouts need an axis of rows.
        known = {name: own + shape for name, shape in expected.items() if rows is not None or not name.startswith(".pullback")}
        assert calls(model, rows) == known, rows


def test_shapes_without_rows_are_those_of_the_docs():
    model = Rope()
    x, n = model.initial(0), len(model.rates)
    assert x.shape == (0, model.nx) and model.accelerations(x).shape == (0, n)
    for name in ("bias_efforts", "gravity_efforts", "passive_efforts"):
        assert getattr(model, name)(x).shape == (0, n), name
    linear = model.linearize(x)
    assert linear.accelerations.shape == (0, n) and linear.a.shape == (0, 2 * n, 2 * n)
    assert [value.shape for value in model.energy(x)] == [(0,)] * 2
    assert model.momentum(x).mass.shape == (0,)
    assert model.rollout(x, None, 1e-3, 4).shape == (0, 5, model.nx)


def test_a_chain_without_degrees_of_freedom_has_empty_gradients():
    model = Plate()
    trajectory = model.rollout(model.initial(3), None, 1e-3, N)
    assert trajectory.shape == (3, N + 1, 0)
    by_x, by_u, by_p = pullback(model, trajectory, None, 1e-3, trajectory)
    assert (by_x.shape, by_u.shape, by_p.shape) == ((3, 0), (3, N, 0), (3, 0))
    assert [value.shape for value in sensitivities(model, trajectory[0], None, 1e-3)] == [(N + 1, 0, 0)] * 2
