"""The same bits for any number of workers, also when workers are killed; resuming; statistics."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import dask
import numpy as np
import pyarrow.parquet
import pytest
from distributed import Client, LocalCluster
from mstmm_studies import Study, compute_chunk, digest, execute, missing, part_path, read, summary

FILE = str(pathlib.Path(__file__).parents[1] / "pole_on_cart.py")
STUDY = Study(FILE, samples=120, chunk=10, seed=7)
dask.config.set({"distributed.scheduler.allowed-failures": 1000})


def run(folder, workers, disturb=None):
    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        stop = threading.Event()
        thread = threading.Thread(target=disturb or (lambda *_: None), args=(cluster, stop, folder))
        thread.start()
        try:
            execute(STUDY, folder, client)
        finally:
            stop.set()
            thread.join()
    return digest(read(STUDY, folder))


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    folder = tmp_path_factory.mktemp("one")
    for number in range(STUDY.chunks):
        compute_chunk(STUDY, number, folder)
    return digest(read(STUDY, folder))


@pytest.mark.parametrize("workers", [1, 3])
def test_any_number_of_workers_gives_the_same_bits(tmp_path, expected, workers):
    assert run(tmp_path, workers) == expected


def test_killed_workers_do_not_change_the_bits(tmp_path, expected):
    killed = []

    def disturb(cluster, stop, folder):
        # The first workers die as soon as some part exists, so some chunk is always lost or about to begin.
        while len(killed) < 3 and not stop.is_set():
            if len(list(pathlib.Path(folder).glob("part-*"))) > len(killed):
                # Nannies restart their workers, with other process numbers.
                pids = [worker.pid for worker in cluster.workers.values() if worker.pid and worker.pid not in killed]
                if pids:
                    os.kill(pids[0], signal.SIGKILL)
                    killed.append(pids[0])
            time.sleep(0.01)

    assert run(tmp_path, 2, disturb) == expected
    assert killed, "no worker was killed"


def test_a_killed_study_continues_with_the_parts_that_exist(tmp_path, expected):
    command = [sys.executable, "-m", "mstmm_studies", FILE, "-o", str(tmp_path), "--samples", "120", "--chunk", "10", "--seed", "7", "--workers", "1"]
    first = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    deadline = time.monotonic() + 120
    while not part_path(tmp_path, 2).exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    os.killpg(first.pid, signal.SIGKILL)
    first.wait()
    left = len(missing(STUDY, tmp_path))
    assert left < STUDY.chunks
    times = {path: path.stat().st_mtime_ns for path in tmp_path.glob("part-*")}
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert f"{left} chunks computed, {STUDY.chunks - left} found" in done.stderr
    assert f"sha256 {expected}" in done.stdout
    assert all(path.stat().st_mtime_ns == time for path, time in times.items()), "parts are not written again"
    assert (tmp_path / "results.svg").read_text().startswith("<?xml")


def test_samples_do_not_depend_on_chunks(tmp_path):
    for chunk in (7, 40):
        study = Study(FILE, samples=40, chunk=chunk, seed=3)
        folder = tmp_path / str(chunk)
        folder.mkdir()
        for number in range(study.chunks):
            compute_chunk(study, number, folder)
    hashes = {digest(read(Study(FILE, 40, chunk, 3), tmp_path / str(chunk))) for chunk in (7, 40)}
    assert len(hashes) == 1


def test_a_folder_of_another_study_is_refused(tmp_path):
    class Nobody:
        def submit(self, *_, **__):
            raise AssertionError("nothing is computed")

    done = Study(FILE, 10, 10, 1)
    compute_chunk(done, 0, tmp_path)
    execute(done, tmp_path, Nobody())
    with pytest.raises(ValueError, match="parts of another study: seed differ"):
        execute(Study(FILE, 10, 10, 2), tmp_path, Nobody())
    table = pyarrow.parquet.read_table(part_path(tmp_path, 0))
    assert b"pole_on_cart.py" in table.schema.metadata[b"study"]


def test_intervals_cover_the_truth_as_often_as_they_say():
    print("seed 9")
    rng, covered, events = np.random.default_rng(9), 0, 0
    for _ in range(400):
        row = summary({"a": rng.normal(2.0, 3.0, 200)}, ["a"])[0]
        covered += row["low"] < 2.0 < row["high"]
        row = summary({"b": (rng.random(200) < 0.1).astype(float)}, ["b"])[0]
        events += row["low"] < 0.1 < row["high"]
    # 380 are expected; the standard deviation is 4.4, so five of them are 22.
    assert abs(covered - 380) < 22 and abs(events - 380) < 25


def test_payloads_have_the_hash_of_the_study_in_rust(tmp_path):
    """The test of the crate `mstmm-payloads` has the same samples and the same hash."""
    study = Study(str(pathlib.Path(FILE).with_name("payloads.py")), samples=40, chunk=16, seed=7)
    for number in range(study.chunks):
        compute_chunk(study, number, tmp_path)
    assert digest(read(study, tmp_path)) == "ff2c01cb4b5fc7872dd0ef4eb1a0e6409422c6bdb6b7be63c3f3486316672f06"
