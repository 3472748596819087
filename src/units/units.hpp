// Numbers with units, as a deck writes them: "10 um", "10000 rpm", "4430 kg/m3", "25 degC".
#pragma once
#include <string>
#include <variant>

namespace swarf {

enum class Dimension {
  none,
  length,
  time,
  angle,
  velocity,
  acceleration,
  angular_velocity,
  rate,
  density,
  pressure,
  temperature,
  specific_heat,
  conductivity,
  conductance,
  per_kelvin,
  per_pressure,
  force,
  line_force,
  percentage
};

struct DimensionText {
  std::string name;    // "a length"
  std::string si;      // unit that resolved decks are written in: "m"
  std::string example; // "2.5 um"
};
const DimensionText& describe(Dimension dimension);

// What was wrong with a quantity, as the rest of a sentence that begins with the key.
struct UnitError {
  std::string message;
};

// SI value of "number unit". A unit is a product such as m/min, J/kg/K or N/mm2: symbols m g s K rad N Pa J W
// Hz with prefixes n u m c k M G, and deg rpm rev min h; degC and % stand alone. Decimal prefixes are exact:
// "10 um" is the double nearest to 1e-5. Errors: no number, NaN, infinity, overflow, no unit, unknown or
// wrong unit.
std::variant<double, UnitError> parse_quantity(const std::string& text, Dimension dimension);

// Shortest text that reads back as the same double, with the SI unit of the dimension; bare if it has none.
std::string format_quantity(double value, Dimension dimension,
                            int digits = 0); // 0: as many as give the number back

} // namespace swarf
