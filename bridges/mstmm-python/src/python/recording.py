"""Names of quantities, and recordings. The extension runs this text first."""

import html
import os

import numpy as np


class Names(tuple):
    """The names of quantities, in the order of the entries of arrays.

    ``units``, ``starts``, ``limits`` and ``kinds`` have an entry for each name. A start is ``None`` where the
    description has none, limits are ``None`` or the lowest and the highest value; both are in the unit of their name. Units
    are texts such as ``"rad/s"``; ``"1"`` is dimensionless.
    """

    def __new__(cls, rows):
        names = super().__new__(cls, (row[0] for row in rows))
        names.units = tuple(row[1] for row in rows)
        names.starts = tuple(row[2] for row in rows)
        names.limits = tuple(row[3] for row in rows)
        names.kinds = tuple(row[4] for row in rows)
        return names

    def __reduce__(self):
        return Names, (list(zip(self, self.units, self.starts, self.limits, self.kinds)),)

    def __repr__(self):
        width = max((len(name) for name in self), default=0)
        return "\n".join(f"{name:{width}}  {unit}" for name, unit in zip(self, self.units))


def _as_array(name, value):
    """Returns an argument that is no array as an array; arrays are checked by the extension. Texts are not numbers."""
    if value is None:
        return value
    try:
        if np.asarray(value).dtype.kind in "SU":
            raise TypeError("it has texts")
        return value if isinstance(value, np.ndarray) else np.ascontiguousarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name} must be an array of float64: {error}") from None


class Recording:
    """The recorded motion of a model: a table with a row for each frame, for pages, plots and files.

    It keeps a copy of the model with the parameters that are set. A notebook shows its page. ``recording[name]`` is a column
    with the shape (frames,), such as ``recording["bob.input.force.x"]`` in N; ``columns`` has all names with their
    ``units``. ``velocities=True`` also records the velocities of connection points in m/s and rad/s.
    """

    def __init__(self, model, *, velocities=False):
        self._name = model.name
        parameters = [model._parameter(index) for index in range(len(model.parameters))]
        self._core = model._maker.recorder(parameters, velocities)
        self.columns = Names([(name, unit, None, None, "") for name, unit in self._core.columns()])
        self._indices = {name: index for index, name in enumerate(self.columns)}

    def record(self, x, inputs=None, time=None):
        """Records a state, or the states of an array with the shape (frames, nx), with the results of `Model.solve`.

        States have the units of `Model.coordinates` and `Model.rates`. Inputs have the shape (nu,) or (frames, nu), in the units of
        `Model.inputs`. ``time`` has the time of each frame in s; only the first frame of a
        recording may omit it, which is then at zero. Frames before one that cannot be computed are recorded.
        """
        x, inputs = _as_array("x", x), _as_array("inputs", inputs)
        if time is None:
            if len(self) > 0 or x.ndim != 1:
                raise ValueError("time is missing: write record(x, inputs, time), with a time in s for each frame")
            time = 0.0
        self._core.record(x, inputs, np.atleast_1d(np.asarray(_as_array("time", time), np.float64)).tolist())

    def __len__(self):
        return self._core.len()

    def __repr__(self):
        return f"<Recording of {self._name}: {len(self)} frames of {len(self.columns)} quantities>"

    def __getitem__(self, name):
        if name not in self._indices:
            raise KeyError(f"no quantity {name!r}; `columns` lists all")
        return self._core.values(self._indices[name], 1)

    def arrays(self):
        """Returns a dict of arrays with an entry for each frame, as `write_npz` writes it.

        ``time`` in s has the shape (frames,), ``coordinates`` (frames, entries), ``force`` in N (frames, points, 3) and so on;
        the units are those of ``columns``.
        """
        arrays = {}
        for name, first, shape, names in self._core.blocks():
            arrays[name] = self._core.values(first, int(np.prod(shape))).reshape([len(self), *shape])
            if names is not None:
                arrays[names[0]] = np.array(names[1])
        return arrays

    def html(self, *, title=None, meshes=None):
        """Returns the page as text. ``meshes`` is the folder of the STL and OBJ files of shapes."""
        return self._core.html(title, None if meshes is None else os.fspath(meshes))

    def write_html(self, path, *, title=None, meshes=None):
        """Writes a page that shows the motion with all forces: one file, which needs no network."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html(title=title, meshes=meshes))

    def write_csv(self, path):
        """Writes a CSV file with a head of names and units and a row for each frame; its numbers read back to the same bits."""
        self._core.write_csv(os.fspath(path))

    def write_npz(self, path):
        """Writes the arrays of `arrays`, and units, as an NPZ file for `numpy.load`."""
        self._core.write_npz(os.fspath(path))

    def svg(self, frame=0, *, meshes=None):
        """Returns a still picture of a frame with its forces as text; -1 is the last frame."""
        if not -len(self) <= frame < len(self):
            raise IndexError(f"the recording has {len(self)} frames, none is {frame}")
        return self._core.svg(frame % len(self), None if meshes is None else os.fspath(meshes))

    def write_svg(self, path, frame=0, *, meshes=None):
        """Writes a still picture of a frame with its forces as SVG; -1 is the last frame."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg(frame, meshes=meshes))

    def _repr_html_(self):
        # A frame of its own, whose styles and program do not meet those of the notebook.
        if len(self) == 0:
            return f"<p>{html.escape(repr(self))}</p>"
        page = html.escape(self.html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 640px; border: 0" allowfullscreen></iframe>'
