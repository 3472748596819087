// A scene as the user wrote it: plain values in SI, checked, with every default filled in.
#pragma once
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace swarf {

using Triple = std::array<double, 3>;

// what() is a whole message: file, line, key, what was expected, what to do.
struct DeckError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A constant, or a table over temperature: straight lines between its points, constant outside.
struct OverTemperature {
  OverTemperature(double constant = 0) : value(constant) {}
  double value;                                // where there are no points
  std::vector<std::array<double, 2>> points{}; // K and the value there, by rising temperature
  double least() const;
  double greatest() const;
  bool operator==(const OverTemperature&) const = default;
};

struct MaterialDeck {
  std::string name;
  std::string
      law; // elastic | linear_hardening | johnson_cook | johnson_cook_tanh | zerilli_armstrong | rigid
  double density, poissons_ratio;
  OverTemperature youngs_modulus, specific_heat, conductivity;
  double thermal_expansion, taylor_quinney;
  double yield_stress, hardening_modulus;                                        // linear_hardening
  double A, B, n, C, m, reference_rate, reference_temperature, melt_temperature; // johnson_cook
  double softening_a, softening_b, softening_c, softening_d;                     // johnson_cook_tanh
  double C0, C1, C2, C3, C4, C5;                                                 // zerilli_armstrong
  std::optional<std::array<double, 5>> damage;                                   // D1..D5
  bool operator==(const MaterialDeck&) const = default;
};

struct FaceDeck {
  std::string face; // x_min .. z_max | bottom top side | inner outer bottom top start end
  std::string kind; // free | fixed | symmetric | periodic | velocity
  Triple velocity{};
  bool fixed = false;                     // as the deck's table says it; kind has it, too
  std::optional<double> temperature = {}; // of the surface, or of what is around it
  std::optional<double> film = {};        // W/(m2 K), in between
  bool operator==(const FaceDeck&) const = default;
};

struct BodyDeck {
  std::string name, shape, fill, material; // shape: block | cylinder | ring | sphere; fill: particles | hexes
  Triple origin{};                         // block: corner of least x, y, z; others: centre (of the base)
  Triple size{};                           // block
  double radius = 0, inner_radius = 0, outer_radius = 0, height = 0;
  double start_angle = 0, end_angle = 0; // ring, rad; a whole turn closes the ring
  std::optional<double> spacing;         // m: particles, or edges of hexes
  std::optional<std::array<int, 3>>
      cells; // block: nx ny nz; ring: around, axial, radial; cylinder: across, across, axial
  bool previous_tooth = false; // ring: inner surface as the previous tooth of the tool left it
  Triple velocity{};
  double temperature = 0;
  std::string tie;                        // hexes that this body's particles are tied to, or empty
  std::optional<double> convert_distance; // m: hexes nearer to the tool become particles
  std::optional<double> convert_strain;   // or those of this equivalent plastic strain
  int convert_particles = 2;              // along each edge of a hex
  std::vector<FaceDeck> faces;
  int line = 0; // of the deck, for messages
  bool converts() const { return convert_distance || convert_strain; }
  bool operator==(const BodyDeck&) const = default;
};

struct ToolDeck {
  std::string kind; // end_mill | wedge | wall | stl
  // end mill
  double diameter = 0, helix = 0, rake = 0, clearance = 0, edge_radius = 0, length = 0;
  double core_ratio = 0, runout = 0, runout_angle = 0;
  int flutes = 0;
  // wedge (shares rake, clearance, edge_radius): cuts along +x of its own frame, edge along z
  double inclination = 0, width = 0, height = 0;
  // wall
  Triple normal{0, 0, 1};
  double size = 0;
  std::string file;      // stl; relative to the deck there, absolute here
  double file_scale = 1; // m per unit of the file
  // motion
  Triple position{}, velocity{};
  double spindle_speed = 0; // rad/s, clockwise seen from +z
  double feed_per_tooth = 0;
  Triple feed_direction{1, 0, 0};
  double start_angle = 0; // immersion angle at time 0, rad
  // heat
  std::string material;              // a rigid one; empty: the tool does not conduct
  double temperature = 0;            // at the start
  std::optional<double> held_beyond; // m from where the work touches: held at it; not given: insulated
  std::string temperature_from;      // results folder whose tool's temperature it starts with; absolute here
  double idle_time = 0;              // s between that run and this one, in which the tool only conducts
  std::optional<double> heat_time;   // s that heat has to spread in all; not given: that of the run
  // wear
  std::optional<double> wear_A, wear_B; // 1/Pa, K; not given: none
  // after the cut
  std::optional<double> lift_time; // s; from then on it moves at:
  Triple lift_velocity{};
  bool operator==(const ToolDeck&) const = default;
};

struct ContactDeck {
  double friction = 0;
  std::optional<double> shear_limit;       // Pa
  std::string between_bodies = "hexes";    // hexes | none
  double stiffness = 1;                    // at most, penalty / (scaled mass / dt^2)
  std::optional<double> heat_to_workpiece; // share of the friction work, of a tool without a material
  std::optional<double> conductance;       // W/(m2 K), of one with a material; not given: perfect contact
  bool operator==(const ContactDeck&) const = default;
};

struct ParticlesDeck {
  std::string kernel_frame;     // current | initial
  double smoothing_ratio = 1.2; // h / spacing
  std::string smoothing_length; // fixed | evolving
  std::string density;          // continuity | summation
  bool correction = true, correct_forces = true;
  double viscosity_linear = 0, viscosity_quadratic = 0, hourglass_stiffness = 0;
  double pressure_diffusion = 0;
  bool shifting = true;
  double skin = 0.1; // of the support
  bool operator==(const ParticlesDeck&) const = default;
};

struct HexesDeck {
  std::string hourglass; // stiffness | viscous
  double hourglass_coefficient = 0;
  double viscosity_linear = 0, viscosity_quadratic = 0;
  bool delete_failed = false;             // delete a hex whose damage reaches 1
  std::optional<double> delete_at_strain; // or whose equivalent plastic strain reaches this
  bool operator==(const HexesDeck&) const = default;
};

struct SleepDeck {
  std::optional<double> distance; // m; not given: nothing sleeps
  double ramp = 0.5;              // of the distance, where velocities are damped
  double speed = 0.05;            // of the tool's, or of held faces: what is faster stays awake
  bool operator==(const SleepDeck&) const = default;
};

struct RetireDeck {
  std::optional<double> distance; // m; not given: nothing leaves
  bool operator==(const RetireDeck&) const = default;
};

struct RunDeck {
  std::optional<double> end_time;      // s
  std::optional<double> end_immersion; // rad, instead of end_time
  double courant = 0, mass_factor = 1;
  std::optional<double> accuracy; // %, of the mean cutting force; sets others, see accuracy.hpp
  int accuracy_line = 0;          // of the deck, for messages
  int threads = 0;                // 0: all cores
  double energy_tolerance = 2, energy_limit = 10; // %, of the energy given: where a run warns, where it ends
  Triple gravity{};
  bool operator==(const RunDeck&) const = default;
};

// Short runs spread over a pass, in place of the whole of it. Angles in rad.
struct WindowsDeck {
  double first = 0, last = 0, step = 0; // immersion at their centres
  double width = 0;                     // measured, about the centre
  double run_in = 0;                    // from the free end to where the measurement begins
  double ahead = 0;                     // of the measurement's end, that the material goes on
  int line = 0;                         // of the deck, for messages; 0: not from the deck
  bool operator==(const WindowsDeck&) const = default;
};

// The mechanistic model of the mill: forces of edge elements, linear in the chip thickness.
struct MechanisticDeck {
  double K_tc = 0, K_rc = 0, K_ac = 0; // Pa: shearing, tangential, radial, axial
  double K_te = 0, K_re = 0, K_ae = 0; // N/m: of the edge
  double minimum_chip = 0;             // m: thinner ones are not cut, but pressed down
  std::optional<double> depth, helix;  // m, rad; not given: of the scene
  double entry = 0, exit = 0;          // immersion, rad, where the work begins and ends
  int line = 0;                        // of the deck, for messages; 0: not from a deck
  bool operator==(const MechanisticDeck&) const = default;
};

struct LabelledForce {
  std::string label;
  double force; // N
  bool operator==(const LabelledForce&) const = default;
};

struct OutputDeck {
  double force_scale = 1;                // depth of cut over thickness of the slice
  int history_steps = 10;                // steps between two history samples, at most
  std::optional<double> frame_time;      // s
  std::optional<double> frame_immersion; // rad
  std::optional<double> checkpoint_time; // s of simulated time; default: with every frame
  double filter_frequency = 0;           // Hz, low pass of the force; 0: chosen from the run's length
  std::vector<double> picture_immersion; // rad, views of the strip; default: spread over the run
  std::vector<double> picture_time;      // s, the same for scenes without a spindle
  std::string picture_field;             // temperature | equivalent_plastic_strain | von_mises | velocity
  Triple picture_view{0, 0, 1};          // direction from the scene to the camera
  std::vector<LabelledForce> published;  // drawn as lines in the force plot
  bool operator==(const OutputDeck&) const = default;
};

// What run.accuracy has set, and why.
struct AccuracyPick {
  double asked = 0; // %
  std::string why;
  std::vector<std::string> changes; // a key each
  bool operator==(const AccuracyPick&) const = default;
};

struct Deck {
  std::string file, title;
  std::vector<MaterialDeck> materials;
  std::vector<BodyDeck> bodies;
  std::optional<ToolDeck> tool;
  ContactDeck contact;
  ParticlesDeck particles;
  HexesDeck hexes;
  SleepDeck sleep;
  RetireDeck retire;
  RunDeck run;
  OutputDeck output;
  std::optional<WindowsDeck> windows;
  std::optional<MechanisticDeck> mechanistic;
  std::optional<AccuracyPick> picked; // never from a file: that has the settings themselves
  bool operator==(const Deck&) const = default;
};

// Throws DeckError with one line for each fault of the deck: faults of single sections first; those between
// sections (names, ties, spindle) when there are no others.
// `stl` takes the place of the tool's STL file where that is missing: the copy that a results folder keeps.
Deck read_deck(const std::string& file, const std::string& stl = "");

// The section [mechanistic] of a file that may have no other: what swarf identify writes. Throws DeckError.
MechanisticDeck read_mechanistic(const std::string& file);
// That section as TOML, in SI units.
std::string write_mechanistic(const MechanisticDeck& model);

bool conducts_heat(const Deck& deck);
// The group of each body, and whether any two can meet by contact: tied bodies are one group.
std::vector<int> contact_groups(const Deck& deck);
bool can_meet(const Deck& deck, const BodyDeck& a, const BodyDeck& b); // two that are not tied
bool can_meet(const Deck& deck);
bool are_all_tied(const Deck& deck);      // into one group; a single body is
bool heats_faces(const Deck& deck);       // a face has a film or a held temperature
bool stress_knows_heat(const Deck& deck); // thermal expansion, or a modulus that depends on temperature
const MaterialDeck* find_material(const Deck& deck, const std::string& name); // null: there is none

// When the run ends, s.
double end_time_of(const Deck& deck);
// The deck as TOML with every default written out, in SI units. Reading it back gives the same Deck, bit by
// bit, but for `file`, `picked` (a comment there) and the lines for messages.
std::string resolved_deck(const Deck& deck);
// Reference page of all keys: key, unit, bounds, default, help (Markdown).
std::string key_reference();

} // namespace swarf
