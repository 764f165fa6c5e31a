"""Gradients of rollouts against differences of rollouts, and by JAX."""

import numpy as np
import pytest
from mstmm_robots import CartPole, Hyq, Ur5
from mstmm_robots.gradients import pullback, sensitivities

H, N = 1e-2, 15


def cost(model, x, u, weights):
    return (weights * model.rollout(x, u, H, N)).sum(axis=(1, 2))


@pytest.mark.parametrize("Model", [CartPole, Ur5])
def test_gradients_are_limits_of_differences(Model):
    print("seed 11")
    rng, model, rows = np.random.default_rng(11), Model(), 3
    nx, nu = model.nx, len(model.inputs)
    x, u = rng.normal(size=(rows, nx)) * 0.5, rng.normal(size=(rows, N, nu))
    weights = rng.normal(size=(rows, N + 1, nx))
    by_x, by_u, by_p = pullback(model, model.rollout(x, u, H, N), u, H, weights)
    # Central differences of step d: rounding 1e-13 / d and curvature d^2 times a third derivative below 1e3.
    d = 1e-5
    scale = 1 + np.abs(by_x).max()
    for k in range(nx):
        change = np.zeros_like(x)
        change[:, k] = d
        difference = (cost(model, x + change, u, weights) - cost(model, x - change, u, weights)) / (2 * d)
        np.testing.assert_allclose(by_x[:, k], difference, atol=1e-6 * scale)
    for k in (0, 7, N - 1):
        change = np.zeros_like(u)
        change[:, k, 0] = d
        difference = (cost(model, x, u + change, weights) - cost(model, x, u - change, weights)) / (2 * d)
        np.testing.assert_allclose(by_u[:, k, 0], difference, atol=1e-6 * scale)
    for name in model.parameters:
        sides = []
        for sign in (1, -1):
            other = model.__copy__()
            other.set(name, model.get(name) + sign * d)
            sides.append(cost(other, x, u, weights))
        index = model.parameters.index(name)
        np.testing.assert_allclose(by_p[:, index], (sides[0] - sides[1]) / (2 * d), atol=1e-6 * (1 + np.abs(by_p).max()))


def base_states(rng, rows):
    """Returns random states of HyQ with unit quaternions, and rates below 1 rad/s and 1 m/s."""
    model = Hyq()
    x = model.initial(rows) + 0.2 * rng.normal(size=(rows, model.nx))
    x[:, 3:7] = rng.normal(size=(rows, 4))
    x[:, 3:7] /= np.linalg.norm(x[:, 3:7], axis=1)[:, None]
    x[:, len(model.coordinates) :] = 0.5 * rng.normal(size=(rows, len(model.rates)))
    return model, x


def turned(x, axis, angle):
    """Returns states whose base is turned about an axis of the base: q (1, angle / 2) of unit length."""
    half = np.zeros(3)
    half[axis] = np.sin(angle / 2)
    w, r = x[:, 3:4], x[:, 4:7]
    turned = x.copy()
    turned[:, 3:4] = np.cos(angle / 2) * w - (r * half).sum(axis=1, keepdims=True)
    turned[:, 4:7] = np.cos(angle / 2) * r + w * half + np.cross(r, half)
    return turned


@pytest.mark.parametrize("h", [4e-3, 2e-3])
def test_gradients_of_quaternions_are_limits_of_differences_along_the_rates(h):
    print("seed 13")
    rng, rows = np.random.default_rng(13), 2
    model, x = base_states(rng, rows)
    n, nq = 10, len(model.coordinates)
    u = rng.normal(size=(rows, n, len(model.inputs)))
    weights = rng.normal(size=(rows, n + 1, model.nx))

    def cost(x, u):
        return (weights * model.rollout(x, u, h, n)).sum(axis=(1, 2))

    by_x, by_u, _ = pullback(model, model.rollout(x, u, h, n), u, h, weights)
    # Orthogonal to the quaternion up to rounding.
    assert np.abs((by_x[:, 3:7] * x[:, 3:7]).sum(axis=1)).max() < 1e-12 * np.abs(by_x).max()
    # Central differences of step d: rounding 1e-13 / d, and curvature d^2. The linear equation of displacements is
    # integrated with an error of order h^4: measured 2e-8 of the largest gradient for 4 ms, so that 1e-6 has a margin.
    d, scale = 1e-5, 1 + np.abs(by_x).max()
    for axis in range(3):
        half = 0.5 * np.stack([-x[:, 4 + axis], *turned_columns(x, axis)], axis=1)
        expected = (by_x[:, 3:7] * half).sum(axis=1)
        difference = (cost(turned(x, axis, d), u) - cost(turned(x, axis, -d), u)) / (2 * d)
        np.testing.assert_allclose(expected, difference, atol=1e-6 * scale)
    for entry in (0, 2, 8, 15, nq, nq + 3, nq + 5, nq + 11):
        change = np.zeros_like(x)
        change[:, entry] = d
        difference = (cost(x + change, u) - cost(x - change, u)) / (2 * d)
        np.testing.assert_allclose(by_x[:, entry], difference, atol=1e-6 * scale, err_msg=str(entry))
    for k in (0, n - 1):
        change = np.zeros_like(u)
        change[:, k, 4] = d
        difference = (cost(x, u + change) - cost(x, u - change)) / (2 * d)
        np.testing.assert_allclose(by_u[:, k, 4], difference, atol=1e-6 * scale)


def turned_columns(x, axis):
    """Returns x, y, z of the product of a quaternion with a unit vector of the base: w e + r x e."""
    unit = np.eye(3)[axis]
    return (x[:, 3:4] * unit + np.cross(x[:, 4:7], unit)).T


def test_the_error_of_quaternion_gradients_has_the_order_of_the_steps():
    """The difference from the derivative of the computed steps has the order h^4: with half the step, a sixteenth."""
    print("seed 14")
    model, x = base_states(np.random.default_rng(14), 1)
    entry = len(model.coordinates) + 4
    x[:, entry - 1 : entry + 2] *= 6
    weight = np.random.default_rng(15).normal(size=model.nx)
    errors = []
    for n in (4, 8):
        h = 0.16 / n
        trajectory = model.rollout(x, None, h, n)
        weights = np.zeros_like(trajectory)
        weights[:, -1] = weight
        by_x, _, _ = pullback(model, trajectory, None, h, weights)

        def difference(d):
            change = np.eye(model.nx)[entry] * d
            ends = [model.rollout(x + sign * change, None, h, n)[0, -1] @ weight for sign in (1, -1)]
            return (ends[0] - ends[1]) / (2 * d)

        # Richardson's extrapolation: the error of d^2 vanishes.
        exact = (4 * difference(1e-3) - difference(2e-3)) / 3
        errors.append(abs(by_x[0, entry] - exact) / abs(exact))
    assert 8 < errors[0] / errors[1] < 32 and errors[1] > 1e-10, errors


@pytest.mark.parametrize("Model", [CartPole, Ur5, Hyq])
def test_sensitivities_are_the_transpose_of_gradients(Model):
    """The products of a matrix and of its transpose agree up to rounding."""
    print("seed 16")
    rng = np.random.default_rng(16)
    model, x = base_states(rng, 1) if Model is Hyq else (Model(), 0.5 * rng.normal(size=(1, Model().nx)))
    h, n = 5e-3, 8
    u = rng.normal(size=(1, n, len(model.inputs)))
    trajectory = model.rollout(x, u, h, n)
    weights = rng.normal(size=trajectory.shape)
    by_x, _, by_p = pullback(model, trajectory, u, h, weights)
    by_start, by_parameters = sensitivities(model, trajectory[0], u[0], h)
    products = np.einsum("kx,kxc->c", weights[0], by_start)
    scale = np.abs(products).max()
    np.testing.assert_allclose(np.einsum("kx,kxp->p", weights[0], by_parameters), by_p[0], atol=1e-11 * scale)
    if Model is not Hyq:
        np.testing.assert_allclose(products, by_x[0], atol=1e-11 * scale)
        return
    nq, nv = len(model.coordinates), len(model.rates)
    for axis in range(3):
        half = 0.5 * np.concatenate([[-x[0, 4 + axis]], [c[0] for c in turned_columns(x, axis)]])
        np.testing.assert_allclose(products[3 + axis], by_x[0, 3:7] @ half, atol=1e-11 * scale)
    plain = [*range(3), *range(7, nq)]
    np.testing.assert_allclose(products[[*range(3), *range(6, nv)]], by_x[0, plain], atol=1e-11 * scale)
    np.testing.assert_allclose(products[nv:], by_x[0, nq:], atol=1e-11 * scale)


def test_wrong_arguments_are_refused():
    model, n = Ur5(), 3
    x, u = model.initial(2), np.zeros((2, n, 6))
    trajectory = model.rollout(x, u, H, n)
    with pytest.raises(ValueError, match=r"trajectory must have the shape \(rows, n \+ 1, 12\).*not \(4, 12\)"):
        pullback(model, trajectory[0], u, H, trajectory)
    with pytest.raises(ValueError, match=r"inputs must have the shape \(2, 3, 6\) for a trajectory of 3 steps, not \(2, 4, 6\)"):
        pullback(model, trajectory, np.zeros((2, 4, 6)), H, trajectory)
    with pytest.raises(ValueError, match=r"weights must have the shape of the trajectory, \(2, 4, 12\), not \(2, 12\)"):
        pullback(model, trajectory, u, H, trajectory[:, 0])
    with pytest.raises(TypeError, match="weights must be an array of float64, not object"):
        pullback(model, trajectory, u, H, None)
    with pytest.raises(ValueError, match=r"trajectory must have the shape \(n \+ 1, 12\)"):
        sensitivities(model, trajectory, u[0], H)
    with pytest.raises(ValueError, match="h must be a finite step"):
        pullback(model, trajectory, u, float("nan"), trajectory)
    u[1, 2, 0] = np.inf
    with pytest.raises(FloatingPointError, match="row 1, step 2: `.*` is not finite"):
        pullback(model, trajectory, u, H, trajectory)


def test_gradients_of_no_step_are_the_weights():
    model, rng = CartPole(), np.random.default_rng(18)
    print("seed 18")
    x, weights = rng.normal(size=(3, 4)), rng.normal(size=(3, 1, 4))
    by_x, by_u, by_p = pullback(model, x[:, None], np.zeros((3, 0, 1)), H, weights)
    assert np.array_equal(by_x, weights[:, 0]) and by_u.shape == (3, 0, 1) and not by_p.any()
    by_start, by_parameters = sensitivities(model, x[:1], None, H)
    assert np.array_equal(by_start, np.eye(4)[None]) and not by_parameters.any()


def test_jax_differentiates_a_rollout():
    jax = pytest.importorskip("jax")
    from mstmm_robots.gradients import jax_rollout

    jax.config.update("jax_enable_x64", True)
    rng, model = np.random.default_rng(12), CartPole()
    x, u = rng.normal(size=(2, 4)), rng.normal(size=(2, N, 1))
    p, target = np.array([1.2, 0.15, 0.6]), rng.normal(size=(2, N + 1, 4))
    rollout = jax_rollout(model, H)

    def loss(x, u, p):
        return ((rollout(x, u, p) - target) ** 2).sum()

    by_x, by_u, by_p = jax.jit(jax.grad(loss, argnums=(0, 1, 2)))(x, u, p)
    own = CartPole(cart_mass=p[0], bob_mass=p[1], length=p[2])
    trajectory = own.rollout(x, u, H, N)
    assert np.array_equal(np.asarray(rollout(x, u, p)), trajectory)
    expected = pullback(own, trajectory, u, H, 2 * (trajectory - target))
    for got, value in zip((by_x, by_u, by_p), (*expected[:2], expected[2].sum(0))):
        np.testing.assert_allclose(np.asarray(got), value, rtol=1e-12, atol=1e-12)
    # A few steps of descent reduce the loss.
    losses = [loss(x, u, p)]
    for _ in range(5):
        u = u - 1e-2 * np.asarray(jax.grad(loss, argnums=1)(x, u, p))
        losses.append(loss(x, u, p))
    assert all(after < before for before, after in zip(losses, losses[1:]))
