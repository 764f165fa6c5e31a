"""Gradients of rollouts against differences of rollouts, and by JAX."""

import numpy as np
import pytest
from mstmm_robots import CartPole, Hyq, Ur5
from mstmm_robots.gradients import pullback

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


def test_models_with_quaternions_are_refused():
    with pytest.raises(NotImplementedError, match="without quaternions"):
        pullback(Hyq(), np.zeros((1, 2, 37)), None, H, np.zeros((1, 2, 37)))


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
