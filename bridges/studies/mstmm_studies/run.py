"""Runs the chunks of a study on the workers of a Dask cluster."""

import json
import pathlib
from dataclasses import asdict

from .chunks import compute_chunk, part_path


def missing(study, folder):
    """Returns the numbers of the chunks without a part."""
    return [number for number in range(study.chunks) if not part_path(folder, number).exists()]


def _claim(study, folder):
    """Writes the study beside its parts; refuses a folder with parts of another study."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    note = folder / "study.json"
    own = asdict(study) | {"text": pathlib.Path(study.file).read_text()}
    own["file"] = pathlib.Path(study.file).name
    if note.exists():
        known = json.loads(note.read_text())
        # More samples of the same study continue it.
        differing = [key for key in own if key != "samples" and known.get(key) != own[key]]
        # The last part of a study may be incomplete for one with more samples.
        if known["samples"] != study.samples and min(known["samples"], study.samples) % study.chunk:
            differing.append("samples")
        if differing:
            raise ValueError(f"{folder} has parts of another study: {', '.join(differing)} differ; use another folder")
    note.write_text(json.dumps(own, indent=1))


def execute(study, folder, client, report=lambda done, all: None):
    """Computes the chunks of a study that have no part yet. Returns the number of chunks computed.

    A worker that dies loses its chunk only, which another worker computes. `client` is one of `dask.distributed`. All workers
    must reach `folder`, the study's file and the wheels that it imports.
    """
    from distributed import as_completed

    _claim(study, folder)
    todo = missing(study, folder)
    folder = str(pathlib.Path(folder).resolve())
    futures = [client.submit(compute_chunk, study, number, folder, pure=False) for number in todo]
    done = study.chunks - len(todo)
    report(done, study.chunks)
    if futures:
        for future in as_completed(futures):
            future.result()
            done += 1
            report(done, study.chunks)
        # The scheduler forgets the chunks; else it warns of lost results when the workers end.
        client.cancel(futures)
    return len(todo)
