"""What a run of a deck will cost, roughly."""
import math

from swarf import decks, si


def predicted_core_seconds(deck, seconds_per_particle_step=2e-6):
    """Steps by the Courant number and the scaled wave speed; work by counts and neighbours."""
    material = next(iter(deck["material"].values()))
    E, nu = si(material["youngs_modulus"]), material["poissons_ratio"]
    wave = math.sqrt(E * (1 - nu) / (1 + nu) / (1 - 2 * nu) / si(material["density"]) / deck["run"]["mass_factor"])
    ratio = deck.get("particles", {}).get("smoothing_ratio", 1.2)
    work, reach = 0, math.inf
    for one in deck["body"]:
        volume, cells = decks.volume_and_cells(one)
        spacing = (volume / cells) ** (1 / 3)
        if one["fill"] == "particles":
            work += cells * (ratio / 1.2) ** 3
            reach = min(reach, ratio * spacing)
        else:
            work += 0.3 * cells
            reach = min(reach, spacing)
    steps = decks.end_time(deck) / (deck["run"].get("courant", 0.3) * reach / wave)
    return work * steps * seconds_per_particle_step
