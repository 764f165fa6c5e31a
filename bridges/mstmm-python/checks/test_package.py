"""The wheel: stubs, docs, the mark of typed packages."""

import pathlib
import subprocess
import sys

import mstmm_robots

FOLDER = pathlib.Path(mstmm_robots.__file__).parent


def test_stubs_are_those_of_the_descriptions():
    assert (FOLDER / "py.typed").exists()
    text = (FOLDER / "__init__.pyi").read_text()
    assert text == mstmm_robots.mstmm_robots._stubs()
    assert "def bob_mass(self) -> float:" in text and "class LinearizeResult:" in text


PROGRAM = '''
import numpy as np
from mstmm_robots import CartPole, Panda
model = CartPole(bob_mass=0.2)
x = model.initial(10)
model.step(x, None, 1e-3, 10, method="rk4")
a: np.ndarray = model.linearize(x).a
force: np.ndarray = model.solve(x)["points"]["bob.input"]["force"]
efforts: np.ndarray = Panda().inverse_dynamics(Panda().initial(), np.zeros(7))
'''
WRONG = {
    "CartPole(mass=1.0)": "call-arg",
    "CartPole().bob_mass = 'heavy'": "assignment",
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
