"""Makes the contenders."""

import hashlib
import os
import subprocess
import sys
import sysconfig
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from . import casadi_code, models
from .cases import Case

ROOT = Path(__file__).resolve().parents[3]
DRIVERS = ROOT / "benches/peers/drivers"
PACKAGES = Path(sysconfig.get_paths()["purelib"])

NATIVE = ["-O3", "-march=native", "-DNDEBUG"]
CASADI = [*NATIVE, "-ffp-contract=fast", "-fno-math-errno"]
PINOCCHIO = [
    "-std=c++17",
    *NATIVE,
    "-ffp-contract=fast",
    # Limits of Boost's lists of types, for the variant of all joints.
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
]


@dataclass(frozen=True)
class Contender:
    name: str
    command: tuple[str, ...]
    """Before the files of states and results and the milliseconds."""
    own: bool = field(default=False)


@dataclass(frozen=True)
class Builder:
    work: Path
    clang: str

    def own(self, native: bool) -> Path:
        """The project's own contender, for this processor or for any of its architecture."""
        folder = self.work / ("own-native" if native else "own")
        command = ["cargo", "build", "--release", "--package", "mstmm-benches", "--bin", "contender"]
        environment = dict(os.environ)
        if native:
            environment["RUSTFLAGS"] = "-C target-cpu=native"
            manifest = tomllib.loads((ROOT / "Cargo.toml").read_text())
            if "fma" in manifest["features"]:
                command += ["--features", "mstmm/fma"]
        say(f"cargo build ({folder.name})")
        environment["CARGO_TARGET_DIR"] = str(folder)
        subprocess.run([*command, "--quiet"], cwd=ROOT, env=environment, check=True)
        return folder / "release/contender"

    def casadi(self, case: Case, what: str) -> list[Contender]:
        """Every way to compile CasADi's code; there is none of an integrator."""
        if what == "rk4":
            return []
        folder = self.work / "casadi" / case.name / what
        folder.mkdir(parents=True, exist_ok=True)
        recursion = [Path(casadi_code.__file__), *(Path(__file__).parent / f"{n}.py" for n in ("recursion", "cases"))]
        core = folder / "core.h"
        if self._outdated(core, "", recursion):
            say(f"CasADi's code of {case.name}, {what}")
            casadi_code.generate(case, what == "all", core)
            self._done(core, "", recursion)

        vector = [] if case.balls else ["-DVECTOR_TRIGONOMETRY"]
        words = "" if case.balls else ", vector sin/cos"
        variants = {
            "CasADi C": [],
            f"CasADi C{words}, fast math": [*vector, "-ffast-math"],
            "CasADi C, 8 states wide": ["-DWIDE", "-mprefer-vector-width=512"],
        }
        if not case.balls:
            variants[f"CasADi C{words}"] = vector
        if what == "all":
            del variants["CasADi C, 8 states wide"]
        contenders = []
        for index, (name, flags) in enumerate(sorted(variants.items())):
            binary = folder / f"contender{index}"
            include = ["-I", str(folder), "-I", str(DRIVERS)]
            self._compile(binary, DRIVERS / "casadi.c", [*CASADI, *flags, *include], ["-lmvec", "-lm"], [core])
            contenders.append(Contender(name, (str(binary),)))
        return contenders

    def pinocchio(self, case: Case, what: str) -> Contender:
        include = PACKAGES / "cmeel.prefix/include"
        flags = [*PINOCCHIO, "-I", str(include), "-I", str(include / "eigen3")]
        binary = self.work / "pinocchio"
        self._compile(binary, DRIVERS / "pinocchio.cpp", flags, ["-lstdc++", "-lm"], [])
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

    def _compile(self, binary: Path, source: Path, flags: list[str], libraries: list[str], others: list[Path]) -> None:
        command = [self.clang, *flags, str(source), "-o", str(binary), *libraries]
        sources = [source, DRIVERS / "contender.h", *others]
        if self._outdated(binary, " ".join(command), sources):
            say(" ".join(["clang", source.name, str(binary.relative_to(self.work))]))
            subprocess.run(command, check=True)
            self._done(binary, " ".join(command), sources)

    def _outdated(self, made: Path, command: str, sources: list[Path]) -> bool:
        stamp = made.with_suffix(".stamp")
        is_made = made.exists() and stamp.exists()
        return not is_made or stamp.read_text() != digest(command, sources)

    def _done(self, made: Path, command: str, sources: list[Path]) -> None:
        made.with_suffix(".stamp").write_text(digest(command, sources))


def digest(command: str, sources: list[Path]) -> str:
    sums = [hashlib.sha256(source.read_bytes()).hexdigest() for source in sources]
    return hashlib.sha256("\n".join([command, *sums]).encode()).hexdigest()


def say(what: str) -> None:
    print(what, file=sys.stderr, flush=True)
