"""Parameters of models. The extension runs this text after `recording.py`."""

import re

import numpy as np


def _number(name, value):
    """Returns an argument as a float. A text is not a number, although `float` reads it."""
    number = value.item() if isinstance(value, np.ndarray) and value.ndim == 0 else value
    try:
        if isinstance(number, (str, bytes, bytearray, memoryview)):
            raise TypeError
        return float(number)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {value!r}") from None


def _numbers(name, value, count):
    """Returns an argument as a list of floats: a number for all of them, or a sequence with a number for each."""
    if isinstance(value, (str, bytes, bytearray, memoryview)) or np.ndim(value) == 0:
        return [_number(name, value)] * count
    shape = np.shape(value)
    if shape != (count,):
        raise ValueError(f"{name} must be a number or have the shape ({count},); its shape is {shape}")
    return [_number(f"{name}[{k}]", entry) for k, entry in enumerate(value)]


def _parameter_places(names):
    """Returns the index of each parameter, and the range of indices of each that has a value for each repetition."""
    places = {}
    for index, name in enumerate(names):
        repeated = re.fullmatch(r"(.+)\[\d+\]", name)
        if repeated is None:
            places[name] = index
        else:
            first = places.get(repeated[1], range(index, index)).start
            places[repeated[1]] = range(first, index + 1)
    return places


def _get(model, places):
    if isinstance(places, int):
        return model._parameter(places)
    values = np.array([model._parameter(index) for index in places])
    # A value that is written to the copy would not reach the model.
    values.flags.writeable = False
    return values


def _set(model, name, places, value):
    if isinstance(places, int):
        model._set_parameter(places, _number(name, value))
        return
    values = _numbers(name, value, len(places))
    before = []
    try:
        for index, new in zip(places, values):
            old = model._parameter(index)
            model._set_parameter(index, new)
            before.append((index, old))
    except ValueError:
        for index, old in reversed(before):
            model._set_parameter(index, old)
        raise


def _shown(value):
    """Returns a value as an argument of a class: one number for equal values."""
    if isinstance(value, float):
        return repr(value)
    values = value.tolist()
    return repr(values[0] if len(set(values)) == 1 else values)


def _property(name, places, names):
    def get(self):
        return _get(self, places)

    def set(self, value):
        _set(self, name, places, value)

    first = places if isinstance(places, int) else places.start
    unit, default = names.units[first], names.starts[first]
    start = "" if default is None else f"; its default is {default:g}"
    shape = "" if isinstance(places, int) else f", an array of the shape ({len(places)},) with a value for each repetition"
    return property(get, set, doc=f"The parameter `{name}` in {unit}{shape}{start}.")
