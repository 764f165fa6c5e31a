"""Builds the contenders of the answers."""

import os
import subprocess
from pathlib import Path

from .. import algebra, hinges, models, recursion
from .. import casadi_code as code_of_accelerations
from ..build import CASADI, NATIVE, PINOCCHIO, Builder, Contender, say
from ..cases import Case
from ..paths import DRIVERS, PACKAGES, ROOT
from . import casadi_code, inverse, urdf_text
from .goals import BY_COMPONENTS
from .order import DepthFirst
from .questions import TIPS

TOO_LARGE = {
    "B30": {"inverse_mass_matrix", "derivatives", "linearize"},
    "G1": {"inverse_mass_matrix", "derivatives", "linearize"},
}
"""Straight-line code that cannot be compiled in minutes: G1's Jacobian has 213 000 instructions."""

MUJOCO = {
    "accelerations",
    "inverse_dynamics",
    "bias_efforts",
    "mass_matrix",
    "inverse_mass_matrix",
    "jacobian",
    "derivatives",
    "linearize",
}
PINOCCHIO_ANSWERS = MUJOCO | {"coriolis_matrix", "regressor"}
DYNIBO = {"accelerations", "inverse_dynamics", "mass_matrix", "jacobian"}
WITHOUT_CASADI = {"coriolis_matrix", "jacobian", "regressor"}

DYNIBO_MANIFEST = f"""[package]
name = "dynibo-contender"
version = "0.0.0"
edition = "2024"

[[bin]]
name = "contender"
path = "{DRIVERS}/dynibo.rs"

[dependencies]
dynibo = "=0.5.3"

[workspace]
"""


class AnswersBuilder(Builder):
    def peers(self, case: Case, question: str) -> list[Contender]:
        """Builds all contenders that answer a question."""
        peers = []
        if question in PINOCCHIO_ANSWERS:
            peers.append(self.pinocchio(case, question))
        if question not in WITHOUT_CASADI | TOO_LARGE.get(case.name, set()):
            peers += self.casadi(case, question)
        if question in MUJOCO:
            peers.append(self.mujoco(case, question))
        if case.name == "D7" and question in DYNIBO:
            peers.append(self.dynibo(case, question))
        return peers

    def depth_first_states(self, case: Case) -> Path:
        """Returns the file of the states in the order of Pinocchio and MuJoCo."""
        return self.work / f"{case.name}.depth-first.states"

    def own(self, native: bool) -> Path:
        """Builds the answers of this library."""
        return self.cargo_build(native, "answers")

    def casadi(self, case: Case, what: str) -> list[Contender]:
        contenders = self._casadi(case, what, "CasADi")
        if what == "linearize":
            if case.balls:
                contenders += self._casadi(case, "linearize by components", BY_COMPONENTS)
            contenders += self._casadi(case, "linearize by inverse", "CasADi −M⁻¹∂ID")
        return contenders

    def _casadi(self, case: Case, answer: str, name: str) -> list[Contender]:
        folder = self.work / "casadi/answers" / case.name / answer.replace(" ", "-")
        folder.mkdir(parents=True, exist_ok=True)
        core = folder / "core.h"
        modules = (algebra, hinges, recursion, code_of_accelerations, casadi_code, inverse)
        sources = [Path(module.__file__ or "") for module in modules]
        if self._outdated(core, "", sources):
            count = casadi_code.generate(case, answer, core)
            say(f"CasADi's code of {case.name}, {answer}: {count} instructions")
            self._done(core, "", sources)
        trigonometry = [] if case.balls else ["-DVECTOR_TRIGONOMETRY"]
        contenders = []
        for words, fast in (("", []), (", fast math", ["-ffast-math"])):
            flags = [*CASADI, *trigonometry, *fast, "-I", str(folder), "-I", str(DRIVERS)]
            binary = folder / f"contender{words.replace(', ', '-').replace(' ', '-')}"
            headers = [core, DRIVERS / "answers.h", DRIVERS / "trigonometry.h"]
            self._compile(binary, DRIVERS / "answers_casadi.c", flags, ["-lmvec", "-lm"], headers)
            contenders.append(Contender(f"{name}{words}", (str(binary),)))
        return contenders

    def pinocchio(self, case: Case, what: str) -> Contender:
        include = PACKAGES / "cmeel.prefix/include"
        flags = [*PINOCCHIO, "-I", str(include), "-I", str(include / "eigen3")]
        binary = self.work / "answers-pinocchio"
        headers = [DRIVERS / "pinocchio_model.h", DRIVERS / "answers.h"]
        self._compile(binary, DRIVERS / "answers_pinocchio.cpp", flags, ["-lstdc++", "-lm"], headers)
        model = self.work / f"{case.name}.answers.txt"
        depth_first = DepthFirst.of(case)
        # The index of the ground is 0.
        tip = " ".join(map(repr, [depth_first.tip + 1, *TIPS[case.name]]))
        model.write_text(models.for_pinocchio(depth_first.case) + tip + "\n")
        command = (str(binary), str(model), what)
        return Contender("Pinocchio", command, states=self.depth_first_states(case))

    def mujoco(self, case: Case, what: str) -> Contender:
        package = PACKAGES / "mujoco"
        (library,) = package.glob("libmujoco.so.*")
        flags = [*NATIVE, "-I", str(package / "include")]
        link = [str(library), f"-Wl,-rpath,{package}"]
        binary = self.work / "answers-mujoco"
        self._compile(binary, DRIVERS / "answers_mujoco.c", flags, link, [DRIVERS / "answers.h"])
        model = self.work / f"{case.name}.answers.mjb"
        depth_first = DepthFirst.of(case)
        models.for_mujoco(depth_first.case, model, (depth_first.tip, TIPS[case.name]))
        command = (str(binary), str(model), what)
        return Contender("MuJoCo", command, states=self.depth_first_states(case))

    def dynibo(self, case: Case, what: str) -> Contender:
        folder = self.work / "dynibo"
        folder.mkdir(exist_ok=True)
        manifest, binary = folder / "Cargo.toml", folder / "target/release/contender"
        manifest.write_text(DYNIBO_MANIFEST)
        sources = [manifest, DRIVERS / "dynibo.rs", ROOT / "benches/src/timing.rs"]
        if self._outdated(binary, "", sources):
            say("cargo build (dynibo)")
            environment = {
                **os.environ,
                "RUSTFLAGS": "-C target-cpu=native",
                "CARGO_TARGET_DIR": str(folder / "target"),
            }
            subprocess.run(
                ["cargo", "build", "--release", "--quiet"], cwd=folder, env=environment, check=True
            )
            self._done(binary, "", sources)
        model = self.work / f"{case.name}.urdf"
        model.write_text(urdf_text.of(case, TIPS[case.name]))
        return Contender("dynibo", (str(binary), str(model), what))
