"""A study as an array job of Slurm: each task of the array is one run, what is complete is left out."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from .runs import is_complete, program, write_deck


def ranges(numbers):
    """"0-3,7" of [0, 1, 2, 3, 7]."""
    parts = []
    for number in numbers:
        if parts and parts[-1][1] == number - 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ",".join(f"{first}-{last}" if last > first else f"{first}" for first, last in parts)


def script_of(study, folder, numbers, jobs):
    log = (folder.path / "slurm").resolve()
    package = pathlib.Path(__file__).resolve().parents[2]
    again = f"{shlex.quote(sys.executable)} -m swarf study {shlex.quote(str(study.file.resolve()))} --output " \
        f"{shlex.quote(str(folder.path.resolve()))}"
    name = re.sub(r"[^A-Za-z0-9_.-]+", "_", study.title)[:60] or "study"
    return f"""#!/bin/bash
#SBATCH --job-name={name}
#SBATCH --array={ranges(numbers)}%{jobs}
#SBATCH --cpus-per-task={study.threads}
#SBATCH --output={log}/%a.log
#SBATCH --open-mode=append
#SBATCH --requeue
export SWARF_PROGRAM={shlex.quote(program())} PYTHONPATH={shlex.quote(str(package))}
exec {again} --task "$SLURM_ARRAY_TASK_ID"
""", f"exec env SWARF_PROGRAM={shlex.quote(program())} PYTHONPATH={shlex.quote(str(package))} {again} --collect"


def sbatch(arguments, script=None):
    done = subprocess.run(["sbatch", "--parsable", *arguments], input=script, text=True, capture_output=True)
    if done.returncode:
        raise ValueError(f"sbatch: {done.stderr.strip() or 'failed'}")
    return done.stdout.strip().split(";")[0]


def submit(study, folder, jobs, options):
    """Writes study.sbatch, submits it and a job behind it that makes the tables. The numbers of both, or None."""
    if not shutil.which("sbatch"):
        raise ValueError("--submit slurm: there is no sbatch here; run it where Slurm's commands are")
    for task in study.tasks:
        write_deck(study, folder, task)
    missing = [task.number for task in study.tasks if not is_complete(study, folder, task)]
    if not missing:
        return None
    (folder.path / "slurm").mkdir(exist_ok=True)
    script, collect = script_of(study, folder, missing, jobs)
    path = folder.path / "study.sbatch"
    path.write_text(script)
    options = shlex.split(options)
    array = sbatch([*options, os.fspath(path)])
    after = sbatch([*options, f"--dependency=afterany:{array}", "--job-name=collect",
                    f"--output={(folder.path / 'slurm' / 'collect.log').resolve()}", f"--wrap={collect}"])
    return array, after
