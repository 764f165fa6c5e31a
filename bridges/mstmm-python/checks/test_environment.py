"""The environments by the checker of gymnasium."""

import numpy as np
import pytest
from mstmm_robots import CartPole
from mstmm_robots.environment import Env, VectorEnv

pytest.importorskip("gymnasium")
import gymnasium  # noqa: E402
from gymnasium.utils.env_checker import check_env  # noqa: E402

RULES = dict(
    reward=lambda x, u: np.cos(x[:, 1]) - 1e-3 * u[:, 0] ** 2,
    terminated=lambda x: np.abs(x[:, 0]) > 2.4,
    high=10.0,
    limit=30,
)


@pytest.mark.filterwarnings("ignore:.*observation space.*:UserWarning", "ignore:.*render.*:UserWarning")
def test_the_checker_accepts_the_environment():
    check_env(Env(CartPole(), **RULES), skip_render_check=True)


def test_vectors_have_the_interface_of_gymnasium():
    env = VectorEnv(CartPole(), 16, **RULES)
    assert isinstance(env, gymnasium.vector.VectorEnv)
    observation, info = env.reset(seed=4)
    again, _ = env.reset(seed=4)
    assert np.array_equal(observation, again) and info == {}
    assert env.observation_space.contains(observation)
    env.action_space.seed(4)
    ends = np.zeros(16, int)
    for number in range(1, 80):
        observation, reward, terminated, truncated, _ = env.step(env.action_space.sample())
        assert env.observation_space.contains(observation)
        assert reward.shape == terminated.shape == truncated.shape == (16,)
        assert not (terminated & truncated).any()
        ends += terminated | truncated
    assert (ends >= 2).all(), "each episode is truncated after 30 actions at the latest"


def test_a_vector_computes_what_single_environments_do():
    many, seeds = VectorEnv(CartPole(), 3, **RULES), [5, 6, 7]
    singles = [VectorEnv(CartPole(), 1, **RULES) for _ in seeds]
    many.reset(seed=1)
    for row, single in enumerate(singles):
        single.reset(seed=1)
        single.x[0] = many.x[row]
    for action in (3.0, -2.0, 0.5):
        together, *_ = many.step(np.full((3, 1), action))
        for row, single in enumerate(singles):
            assert np.array_equal(single.step(np.full((1, 1), action))[0][0], together[row])


def test_an_ended_episode_begins_anew_with_the_next_action():
    env = VectorEnv(CartPole(), 2, **RULES)
    env.reset(seed=2)
    env.x[0, 0] = 3.0
    *_, terminated, _, _ = env.step(np.zeros((2, 1)))
    assert terminated.tolist() == [True, False]
    before = env.x[1].copy()
    _, reward, terminated, _, _ = env.step(np.ones((2, 1)))
    assert abs(env.x[0, 0]) < 0.1 and reward[0] == 0 and not terminated.any()
    assert not np.array_equal(before, env.x[1])


def test_wrong_environments_are_refused():
    with pytest.raises(ValueError, match="num_envs must be positive, not 0"):
        VectorEnv(CartPole(), 0, reward=lambda x, u: x[:, 0])
    environment = VectorEnv(CartPole(), 4, reward=lambda x, u: np.zeros(3))
    environment.reset(seed=1)
    with pytest.raises(ValueError, match=r"reward must return the shape \(4,\), a value for each row, not \(3,\)"):
        environment.step(np.zeros((4, 1)))
