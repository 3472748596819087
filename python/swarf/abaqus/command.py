"""swarf import MODEL.inp"""
import argparse
import pathlib

from .. import decks
from . import convert, reader, scales


def read_arguments(arguments):
    parser = argparse.ArgumentParser(prog="swarf import", description="Writes a deck, and the meshes beside it, from a "
                                     "model for Abaqus/Explicit, and lists what it left out: docs/guide/import.md")
    parser.add_argument("model", type=pathlib.Path, help="the input file (.inp)")
    parser.add_argument("--units", required=True, help="length-mass-time of the file, which does not say it: mm-tonne-s, "
                        "m-kg-s, mm-kg-ms, ...")
    parser.add_argument("--temperature", choices=["K", "degC"], help="of the file, if it has temperatures and no "
                        "*PHYSICAL CONSTANTS, ABSOLUTE ZERO")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="the deck (default NAME.toml of the model, here)")
    parser.add_argument("--overwrite", action="store_true", help="replace files that are there")
    return parser.parse_args(arguments)


def show(converter, written):
    print("written: " + ", ".join(map(str, written)))
    left = converter.left_out()
    if left:
        print("left out:")
    for line, keyword, why in left:
        print(f"  {keyword.file}:{line}: {keyword}" + (f": {why}" if why else ""))
    if converter.notes:
        print("look at:")
    for note in converter.notes:
        print(f"  {note}")


def main(arguments):
    options = read_arguments(arguments)
    deck_file = options.output or pathlib.Path(options.model.stem + ".toml")
    converter = convert.Converter(reader.read(options.model), scales.parse(options.units, options.temperature),
                                  convert.safe(deck_file.stem))
    deck = converter.convert()
    files = {deck_file.parent / name: text for name, text in converter.files.items()}
    for path in [deck_file, *files]:
        if path.exists() and not options.overwrite:
            raise ValueError(f"{path}: is there already; choose another name with --output, or give --overwrite")
        if path.exists() and path.samefile(options.model):
            raise ValueError(f"{path}: is the model itself; choose another name with --output")
    for path, text in files.items():
        path.write_text(text, encoding="utf-8")
    decks.write(deck_file, deck)
    show(converter, [deck_file, *files])
    return 0
