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
    if any(keyword in ("elastic", "plane_elastic") for _, keyword, _ in model.hinges):
        raise NotImplementedError("gradients of rollouts need hinges whose rates are those of their coordinates")


class _Space:
    """The states of a model and their displacements: along the rates, then of the rates.

    A quaternion q has three rates w, in outboard axes: its derivative is q (0, w) / 2.
    """

    def __init__(self, model):
        self.model, self.nq, self.nv = model, len(model.coordinates), len(model.rates)
        # The first entries of quaternions and of their rates, and the entries of all other coordinates and rates.
        self.quaternions, self.plain = [], ([], [])
        coordinate, rate = 0, 0
        while coordinate < self.nq:
            if model.coordinates.kinds[coordinate] == "Quaternion":
                self.quaternions.append((coordinate, rate))
                coordinate, rate = coordinate + 4, rate + 3
            else:
                self.plain[0].append(coordinate)
                self.plain[1].append(rate)
                coordinate, rate = coordinate + 1, rate + 1

    @staticmethod
    def _columns(quaternion):
        """Returns the matrix N of the derivatives N w of quaternions, for each row."""
        w, x, y, z = np.moveaxis(quaternion, -1, 0)
        rows = [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
        return 0.5 * np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)

    def along(self, x, displacement):
        """Returns the changes of the coordinates, to first order, of displacements along the rates."""
        change = np.zeros(displacement.shape[:-1] + (self.nq,))
        change[..., self.plain[0]] = displacement[..., self.plain[1]]
        for q, v in self.quaternions:
            product = self._columns(x[..., q : q + 4]) @ displacement[..., v : v + 3, None]
            change[..., q : q + 4] = product[..., 0]
        return change

    def against(self, x, weights):
        """Returns the products of weights of the coordinates with `along`: weights of displacements."""
        result = np.zeros(weights.shape[:-1] + (self.nv,))
        result[..., self.plain[1]] = weights[..., self.plain[0]]
        for q, v in self.quaternions:
            product = weights[..., None, q : q + 4] @ self._columns(x[..., q : q + 4])
            result[..., v : v + 3] = product[..., 0, :]
        return result

    def gradient(self, x, weights):
        """Returns the gradient by states whose products with changes of states are those of weights with displacements.

        That by a quaternion is orthogonal to it, since states have unit quaternions.
        """
        coordinates = self.along(x, weights[..., : self.nv])
        for q, _ in self.quaternions:
            # N has orthogonal columns of length 1/2.
            coordinates[..., q : q + 4] *= 4
        return np.concatenate([coordinates, weights[..., self.nv :]], axis=-1)

    def rate(self, x, u):
        """Returns the derivatives of states."""
        return np.concatenate([self.along(x, x[:, self.nq :]), self.model.accelerations(x, u)], axis=1)

    def stage(self, x, change):
        """Returns states that are moved, with quaternions of unit length."""
        moved = x + change
        for q, _ in self.quaternions:
            moved[:, q : q + 4] /= np.linalg.norm(moved[:, q : q + 4], axis=1, keepdims=True)
        return moved

    def stages(self, x, u, h):
        """Returns the states of the four stages of a step."""
        stages = [x]
        for factor in _factors(h):
            stages.append(self.stage(x, factor * self.rate(stages[-1], u)))
        return stages

    def turned(self, x, displacement, sign):
        """Returns -w x d, the rate of a displacement d of a quaternion due to its own rate w; its transpose if the sign
        is -1."""
        result = np.zeros(displacement.shape[:-1] + (self.nv,))
        for _, v in self.quaternions:
            rates = x[..., self.nq + v : self.nq + v + 3]
            result[..., v : v + 3] = -sign * np.cross(rates, displacement[..., v : v + 3])
        return result

    def pulled(self, x, u, weights):
        """Returns the products of weights with the derivatives of the rates of displacements: by displacement, inputs,
        parameters."""
        nv = self.nv
        result = self.model.pull(x, np.ascontiguousarray(weights[:, nv:]), u)
        by_coordinates = result.coordinates + self.turned(x, weights[:, :nv], -1)
        return np.concatenate([by_coordinates, weights[:, :nv] + result.rates], axis=1), result.inputs, result.parameters

    def pushed(self, x, u, displacement, parameters):
        """Returns the rates of displacements, with changes of the parameters."""
        nv = self.nv
        result = self.model.push(x, u, d_coordinates=displacement[:, :nv], d_rates=displacement[:, nv:], d_parameters=parameters)
        by_rates = displacement[:, nv:] + self.turned(x, displacement[:, :nv], 1)
        return np.concatenate([by_rates, result.change], axis=1)


def _factors(h):
    """Returns the factors of a stage's rate in the next one."""
    return h / 2, h / 2, h


# The shares of the stages in a step x' = x + h (k1 + 2 k2 + 2 k3 + k4) / 6.
_SHARES = (1 / 6, 2 / 6, 2 / 6, 1 / 6)


def _inputs_of(inputs, k):
    return None if inputs is None else np.ascontiguousarray(inputs[:, k])


def pullback(model, trajectory, inputs, h, weights):
    """Returns the gradients of ``sum(weights * trajectory)`` with respect to start, inputs and parameters.

    ``trajectory`` is that of ``model.rollout(x, inputs, h, n)`` with all steps, ``inputs`` have the shape (rows, n, nu) or
    are ``None``. The gradients have the shapes (rows, nx), (rows, n, nu) and (rows, parameters). The gradient by a quaternion
    is orthogonal to the quaternion.
    """
    _checked(model)
    space, nq = _Space(model), len(model.coordinates)
    rows, count, _ = trajectory.shape
    by_inputs = np.zeros((rows, count - 1, len(model.inputs)))
    by_parameters = np.zeros((rows, len(model.parameters)))

    def weights_of(k):
        own = weights[:, k]
        return np.concatenate([space.against(trajectory[:, k], own[:, :nq]), own[:, nq:]], axis=1)

    gradient = weights_of(count - 1)
    for k in reversed(range(count - 1)):
        x, u = np.ascontiguousarray(trajectory[:, k]), _inputs_of(inputs, k)
        stages = space.stages(x, u, h)
        weight = [h * share * gradient for share in _SHARES]
        by_start = gradient.copy()
        for stage in (3, 2, 1, 0):
            by_x, by_u, by_p = space.pulled(stages[stage], u, weight[stage])
            by_inputs[:, k] += by_u
            by_parameters += by_p
            by_start += by_x
            if stage > 0:
                weight[stage - 1] += _factors(h)[stage - 1] * by_x
        gradient = by_start + weights_of(k)
    return space.gradient(trajectory[:, 0], gradient), by_inputs, by_parameters


def sensitivities(model, trajectory, inputs, h):
    """Returns the derivatives of a trajectory with respect to its start and the parameters, for fits by least squares.

    ``trajectory`` has the shape (n + 1, nx), that of ``model.rollout(x, inputs, h, n)``, and ``inputs`` (n, nu) or are
    ``None``. The derivatives have the shapes (n + 1, nx, 2 * rates) and (n + 1, nx, parameters). A column of the first one
    is for a displacement of the start along a rate, then for a change of a rate; without quaternions these are the
    derivatives by the entries of the start. The model needs the answer `push`.
    """
    _checked(model, "push")
    space, nq, nv = _Space(model), len(model.coordinates), len(model.rates)
    columns, own = 2 * nv, len(model.parameters)
    displacement = np.concatenate([np.eye(columns), np.zeros((own, columns))])
    parameters = np.concatenate([np.zeros((columns, own)), np.eye(own)])
    results = np.empty((len(trajectory), trajectory.shape[1], columns + own))
    for k, state in enumerate(trajectory):
        x = np.tile(state, (columns + own, 1))
        results[k, :nq] = space.along(x, displacement[:, :nv]).T
        results[k, nq:] = displacement[:, nv:].T
        if k + 1 == len(trajectory):
            break
        u = None if inputs is None else np.ascontiguousarray(inputs[k])
        stages = space.stages(state[None], u, h)
        change, total = np.zeros_like(displacement), np.zeros_like(displacement)
        for stage, share, factor in zip(stages, _SHARES, (*_factors(h), 0.0)):
            rate = space.pushed(np.tile(stage, (columns + own, 1)), u, displacement + change, parameters)
            total += share * rate
            change = factor * rate
        displacement = displacement + h * total
    return results[..., :columns], results[..., columns:]


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
