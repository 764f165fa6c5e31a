"""Runs the commands on the pages of the examples."""

import os
import pathlib
import re
import shutil
import subprocess

FOLDER = pathlib.Path(__file__).parents[1]
# The wheels and programs that a page installs first are those of `bridges/check`, unless all is asked for.
ALL = os.environ.get("MSTMM_ALL") == "1"
INSTALLS = ("cd ", "python3 -m venv", "pip install maturin", "cargo install")


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
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], cwd=copy, capture_output=True, text=True)
    assert done.returncode == 0, f"{text}\n{done.stdout}\n{done.stderr}"
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
