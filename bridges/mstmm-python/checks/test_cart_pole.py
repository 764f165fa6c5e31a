"""A cart-pole against its equations in numpy, and what all models share."""

import copy
import pickle

import numpy as np
import pytest
from mstmm_robots import CartPole, Hyq, Panda

G = 9.81


def equations(x, force, cart=1.0, bob=0.1, length=0.5):
    """Accelerations of cart and pole, from Lagrange's equations; the angle is counter-clockwise from upright."""
    angle, rate = x[:, 1], x[:, 3]
    sine, cosine = np.sin(angle), np.cos(angle)
    # (M + m) x'' - m l cos(a) a'' = F - m l sin(a) a'^2,  l a'' - cos(a) x'' = g sin(a)
    acceleration = (force - bob * length * sine * rate**2 + bob * G * sine * cosine) / (cart + bob * sine**2)
    return np.stack([acceleration, (G * sine + cosine * acceleration) / length], axis=1)


def rk4(x, force, h, n):
    def rate(x):
        return np.concatenate([x[:, 2:], equations(x, force)], axis=1)

    for _ in range(n):
        a = rate(x)
        b = rate(x + h / 2 * a)
        c = rate(x + h / 2 * b)
        x = x + h / 6 * (a + 2 * b + 2 * c + rate(x + h * c))
    return x


@pytest.fixture
def states():
    seed = 20260101
    print("seed", seed)
    return np.random.default_rng(seed).uniform(-1, 1, (37, 4))


def test_accelerations_are_those_of_the_equations(states):
    force = np.linspace(-3, 3, len(states))
    got = CartPole().accelerations(states, force[:, None].copy())
    # Some ten operations on values below 40: 40 * 10 * 2.2e-16 is 9e-14.
    np.testing.assert_allclose(got, equations(states, force), rtol=0, atol=1e-13)


def test_steps_are_those_of_rk4_in_numpy(states):
    expected = rk4(states, 0.7, 1e-2, 50)
    x = states.copy()
    CartPole().step(x, np.array([0.7]), 1e-2, 50)
    # Rounding of 50 steps, amplified by exp(sqrt(g/l) * 0.5 s) = 10.
    np.testing.assert_allclose(x, expected, rtol=0, atol=1e-12)


def test_rollout_has_all_steps_and_their_inputs(states):
    model, n = CartPole(), 12
    inputs = np.random.default_rng(3).normal(size=(len(states), n, 1))
    trajectory = model.rollout(states, inputs, 1e-2, n)
    assert trajectory.shape == (len(states), n + 1, 4)
    x = states.copy()
    for k in range(n):
        assert np.array_equal(trajectory[:, k], x)
        model.step(x, np.ascontiguousarray(inputs[:, k]), 1e-2, 1)
    # Rounding of the clock differs between one run and twelve, the states do not depend on it.
    assert np.array_equal(trajectory[:, n], x)
    assert np.array_equal(model.rollout(states, inputs, 1e-2, n, every=4), trajectory[:, ::4])


@pytest.mark.parametrize("Model", [CartPole, Panda, Hyq])
def test_a_batch_has_the_bits_of_single_states(Model):
    model = Model()
    rng = np.random.default_rng(1)
    x = model.initial(23) + 0.0
    nq = len(model.coordinates)
    x[:, nq:] += rng.normal(size=x[:, nq:].shape)
    u = rng.normal(size=(23, len(model.inputs)))
    together = x.copy()
    model.step(together, u, 1e-3, 20)
    linear, solution = model.linearize(x, u), model.solve(x, u)
    point = model.points[-1]
    for row in range(23):
        single = x[row].copy()
        model.step(single, u[row].copy(), 1e-3, 20)
        assert np.array_equal(single, together[row])
        assert np.array_equal(model.linearize(x[row], u[row]).a, linear.a[row])
        of_row = model.solve(x[row], u[row])["points"][point]["force"]
        assert np.array_equal(of_row, solution["points"][point]["force"][row])


def test_any_number_of_threads_gives_the_same_bits():
    model = Panda()
    x = model.initial(3001)
    x += np.random.default_rng(2).normal(size=x.shape)
    results = []
    for threads in (1, 2, 3, 7, 64):
        y = x.copy()
        model.step(y, None, 1e-3, 3, threads=threads)
        results.append(y)
    assert all(np.array_equal(results[0], other) for other in results)
    m = [model.mass_matrix(x, threads=threads) for threads in (1, 5)]
    assert np.array_equal(*m)


def test_parameters_are_properties_that_are_checked():
    model = CartPole(bob_mass=0.2)
    assert model.bob_mass == 0.2 and CartPole().bob_mass == 0.1
    with pytest.raises(ValueError, match="`bob_mass` must leave the mass of body `bob` positive"):
        model.bob_mass = -1
    with pytest.raises(ValueError, match="`bob_mass` must be a finite number"):
        model.bob_mass = float("nan")
    assert model.bob_mass == 0.2, "the previous value is kept"
    with pytest.raises(TypeError, match="CartPole has no parameter 'mass'; its parameters: cart_mass, bob_mass"):
        CartPole(mass=1)
    assert "kg" in CartPole.bob_mass.__doc__ and "0.1" in CartPole.bob_mass.__doc__
    assert repr(model) == "CartPole(cart_mass=1.0, bob_mass=0.2, length=0.5)"
    for other in (copy.copy(model), copy.deepcopy(model), pickle.loads(pickle.dumps(model))):
        assert repr(other) == repr(model)
    x = CartPole().initial()
    x[1] = 0.3
    assert not np.array_equal(model.accelerations(x), CartPole().accelerations(x))


def test_names_and_units_are_those_of_the_description():
    assert CartPole.coordinates == ("rail.position", "pole.angle")
    assert CartPole.coordinates.units == ("m", "rad")
    assert CartPole.rates == ("rail.velocity", "pole.rate") and CartPole.rates.units == ("m/s", "rad/s")
    assert CartPole.inputs == ("rail",) and CartPole.inputs.units == ("N",)
    assert CartPole.parameters.starts == (1.0, 0.1, 0.5)
    assert "A cart on a rail" in CartPole.__doc__ and "pole.angle in rad" in CartPole.__doc__
    assert Hyq.coordinates.index("base_link.orientation.w") == 3


def test_states_that_are_not_finite_are_named(states):
    model = CartPole()
    states[11, 1] = np.nan
    x = states.copy()
    with pytest.raises(FloatingPointError, match="row 11, step 0: `pole.angle` is not finite"):
        model.step(x)
    np.testing.assert_array_equal(x, states, "the states are unchanged")
    with pytest.raises(FloatingPointError, match="row 0: `rail` is not finite"):
        model.accelerations(states[:3], np.array([np.inf]))
    good = np.delete(np.arange(len(states)), 11)
    model.step(x, errors="nan")
    assert np.isnan(x[11]).all()
    expected = states[good].copy()
    model.step(expected)
    assert np.array_equal(x[good], expected)


def test_singular_states_have_the_words_of_the_library():
    x = Hyq().initial(2)
    x[1, 3:7] = 0
    with pytest.raises(ValueError, match="row 1: the quaternion of `base_link` is not a rotation"):
        Hyq().accelerations(x)


@pytest.mark.parametrize(
    "x, error, text",
    [
        (np.zeros((2, 3)), ValueError, r"x must have the shape \(4,\) or \(rows, 4\).*its shape is \(2, 3\)"),
        (np.zeros((2, 4), np.float32), TypeError, "x must be an array of float64, not float32"),
        (np.zeros((4, 2)).T, ValueError, "x must be contiguous"),
        ([0, 0, 0, 0], TypeError, "x must be a numpy array of float64, not list"),
    ],
)
def test_wrong_arrays_are_refused(x, error, text):
    with pytest.raises(error, match=text):
        CartPole().step(x)


def test_wrong_arguments_are_refused():
    model, x = CartPole(), CartPole().initial(3)
    with pytest.raises(ValueError, match=r"inputs must have the shape \(1,\) or \(3, 1\) or \(3, 5, 1\)"):
        model.step(x, np.zeros((2, 1)), 1e-3, 5)
    with pytest.raises(ValueError, match="h must be a finite step"):
        model.step(x, None, 0.0)
    with pytest.raises(ValueError, match="method must be one of rk4"):
        model.step(x, method="euler")
    with pytest.raises(ValueError, match="errors must be 'raise' or 'nan'"):
        model.step(x, errors="ignore")
    with pytest.raises(NotImplementedError, match=r"`answers` omits `momentum`: write `answers = \[..., momentum\];`"):
        model.momentum(x)
    with pytest.raises(ValueError, match="no frame 'bob.output'; the frames are cart.input"):
        model.jacobian("bob.output", x)
    x.flags.writeable = False
    with pytest.raises(ValueError, match="x is read-only"):
        model.step(x)
    with pytest.raises(ValueError, match=r"the given values must have the shape \(3, 2\)"):
        model.inverse_dynamics(x, np.zeros((3, 3)))


def test_wrong_numbers_are_refused_by_their_names():
    model, x = CartPole(), CartPole().initial(3)
    with pytest.raises(ValueError, match="n must not be negative, not -1"):
        model.rollout(x, None, 1e-3, -1)
    with pytest.raises(ValueError, match="n must not be negative, not -1"):
        model.step(x, None, 1e-3, -1)
    with pytest.raises(TypeError, match="n must be a whole number, not 1.5"):
        model.rollout(x, None, 1e-3, 1.5)
    with pytest.raises(ValueError, match="threads must not be negative"):
        model.accelerations(x, threads=-1)
    with pytest.raises(TypeError, match="h must be a number, not 'a'"):
        model.rollout(x, None, "a", 1)
    with pytest.raises(ValueError, match="h must be a finite step"):
        model.record(x, None, 0)
    with pytest.raises(TypeError, match="bob_mass must be a number, not 'a'"):
        model.bob_mass = "a"
    with pytest.raises(TypeError, match="CartPole has no parameter 'bobmass'; its parameters: cart_mass, bob_mass, length"):
        model.bobmass = 2

    class Named(CartPole):
        pass

    named = Named(bob_mass=0.3)
    named.label = "mine"
    assert named.bob_mass == 0.3 and named.label == "mine"


def test_arrays_that_are_read_may_have_any_order():
    """Views with other strides give the bits of their copies; arrays that are written must be in C order."""
    print("seed 9")
    rng, model, n = np.random.default_rng(9), CartPole(), 6
    wide, tall = rng.normal(size=(8, 8)), rng.normal(size=(4, 5))
    views = [wide[::2, ::2], tall.T, wide[:4, 3::-1], np.asfortranarray(wide[:, :4])]
    for x in views:
        assert not x.flags.c_contiguous
        kept, copy = x.copy(), np.ascontiguousarray(x)
        forces = rng.normal(size=(n, len(x), 1)).swapaxes(0, 1)
        weights = rng.normal(size=(2, len(x))).T
        assert np.array_equal(model.accelerations(x), model.accelerations(copy))
        given = model.inverse_dynamics(x, weights)
        assert np.array_equal(given, model.inverse_dynamics(copy, np.ascontiguousarray(weights)))
        rollout = model.rollout(x, forces, 1e-2, n)
        assert np.array_equal(rollout, model.rollout(copy, np.ascontiguousarray(forces), 1e-2, n))
        solved, expected = model.solve(x)["points"], model.solve(copy)["points"]
        assert np.array_equal(solved["bob.input"]["force"], expected["bob.input"]["force"])
        assert np.array_equal(x, kept)
        with pytest.raises(ValueError, match="x must be contiguous, with its last axis first in memory"):
            model.step(x)
        assert np.array_equal(x, kept)
    motion = model.rollout(wide[0, ::2], None, 1e-2, 9)
    assert len(model.record(motion[::3], None, 3e-2)) == 4


def test_the_state_is_changed_in_place_and_views_are_not_copied():
    x = CartPole().initial(100)
    x[:, 1] = 0.1
    part = x[20:30]
    CartPole().step(part, None, 1e-2, 5)
    assert (x[20:30, 1] != 0.1).all() and (x[:20, 1] == 0.1).all() and (x[30:, 1] == 0.1).all()


def test_methods_of_integration_have_their_orders():
    x = CartPole().initial()
    x[1], duration = 0.5, 0.4
    reference = x.copy()
    CartPole().step(reference, None, duration / 4000, 4000)
    for method, order in (("rk4", 4), ("semi_implicit_euler", 1), ("linearly_implicit_euler", 1)):
        errors = []
        for n in (20, 40):
            y = x.copy()
            CartPole().step(y, None, duration / n, n, method=method)
            errors.append(np.abs(y - reference).max())
        assert abs(np.log2(errors[0] / errors[1]) - order) < 0.3, method


def test_linear_model_predicts_small_changes(states):
    model, u = CartPole(), np.array([0.3])
    linear = model.linearize(states, u)
    h = 1e-6
    for k in range(4):
        change = np.zeros(4)
        change[k] = h
        difference = (model.accelerations(states + change, u) - model.accelerations(states - change, u)) / (2 * h)
        # Rounding of the difference: 40 * 1e-16 / 1e-6; curvature: 1e-12 * 100.
        np.testing.assert_allclose(linear.a[:, 2:, k], difference, atol=2e-8)
    assert np.array_equal(linear.a[:, :2, 2:], np.broadcast_to(np.eye(2), (len(states), 2, 2)))
    weights = np.ones((len(states), 2))
    gradient = model.pull(states, weights, u)
    # The same sums in another order.
    np.testing.assert_allclose(gradient.coordinates, linear.by_coordinates.sum(1), atol=1e-12)
    np.testing.assert_allclose(gradient.parameters, linear.by_parameters.sum(1), atol=1e-11)
    pushed = model.push(states, u, d_rates=np.array([1.0, 0.0]))
    np.testing.assert_allclose(pushed.change, linear.by_rates[:, :, 0], atol=1e-12)


def test_energy_is_conserved_and_forces_balance(states):
    model = CartPole()
    kinetic, potential = model.energy(states)
    x = states.copy()
    model.step(x, None, 1e-4, 1000)
    after = sum(model.energy(x))
    np.testing.assert_allclose(after, kinetic + potential, atol=1e-11)
    solution = model.solve(states)
    force = solution["points"]["bob.input"]["force"]
    # The force on the bob at its input is its mass times its acceleration less gravity.
    bob = states[:, 1], states[:, 3], solution["accelerations"]
    sine, cosine = np.sin(bob[0]), np.cos(bob[0])
    ax = bob[2][:, 0] - 0.5 * (cosine * bob[2][:, 1] - sine * bob[1] ** 2)
    ay = -0.5 * (sine * bob[2][:, 1] + cosine * bob[1] ** 2)
    np.testing.assert_allclose(force[:, 0], 0.1 * ax, atol=1e-13)
    np.testing.assert_allclose(force[:, 1], 0.1 * (ay + G), atol=1e-13)
