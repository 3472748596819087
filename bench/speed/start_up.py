"""From the start of the program to the first step of the full scene: tool, lattice, tie, lists, first forces, first
frame and checkpoint. The checkpoint is written last, so its time is that of the first step."""
import os
import pathlib
import subprocess
import tempfile
import time

DECK = pathlib.Path(__file__).resolve().parents[2] / "inputs" / "micro_milling.toml"


def measure(program, threads):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", DECK, "--whole", "--stop-after", "1", "--no-pictures", "-t", str(threads), "-o", folder]
        environment = {"OMP_WAIT_POLICY": "passive", "OMP_PROC_BIND": "false", **os.environ}
        begun = time.time()
        child = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status != 0:
            raise SystemExit(f"{DECK.name}: ended with status {status}")
        first_step = (pathlib.Path(folder) / "checkpoint.h5").stat().st_mtime - begun
        return {"deck": DECK.name, "seconds": first_step, "whole_run": time.time() - begun,
                "core_seconds": usage.ru_utime + usage.ru_stime, "most_resident": 1024 * usage.ru_maxrss}
