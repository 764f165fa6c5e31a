"""The classes of models. The extension runs this text after `parameters.py`, with `Core`, `module_name` and the texts of its
submodules."""

import math
import operator
import sys
import types

import numpy as np


# The results at a connection point with their shapes, in the order of the library.
POINT = [
    ("position", (3,)),
    ("orientation", (3, 3)),
    ("velocity", (3,)),
    ("angular_velocity", (3,)),
    ("acceleration", (3,)),
    ("angular_acceleration", (3,)),
    ("moment", (3,)),
    ("force", (3,)),
]

# The motion of a frame.
MOTION = POINT[:4] + [("bias_acceleration", (3,)), ("angular_bias_acceleration", (3,))]


def _split(raw, first, parts):
    """Returns views of entries from `first` on, by names and shapes, and the index behind them."""
    views = {}
    for name, shape in parts:
        count = int(np.prod(shape))
        views[name] = raw[..., first : first + count].reshape(raw.shape[:-1] + shape)
        first += count
    return views, first


def _whole(name, value):
    """Returns an argument that is a whole number from 0 on."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {value!r}") from None
    if number < 0:
        raise ValueError(f"{name} must not be negative, not {number}")
    return number


class Model(Core):  # noqa: F821 (set by the extension, as the names of `recording.py`)
    """A model of a chain of the library mstmm.

    A state is an array of coordinates, then rates, in the order of `coordinates` and `rates`. Arrays of states have a
    row for each state. All functions compute all rows, on all cores, without the interpreter's lock. A single state
    may be an array of one axis; results then have no axis of rows.

    Quantities are in SI units: angles in rad, translations in m, torques in N m, forces in N. ``coordinates``, ``rates``,
    ``efforts``, ``inputs`` and ``parameters`` list the names of entries with their ``units``. Below, nx is the number of
    entries of a state, n = len(rates) and nu = len(inputs); shapes are those for states of the shape (rows, nx).

    Keyword arguments of the functions: ``threads`` is their number, 0 for all cores; it has no effect on results.
    ``errors="nan"`` sets the results of states that cannot be computed to NaN; ``"raise"`` raises the library's error with
    the row.
    """

    def __init__(self, **parameters):
        for name, value in parameters.items():
            self.set(name, value)

    def __repr__(self):
        cls = type(self)
        values = ", ".join(f"{name}={_shown(self.get(name))}" for name in cls._parameter_places)
        return f"{cls.__qualname__}({values})"

    def __copy__(self):
        copy = type(self)()
        for index in range(len(type(self).parameters)):
            copy._set_parameter(index, self._parameter(index))
        return copy

    def __deepcopy__(self, memo):
        return self.__copy__()

    def __reduce__(self):
        return _restore, (type(self), [self._parameter(i) for i in range(len(type(self).parameters))])

    def get(self, parameter):
        """Returns a parameter by its name, in its unit of ``parameters.units``.

        The value is a float. A parameter with a value for each repetition, such as ``"ks"`` of ``param ks[3]``, is an array
        of the shape (repetitions,), which is read-only; ``"ks[1]"`` is one of its values.
        """
        return _get(self, self._places(parameter))

    def set(self, parameter, value):
        """Sets a parameter by its name to a float, in its unit of ``parameters.units``.

        A parameter with a value for each repetition also accepts an array of the shape (repetitions,); a float sets all its
        values. Raises ValueError with the library's reason if a value is refused; the parameter is then unchanged.
        """
        _set(self, parameter, self._places(parameter), value)

    def __setattr__(self, name, value):
        # Of the classes of chains only: classes that users derive from them may have further attributes.
        if "_maker" in vars(type(self)) and not hasattr(type(self), name):
            self.set(name, value)
        else:
            super().__setattr__(name, value)

    def _places(self, parameter):
        """Returns the index of a parameter, or the range of indices of one with a value for each repetition."""
        cls = type(self)
        if parameter in cls._parameter_places:
            return cls._parameter_places[parameter]
        if parameter in cls.parameters:
            return cls.parameters.index(parameter)
        known = ", ".join(cls._parameter_places) or "none"
        raise TypeError(f"{cls.__qualname__} has no parameter {parameter!r}; its parameters: {known}")

    @property
    def nx(self):
        """The number of entries of a state: coordinates, then rates; dimensionless."""
        return len(self.coordinates) + len(self.rates)

    def initial(self, rows=None):
        """Returns the state at the start of the description: the shape (nx,), or (rows, nx) with equal rows.

        Its units are those of `coordinates`, then of `rates`.
        """
        start = self._start()
        return start if rows is None else np.tile(start, (rows, 1))

    def _rows(self, job, arguments, x, inputs, given, threads, errors):
        """Returns the results of a job of the extension, with the axes of ``x``, then one axis of results."""
        x, threads = _as_array("x", x), _whole("threads", threads)
        raw = self._run(job, arguments, x, _as_array("inputs", inputs), given, threads, errors)
        return raw.reshape(x.shape[:-1] + raw.shape[-1:])

    def rollout(self, x, inputs=None, h=1e-3, n=1, *, every=1, method="rk4", threads=0, errors="raise"):
        """Returns the states over ``n`` steps of ``h`` seconds, from ``x`` on.

        The result has the shape (rows, n // every + 1, nx), in the units of `coordinates` and `rates`: the start, then one state
        after every ``every`` steps. Inputs have the shape (nu,), (rows, nu) or, for each step, (rows, n, nu), in the units of
        `inputs`. They are held over a step.
        """
        x, inputs = _as_array("x", x), _as_array("inputs", inputs)
        h, n, every = _number("h", h), _whole("n", n), _whole("every", every)
        if x.ndim == 1 and inputs is not None and inputs.ndim == 2:
            inputs = inputs[None]
        raw = self._rows("rollout", (method, h, n, every), x, inputs, None, threads, errors)
        return raw.reshape(x.shape[:-1] + (n // every + 1, self.nx))

    def record(self, x, inputs=None, h=1e-3, *, velocities=False):
        """Returns a `Recording` of the states ``x``, with the shape (frames, nx), at the times 0, ``h``, 2 ``h``, … in s.

        Inputs have the shape (nu,) or (frames, nu), or (frames - 1, nu) if the last ones are held, as those of `rollout`; their
        units are those of `inputs`. ``velocities=True`` also records the velocities of connection points.
        """
        x, inputs = _as_array("x", x), _as_array("inputs", inputs)
        if x.ndim == 2 and inputs is not None and inputs.ndim == 2 and len(inputs) == len(x) - 1 > 0:
            inputs = np.concatenate([inputs, inputs[-1:]])
        h = _number("h", h)
        if not math.isfinite(h) or h == 0:
            raise ValueError("h must be a finite step in s, and not zero")
        recording = Recording(self, velocities=velocities)
        recording.record(x, inputs, h * np.arange(len(x)) if x.ndim == 2 else 0.0)
        return recording

    def accelerations(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the accelerations of all rates (forward dynamics), in rad/s² and m/s².

        The shape is (rows, n), in the order of `rates`.
        """
        return self._rows("accelerations", (), x, inputs, None, threads, errors)

    def energy(self, x, *, threads=0, errors="raise"):
        """Returns kinetic and potential energy in J: two arrays of the shape (rows,)."""
        raw = self._rows("energies", (), x, None, None, threads, errors)
        return raw[..., 0], raw[..., 1]

    def assemble(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the states next to ``x`` that satisfy the loop constraints of a closed chain.

        The shape and the units are those of ``x``.
        """
        return self._rows("assembly", (), x, inputs, None, threads, errors)

    def solve(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns accelerations, efforts, energies and the results at all connection points.

        The result is a dict with the keys ``accelerations`` in rad/s² and m/s², shape (rows, n), ``efforts`` in N m and N, shape
        (rows, len(efforts)), ``kinetic_energy`` and ``potential_energy`` in J, shape (rows,), and ``points``. ``points`` is a dict
        by the names in `points`; each entry is a dict of arrays: ``position`` in m, ``orientation`` (rotation matrices from the
        point's frame to the inertial frame, dimensionless), ``velocity`` in m/s, ``angular_velocity`` in rad/s,
        ``acceleration`` in m/s², ``angular_acceleration`` in rad/s², and the internal ``moment`` in N m, which acts on the inboard
        element, and ``force`` in N, which acts on the outboard element; all in the inertial frame. Orientations have the shape
        (rows, 3, 3), the others (rows, 3). What the chain's setting ``results`` omits is NaN.
        """
        raw = self._rows("solution", (), x, inputs, None, threads, errors)
        parts = [("accelerations", (len(self.rates),)), ("efforts", (len(self.efforts),))]
        solution, first = _split(raw, 0, parts + [("kinetic_energy", ()), ("potential_energy", ())])
        solution["points"] = {}
        for name in self.points:
            solution["points"][name], first = _split(raw, first, POINT)
        return solution

    def kinematics(self, frame, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the motion of a frame on a body at zero accelerations, without dynamics, as a dict of arrays.

        A frame is a body and one of its points, such as ``"hand.output"``; `frames` lists all. The keys are ``position`` in m,
        ``orientation`` (rotation matrices from the frame to the inertial frame, dimensionless, shape (rows, 3, 3)), ``velocity``
        in m/s, ``angular_velocity`` in rad/s, ``bias_acceleration`` in m/s² and ``angular_bias_acceleration`` in rad/s²; shape
        (rows, 3), in the inertial frame.
        """
        self._needs("kinematics", "jacobian")
        motion, _ = self._frame(frame, 0, x, inputs, threads, errors)
        return motion

    def jacobian(self, frame, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the Jacobian of a frame in the inertial frame: rows velocity in m/s, then angular velocity in rad/s.

        The shape is (rows, 6, n) in space, (rows, 3, n) in a plane and (rows, 1, n) on a line. A column is for a unit of a rate, in
        rad/s or m/s. A frame is a body and one of its points, such as ``"hand.output"``.
        """
        self._needs("jacobian")
        rows = {"space": 6, "plane": 3, "line": 1}[self.dimension]
        _, jacobian = self._frame(frame, rows, x, inputs, threads, errors)
        return jacobian

    def _frame(self, frame, rows, x, inputs, threads, errors):
        if frame not in self.frames:
            raise ValueError(f"no frame {frame!r}; the frames are {', '.join(self.frames)}")
        raw = self._rows("motion", (*self._frame_places[frame], rows), x, inputs, None, threads, errors)
        motion, first = _split(raw, 0, MOTION)
        jacobian = raw[..., first:].reshape(raw.shape[:-1] + (len(self.rates), rows))
        return motion, np.swapaxes(jacobian, -1, -2)

    def _needs(self, *keywords):
        if not any(keyword in self.answers for keyword in keywords):
            raise NotImplementedError(
                f"the chain's setting `answers` omits `{keywords[0]}`: write `answers = [..., {keywords[0]}];` in the chain"
            )

    def _compute(self, number, x, inputs, given, threads, errors):
        name, keyword, is_there, given_len, parts = self._methods[number]
        if not is_there:
            if keyword in self.answers:
                raise NotImplementedError(f"a closed chain does not have `{name}`")
            self._needs(keyword)
        x, given = _as_array("x", x), _as_array("the given values", given)
        shape = x.shape[:-1]
        if given is not None:
            if given.ndim == 1 and given.shape == (given_len,):
                given = np.broadcast_to(given, shape + (given_len,))
            given = np.ascontiguousarray(given)
            if given.shape != shape + (given_len,):
                raise ValueError(f"the given values must have the shape {shape + (given_len,)}, not {given.shape}")
        raw = self._rows("answer", (number,), x, inputs, given, threads, errors)
        first, results = 0, {}
        for part, rows, columns in parts:
            count = rows * (1 if columns is None else columns)
            value = raw[..., first : first + count]
            if columns is not None:
                value = np.swapaxes(value.reshape(shape + (columns, rows)), -1, -2)
            results[part], first = value[..., 0] if part == "mass" else value, first + count
        return results[""] if list(results) == [""] else types.SimpleNamespace(**results)

    def _direction(self, coordinates, rates, inputs, parameters, shape):
        parts = [(coordinates, len(self.rates)), (rates, len(self.rates))]
        parts += [(inputs, len(self.inputs)), (parameters, len(self.parameters))]
        zeros = [np.zeros(shape + (count,)) if part is None else np.asarray(_as_array("the direction", part), np.float64) for part, count in parts]
        return np.concatenate([np.broadcast_to(part, shape + part.shape[-1:]) for part in zeros], axis=-1)

    def bias_efforts(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the efforts that keep all rates constant: inverse dynamics at zero accelerations.

        They are in N m and N, in the order of `rates`; shape (rows, n).
        """
        return self._compute(0, x, inputs, None, threads, errors)

    def inverse_dynamics(self, x, accelerations, inputs=None, *, threads=0, errors="raise"):
        """Returns the efforts that the drives must supply for given accelerations, in N m and N.

        Accelerations are in rad/s² and m/s². Both have the shape (rows, n), in the order of `rates`; accelerations may have (n,).
        """
        return self._compute(1, x, inputs, accelerations, threads, errors)

    def gravity_efforts(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the efforts that balance gravity at rest, in N m and N.

        The shape is (rows, n), in the order of `rates`.
        """
        return self._compute(2, x, inputs, None, threads, errors)

    def passive_efforts(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the efforts of springs, dampers, friction and limits, in N m and N.

        The shape is (rows, n), in the order of `rates`.
        """
        return self._compute(3, x, inputs, None, threads, errors)

    def mass_matrix(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the mass matrix, in kg m² for rotations, kg for translations and kg m between them.

        The shape is (rows, n, n), in the order of `rates`.
        """
        return self._compute(4, x, inputs, None, threads, errors)

    def inverse_mass_matrix(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the inverse of the mass matrix, in 1/(kg m²) for rotations, 1/kg for translations and 1/(kg m) between them.

        The shape is (rows, n, n), in the order of `rates`.
        """
        return self._compute(5, x, inputs, None, threads, errors)

    def mass_matrix_times(self, x, vector, inputs=None, *, threads=0, errors="raise"):
        """Returns the product of the mass matrix with a vector, without the matrix.

        Of accelerations in rad/s² and m/s² it is efforts in N m and N, of rates it is momenta in kg m²/s and kg m/s. Both have the
        shape (rows, n), in the order of `rates`; the vector may have (n,).
        """
        return self._compute(6, x, inputs, vector, threads, errors)

    def inverse_mass_matrix_times(self, x, vector, inputs=None, *, threads=0, errors="raise"):
        """Returns the product of the inverse of the mass matrix with a vector, without the matrix.

        Of efforts in N m and N it is accelerations in rad/s² and m/s². Both have the shape (rows, n), in the order of `rates`; the
        vector may have (n,).
        """
        return self._compute(7, x, inputs, vector, threads, errors)

    def inverse_dynamics_derivatives(self, x, accelerations, inputs=None, *, threads=0, errors="raise"):
        """Returns the derivatives of inverse dynamics: ``by_coordinates``, ``by_rates``, ``by_accelerations``.

        Each has the shape (rows, n, n): efforts in N m and N by displacements along the rates in rad and m, by rates in rad/s and
        m/s, and by accelerations in rad/s² and m/s², which is the mass matrix.
        """
        return self._compute(8, x, inputs, accelerations, threads, errors)

    def linearize(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the accelerations and their derivatives; ``a`` and ``b`` are the matrices of ẋ = a x + b u.

        x are displacements along the rates in rad and m, then changes of the rates in rad/s and m/s, so ``a`` has the shape
        (rows, 2 n, 2 n); u are changes of the inputs, in their units, and ``b`` has (rows, 2 n, nu). ``accelerations`` has the shape
        (rows, n), in rad/s² and m/s²; ``by_coordinates``, ``by_rates``, ``by_inputs`` and ``by_parameters`` are its derivatives with
        a column for each, and ``inverse_mass_matrix`` is the derivative by efforts.
        """
        return self._compute(9, x, inputs, None, threads, errors)

    def push(self, x, inputs=None, *, d_coordinates=None, d_rates=None, d_inputs=None, d_parameters=None, threads=0, errors="raise"):
        """Returns ``accelerations`` and their ``change`` along a direction (a product of their Jacobian with a vector).

        Both have the shape (rows, n), in rad/s² and m/s². The direction has ``d_coordinates``, displacements along the rates in rad
        and m, and ``d_rates``, with the shape (rows, n) or (n,); ``d_inputs`` and ``d_parameters``, one entry for each, in
        their units. What is omitted is zero.
        """
        x = _as_array("x", x)
        direction = self._direction(d_coordinates, d_rates, d_inputs, d_parameters, x.shape[:-1])
        return self._compute(10, x, inputs, direction, threads, errors)

    def pull(self, x, weights, inputs=None, *, threads=0, errors="raise"):
        """Returns ``accelerations`` and the gradient of their sum with ``weights`` (a product of a vector with their Jacobian).

        ``accelerations``, in rad/s² and m/s², and ``weights`` have the shape (rows, n); weights may have (n,). The gradient has
        ``coordinates``, by displacements along the rates in rad and m, and ``rates``, with the shape (rows, n), ``inputs`` with
        (rows, nu) and ``parameters`` with an entry for each parameter, by their units.
        """
        return self._compute(11, x, inputs, weights, threads, errors)

    def regressor(self, x, accelerations, inputs=None, *, threads=0, errors="raise"):
        """Returns the matrix that maps the dynamic parameters to efforts in N m and N, for given accelerations.

        The shape is (rows, n, p) for p dynamic parameters, as `dynamic_parameters` returns them. Accelerations are in rad/s² and
        m/s², with the shape (rows, n) or (n,).
        """
        return self._compute(12, x, inputs, accelerations, threads, errors)

    def dynamic_parameters(self):
        """Returns the dynamic parameters in SI units: masses in kg, first moments in kg m, inertias in kg m², and those of hinges.

        The shape is (p,), in the order of the columns of `regressor`.
        """
        return self._compute(13, self.initial(), None, None, 1, "raise")

    def momentum(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns ``mass``, ``center_of_mass``, ``linear`` momentum and ``angular`` momentum about the centre of mass.

        They are in kg, m, kg m/s and kg m²/s, in the inertial frame. ``mass`` has the shape (rows,), the others (rows, 3) in space. In a
        plane the angular momentum has (rows, 1) and the others (rows, 2); on a line they have (rows, 0) and (rows, 1).
        """
        return self._compute(14, x, inputs, None, threads, errors)

    def momentum_matrix(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the matrix that maps rates to linear momentum in kg m/s, then angular momentum in kg m²/s.

        The shape is (rows, 6, n) in space, (rows, 3, n) in a plane and (rows, 1, n) on a line.
        """
        return self._compute(15, x, inputs, None, threads, errors)

    def coriolis_matrix(self, x, inputs=None, *, threads=0, errors="raise"):
        """Returns the Coriolis matrix C, in kg m²/s for rotations, kg/s for translations and kg m/s between them.

        The shape is (rows, n, n), in the order of `rates`. The derivative of the mass matrix along the motion is C + Cᵀ.
        """
        return self._compute(16, x, inputs, None, threads, errors)

    def coriolis_matrix_times(self, x, vector, inputs=None, *, threads=0, errors="raise"):
        """Returns the product of the Coriolis matrix with a vector, without the matrix.

        Of rates in rad/s and m/s it is efforts in N m and N. Both have the shape (rows, n), in the order of `rates`; the vector may
        have (n,).
        """
        return self._compute(17, x, inputs, vector, threads, errors)


def _restore(cls, values):
    model = cls()
    for index, value in enumerate(values):
        model._set_parameter(index, value)
    return model


def _docs(description):
    lines = [description["docs"].strip() or f"The chain {description['name']}.", ""]
    for key in ("coordinates", "rates", "inputs", "parameters"):
        rows = description[key]
        if rows and len(rows) <= 64:
            lines += [f"{key.capitalize()}:", *(f"    {row[0]} in {row[1]}" for row in rows), ""]
        elif rows:
            lines += [f"{key.capitalize()}: {len(rows)}, see `{key}`.", ""]
    return "\n".join(lines)


def _make(module, maker):
    description = maker.describe()
    body = {
        "__doc__": _docs(description),
        "__module__": module.__name__,
        "_maker": maker,
        "_methods": description["methods"],
        "name": description["name"],
        "dimension": description["dimension"],
        "answers": tuple(description["answers"]),
        "points": tuple(description["points"]),
        "hinges": tuple(description["hinges"]),
        "lanes": description["lanes"],
    }
    for key in ("coordinates", "rates", "inputs", "parameters"):
        body[key] = Names(description[key])
    # These names are methods or free of units in the tables above.
    body["efforts"] = Names(description["efforts"])
    places = {}
    for number, (body_name, frames) in enumerate(description["bodies"]):
        for frame in frames:
            places[f"{body_name}.{frame}"] = (number, frame)
    body["frames"], body["_frame_places"] = tuple(places), places
    body["_parameter_places"] = _parameter_places(body["parameters"])
    for name, places in body["_parameter_places"].items():
        if not hasattr(Model, name) and name not in body:
            body[name] = _property(name, places, body["parameters"])
    return type(description["name"], (Model,), body)


def fill(module, makers):
    """Adds a class for each maker, and the submodules."""
    module.Model, module.Names, module.Recording = Model, Names, Recording
    Model.__module__ = Names.__module__ = Recording.__module__ = module.__name__
    _restore.__module__ = module.__name__
    module._restore = _restore
    for maker in makers:
        model = _make(module, maker)
        setattr(module, model.name, model)
    module.__all__ = [name for name in vars(module) if not name.startswith("_")]
    module._stubs = lambda: stubs(module)
    for name, text in (("environment", environment_text), ("gradients", gradients_text)):  # noqa: F821
        # A class or a function of these names has the package's own errors if its library is not installed.
        submodule = types.ModuleType(f"{module.__name__}.{name}")
        exec(compile(text, f"<{module.__name__}.{name}>", "exec"), submodule.__dict__)
        setattr(module, name, submodule)
        sys.modules[submodule.__name__] = submodule
        # The package of maturin has the extension of the same name inside.
        package = module.__name__.split(".")[0]
        sys.modules.setdefault(f"{package}.{name}", submodule)
        module.__all__.append(name)
