"""Runs the commands on the pages of the examples."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

FOLDER = pathlib.Path(__file__).parents[1]
# The wheels and programs that a page installs first are those of `bridges/check`, unless all is asked for.
ALL = os.environ.get("MSTMM_ALL") == "1"
INSTALLS = ("cd ", "python3 -m venv", "pip install maturin", "cargo install")
# The wheel that each page builds.
WHEELS = {"ur5": "ur5", "swing_up": "cart_pole", "calibration": "arm", "gantry": "gantry"}


def commands(example):
    """Returns the commands of a page: the lines of its first block of `sh`."""
    text = (FOLDER / example / "README.md").read_text()
    block = re.search(r"```sh\n(.*?)```", text, re.DOTALL).group(1)
    lines = [line for line in block.splitlines() if line]
    return [line for line in lines if ALL and not line.startswith("cd ") or not line.startswith(INSTALLS)]


def run(example, folder, small=()):
    """Runs the commands of a page in a copy of its folder. Returns the folder and what the commands print.

    `small` has pairs of texts that make commands smaller, unless all is asked for.
    """
    copy = folder / example
    shutil.copytree(FOLDER / example, copy, ignore=shutil.ignore_patterns("wheels", "venv", "results"))
    text = "\n".join(commands(example)).replace("../..", str(FOLDER.parent))
    for whole, part in () if ALL else small:
        assert whole in text, f"the page of {example} has no `{whole}`"
        text = text.replace(whole, part)
    # A wheel of an earlier run has the same version.
    pip = [sys.executable, "-m", "pip"]
    subprocess.run([*pip, "uninstall", "--quiet", "--yes", WHEELS[example]], check=True, capture_output=True)
    own = {"CARGO_INSTALL_ROOT": str(folder / "cargo"), "PATH": f"{folder / 'cargo/bin'}:{os.environ['PATH']}"} if ALL else {}
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], cwd=copy, capture_output=True, text=True, env=os.environ | own)
    assert done.returncode == 0, f"{text}\n{done.stdout}\n{done.stderr}"
    if ALL:
        # The page has a separate environment; the checks import the wheel, too.
        subprocess.run([*pip, "install", "--quiet", "--no-deps", *map(str, (copy / "wheels").glob("*.whl"))], check=True)
    return copy, done.stdout


def load(example, file):
    """Returns the module of an example's program, which imports a wheel that `run` has installed."""
    import importlib
    import importlib.util

    importlib.invalidate_caches()
    path = FOLDER / example / file
    spec = importlib.util.spec_from_file_location(f"{example}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
