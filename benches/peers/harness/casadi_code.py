"""C code of the recursion for one case, by CasADi."""

import re
from pathlib import Path

import casadi

from .cases import Case
from .recursion import accelerations


def generate(case: Case, wrenches: bool, path: Path) -> None:
    """Writes `core.h` with folded constants, common subexpressions and no operations on zeros.

    CasADi's own simplification is off. The recursion forms no operation with a zero or a one anyway,
    and CasADi would turn the products with a reciprocal into as many divisions.
    """
    casadi.GlobalOptions.setSimplificationOnTheFly(False)
    pins = sum(body.hinge in "xyz" for body in case.bodies)
    sizes = {"q": case.coordinates} if case.balls else {"sines": pins, "cosines": pins}
    if case.floating:
        sizes = {"base": 7, **sizes}
    names = list(sizes)
    coordinates = [casadi.SX.sym(name, size) for name, size in sizes.items()]
    rates, torques = (casadi.SX.sym(name, case.rates) for name in ("v", "torques"))
    if case.balls:
        (q,) = coordinates
        hinges = [[q[4 * i + j] for j in range(4)] for i in range(len(case.bodies))]
    else:
        *base, sines, cosines = coordinates
        hinges = [casadi.vertsplit(x) for x in base]
        hinges += [[sines[i], cosines[i]] for i in range(pins)]
    results = accelerations(
        case,
        hinges,
        casadi.vertsplit(rates),
        casadi.vertsplit(torques),
        wrenches=wrenches,
    )
    inputs = [*coordinates, rates, torques]
    core = casadi.Function("core", inputs, [casadi.cse(casadi.vertcat(*results))])
    generator = casadi.CodeGenerator("core.c", {"with_header": False, "verbose": False})
    generator.add(core)
    defines = {
        "BASE": 7 if case.floating else 0,
        "COORDINATES": case.coordinates,
        "RATES": case.rates,
        "PINS": pins,
        "RESULTS": len(results),
    }
    lines = [f"#define {name} {value}" for name, value in defines.items()]
    path.write_text("\n".join([*lines, plain_function(generator.dump(), [*names, "v", "torques"])]))


def plain_function(code: str, inputs: list[str]) -> str:
    """Returns CasADi's function with named arguments and without tests for null pointers."""
    body = re.search(r"static int casadi_f0\(.*?\) \{\n(.*?)  return 0;\n\}", code, re.DOTALL)
    assert body, "the form of CasADi's code has changed"
    text = body[1].replace("casadi_real ", "real ")
    text = re.sub(r"arg\[(\d+)\]\? arg\[\1\]\[(\d+)\] : 0", lambda m: f"{inputs[int(m[1])]}[{m[2]}]", text)
    text = re.sub(r"if \(res\[0\]!=0\) res\[0\]\[(\d+)\]", r"result[\1]", text)
    assert "arg[" not in text and "res[" not in text, "the form of CasADi's code has changed"
    arguments = [f"const real *restrict {name}" for name in inputs] + ["real *restrict result"]
    return f"static inline void core({', '.join(arguments)}) {{\n{text}}}\n"
