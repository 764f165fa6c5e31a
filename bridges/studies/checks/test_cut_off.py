"""A host that is cut off from the network on the way: its chunks are computed by another host, with the same bits.

The hosts are network namespaces with a bridge between them, so the test needs root and `ip`.
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import dask
import pytest
from distributed import Client
from mstmm_studies import Study, compute_chunk, digest, execute, part_path, read

FILE = str(pathlib.Path(__file__).parents[1] / "pole_on_cart.py")
STUDY = Study(FILE, samples=120, chunk=6, seed=8)
NAME = f"ms{os.getpid() % 10000}"


def ip(*arguments):
    subprocess.run(["ip", *arguments], check=True, capture_output=True)


@pytest.fixture
def hosts():
    """Two namespaces, at 10.199.x.2 and 10.199.x.3, and the bridge of this machine at 10.199.x.1."""
    if os.geteuid() != 0 or shutil.which("ip") is None:
        pytest.skip("network namespaces need root and `ip`")
    net, made = f"10.199.{os.getpid() % 250}", []
    try:
        ip("link", "add", f"{NAME}b", "type", "bridge")
        made.append(("link", "del", f"{NAME}b"))
        ip("addr", "add", f"{net}.1/24", "dev", f"{NAME}b")
        ip("link", "set", f"{NAME}b", "up")
        for host in (2, 3):
            ip("netns", "add", f"{NAME}{host}")
            made.append(("netns", "del", f"{NAME}{host}"))
            ip("link", "add", f"{NAME}o{host}", "type", "veth", "peer", "name", "eth0", "netns", f"{NAME}{host}")
            ip("link", "set", f"{NAME}o{host}", "master", f"{NAME}b", "up")
            inside = ("netns", "exec", f"{NAME}{host}", "ip")
            ip(*inside, "addr", "add", f"{net}.{host}/24", "dev", "eth0")
            ip(*inside, "link", "set", "eth0", "up")
            ip(*inside, "link", "set", "lo", "up")
    except subprocess.CalledProcessError as error:
        for command in reversed(made):
            subprocess.run(["ip", *command], capture_output=True)
        pytest.skip(f"network namespaces cannot be made: {error.stderr.decode().strip()}")
    yield net
    for command in reversed(made):
        subprocess.run(["ip", *command], capture_output=True)


def test_a_host_that_is_cut_off_does_not_change_the_bits(tmp_path, hosts):
    alone = tmp_path / "alone"
    alone.mkdir()
    for number in range(STUDY.chunks):
        compute_chunk(STUDY, number, alone)
    expected = digest(read(STUDY, alone))

    environment = os.environ | {
        "DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "4s",
        "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "1000",
    }
    address, folder, started = f"tcp://{hosts}.1:8786", tmp_path / "cut", []

    def start(*command):
        log = open(tmp_path / f"{len(started)}.log", "w")
        own = subprocess.Popen(command, env=environment, stdout=log, stderr=log, start_new_session=True)
        started.append(own)

    try:
        dask_ = [sys.executable, "-m", "distributed.cli.dask_scheduler"]
        start(*dask_, "--host", f"{hosts}.1", "--port", "8786", "--no-dashboard")
        for host in (2, 3):
            worker = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-dashboard"]
            start("ip", "netns", "exec", f"{NAME}{host}", *worker)
        with dask.config.set({"distributed.comm.timeouts.connect": "60s"}), Client(address) as client:
            client.wait_for_workers(2, timeout=60)
            cut = []

            def report(done, count):
                # After some parts, while the others are on the queues of both hosts.
                if done >= 3 and not cut:
                    ip("link", "set", f"{NAME}o2", "down")
                    cut.append(time.monotonic())

            assert execute(STUDY, folder, client, report) == STUDY.chunks
            assert cut, "no host was cut off"
    finally:
        for process in started:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    assert part_path(folder, STUDY.chunks - 1).exists()
    assert digest(read(STUDY, folder)) == expected
