"""The type stubs of models. The extension runs this text after `model.py`, with its names."""

# The methods of answers in the stubs: arguments and type of the result.
_ARRAY = "Array"


def stubs(module):
    """Returns the text of the module's type stubs."""
    lines = [
        '"""Models of the library mstmm. Written from their descriptions."""',
        "",
        "from collections.abc import Mapping",
        "from os import PathLike",
        "from typing import Any, Literal, TypedDict",
        "import numpy as np",
        "from numpy.typing import ArrayLike, NDArray",
        "",
        "Array = NDArray[np.float64]",
        "",
        "class Names(tuple[str, ...]):",
        "    units: tuple[str, ...]",
        "    starts: tuple[float | None, ...]",
        "    limits: tuple[tuple[float, float] | None, ...]",
        "    kinds: tuple[str, ...]",
        "",
        "class Point(TypedDict):",
        *(f"    {name}: Array" for name, _ in POINT),
        "",
        "class Motion(TypedDict):",
        *(f"    {name}: Array" for name, _ in MOTION),
        "",
        "class Solution(TypedDict):",
        *(f"    {name}: Array" for name in ("accelerations", "efforts", "kinetic_energy", "potential_energy")),
        "    points: dict[str, Point]",
        "",
    ]
    models = [value for value in vars(module).values() if isinstance(value, type) and issubclass(value, Model) and value is not Model]
    parts = {}
    for model in models:
        for name, _, is_there, _, of in model._methods:
            if is_there and of[0][0]:
                parts[name] = [part for part, _, _ in of]
    lines += _recording_stub()
    for name, fields in parts.items():
        lines += [f"class {_result(name)}:", *(f"    {field}: Array" for field in fields), ""]
    lines += _stub_of(Model, parts, None)
    for model in models:
        lines += _stub_of(model, parts, model)
    return "\n".join(lines) + "\n"


def _result(name):
    return "".join(word.capitalize() for word in name.split("_")) + "Result"


_HOW = 'threads: int = 0, errors: Literal["raise", "nan"] = "raise"'
_METHOD = 'method: Literal["rk4", "semi_implicit_euler", "linearly_implicit_euler"] = "rk4"'


def _quoted(text, indent):
    lines = (text or "").strip().splitlines()
    body = [(indent + line.strip()).rstrip() for line in lines[1:]]
    escaped = [line.replace("\\", "\\\\").replace('"""', "'''") for line in lines[:1] + body]
    return [f'{indent}"""{escaped[0]}' + ('"""' if len(escaped) == 1 else "")] + escaped[1:] + ([f'{indent}"""'] if len(escaped) > 1 else [])


_RECORDING = {
    "__init__": 'model: "Model", *, velocities: bool = False',
    "record": "x: ArrayLike, inputs: ArrayLike | None = None, time: ArrayLike | None = None",
    "__len__": "",
    "__getitem__": "name: str",
    "arrays": "",
    "html": "*, title: str | None = None, meshes: str | PathLike[str] | None = None",
    "write_html": "path: str | PathLike[str], *, title: str | None = None, meshes: str | PathLike[str] | None = None",
    "write_csv": "path: str | PathLike[str]",
    "write_npz": "path: str | PathLike[str]",
    "svg": "frame: int = 0, *, meshes: str | PathLike[str] | None = None",
    "write_svg": "path: str | PathLike[str], frame: int = 0, *, meshes: str | PathLike[str] | None = None",
}
_RETURNS = {"__len__": "int", "__getitem__": "Array", "arrays": "dict[str, NDArray[Any]]", "html": "str", "svg": "str"}


def _recording_stub():
    lines = ["class Recording:", *_quoted(Recording.__doc__, "    "), "    columns: Names"]
    for name, arguments in _RECORDING.items():
        head = f"    def {name}(self{', ' if arguments else ''}{arguments}) -> {_RETURNS.get(name, 'None')}:"
        docs = getattr(Recording, name).__doc__ if not name.startswith("__") else None
        lines += [head, *_quoted(docs, "        ")] if docs else [head + " ..."]
    return lines + [""]


def _stub_of(cls, parts, model):
    indent = "    "
    if model is None:
        lines = ["class Model:", *_quoted(Model.__doc__, indent)]
        for name in ("coordinates", "rates", "efforts", "inputs", "parameters"):
            lines.append(f"    {name}: Names")
        lines += ["    name: str", "    dimension: str", "    answers: tuple[str, ...]", "    points: tuple[str, ...]"]
        lines += ["    frames: tuple[str, ...]", "    hinges: tuple[tuple[str, str, bool], ...]", "    lanes: int"]
        lines += ["    @property", "    def nx(self) -> int: ..."]
        lines += ["    def get(self, parameter: str) -> Any: ...", "    def set(self, parameter: str, value: ArrayLike) -> None: ..."]
        lines += ["    def initial(self, rows: int | None = None) -> Array: ..."]
        state = "x: ArrayLike, inputs: ArrayLike | None = None"
        lines += [f"    def step(self, x: Array, inputs: Array | None = None, h: float = 1e-3, n: int = 1, *, {_METHOD}, {_HOW}) -> None: ..."]
        lines += [f"    def rollout(self, {state}, h: float = 1e-3, n: int = 1, *, every: int = 1, {_METHOD}, {_HOW}) -> Array: ..."]
        lines += [f"    def record(self, {state}, h: float = 1e-3, *, velocities: bool = False) -> Recording: ..."]
        lines += [f"    def accelerations(self, {state}, *, {_HOW}) -> Array: ..."]
        lines += [f"    def energy(self, x: ArrayLike, *, {_HOW}) -> tuple[Array, Array]: ..."]
        lines += [f"    def assemble(self, {state}, *, {_HOW}) -> Array: ..."]
        lines += [f"    def solve(self, {state}, *, {_HOW}) -> Solution: ...", ""]
        return lines
    lines = [f"class {model.name}(Model):", *_quoted(model.__doc__, indent)]
    # The types of a parameter that is set and read: a number, or one for each repetition.
    types = {
        name: ("float", "float") if isinstance(places, int) else ("ArrayLike", "Array")
        for name, places in model._parameter_places.items()
        if isinstance(getattr(model, name, None), property)
    }
    arguments = "".join(f", {name}: {given} = ..." for name, (given, _) in types.items())
    arguments = f", *{arguments}" if arguments else ""
    lines.append(f"    def __init__(self{arguments}) -> None: ...")
    for name, (given, returned) in types.items():
        lines += ["    @property", f"    def {name}(self) -> {returned}:", *_quoted(getattr(model, name).__doc__, indent * 2)]
        lines += [f"    @{name}.setter", f"    def {name}(self, value: {given}) -> None: ..."]
    after = f"inputs: ArrayLike | None = None, *, {_HOW}"
    for name, _, is_there, given, _ in model._methods:
        if not is_there:
            continue
        returns = _result(name) if name in parts else "Array"
        if name == "dynamic_parameters":
            arguments = ""
        elif name == "push":
            changes = ", ".join(f"d_{part}: ArrayLike | None = None" for part in ("coordinates", "rates", "inputs", "parameters"))
            arguments = f", x: ArrayLike, inputs: ArrayLike | None = None, *, {changes}, {_HOW}"
        elif given:
            argument = {"pull": "weights"}.get(name, "vector" if name.endswith("times") else "accelerations")
            arguments = f", x: ArrayLike, {argument}: ArrayLike, {after}"
        else:
            arguments = f", x: ArrayLike, {after}"
        lines += [f"    def {name}(self{arguments}) -> {returns}:", *_quoted(getattr(Model, name).__doc__, indent * 2)]
    if {"kinematics", "jacobian"} & set(model.answers):
        lines.append(f"    def kinematics(self, frame: str, x: ArrayLike, {after}) -> Motion: ...")
    if "jacobian" in model.answers:
        lines.append(f"    def jacobian(self, frame: str, x: ArrayLike, {after}) -> Array: ...")
    return lines + [""]
