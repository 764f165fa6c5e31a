"""Learns to swing a pole up and to balance it, by an evolution strategy with numpy alone. Needs the wheel of
`cart_pole.chain`."""

import argparse
import pathlib
import time

import numpy as np
from cart_pole import CartPole

# The force is held for 20 ms, over two steps of the integration.
PERIOD, SUBSTEPS = 0.02, 2
FORCE = 15.0
RAIL = 2.4
HIDDEN = 12
OBSERVED = 5
WEIGHTS = HIDDEN * (OBSERVED + 2)


def observation(x):
    """Returns what the policy sees of the states: no jump where the angle passes a whole turn."""
    return np.stack([x[:, 0], np.sin(x[:, 1]), np.cos(x[:, 1]), x[:, 2] / 3, x[:, 3] / 6], axis=1)


def policy(weights, x):
    """Returns the force in N for each row: a network of one layer, with weights for each row."""
    inner, bias, outer = np.split(weights, [HIDDEN * OBSERVED, HIDDEN * (OBSERVED + 1)], axis=1)
    hidden = np.einsum("rho,ro->rh", inner.reshape(-1, HIDDEN, OBSERVED), observation(x))
    return FORCE * np.tanh((np.tanh(hidden + bias) * outer).sum(axis=1, keepdims=True))


def reward(x):
    """Returns the reward of states: upright, in the middle of the rail, and at rest when upright."""
    upright = np.cos(x[:, 1])
    slow = np.where(upright > 0.9, 0.002 * x[:, 3] ** 2, 0.0)
    return upright - 0.05 * x[:, 0] ** 2 - slow - (np.abs(x[:, 0]) > RAIL)


def starts(rng, rows):
    """Returns states with the pole hanging, up to random deviations of 0.3 m, 0.4 rad, 0.3 m/s and 0.3 rad/s."""
    width = np.array([0.3, 0.4, 0.3, 0.3])
    return CartPole().initial(rows) + rng.uniform(-width, width, (rows, 4))


def episodes(weights, x, periods):
    """Runs each row of weights from each start; returns mean rewards by rows, and all states of all episodes."""
    model, rows = CartPole(), len(weights)
    state, each = np.tile(x, (rows, 1)), np.repeat(weights, len(x), axis=0)
    total, states = np.zeros(len(state)), [state.copy()]
    for _ in range(periods):
        model.step(state, policy(each, state), PERIOD / SUBSTEPS, SUBSTEPS)
        total += reward(state)
        states.append(state.copy())
    return total.reshape(rows, len(x)).mean(axis=1) / periods, np.stack(states, axis=1)


def learn(seed, iterations, population=64, deviation=0.15, rate=0.1, report=print):
    """Returns the weights of a policy.

    Evolution strategy of Salimans et al. (2017): pairs of opposite random directions, ranks of their rewards, and the
    step rule Adam, whose rate falls to zero in the last third.
    """
    rng = np.random.default_rng(seed)
    weights = 0.3 * rng.normal(size=WEIGHTS)
    mean, square = np.zeros(WEIGHTS), np.zeros(WEIGHTS)
    begin = time.perf_counter()
    for iteration in range(1, iterations + 1):
        half = rng.normal(size=(population // 2, WEIGHTS))
        directions = np.concatenate([half, -half])
        rewards, _ = episodes(weights + deviation * directions, starts(rng, 4), 300)
        ranks = np.empty(population)
        ranks[np.argsort(rewards)] = np.linspace(-0.5, 0.5, population)
        gradient = ranks @ directions / (population * deviation)
        mean, square = 0.9 * mean + 0.1 * gradient, 0.99 * square + 0.01 * gradient**2
        step = mean / (1 - 0.9**iteration) / (np.sqrt(square / (1 - 0.99**iteration)) + 1e-8)
        weights = weights + rate * min(1.0, 3 * (1 - iteration / (iterations + 1))) * step
        if iteration % 20 == 0:
            report(f"{iteration:4} iterations  {time.perf_counter() - begin:5.1f} s  mean reward {rewards.mean():6.3f}")
    return weights


def balanced(states):
    """Returns for each episode whether the pole is within 18 degrees of upright and the cart on the rail in the last
    half of the time."""
    late = states[:, states.shape[1] // 2 :]
    return ((np.cos(late[..., 1]) > 0.95) & (np.abs(late[..., 0]) < RAIL)).all(axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", default=".", help="the folder for the page, the picture and the weights")
    parser.add_argument("--iterations", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    weights = learn(given.seed, given.iterations)
    # 20 s from 100 starts that learning has not seen, since its generator is another.
    _, states = episodes(weights[None], starts(np.random.default_rng(given.seed + 1000), 100), 1000)
    up = balanced(states)
    print(f"{up.sum()} of {len(up)} new starts: the pole is up from the tenth to the twentieth second")
    folder = pathlib.Path(given.output)
    np.save(folder / "weights.npy", weights)
    first = states[0, :500]
    recording = CartPole().record(first, policy(np.tile(weights, (len(first), 1)), first), PERIOD)
    recording.write_html(folder / "swing_up.html", title="A learned swing-up")
    recording.write_svg(folder / "swing_up.svg", -1)
    print(f"{folder / 'swing_up.html'} shows the motion and its forces")


if __name__ == "__main__":
    main()
