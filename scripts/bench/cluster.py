"""Measures plantigrade.ray on a cluster of this machine: two nodes with one processor each.

Usage: python scripts/bench/cluster.py CLIPS_FOLDER [CLIPS_OF_SHORT_RUN]

Labels all clips of the folder with two nodes and kills one worker in the middle; then labels some of them with
one node and with two, for the ratio of their throughputs. Prints the figures as JSON. Requires the wheel with
its extra `ray`, and Linux.
"""

from __future__ import annotations

import json
import os
import secrets
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import pyarrow.parquet as pq

PORT = 6399
# Ray replaces 127.0.0.1 by the address of the machine in its network, which may not be reachable.
HEAD = f"127.0.0.2:{PORT}"
RAY = str(Path(sys.executable).with_name("ray"))
#: All processes of the cluster have one token, which others do not know.
ENVIRONMENT = {**os.environ, "RAY_AUTH_MODE": "token", "RAY_AUTH_TOKEN": secrets.token_hex(32)}
#: Runs in a process of its own, because a process can join one cluster only.
DRIVER = """
import json, sys, time
import ray
from plantigrade import ray as plantigrade_ray
ray.init(address=sys.argv[1], log_to_driver=False)
inputs = json.load(open(sys.argv[2]))
start = time.perf_counter()
summary = plantigrade_ray.run(inputs, sys.argv[3])
print("SUMMARY", json.dumps([time.perf_counter() - start, *summary]))
"""


def start(node: int) -> subprocess.Popen[bytes]:
    """Start the head or a further node on a processor of its own."""
    place = ["--head", f"--port={PORT}"] if node == 0 else [f"--address={HEAD}"]
    place.append(f"--node-ip-address=127.0.0.{node + 2}")
    command = ["taskset", "-c", str(node), RAY, "start", "--block", *place, "--num-cpus=1"]
    command += ["--object-store-memory=300000000", "--disable-usage-stats"]
    command += ["--include-dashboard=false"] if node == 0 else []
    process = subprocess.Popen(
        command,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=ENVIRONMENT,
        start_new_session=True,
    )
    time.sleep(15)
    return process


def workers() -> dict[int, int]:
    """Return the resident memory of each worker that labels clips, by process."""
    found = {}
    for status in Path("/proc").glob("[0-9]*/status"):
        try:
            pid = int(status.parent.name)
            title = (status.parent / "cmdline").read_bytes().replace(b"\0", b" ")
            if title.startswith(b"ray::MapBatches"):
                line = next(line for line in status.read_text().splitlines() if line.startswith("VmRSS"))
                found[pid] = int(line.split()[1]) * 1024
        except (OSError, StopIteration):
            continue
    return found


def run(node_count: int, inputs: list[str], kill_after: int | None = None) -> dict[str, object]:
    """Label clips and return the figures; kill a worker when some files of results exist."""
    processes = [start(node) for node in range(node_count)]
    try:
        with tempfile.TemporaryDirectory() as folder:
            out, listing = Path(folder) / "labels", Path(folder) / "inputs.json"
            listing.write_text(json.dumps(inputs))
            largest, killed = 0, []
            is_done = threading.Event()

            def watch() -> None:
                nonlocal largest
                while not is_done.wait(0.2):
                    current = workers()
                    largest = max([largest, *current.values()])
                    is_time = kill_after is not None and len(list(out.glob("*.parquet"))) >= kill_after
                    if is_time and not killed and current:
                        killed.append(next(iter(current)))
                        os.kill(killed[0], signal.SIGKILL)

            watcher = threading.Thread(target=watch, daemon=True)
            watcher.start()
            # On the processor of the head, which one node would otherwise have in addition.
            command = ["taskset", "-c", "0", sys.executable, "-c", DRIVER, HEAD, str(listing), str(out)]
            started = time.perf_counter()
            output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env=ENVIRONMENT).stdout
            total = time.perf_counter() - started
            is_done.set()
            watcher.join()
            line = next(line for line in output.splitlines() if line.startswith("SUMMARY"))
            seconds, clips, labelled, failures, repeated, frames, _ = json.loads(line[8:])
            names = pq.read_table(out, columns=["clip"])["clip"].to_pylist()
            return {
                "nodes": node_count,
                "clips": clips,
                "labelled": labelled,
                "failures": failures,
                "rows": len(names),
                "missing": len(set(inputs) - set(names)),
                "repeated": repeated,
                "frames": frames,
                "seconds": round(seconds, 1),
                "seconds with start": round(total, 1),
                "clips per second": round(clips / seconds, 1),
                "killed workers": len(killed),
                "largest worker, MB": round(largest / 1e6),
            }
    finally:
        for process in reversed(processes):
            os.killpg(process.pid, signal.SIGTERM)
            process.wait()
        time.sleep(10)


def main() -> None:
    """Run the measurements."""
    inputs = sorted(str(path) for path in Path(sys.argv[1]).resolve().rglob("*.bvh"))
    short = inputs[:: max(1, len(inputs) // int(sys.argv[2] if len(sys.argv) > 2 else 4000))]
    kill_after = len(inputs) // 256 // 2
    for title, node_count, clips, kill in (
        ("all clips, one worker killed", 2, inputs, kill_after),
        ("one node", 1, short, None),
        ("two nodes", 2, short, None),
    ):
        print(json.dumps({title: run(node_count, clips, kill)}, indent=2), flush=True)


if __name__ == "__main__":
    main()
