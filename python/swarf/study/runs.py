"""Runs the decks of a study, some at a time, and goes on where an earlier call has ended."""
import concurrent.futures
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from .. import decks, results

RETRIES = 2  # of a run that something killed, from its checkpoint


def program():
    """The swarf to run: the one that called us, or the one of the path."""
    found = os.environ.get("SWARF_PROGRAM") or shutil.which("swarf")
    if not found:
        raise ValueError("there is no swarf program: put it on the PATH, or set SWARF_PROGRAM")
    return found


class Folder:
    """Where a study keeps its decks, runs and tables."""

    def __init__(self, path):
        self.path = pathlib.Path(path)

    def deck(self, task):
        return self.path / "decks" / f"run_{task.number:04d}.toml"

    def run(self, task):
        return self.path / "runs" / f"run_{task.number:04d}"

    def log(self, task):
        return self.path / "runs" / f"run_{task.number:04d}.log"


def write_deck(study, folder, task):
    """Writes the deck of a task; what an earlier deck of that number gave, the study's own file, is removed."""
    path, run = folder.deck(task), folder.run(task)
    path.parent.mkdir(parents=True, exist_ok=True)
    run.parent.mkdir(parents=True, exist_ok=True)
    deck = study.deck_of(task)
    if "file" in deck.get("tool", {}):  # relative to the deck of the study
        deck["tool"]["file"] = str((study.deck_file.parent / deck["tool"]["file"]).resolve())
    for body in deck.get("body", []):
        if "file" in body:
            body["file"] = str((study.deck_file.parent / body["file"]).resolve())
    if path.exists() and decks.read(path) == deck:
        return
    shutil.rmtree(run, ignore_errors=True)
    decks.write(path, deck)


def is_complete(study, folder, task):
    run = folder.run(task)
    if not run.is_dir() or not folder.deck(task).exists():
        return False
    if study.windows:
        if not (run / "windows.json").exists():
            return False
        return all(one["ended"] == "complete" for one in results.read(run).joined["windows"].values())
    return results.read(run).is_complete


def command_of(study, folder, task):
    run = folder.run(task)
    command = [program(), "run", str(folder.deck(task)), "--output", str(run), "--no-pictures", "--threads",
               str(study.threads)]
    if study.windows:
        return command + ["--windows", study.windows, "--resume"]
    can_go_on = (run / "checkpoint.h5").exists() and (run / "history.csv").exists()
    return command + ["--resume" if can_go_on else "--overwrite"]


def run_task(study, folder, task):
    """Runs one task, unless it is complete, and again from its checkpoint if something kills it. Exit status."""
    write_deck(study, folder, task)
    if is_complete(study, folder, task):
        return 0
    for attempt in range(1 + RETRIES):
        with open(folder.log(task), "a") as log:
            status = subprocess.run(command_of(study, folder, task), stdout=log, stderr=subprocess.STDOUT).returncode
        if status >= 0 and status != 128 + signal.SIGKILL:
            break
        print(f"run {task.number}: was killed by signal {abs(status) % 128}; going on from its checkpoint", flush=True)
    return status


def show(seconds):
    return f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min" if seconds < 7200 else \
        f"{seconds / 3600:.1f} h"


def run_all(study, folder, jobs):
    """{number of the task: exit status}."""
    for task in study.tasks:
        write_deck(study, folder, task)
    waiting = [task for task in study.tasks if not is_complete(study, folder, task)]
    done = {task.number: 0 for task in study.tasks if task not in waiting}
    if done:
        print(f"{len(done)} of {len(study.tasks)} runs are complete already", flush=True)
    begin = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = {pool.submit(run_task, study, folder, task): task for task in waiting}
        try:
            for count, future in enumerate(concurrent.futures.as_completed(futures), 1):
                task = futures[future]
                done[task.number] = future.result()
                passed = time.monotonic() - begin
                left = passed / count * (len(waiting) - count)
                state = "complete" if done[task.number] == 0 else f"ended with status {done[task.number]}, see " \
                    f"{folder.log(task)}"
                print(f"run {task.number}: {state}; {len(study.tasks) - len(waiting) + count} of {len(study.tasks)}, "
                      f"{show(passed)} so far, about {show(left)} left", flush=True)
        except KeyboardInterrupt:
            print("interrupted; the same command goes on", file=sys.stderr)
            pool.shutdown(cancel_futures=True)
            raise
    return done
