"""A study and its chunks. A chunk depends on the study, the seed and its number only."""

import importlib.util
import json
import os
import pathlib
import uuid
from dataclasses import asdict, dataclass

import numpy as np
import pyarrow
import pyarrow.parquet


@dataclass(frozen=True)
class Study:
    """A study: a file of Python with functions, the number of samples, and how they are divided.

    The file has ``sample(rng)``, which returns a dict of numbers drawn for one sample, and ``simulate(samples)``, which gets
    a dict of arrays with one entry for each sample and returns a dict of arrays of results. Sample number ``i`` has its own
    generator from ``[seed, i]``, so its numbers do not depend on chunks.
    """

    file: str
    samples: int
    chunk: int
    seed: int

    @property
    def chunks(self):
        """The number of chunks."""
        return -(-self.samples // self.chunk)

    def rows(self, number):
        """Returns the numbers of the samples in a chunk."""
        return range(number * self.chunk, min((number + 1) * self.chunk, self.samples))


def load(file):
    """Returns the module of a study's file."""
    path = pathlib.Path(file).resolve()
    spec = importlib.util.spec_from_file_location(f"study_{path.stem}", path)
    if spec is None or not path.exists():
        raise FileNotFoundError(f"no study {file}")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    for name in ("sample", "simulate"):
        if not hasattr(module, name):
            raise AttributeError(f"{file} has no function `{name}`")
    return module


def part_path(folder, number):
    """Returns the file of a chunk."""
    return pathlib.Path(folder) / f"part-{number:06}.parquet"


def compute_chunk(study, number, folder):
    """Computes a chunk and writes its part, unless it exists. Returns the number.

    The part is written under another name and renamed, so a part that exists is complete. Two workers that compute the
    same chunk write the same bytes.
    """
    path = part_path(folder, number)
    if path.exists():
        return number
    module, rows = load(study.file), study.rows(number)
    drawn = [module.sample(np.random.default_rng([study.seed, row])) for row in rows]
    samples = {name: np.array([one[name] for one in drawn], np.float64) for name in drawn[0]}
    results = {name: np.asarray(values, np.float64) for name, values in module.simulate(samples).items()}
    for name, values in results.items():
        if values.shape != (len(rows),):
            raise ValueError(f"the result {name!r} has the shape {values.shape}, not ({len(rows)},)")
        if name in samples:
            raise ValueError(f"{name!r} is drawn and a result")
    table = pyarrow.table({"sample": np.arange(rows.start, rows.stop), **samples, **results})
    table = table.replace_schema_metadata({"study": json.dumps(asdict(study) | {"file": pathlib.Path(study.file).name})})
    other = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    pyarrow.parquet.write_table(table, other)
    with open(other, "rb") as written:
        os.fsync(written.fileno())
    os.replace(other, path)
    return number
