"""A vector environment of gymnasium over a model. Needs `pip install gymnasium`."""

import numpy as np

try:
    import gymnasium
    from gymnasium.vector.utils import batch_space
except ImportError as error:
    _missing = error

    class VectorEnv:
        """Needs the package gymnasium."""

        def __init__(self, *_, **__):
            raise ImportError("VectorEnv needs the package gymnasium: pip install gymnasium") from _missing

else:

    class VectorEnv(gymnasium.vector.VectorEnv):
        """Many states of a model as environments of gymnasium.

        An observation is a state: coordinates, then rates, in their units, or ``observe(x)``; the shape is (num_envs, nx).
        An action is the values of all inputs in their units, from ``-high`` or ``low`` to ``high``; the shape is
        (num_envs, nu). It is held over ``substeps`` steps of ``step`` seconds.

        ``reward(x, u)`` and ``terminated(x)`` return the shape (num_envs,). ``reset(rng, rows)`` returns states to begin with,
        with the shape (rows, nx); without it they are the model's start with a random deviation up to ``noise``, in the units of
        the state. After ``limit`` actions an episode is
        truncated. An environment that has ended begins anew with the next action (``AutoresetMode.NEXT_STEP``).
        """

        metadata = {"autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}

        def __init__(
            self, model, num_envs, *, reward, terminated=None, reset=None, observe=None, high=1.0, low=None,
            step=1e-3, substeps=20, limit=500, noise=0.05, threads=0,
        ):
            if num_envs < 1:
                raise ValueError(f"num_envs must be positive, not {num_envs}")
            self.model, self.num_envs, self.threads = model, num_envs, threads
            self._reward, self._terminated, self._start, self._observe = reward, terminated, reset, observe
            self._h, self._substeps, self.limit, self.noise = step, substeps, limit, noise
            inputs = len(model.inputs)
            high = np.broadcast_to(np.asarray(high, np.float64), (inputs,)).copy()
            low = -high if low is None else np.broadcast_to(np.asarray(low, np.float64), (inputs,)).copy()
            shape = self._observed(model.initial(1)).shape[1:]
            self.single_observation_space = gymnasium.spaces.Box(-np.inf, np.inf, shape, np.float64)
            self.single_action_space = gymnasium.spaces.Box(low, high, (inputs,), np.float64)
            self.observation_space = batch_space(self.single_observation_space, num_envs)
            self.action_space = batch_space(self.single_action_space, num_envs)
            self.x = model.initial(num_envs)
            self._time = np.zeros(num_envs, np.int64)
            self._ended = np.zeros(num_envs, bool)

        def _observed(self, x):
            return x.copy() if self._observe is None else np.asarray(self._observe(x), np.float64)

        def _per_row(self, name, values):
            if values.shape != (self.num_envs,):
                raise ValueError(f"{name} must return the shape ({self.num_envs},), a value for each row, not {values.shape}")
            return values

        def _begin(self, rows):
            if self._start is not None:
                self.x[rows] = self._start(self.np_random, int(rows.sum()))
            else:
                start = self.model.initial(int(rows.sum()))
                self.x[rows] = start + self.np_random.uniform(-self.noise, self.noise, start.shape)
            self._time[rows], self._ended[rows] = 0, False

        def reset(self, *, seed=None, options=None):
            """Begins all episodes anew. Returns the observations, shape (num_envs, nx) in the units of the state, and a dict."""
            super().reset(seed=seed)
            self._begin(np.ones(self.num_envs, bool))
            return self._observed(self.x), {}

        def step(self, actions):
            """Takes ``substeps`` steps with actions of the shape (num_envs, nu), in the units of the inputs.

            Returns observations, in the units of the state, and rewards, ends, truncations, each dimensionless with the shape
            (num_envs,), and a dict.
            """
            actions = np.clip(np.asarray(actions, np.float64), self.action_space.low, self.action_space.high)
            again, before = self._ended.copy(), self.x
            # A state that cannot be computed ends its episode.
            after = before.copy()
            self.model.step(after, np.ascontiguousarray(actions), self._h, self._substeps, threads=self.threads, errors="nan")
            failed = np.isnan(after).any(axis=1)
            after[failed] = before[failed]
            self.x = after
            self._time += 1
            reward = self._per_row("reward", np.array(self._reward(after, actions), np.float64))
            ended = failed.copy()
            if self._terminated is not None:
                ended |= self._per_row("terminated", np.asarray(self._terminated(after), bool))
            truncated = (self._time >= self.limit) & ~ended
            if again.any():
                self._begin(again)
                reward[again], ended[again], truncated[again] = 0.0, False, False
            self._ended = ended | truncated
            return self._observed(self.x), reward, ended, truncated, {}

    class Env(gymnasium.Env):
        """One environment, with the arguments of `VectorEnv` but the number.

        An observation has the shape (nx,), an action (nu,), in the units of the model.
        """

        metadata = {"render_modes": []}

        def __init__(self, model, **arguments):
            self._vector = VectorEnv(model, 1, **arguments)
            self.observation_space = self._vector.single_observation_space
            self.action_space = self._vector.single_action_space

        def reset(self, *, seed=None, options=None):
            """Begins an episode. Returns the observation, shape (nx,) in the units of the state, and a dict."""
            super().reset(seed=seed)
            self._vector.np_random = self.np_random
            self._vector._begin(np.ones(1, bool))
            return self._vector._observed(self._vector.x)[0], {}

        def step(self, action):
            """Takes ``substeps`` steps with an action of the shape (nu,), in the units of the inputs.

            Returns the observation in the units of the state, the dimensionless reward, end, truncation, and a dict.
            """
            self._vector._ended[:] = False
            self._vector.np_random = self.np_random
            observation, reward, ended, truncated, info = self._vector.step(np.asarray(action)[None])
            return observation[0], float(reward[0]), bool(ended[0]), bool(truncated[0]), info
