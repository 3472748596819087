"""python3 -m swarf study | report | import: the commands of the program that this package carries out."""
import sys

from .abaqus import command as abaqus
from .report import command as report
from .study import command as study

COMMANDS = {"study": study.main, "report": report.main, "import": abaqus.main}


def main(arguments):
    if not arguments or arguments[0] not in COMMANDS:
        print(f"swarf: expected one of {', '.join(COMMANDS)}, then its arguments", file=sys.stderr)
        return 1
    try:
        return COMMANDS[arguments[0]](arguments[1:])
    except (ValueError, OSError) as error:  # of what the user gave; anything else is a fault of ours
        print(f"swarf: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
