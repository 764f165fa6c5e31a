"""python -m mstmm_studies STUDY.py -o FOLDER: runs a study on this machine or on a cluster."""

import argparse
import os
import sys

import dask

from . import Study, digest, execute, read, summary
from .chunks import load
from .results import plot


def arguments():
    parser = argparse.ArgumentParser(prog="python -m mstmm_studies", description=__doc__)
    parser.add_argument("study", help="a file of Python with `sample(rng)` and `simulate(samples)`")
    parser.add_argument("-o", "--output", required=True, help="the folder for parts and results")
    parser.add_argument("--samples", type=int, default=1000)
    parser.add_argument("--chunk", type=int, default=100, help="samples in a chunk")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="processes on this machine")
    parser.add_argument("--scheduler", help="the address of a Dask scheduler, such as tcp://head:8786, instead of this machine")
    return parser.parse_args()


def client_of(given):
    from distributed import Client, LocalCluster

    # A worker that dies is not the fault of its chunk.
    dask.config.set({"distributed.scheduler.allowed-failures": 1000})
    if given.scheduler:
        return Client(given.scheduler)
    cluster = LocalCluster(n_workers=given.workers, threads_per_worker=1, dashboard_address=":0")
    return Client(cluster)


def main():
    given = arguments()
    study = Study(os.path.abspath(given.study), given.samples, given.chunk, given.seed)
    load(study.file)

    def report(done, count):
        print(f"\r{done} of {count} chunks", end="", file=sys.stderr, flush=True)

    with client_of(given) as client:
        print(f"dashboard: {client.dashboard_link}", file=sys.stderr)
        computed = execute(study, given.output, client, report)
        if not given.scheduler:
            client.cluster.close()
    values = read(study, given.output)
    names = [name for name in values if name != "sample"]
    print(f"\n{computed} chunks computed, {study.chunks - computed} found", file=sys.stderr)
    print(f"{'quantity':24}{'samples':>8}{'mean':>14}{'95 % interval':>30}{'q95':>14}")
    for row in summary(values, names):
        if row["count"]:
            interval = f"{row['low']:.6g} to {row['high']:.6g}"
            print(f"{row['name']:24}{row['count']:8}{row['mean']:14.6g}{interval:>30}{row['q95']:14.6g}")
    plot(values, names, os.path.join(given.output, "results.svg"))
    print(f"sha256 {digest(values)}")


if __name__ == "__main__":
    main()
