"""The text of an Abaqus input file as keywords: name, options and rows, each with its line."""
import dataclasses
import math

OPTIONS = {"NODE": {"NSET"}, "ELEMENT": {"TYPE", "ELSET"}}  # others would move what stands there, or name another file


class Fault(ValueError):
    """What is said to the user, with the line it is about."""

    def __init__(self, keyword, text, line=None):
        super().__init__(f"{keyword.file}:{line or keyword.line}: *{keyword.name}: {text}")


@dataclasses.dataclass
class Keyword:
    file: str
    line: int
    name: str  # upper case, single blanks
    options: dict  # upper-case names; values as written, None where there is none
    rows: list = dataclasses.field(default_factory=list)  # (line, [fields])
    is_used: bool = False

    def get(self, option):
        """The value in upper case, as Abaqus compares names; None if it is not there."""
        value = self.options.get(option)
        return value.upper() if value is not None else None

    def numbers(self, row=0):
        """The fields of a row as numbers, 0 for empty ones."""
        if row >= len(self.rows):
            raise Fault(self, "expected a line of numbers after it")
        line, fields = self.rows[row]
        return [number(self, line, field) for field in fields]

    def __str__(self):
        options = "".join(f", {key}" + ("" if value is None else f"={value}") for key, value in self.options.items())
        return f"*{self.name}{options}"


def number(keyword, line, text):
    try:
        value = float(text.upper().replace("D", "E")) if text else 0.0
    except (ValueError, AttributeError):
        value = math.nan
    if not math.isfinite(value):
        raise Fault(keyword, f'expected a number, got "{text}"', line)
    return value


def label(keyword, line, text):
    try:
        return int(text)
    except ValueError:
        raise Fault(keyword, f'expected the number of a node or an element, got "{text}"', line) from None


def _fields(text):
    fields = [field.strip().strip('"') for field in text.split(",")]
    while fields and not fields[-1]:
        fields.pop()
    return fields


def read(path):
    """All keywords of a file. "**" begins a comment; a line of options or of an element that ends with a comma goes
    on in the next one."""
    keywords, goes_on = [], False
    for line, raw in enumerate(path.read_text(encoding="utf-8-sig", errors="replace").splitlines(), 1):
        text = raw.strip()
        if not text or text.startswith("**"):
            continue
        if text.startswith("*"):
            name, *options = _fields(text[1:])
            keywords.append(Keyword(path.name, line, " ".join(name.upper().split()), {}))
            _add_options(keywords[-1], options)
            goes_on = text.endswith(",")
            continue
        if not keywords:
            raise ValueError(f"{path.name}:{line}: stands before the first keyword: expected an Abaqus input file")
        last = keywords[-1]
        if goes_on and not last.rows:
            _add_options(last, _fields(text))
        elif goes_on:
            last.rows[-1][1].extend(_fields(text))
        else:
            last.rows.append((line, _fields(text)))
        goes_on = text.endswith(",") and last.name in ("ELEMENT", "NSET", "ELSET") or goes_on and not last.rows and (
            text.endswith(","))
    for keyword in keywords:
        if keyword.name in ("INCLUDE", "PARAMETER", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM",
                            "MANIFEST"):
            raise Fault(keyword, "is not followed: expected a file with all nodes and elements in it, as Abaqus/CAE "
                                 "writes it")
        unknown = sorted(set(keyword.options) - OPTIONS.get(keyword.name, set(keyword.options)))
        if unknown and keyword.get("SYSTEM") != "R":
            raise Fault(keyword, f"{unknown[0]} is not followed: expected Cartesian coordinates and numbers in this file")
    return keywords


def _add_options(keyword, options):
    for option in options:
        key, equals, value = option.partition("=")
        keyword.options[" ".join(key.upper().split())] = value.strip().strip('"') if equals else None
