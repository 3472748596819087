"""swarf study STUDY.toml"""
import argparse
import math
import pathlib
import shutil

from . import effects, pictures, plan, runs, slurm, table


def read_arguments(arguments):
    parser = argparse.ArgumentParser(prog="swarf study", description="Runs a deck many times, as a study says, and puts "
                                     "the results together. The same command goes on with what is missing.")
    parser.add_argument("study", help="a TOML file: docs/guide/study.md")
    parser.add_argument("-o", "--output", help="folder (default results/NAME of the study)")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="runs side by side")
    parser.add_argument("--list", action="store_true", help="say what would run, and run nothing")
    parser.add_argument("--collect", action="store_true", help="run nothing; tables and pictures of what is complete")
    parser.add_argument("--task", type=int, help="run this one task only")
    parser.add_argument("--submit", choices=["slurm"], help="hand the runs to a cluster instead of running them")
    parser.add_argument("--slurm-options", default="", help='for sbatch, such as "--partition=long --time=8:00:00"')
    options = parser.parse_args(arguments)
    if options.jobs < 1:
        parser.error("--jobs: expected 1 or more")
    return options


def open_folder(study, path):
    folder = runs.Folder(path)
    kept = folder.path / "study.toml"
    if folder.path.is_dir() and any(folder.path.iterdir()) and not kept.exists():
        raise ValueError(f"{path}: is not the folder of a study; choose another with --output")
    folder.path.mkdir(parents=True, exist_ok=True)
    if not kept.exists() or not kept.samefile(study.file):
        shutil.copyfile(study.file, kept)
    return folder


def show_point(study, point):
    return ", ".join(f"{one.name} = {point[one.name]}" for one in study.parameters)


def collect(study, folder):
    """Tables and pictures; how many points are there."""
    points = table.join_repeats(study, table.measure(study, folder))
    if not points:
        print("no run is complete: nothing to put together")
        return 0
    table.write(study, folder, points)
    unit = table.UNITS[study.response]
    surface, why_not = effects.fit_surface(study, points)
    bars, base = effects.tornado(study, points, surface)
    drawn = [pictures.draw_main_effects(study, effects.main_effects(study, points), folder.path / "main_effects.png")]
    if bars and not math.isnan(base):
        drawn.append(pictures.draw_tornado(study, bars, base, folder.path / "tornado.png"))
    if surface:
        drawn.append(pictures.draw_surface(study, surface, bars, folder.path / "surface.png"))
    print(f"\n{study.response} [{unit}], base {base:.4g}")
    for bar in bars:
        print(f"  {bar.parameter.name:<24} {bar.low:8.4g} at {bar.low_value} to {bar.high:8.4g} at {bar.high_value}")
    print(f"surface: {surface.model.name}, off by {surface.error:.3g} {unit} at points left out" if surface else
          f"no surface: {why_not}")
    print(f"table: {folder.path / 'study.csv'}, study.h5; pictures: {', '.join(path.name for path in drawn)}")
    return len(points)


def main(arguments):
    options = read_arguments(arguments)
    study = plan.read(options.study)
    if options.list:
        for task in study.tasks:
            print(f"run {task.number}: {show_point(study, study.points[task.point])}"
                  + (f", repeat {task.repeat}" if study.repeats["count"] > 1 else ""))
        return 0
    folder = open_folder(study, options.output or pathlib.Path("results") / study.file.stem)
    if options.task is not None:
        if not 0 <= options.task < len(study.tasks):
            raise ValueError(f"--task {options.task}: the study has tasks 0 to {len(study.tasks) - 1}")
        return runs.run_task(study, folder, study.tasks[options.task])
    if options.submit:
        jobs = slurm.submit(study, folder, options.jobs, options.slurm_options)
        print(f"submitted: array job {jobs[0]}, and {jobs[1]} behind it for the tables" if jobs else
              "all runs are complete: nothing to submit")
        return 0
    failed = 0
    if not options.collect:
        done = runs.run_all(study, folder, options.jobs)
        failed = sum(status != 0 for status in done.values())
    there = collect(study, folder)
    if failed:
        print(f"{failed} of {len(study.tasks)} runs are not complete; the same command goes on with them")
    return 3 if failed or not there else 0
