"""Parameters with a value for each repetition, and what is a number."""

import copy
import pathlib
import pickle
import re

import mstmm_robots
import numpy as np
import pytest
from mstmm_robots import CartPole, Rope

README = pathlib.Path(__file__).parents[1] / "README.md"


def test_parameters_of_repetitions_are_arrays():
    rope = Rope(ks=[4, 5.0, np.float64(6)])
    assert isinstance(rope.ks, np.ndarray) and rope.ks.tolist() == [4.0, 5.0, 6.0]
    assert [rope.get(f"ks[{k}]") for k in range(3)] == [4.0, 5.0, 6.0] and rope.get("ks").tolist() == [4.0, 5.0, 6.0]
    assert Rope(ks=2).ks.tolist() == [2.0] * 3 and Rope(**{"ks[1]": 6.0}).ks.tolist() == [5.0, 6.0, 5.0]
    rope.ks = np.array([1, 2, 3])
    rope.set("ks[0]", 7)
    assert rope.ks.tolist() == [7.0, 2.0, 3.0] and rope.length == 0.5
    setattr(rope, "ks[2]", 8)
    rope.ks = 2 * rope.ks
    assert rope.ks.tolist() == [14.0, 4.0, 16.0]
    with pytest.raises(ValueError, match="read-only"):
        rope.ks[1] = 1.0
    assert repr(rope) == "Rope(length=0.5, ks=[14.0, 4.0, 16.0])" and repr(Rope()) == "Rope(length=0.5, ks=5.0)"
    for other in (copy.copy(rope), pickle.loads(pickle.dumps(rope)), eval(repr(rope))):
        assert other.ks.tolist() == rope.ks.tolist()
    assert "N m/rad" in Rope.ks.__doc__.replace("*", " ") and "(3,)" in Rope.ks.__doc__ and "default is 5" in Rope.ks.__doc__
    stubs = mstmm_robots.mstmm_robots._stubs()
    assert "ks: ArrayLike = ..." in stubs and "def ks(self) -> Array:" in stubs


def test_wrong_values_of_repetitions_are_refused():
    rope = Rope(ks=[1, 2, 3])
    for value in ([1, 2], [[1, 2, 3]], []):
        with pytest.raises(ValueError, match=r"ks must be a number or have the shape \(3,\); its shape is \("):
            rope.ks = value
    with pytest.raises(TypeError, match=r"ks\[1\] must be a number, not 'a'"):
        rope.ks = [4, "a", 4]
    with pytest.raises(TypeError, match="ks must be a number, not '3'"):
        rope.ks = "3"
    with pytest.raises(ValueError, match="`ks` must be a finite number"):
        rope.ks = [4, np.nan, 4]
    assert rope.ks.tolist() == [1.0, 2.0, 3.0], "the previous values are kept"
    for name in ("k", "ks[3]"):
        with pytest.raises(TypeError, match=re.escape(f"Rope has no parameter {name!r}; its parameters: length, ks")):
            rope.set(name, 1)
        with pytest.raises(TypeError, match=re.escape(f"Rope has no parameter {name!r}")):
            setattr(rope, name, 1)


def test_values_reach_their_repetitions():
    rope, x = Rope(ks=[0, 0, 9]), Rope().initial()
    places = [k for k, name in enumerate(rope.coordinates) if name.endswith(".y")]
    assert len(places) == 3
    for k, place in enumerate(places):
        # A rotation of 0.2 rad about y, whose length is near enough to one.
        bent = x.copy()
        bent[place] = 0.1
        assert np.any(rope.passive_efforts(bent)) == (k == 2)


@pytest.mark.parametrize("text", ["3", b"3", bytearray(b"3"), np.str_("3"), np.array("3"), np.array("3", object)])
def test_texts_are_not_numbers(text):
    with pytest.raises(TypeError, match="bob_mass must be a number"):
        CartPole(bob_mass=text)
    model = CartPole()
    with pytest.raises(TypeError, match="bob_mass must be a number"):
        model.bob_mass = text
    with pytest.raises(TypeError, match="h must be a number"):
        model.rollout(model.initial(), None, text, 1)


def test_texts_are_not_arrays():
    model, text = CartPole(), ["0", "0", "0", "0"]
    for x in (text, np.array(text)):
        with pytest.raises(TypeError, match="x must be an array of float64"):
            model.accelerations(x)
    with pytest.raises(TypeError, match="the direction must be an array of float64"):
        model.push(model.initial(), d_rates=np.array(["1", "0"]))
    with pytest.raises(TypeError, match="time must be an array of float64"):
        mstmm_robots.Recording(model).record(model.initial(), None, "0.5")


@pytest.mark.parametrize("number", [3, True + 2, np.int32(3), np.float32(3), np.array(3), np.array(3.0), np.array(3, object)])
def test_numbers_of_all_types_are_accepted(number):
    model = CartPole(bob_mass=number)
    assert model.bob_mass == 3.0 and isinstance(model.bob_mass, float)
    assert Rope(ks=number).ks.tolist() == [3.0] * 3


def test_the_readme_sets_parameters_of_repetitions():
    blocks = re.findall(r"```python\n(.*?)```", README.read_text(), re.DOTALL)
    (block,) = [block for block in blocks if "from rope import" in block]
    names = {}
    exec(block.replace("from rope import", "from mstmm_robots import"), names)
    assert names["rope"].ks.tolist() == [5.0, 6.0, 5.0]
