"""The wheel: stubs, docs, the mark of typed packages."""

import inspect
import pathlib
import re
import subprocess
import sys

import mstmm_robots
import numpy as np

FOLDER = pathlib.Path(mstmm_robots.__file__).parent


def test_stubs_are_those_of_the_descriptions():
    assert (FOLDER / "py.typed").exists()
    text = (FOLDER / "__init__.pyi").read_text()
    assert text == mstmm_robots.mstmm_robots._stubs()
    assert "def bob_mass(self) -> float:" in text and "class LinearizeResult:" in text


UNIT = re.compile(r"\b(in|of) (rad|m|s|kg|N|J|N m|SI units|rad/s²?|m/s²?|1/\(kg)\b|\bunits?\b|\bseconds\b|\bdimensionless\b")
SHAPE = re.compile(r"\bshapes?\s|\bfloat\b|\ba row for each\b|\bnumber of entries\b")
# Of files and pages, without quantities.
TEXTS = {"html", "write_html", "write_csv", "write_npz", "svg", "write_svg"}


def documented():
    """Yields the public classes, methods and functions with quantities, by name."""
    classes = [mstmm_robots.Model, mstmm_robots.Recording, mstmm_robots.environment.VectorEnv, mstmm_robots.environment.Env]
    for cls in classes:
        yield cls.__name__, cls
        # Also those that the base class of the extension has.
        own = {name for base in cls.__mro__ if base.__module__.split(".")[0] not in ("gymnasium", "builtins", "typing") for name in vars(base)}
        own |= {"step"} if cls is mstmm_robots.Model else set()
        for name in sorted(own - TEXTS):
            value = inspect.getattr_static(cls, name)
            if not name.startswith("_") and (callable(value) or isinstance(value, property) or inspect.ismethoddescriptor(value)):
                yield f"{cls.__name__}.{name}", value
    for name in ("pullback", "sensitivities", "jax_rollout", "torch_rollout"):
        yield name, getattr(mstmm_robots.gradients, name)


def test_docs_name_units_and_shapes():
    found = dict(documented())
    assert {"Model.step", "Model.solve", "Model.momentum_matrix", "Model.nx", "Recording.arrays", "VectorEnv.step"} <= set(found)
    docs = {name: inspect.getdoc(value) or "" for name, value in found.items()}
    assert not [name for name, text in docs.items() if not UNIT.search(text)], "no unit"
    assert not [name for name, text in docs.items() if not SHAPE.search(text)], "no shape"
    assert not UNIT.search("Returns the mass matrix.") and not SHAPE.search("Returns the mass matrix.")


def test_results_have_the_shapes_of_the_docs():
    model, rows = mstmm_robots.Panda(), 2
    x, n, nu = model.initial(rows), len(model.rates), len(model.inputs)
    a = np.zeros(n)
    shapes = {
        "accelerations": (n,), "bias_efforts": (n,), "gravity_efforts": (n,), "passive_efforts": (n,),
        "mass_matrix": (n, n), "inverse_mass_matrix": (n, n), "momentum_matrix": (6, n),
    }
    for name, shape in shapes.items():
        assert getattr(model, name)(x).shape == (rows, *shape), name
    shapes = {"inverse_dynamics": (n,), "mass_matrix_times": (n,), "inverse_mass_matrix_times": (n,)}
    for name, shape in shapes.items():
        assert getattr(model, name)(x, a).shape == (rows, *shape), name
    assert [value.shape for value in model.energy(x)] == [(rows,)] * 2
    momentum = model.momentum(x)
    assert momentum.mass.shape == (rows,) and momentum.angular.shape == (rows, 3)
    linear = model.linearize(x)
    assert (linear.a.shape, linear.b.shape) == ((rows, 2 * n, 2 * n), (rows, 2 * n, nu))
    assert model.jacobian(model.frames[-1], x).shape == (rows, 6, n)
    motion = model.kinematics(model.frames[-1], x)
    assert motion["orientation"].shape == (rows, 3, 3) and motion["velocity"].shape == (rows, 3)
    solution = model.solve(x)
    assert solution["efforts"].shape == (rows, len(model.efforts)) and solution["kinetic_energy"].shape == (rows,)
    assert model.rollout(x, None, 1e-3, 4, every=2).shape == (rows, 3, model.nx)
    assert model.push(x, d_rates=a).change.shape == (rows, n)
    pull = model.pull(x, a)
    assert (pull.coordinates.shape, pull.inputs.shape) == ((rows, n), (rows, nu))


PROGRAM = '''
import numpy as np
from mstmm_robots import CartPole, Panda, Rope
model = CartPole(bob_mass=0.2)
x = model.initial(10)
model.step(x, None, 1e-3, 10, method="rk4")
a: np.ndarray = model.linearize(x).a
force: np.ndarray = model.solve(x)["points"]["bob.input"]["force"]
rope = Rope(length=0.4, ks=[1.0, 2.0, 3.0])
rope.ks = 2 * rope.ks
efforts: np.ndarray = Panda().inverse_dynamics(Panda().initial(), np.zeros(7))
'''
WRONG = {
    "CartPole(mass=1.0)": "call-arg",
    "CartPole().bob_mass = 'heavy'": "assignment",
    "Rope().length = [1.0]": "assignment",
    "CartPole().momentum(x)": "attr-defined",
    "model.step(x, method='euler')": "arg-type",
}


def checked(text, folder):
    file = folder / "program.py"
    file.write_text(text)
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", str(file)], capture_output=True, text=True)
    return done.returncode, done.stdout


def test_mypy_accepts_programs_and_finds_errors(tmp_path):
    code, output = checked(PROGRAM, tmp_path)
    assert code == 0, output
    for line, rule in WRONG.items():
        code, output = checked(PROGRAM + line + "\n", tmp_path)
        assert code == 1 and f"[{rule}]" in output, (line, output)
