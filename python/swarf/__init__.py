"""Reads what swarf has written, and reads, varies and writes decks.

    import swarf

    run = swarf.read("results/micro_milling_quick")
    run.history["force_x"]         # array, one number a sample
    run.history.units["force_x"]   # "N"
    run.frames[-1].particles["temperature"]

    deck = swarf.read_deck("inputs/micro_milling_quick.toml")
    faster = swarf.vary(deck, {"tool.spindle_speed": "20000 rpm", "run.courant": 0.5})
    swarf.write_deck("faster.toml", faster)
    swarf.si(faster["tool"]["spindle_speed"])  # 2094.4, rad/s
"""
from .decks import read as read_deck, vary, write as write_deck
from .results import read
from .units import quantity, si

__all__ = ["read", "read_deck", "write_deck", "vary", "si", "quantity"]
