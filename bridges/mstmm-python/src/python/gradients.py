"""Rollouts with gradients, by the products `pull` of the library: for JAX, PyTorch and numpy.

The model needs the answer `pull`. Coordinates and rates must correspond one by one: pins, sliders and the like, no
quaternions. The method is the classical Runge-Kutta method with inputs that are held over a step, as that of `rollout`.
"""

import numpy as np


def _checked(model):
    if "pull" not in model.answers:
        raise NotImplementedError("the chain's setting `answers` omits `pull`: write `answers = [..., pull];` in the chain")
    if "Quaternion" in model.coordinates.kinds or len(model.coordinates) != len(model.rates):
        raise NotImplementedError("gradients of rollouts need coordinates without quaternions")
    if any(keyword in ("elastic", "plane_elastic") for _, keyword, _ in model.hinges):
        raise NotImplementedError("gradients of rollouts need hinges whose rates are those of their coordinates")


def _rate(model, x, u):
    nq = len(model.coordinates)
    return np.concatenate([x[:, nq:], model.accelerations(x, u)], axis=1)


def _pulled(model, x, u, weights):
    """Returns the products of weights with the derivatives of the rate of change: by state, inputs, parameters."""
    nq = len(model.coordinates)
    result = model.pull(x, np.ascontiguousarray(weights[:, nq:]), u)
    by_x = np.concatenate([result.coordinates, weights[:, :nq] + result.rates], axis=1)
    return by_x, result.inputs, result.parameters


def _inputs_of(inputs, k):
    return None if inputs is None else np.ascontiguousarray(inputs[:, k])


def pullback(model, trajectory, inputs, h, weights):
    """Returns the gradients of ``sum(weights * trajectory)`` with respect to start, inputs and parameters.

    ``trajectory`` is that of ``model.rollout(x, inputs, h, n)`` with all steps, ``inputs`` have the shape (rows, n, nu) or
    are ``None``. The gradients have the shapes (rows, nx), (rows, n, nu) and (rows, parameters).
    """
    _checked(model)
    rows, count, _ = trajectory.shape
    n = count - 1
    by_inputs = np.zeros((rows, n, len(model.inputs)))
    by_parameters = np.zeros((rows, len(model.parameters)))
    gradient = np.array(weights[:, n], np.float64)
    for k in reversed(range(n)):
        x, u = np.ascontiguousarray(trajectory[:, k]), _inputs_of(inputs, k)
        # The stages, and back through x' = x + h/6 (k1 + 2 k2 + 2 k3 + k4).
        stages, factors = [x], (h / 2, h / 2, h)
        for factor in factors:
            stages.append(x + factor * _rate(model, stages[-1], u))
        weight = [gradient * (h / 6 * part) for part in (1, 2, 2, 1)]
        by_start = gradient.copy()
        for stage in (3, 2, 1, 0):
            by_x, by_u, by_p = _pulled(model, stages[stage], u, weight[stage])
            by_inputs[:, k] += by_u
            by_parameters += by_p
            by_start += by_x
            if stage > 0:
                weight[stage - 1] += factors[stage - 1] * by_x
        gradient = by_start + weights[:, k]
    return gradient, by_inputs, by_parameters


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

    ``x`` has the shape (rows, nx), ``inputs`` (rows, n, nu), ``parameters`` one value for each of ``model.parameters``. It
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
    """Returns a function of PyTorch, as `jax_rollout` does; its tensors are float64 on the CPU."""
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
