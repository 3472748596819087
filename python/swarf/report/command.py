"""swarf report DIR..."""
import argparse
import pathlib

from . import page


def main(arguments):
    parser = argparse.ArgumentParser(prog="swarf report", description="One page of a run, or of several to compare, that "
                                     "opens in any browser without a network.")
    parser.add_argument("results", nargs="+", help="folders of runs, of windows or of studies")
    parser.add_argument("-o", "--output", help="the page (default report.html in the folder; of several: report.html here)")
    parser.add_argument("--title", help="instead of that of the deck")
    options = parser.parse_args(arguments)
    default = pathlib.Path(options.results[0]) / "report.html" if len(options.results) == 1 else pathlib.Path("report.html")
    target = pathlib.Path(options.output) if options.output else default
    text = page.make(options.results, options.title)
    target.write_text(text)
    print(f"report: {target}, {len(text.encode()) / 1e6:.1f} MB")
    return 0
