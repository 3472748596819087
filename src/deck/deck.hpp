// A scene as the user wrote it: plain values in SI, checked, with every default filled in.
#pragma once
#include "src/units/words.hpp"
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

// Sections of a deck. A new one has every key that applies at its default, as the row of the key says it
// (keys.cpp): there is no other default. What has none, or does not apply to this law, shape or kind, is 0,
// empty or not given.
struct MaterialDeck {
  explicit MaterialDeck(Law law = Law::elastic);
  std::string name;
  Law law;
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
  FaceDeck(std::string face = "", FaceKind kind = FaceKind::free, const Triple& velocity = {});
  std::string face; // x_min .. z_max | bottom top side | inner outer bottom top start end | set of nodes
  FaceKind kind;
  Triple velocity;
  bool fixed;                        // as the deck's table says it; kind has it, too
  std::optional<double> temperature; // of the surface, or of what is around it
  std::optional<double> film;        // W/(m2 K), in between
  bool operator==(const FaceDeck&) const = default;
};

struct BodyDeck {
  explicit BodyDeck(BodyShape shape = BodyShape::block, Fill fill = Fill::particles);
  std::string name, material;
  BodyShape shape;
  Fill fill;
  Triple
      origin;  // block: corner of least x, y, z; stl, mesh: origin of the file; others: centre (of the base)
  Triple size; // block
  double radius, inner_radius, outer_radius, height;
  double start_angle, end_angle; // ring, rad; a whole turn closes the ring
  std::string file;              // stl, mesh; relative to the deck there, absolute here
  double file_scale;             // m per unit of the file
  std::optional<double> spacing; // m: particles, or edges of hexes
  std::optional<std::array<int, 3>>
      cells;           // block: nx ny nz; ring: around, axial, radial; cylinder: across, across, axial
  bool previous_tooth; // ring: inner surface as the previous tooth of the tool left it
  Triple velocity;
  double temperature;
  std::string tie;                        // hexes that this body's particles are tied to, or empty
  std::optional<double> convert_distance; // m: hexes nearer to the tool become particles
  std::optional<double> convert_strain;   // or those of this equivalent plastic strain
  int convert_particles;                  // along each edge of a hex
  std::vector<FaceDeck> faces;
  int line = 0; // of the deck, for messages
  bool converts() const { return convert_distance || convert_strain; }
  bool has_file() const { return shape == BodyShape::stl || shape == BodyShape::mesh; }
  bool operator==(const BodyDeck&) const = default;
};

struct ToolDeck {
  explicit ToolDeck(ToolKind kind = ToolKind::end_mill);
  ToolKind kind;
  // end mill
  double diameter, helix, rake, clearance, edge_radius, length;
  double core_ratio, runout, runout_angle;
  int flutes;
  // wedge (shares rake, clearance, edge_radius): cuts along +x of its own frame, edge along z
  double inclination, width, height;
  // wall
  Triple normal;
  double size;
  std::string file;  // stl; relative to the deck there, absolute here
  double file_scale; // m per unit of the file
  // motion
  Triple position, velocity;
  double spindle_speed; // rad/s, clockwise seen from +z
  double feed_per_tooth;
  Triple feed_direction;
  double start_angle; // immersion angle at time 0, rad
  // heat
  std::string material;              // a rigid one; empty: the tool does not conduct
  double temperature;                // at the start
  std::optional<double> held_beyond; // m from where the work touches: held at it; not given: insulated
  std::string temperature_from;      // results folder whose tool's temperature it starts with; absolute here
  double idle_time;                  // s between that run and this one, in which the tool only conducts
  std::optional<double> heat_time;   // s that heat has to spread in all; not given: that of the run
  // wear
  std::optional<double> wear_A, wear_B; // 1/Pa, K; not given: none
  // after the cut
  std::optional<double> lift_time; // s; from then on it moves at:
  Triple lift_velocity;
  bool operator==(const ToolDeck&) const = default;
};

struct ContactDeck {
  ContactDeck();
  double friction;
  std::optional<double> shear_limit; // Pa
  BetweenBodies between_bodies;
  double stiffness;                        // at most, penalty / (scaled mass / dt^2)
  std::optional<double> heat_to_workpiece; // share of the friction work, of a tool without a material
  std::optional<double> conductance;       // W/(m2 K), of one with a material; not given: perfect contact
  bool operator==(const ContactDeck&) const = default;
};

struct ParticlesDeck {
  ParticlesDeck();
  KernelFrame kernel_frame;
  double smoothing_ratio; // h / spacing
  SmoothingLength smoothing_length;
  DensityRule density;
  bool correction, correct_forces;
  double viscosity_linear, viscosity_quadratic, hourglass_stiffness;
  double pressure_diffusion;
  bool shifting;
  double skin; // of the support
  bool operator==(const ParticlesDeck&) const = default;
};

struct HexesDeck {
  HexesDeck();
  HourglassMethod hourglass;
  double hourglass_coefficient;
  double viscosity_linear, viscosity_quadratic;
  bool delete_failed;                     // delete a hex whose damage reaches 1
  std::optional<double> delete_at_strain; // or whose equivalent plastic strain reaches this
  bool operator==(const HexesDeck&) const = default;
};

struct SleepDeck {
  SleepDeck();
  std::optional<double> distance; // m; not given: nothing freezes
  double ramp;                    // of the distance, where velocities are damped
  double speed;                   // of the tool's, or of held faces: what is faster stays active
  bool operator==(const SleepDeck&) const = default;
};

struct RetireDeck {
  std::optional<double> distance; // m; not given: nothing leaves
  bool operator==(const RetireDeck&) const = default;
};

struct RunDeck {
  RunDeck();
  std::optional<double> end_time;      // s
  std::optional<double> end_immersion; // rad, instead of end_time
  double courant, mass_factor;
  std::optional<double> accuracy;        // %, of the mean cutting force; sets others, see accuracy.hpp
  int accuracy_line = 0;                 // of the deck, for messages
  int threads;                           // 0: all cores
  double energy_tolerance, energy_limit; // %, of the energy given: where a run warns, where it ends
  Triple gravity;
  bool operator==(const RunDeck&) const = default;
};

// Short runs spread over a pass, in place of the whole of it. Angles in rad.
struct WindowsDeck {
  WindowsDeck();
  double first, last, step; // immersion at their centres
  double width;             // measured, about the centre
  double run_in;            // from the free end to where the measurement begins
  double ahead;             // of the measurement's end, that the material goes on
  int line = 0;             // of the deck, for messages; 0: not from the deck
  bool operator==(const WindowsDeck&) const = default;
};

// The mechanistic model of the mill: forces of edge elements, linear in the chip thickness.
struct MechanisticDeck {
  MechanisticDeck();
  double K_tc, K_rc, K_ac;            // Pa: shearing, tangential, radial, axial
  double K_te, K_re, K_ae;            // N/m: of the edge
  double minimum_chip;                // m: thinner ones are not cut, but pressed down
  std::optional<double> depth, helix; // m, rad; not given: of the scene
  double entry, exit;                 // immersion, rad, where the work begins and ends
  int line = 0;                       // of the deck, for messages; 0: not from a deck
  bool operator==(const MechanisticDeck&) const = default;
};

struct LabelledForce {
  std::string label;
  double force; // N
  bool operator==(const LabelledForce&) const = default;
};

struct OutputDeck {
  OutputDeck();
  double force_scale;                    // depth of cut over thickness of the slice
  int history_steps;                     // steps between two history samples, at most
  std::optional<double> frame_time;      // s
  std::optional<double> frame_immersion; // rad
  std::optional<double> checkpoint_time; // s of simulated time; default: with every frame
  double filter_frequency;               // Hz, low pass of the force; 0: chosen from the run's length
  std::vector<double> picture_immersion; // rad, views of the strip; default: spread over the run
  std::vector<double> picture_time;      // s, the same for scenes without a spindle
  PictureField picture_field;
  Triple picture_view;                  // direction from the scene to the camera
  std::vector<LabelledForce> published; // drawn as lines in the force plot
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
  Deck();
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
// `kept`: a results folder, whose copies take the place of files (of the tool, of bodies) that are missing.
Deck read_deck(const std::string& file, const std::string& kept = "");

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
