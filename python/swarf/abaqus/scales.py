"""Units of a model, which its file does not have."""
import dataclasses
import re

LENGTHS = {"m": 1, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}
MASSES = {"tonne": 1e3, "kg": 1, "g": 1e-3, "mg": 1e-6}
TIMES = {"s": 1, "ms": 1e-3, "us": 1e-6}


@dataclasses.dataclass
class Units:
    """SI values of the model's units; quantities as decks write them."""
    word: str
    length: float
    mass: float
    time: float
    temperature: str | None  # "K" or "degC"; None: not said

    @property
    def pressure(self):
        return self.mass / self.length / self.time**2

    def text(self, value, scale, unit):
        return f"{value * scale:.12g} {unit}"

    def a_length(self, value):
        return self.text(value, self.length, "m")

    def a_pressure(self, value):
        return self.text(value, self.pressure, "Pa")

    def a_velocity(self, value):
        return self.text(value, self.length / self.time, "m/s")

    def a_density(self, value):
        return self.text(value, self.mass / self.length**3, "kg/m3")

    def a_conductivity(self, value):
        return self.text(value, self.mass * self.length / self.time**3, "W/m/K")

    def a_specific_heat(self, value):
        return self.text(value, self.length**2 / self.time**2, "J/kg/K")

    def a_rate(self, value):
        return self.text(value, 1 / self.time, "1/s")

    def a_time(self, value):
        return self.text(value, self.time, "s")

    def a_temperature(self, value):
        if self.temperature is None:
            raise ValueError("the model has temperatures: give --temperature K or --temperature degC, in which they "
                             "are, for the file does not say it")
        return f"{value:.12g} {self.temperature}"

    @property
    def unit_length(self):
        """The length of one unit, as file_scale wants it."""
        return f"1 {self.word.split('-')[0]}"


def parse(word, temperature=None):
    parts = re.fullmatch(r"(\w+)-(\w+)-(\w+)", word)
    if not parts or parts[1] not in LENGTHS or parts[2] not in MASSES or parts[3] not in TIMES:
        raise ValueError(f'--units {word}: expected length-mass-time, such as mm-tonne-s or m-kg-s, of {", ".join(LENGTHS)}; '
                         f'{", ".join(MASSES)}; {", ".join(TIMES)}')
    return Units(word, LENGTHS[parts[1]], MASSES[parts[2]], TIMES[parts[3]], temperature)
