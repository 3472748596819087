"""What the pages of docs/reports have in common: their folder, pictures, and where and of what a number was measured."""
import pathlib
import platform
import re
import subprocess
import textwrap

import matplotlib

matplotlib.use("Agg")  # without a screen
matplotlib.rcParams["svg.hashsalt"] = "swarf"  # the same results give the same file
import matplotlib.pyplot as plt

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "reports"
WIDTH = 120  # characters of a line, and of what a screen shows of a table
NUMBERS = re.compile(r"[-+*]*\d\S*( \S{1,4}| \d\S*)*|-?")  # with their units, as in "1.2 +- 0.1 m/s", or nothing


def save(figure, name, dpi="figure"):
    """As PNG and SVG of that name."""
    for kind in ("png", "svg"):
        figure.savefig(FOLDER / f"{name}.{kind}", dpi=dpi,
                       metadata={"Date": None} if kind == "svg" else {"Software": None})
    plt.close(figure)


def table(head, rows, key=1):
    """Lines of a table. One that is wider than a screen comes in parts, each with the first `key` columns. Texts of more
    than 24 characters are wrapped by whoever shows them; columns of numbers are set to the right."""
    columns = [[str(cell).replace("|", "\\|") for cell in column] for column in zip(head, *rows)]
    widths = [3 + min(24, max(map(len, column))) for column in columns]
    parts = [[]]
    for k in range(key, len(columns)):
        if parts[-1] and sum(widths[:key]) + sum(widths[one] for one in parts[-1]) + widths[k] > WIDTH:
            parts.append([])
        parts[-1].append(k)
    for part in parts:
        chosen = columns[:key] + [columns[k] for k in part]
        yield ""
        lines = ["| " + " | ".join(row) + " |" for row in zip(*chosen)]
        rule = "|".join("---:" if all(map(NUMBERS.fullmatch, column[1:])) else "---" for column in chosen)
        yield from [lines[0], f"|{rule}|", *lines[1:]]
    yield ""


def write(name, lines):
    """The page, its prose wrapped."""
    def wrapped(line):
        if len(line) <= WIDTH or line.startswith(("|", "!", "#", " ")):
            return line
        return textwrap.fill(line, WIDTH, break_long_words=False, break_on_hyphens=False,
                             subsequent_indent="  " if line.startswith("- ") else "")
    text = "\n".join(wrapped(line) for block in lines for line in block.split("\n"))
    (FOLDER / f"{name}.md").write_text(re.sub(r"\n{3,}", "\n\n", text).strip() + "\n")


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
