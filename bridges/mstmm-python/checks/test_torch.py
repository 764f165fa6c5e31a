"""Gradients of rollouts by PyTorch. `bridges/check --all` runs this file, with the PyTorch of Debian."""

import numpy as np
import torch
from mstmm_robots import CartPole
from mstmm_robots.gradients import pullback, torch_rollout
from test_gradients import H, N, base_states


def test_torch_differentiates_a_rollout():
    rng = np.random.default_rng(17)
    model, x = base_states(rng, 2)
    u, target = rng.normal(size=(2, N, len(model.inputs))), rng.normal(size=(2, N + 1, model.nx))
    values = [torch.tensor(value, requires_grad=True) for value in (x, u, np.zeros(len(model.parameters)))]
    loss = ((torch_rollout(model, 2e-3)(*values) - torch.tensor(target)) ** 2).sum()
    loss.backward()
    trajectory = model.rollout(x, u, 2e-3, N)
    assert abs(loss.item() - ((trajectory - target) ** 2).sum()) <= 1e-12 * loss.item()
    expected = pullback(model, trajectory, u, 2e-3, 2 * (trajectory - target))
    for value, gradient in zip(values, (*expected[:2], expected[2].sum(0))):
        np.testing.assert_allclose(value.grad.numpy(), gradient, rtol=1e-12, atol=1e-12)


def test_descent_of_torch_finds_forces_that_hold_a_pole():
    """Adam lowers the cost of a pole that falls, by forces of a single trajectory."""
    model = CartPole()
    x, p = model.initial(1), torch.tensor(model.parameters.starts, dtype=torch.float64)
    x[0, 1] = 0.2
    x, forces = torch.tensor(x), torch.zeros(1, 60, 1, dtype=torch.float64, requires_grad=True)
    rollout, costs = torch_rollout(model, H), []
    optimizer = torch.optim.Adam([forces], lr=0.5)
    for _ in range(40):
        optimizer.zero_grad()
        cost = (rollout(x, forces, p)[..., 1] ** 2).sum()
        cost.backward()
        optimizer.step()
        costs.append(cost.item())
    assert np.isfinite(costs).all() and costs[-1] < 0.3 * costs[0], costs[:: len(costs) - 1]
