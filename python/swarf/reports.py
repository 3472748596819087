"""What the pages of docs/reports have in common: their folder, pictures, and where and of what a number was measured."""
import pathlib
import platform
import subprocess

import matplotlib

matplotlib.use("Agg")  # without a screen
matplotlib.rcParams["svg.hashsalt"] = "swarf"  # the same results give the same file
import matplotlib.pyplot as plt

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "reports"


def save(figure, name, dpi="figure"):
    """As PNG and SVG of that name."""
    for kind in ("png", "svg"):
        figure.savefig(FOLDER / f"{name}.{kind}", dpi=dpi,
                       metadata={"Date": None} if kind == "svg" else {"Software": None})
    plt.close(figure)


def write(name, lines):
    (FOLDER / f"{name}.md").write_text("\n".join(lines).rstrip() + "\n")


def processor():
    """Of this machine, as it calls itself."""
    info = pathlib.Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    names = (line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    return next(names, None) or platform.processor() or "unknown processor"


def commit(*paths):
    """Of the working tree, and whether files of these paths differ from it."""
    def git(*arguments):
        return subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True).stdout.strip()
    changed = git("status", "--porcelain", "--", *paths)
    return (git("rev-parse", "--short", "HEAD") or "not from git") + (" with changes" if changed else "")
