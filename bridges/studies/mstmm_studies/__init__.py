"""Monte-Carlo and parameter studies of models on many processes and machines, by Dask."""

from .chunks import Study, compute_chunk, load, part_path
from .run import execute, missing
from .results import digest, read, summary

__all__ = ["Study", "compute_chunk", "digest", "execute", "load", "missing", "part_path", "read", "summary"]
