"""Rollouts with derivatives, by the products `pull` and `push` of the library: for JAX, PyTorch, scipy and numpy.

The method is the classical Runge-Kutta method with inputs that are held over a step, as that of `rollout`. Derivatives are
those of the computed steps. Of models with quaternions they are computed along the rates: the linear equation of small
displacements is integrated by the same method, with an error of the same order as that of the steps, h^4.
"""

import numpy as np


def _checked(model, answer="pull"):
    if answer not in model.answers:
        raise NotImplementedError(
            f"the chain's setting `answers` omits `{answer}`: write `answers = [..., {answer}];` in the chain"
        )
    if any(name == answer and not is_there for name, _, is_there, *_ in model._methods):
        raise NotImplementedError(f"a closed chain does not have `{answer}`")
    if any(keyword in ("elastic", "plane_elastic") for _, keyword, _ in model.hinges):
        raise NotImplementedError("gradients of rollouts need hinges whose rates are those of their coordinates")


def _steps(model, trajectory, inputs, shape):
    """Returns the number of steps of a trajectory, whose shape and whose inputs are checked."""
    if trajectory.ndim != len(shape) or trajectory.shape[-1] != model.nx or trajectory.shape[-2] == 0:
        form = ", ".join(shape)
        raise ValueError(f"trajectory must have the shape ({form}), that of a rollout, not {trajectory.shape}")
    n, nu = trajectory.shape[-2] - 1, len(model.inputs)
    expected = trajectory.shape[:-2] + (n, nu)
    if inputs is not None and np.shape(inputs) != expected:
        raise ValueError(f"inputs must have the shape {expected} for a trajectory of {n} steps, not {np.shape(inputs)}")
    return n


def _values(name, value):
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} must be an array of float64, not {array.dtype}")
    return np.ascontiguousarray(array, np.float64)


def pullback(model, trajectory, inputs, h, weights):
    """Returns the gradients of ``sum(weights * trajectory)`` with respect to start, inputs and parameters.

    ``trajectory`` is that of ``model.rollout(x, inputs, h, n)`` with all steps, ``inputs`` have the shape (rows, n, nu) or
    are ``None``. ``h`` is the step in s. ``weights`` have the shape of the trajectory. The gradients have the shapes (rows, nx),
    (rows, n, nu) and (rows, parameters), by the units of states, inputs and parameters. The gradient by a quaternion is
    orthogonal to the quaternion.
    """
    _checked(model)
    trajectory, weights = _values("trajectory", trajectory), _values("weights", weights)
    n = _steps(model, trajectory, inputs, ("rows", "n + 1", str(model.nx)))
    if weights.shape != trajectory.shape:
        raise ValueError(f"weights must have the shape of the trajectory, {trajectory.shape}, not {weights.shape}")
    rows, nx, nu = len(trajectory), model.nx, len(model.inputs)
    given = np.concatenate([trajectory.reshape(rows, (n + 1) * nx), weights.reshape(rows, (n + 1) * nx)], axis=1)
    inputs = _inputs(inputs, n)
    raw = model._run("pullback", (h, n), np.ascontiguousarray(trajectory[:, 0]), inputs, given)
    return raw[:, :nx].copy(), raw[:, nx : nx + n * nu].reshape(rows, n, nu), raw[:, nx + n * nu :].copy()


def _inputs(inputs, n):
    # A trajectory of no step has no inputs.
    return None if inputs is None or n == 0 else _values("inputs", inputs)


def sensitivities(model, trajectory, inputs, h):
    """Returns the derivatives of a trajectory with respect to its start and the parameters, for fits by least squares.

    ``trajectory`` has the shape (n + 1, nx), that of ``model.rollout(x, inputs, h, n)``, and ``inputs`` (n, nu) or are
    ``None``; ``h`` is the step in s. The derivatives are in the units of states by those of rates or parameters, with the
    shapes (n + 1, nx, 2 * rates) and (n + 1, nx, parameters). A column of the first one
    is for a displacement of the start along a rate, then for a change of a rate; without quaternions these are the
    derivatives by the entries of the start. The model needs the answer `push`.
    """
    _checked(model, "push")
    trajectory = _values("trajectory", trajectory)
    n = _steps(model, trajectory, inputs, ("n + 1", str(model.nx)))
    columns, own = 2 * len(model.rates), len(model.parameters)
    # A row for each column: a unit displacement of the start or a unit change of a parameter.
    start = np.tile(trajectory[0], (columns + own, 1))
    inputs = _inputs(inputs, n)
    if inputs is not None:
        inputs = np.tile(inputs, (columns + own, 1, 1))
    raw = model._run("pushforward", (h, n), start, inputs, np.eye(columns + own))
    results = np.moveaxis(raw.reshape(columns + own, n + 1, model.nx), 0, -1)
    return results[..., :columns].copy(), results[..., columns:].copy()


def _forward(model, h, x, inputs, parameters):
    own = model if parameters is None else _with(model, parameters)
    x, inputs = np.ascontiguousarray(x, np.float64), np.ascontiguousarray(inputs, np.float64)
    return own, inputs, own.rollout(x, inputs, h, inputs.shape[1])


def _with(model, parameters):
    own = model.__copy__()
    for index, value in enumerate(np.asarray(parameters, np.float64)):
        own._set_parameter(index, float(value))
    return own


def jax_rollout(model, h):
    """Returns a function of JAX: ``rollout(x, inputs, parameters)`` with the trajectory (rows, n + 1, nx).

    ``x`` has the shape (rows, nx), ``inputs`` (rows, n, nu), ``parameters`` one value for each of ``model.parameters``, in
    the units of the model; ``h`` is the step in s. It
    can be differentiated (reverse mode) and compiled. JAX must use 64 bits: ``jax.config.update("jax_enable_x64", True)``.
    """
    import jax

    _checked(model)
    if not jax.config.read("jax_enable_x64"):
        raise ValueError('JAX must use 64 bits: jax.config.update("jax_enable_x64", True)')

    def shape(x, inputs):
        return jax.ShapeDtypeStruct((x.shape[0], inputs.shape[1] + 1, x.shape[1]), np.float64)

    def compute(x, inputs, parameters):
        return _forward(model, h, x, inputs, parameters)[2]

    def back(x, inputs, parameters, weights):
        own, inputs, trajectory = _forward(model, h, x, inputs, parameters)
        by_x, by_inputs, by_parameters = pullback(own, trajectory, inputs, h, np.asarray(weights))
        return by_x, by_inputs, by_parameters.sum(0)

    @jax.custom_vjp
    def rollout(x, inputs, parameters):
        return jax.pure_callback(compute, shape(x, inputs), x, inputs, parameters)

    def forward(x, inputs, parameters):
        return rollout(x, inputs, parameters), (x, inputs, parameters)

    def backward(saved, weights):
        shapes = tuple(jax.ShapeDtypeStruct(value.shape, np.float64) for value in saved)
        return jax.pure_callback(back, shapes, *saved, weights)

    rollout.defvjp(forward, backward)
    return rollout


def torch_rollout(model, h):
    """Returns a function of PyTorch, as `jax_rollout` does, with its shapes and units; its tensors are float64 on the CPU."""
    import torch

    _checked(model)

    class Rollout(torch.autograd.Function):
        @staticmethod
        def forward(context, x, inputs, parameters):
            own, values, trajectory = _forward(model, h, x.detach().numpy(), inputs.detach().numpy(), parameters.detach().numpy())
            context.kept = own, values, trajectory
            return torch.from_numpy(trajectory)

        @staticmethod
        def backward(context, weights):
            own, values, trajectory = context.kept
            by_x, by_inputs, by_parameters = pullback(own, trajectory, values, h, weights.numpy())
            return tuple(torch.from_numpy(value) for value in (by_x, by_inputs, by_parameters.sum(0)))

    return Rollout.apply
