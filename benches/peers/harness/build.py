"""Builds the contenders."""

import hashlib
import os
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

from . import algebra, casadi_code, cases, hinges, models, recursion
from .cases import Case
from .paths import DRIVERS, PACKAGES, ROOT
from .trees import robots, urdf

NATIVE = ["-O3", "-march=native", "-DNDEBUG"]
CASADI = [*NATIVE, "-ffp-contract=fast", "-fno-math-errno"]
PINOCCHIO = [
    "-std=c++17",
    *NATIVE,
    "-ffp-contract=fast",
    # Boost's limits for lists of types, for the variant of all joints.
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
]


@dataclass(frozen=True)
class Contender:
    name: str
    command: tuple[str, ...]
    """The arguments before the files of states and results and the milliseconds."""
    own: bool = False
    wide: bool = False
    """Whether several states are evaluated at once."""
    single: bool = False
    """Whether it computes in single precision."""
    states: Path | None = None
    """The file of states, if it is not the common one."""


@dataclass(frozen=True)
class Builder:
    """Builds in the folder `work`, with a stamp of the sources for each file."""

    work: Path
    clang: str

    def own(self, native: bool) -> Path:
        """Builds the contender of this library, for this processor or for any processor."""
        return self.cargo_build(native, "contender")

    def cargo_build(self, native: bool, program: str) -> Path:
        """Builds a program of this library, for this processor or for any processor."""
        folder = self.work / ("own-native" if native else "own")
        command = ["cargo", "build", "--release", "--package", "mstmm-benches", "--bin", program]
        environment = dict(os.environ)
        if native:
            environment["RUSTFLAGS"] = "-C target-cpu=native"
            manifest = tomllib.loads((ROOT / "Cargo.toml").read_text())
            if "fma" in manifest["features"]:
                command += ["--features", "mstmm/fma"]
        say(f"cargo build ({folder.name})")
        environment["CARGO_TARGET_DIR"] = str(folder)
        subprocess.run([*command, "--quiet"], cwd=ROOT, env=environment, check=True)
        return folder / "release" / program

    def casadi(self, case: Case, what: str) -> list[Contender]:
        """Builds all variants of CasADi's code."""
        wrenches = what == "all"
        folder = self.work / "casadi" / case.name / ("wrenches" if wrenches else "accelerations")
        folder.mkdir(parents=True, exist_ok=True)
        core = folder / "core.h"
        modules = (algebra, hinges, recursion, casadi_code, cases, robots, urdf)
        sources = [Path(module.__file__ or "") for module in modules]
        if self._outdated(core, "", sources):
            say(f"CasADi's code of {case.name}, {folder.name}")
            casadi_code.generate(case, wrenches, core)
            self._done(core, "", sources)

        vector = [] if case.balls else ["-DVECTOR_TRIGONOMETRY"]
        words = "" if case.balls else ", vector sin/cos"
        wide = ["-DWIDE", "-mprefer-vector-width=512"]
        fast = ["-ffast-math"]
        variants: dict[str, list[str]] = {"CasADi C": [], f"CasADi C{words}": vector}
        variants[f"CasADi C{words}, fast math"] = vector + fast
        if what == "accelerations":
            variants["CasADi C, 8 states wide"] = wide
            variants["CasADi C, 8 states wide, fast math"] = wide + fast
        contenders = []
        for name, flags in variants.items():
            flags = [*flags, *(["-DRK4"] if what == "rk4" else []), "-I", str(folder), "-I", str(DRIVERS)]
            binary = folder / f"{what} {name}".replace(" ", "-").replace("/", "-").replace(",", "")
            headers = [core, DRIVERS / "trigonometry.h"]
            self._compile(binary, DRIVERS / "casadi.c", [*CASADI, *flags], ["-lmvec", "-lm"], headers)
            contenders.append(Contender(name, (str(binary),), wide="-DWIDE" in flags))
        return contenders

    def pinocchio(self, case: Case, what: str) -> Contender:
        include = PACKAGES / "cmeel.prefix/include"
        flags = [*PINOCCHIO, "-I", str(include), "-I", str(include / "eigen3")]
        binary = self.work / "pinocchio"
        headers = [DRIVERS / "pinocchio_model.h"]
        self._compile(binary, DRIVERS / "pinocchio.cpp", flags, ["-lstdc++", "-lm"], headers)
        model = self.work / f"{case.name}.txt"
        model.write_text(models.for_pinocchio(case))
        return Contender("Pinocchio", (str(binary), str(model), what))

    def mujoco(self, case: Case, what: str) -> Contender:
        package = PACKAGES / "mujoco"
        (library,) = package.glob("libmujoco.so.*")
        flags = [*NATIVE, "-I", str(package / "include")]
        link = [str(library), f"-Wl,-rpath,{package}"]
        binary = self.work / "mujoco"
        self._compile(binary, DRIVERS / "mujoco.c", flags, link, [])
        model = self.work / f"{case.name}.mjb"
        models.for_mujoco(case, model)
        return Contender("MuJoCo", (str(binary), str(model), what))

    def _compile(
        self, binary: Path, source: Path, flags: list[str], libraries: list[str], others: list[Path]
    ) -> None:
        command = [self.clang, *flags, str(source), "-o", str(binary), *libraries]
        sources = [source, DRIVERS / "contender.h", *others]
        if self._outdated(binary, " ".join(command), sources):
            say(" ".join(["clang", source.name, str(binary.relative_to(self.work))]))
            subprocess.run(command, check=True)
            self._done(binary, " ".join(command), sources)

    def _outdated(self, made: Path, command: str, sources: list[Path]) -> bool:
        stamp = stamp_of(made)
        is_made = made.exists() and stamp.exists()
        return not is_made or stamp.read_text() != digest(command, sources)

    def _done(self, made: Path, command: str, sources: list[Path]) -> None:
        stamp_of(made).write_text(digest(command, sources))


def stamp_of(made: Path) -> Path:
    return made.with_name(f"{made.name}.stamp")


def digest(command: str, sources: list[Path]) -> str:
    sums = [hashlib.sha256(source.read_bytes()).hexdigest() for source in sources]
    return hashlib.sha256("\n".join([command, *sums]).encode()).hexdigest()


def say(what: str) -> None:
    print(what, file=sys.stderr, flush=True)
