// The model in time: one step, and what is looked at between steps.
#pragma once
#include "src/files/results.hpp"
#include "src/output/frame.hpp"
#include "src/output/history.hpp"
#include "src/scene/scene.hpp"
#include "src/simulation/parts.hpp"
#include "src/simulation/phase_timer.hpp"
#include "src/tool/geometry.hpp"
#include "swarf/kernels.hpp"

namespace swarf {

class CheckpointWriter;
class CheckpointReader;

// The run has gone wrong: which fault, where, when. what() is a whole message.
struct SimulationFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Simulation {
 public:
  explicit Simulation(const Deck& deck);

  // Before start(), not in a restart: the temperatures of the tool at the end of an earlier run, and what
  // idling makes of them, where the deck asks for them. Throws ResultsError, DeckError.
  void take_tool_temperature();
  void start();                              // lists and forces of the initial state
  void step();                               // the equations of one time step
  void cut_step(double end);                 // so that no step passes the end, and none is tiny
  void write_state(CheckpointWriter&) const; // everything that the next step depends on
  void read_state(const CheckpointReader&);  // instead of start()
  // Reads the status, sets dt and rebuilds the lists if the particles may outrun the skin before the next
  // call. Throws SimulationFault. Steps until it wants to be called again: steps_to_check().
  void check();
  long steps_to_check() const { return next_check - steps; }
  static constexpr long most_unseen_steps = 100; // a fault is seen no later, however rare the samples
  // Energies and extremes of the last check(), mean tool force since the last sample. Takes it: the mean
  // begins anew. Throws SimulationFault where the run has made more energy than it was ever given.
  HistorySample take_sample();
  // What the tool's surface has felt since the last call; at first since the start. Not const: it begins
  // anew.
  ToolFields take_tool_fields();
  void write_tool_heat(const ResultsFolder&) const; // for a run that goes on with it (tool.temperature_from)

  double time() const { return now; }
  double immersion_deg() const { return deck.tool ? immersion(*deck.tool, now) : 0; }
  long step_count() const { return steps; }
  double dt() const { return step_size; }
  long steps_this_run() const { return steps - first_step; }
  // Particles and nodes that are deeper in the tool than a quarter of their spacing: none, if the contact
  // holds.
  int leaked_particles() const;
  int leaked_nodes() const;
  double initial_kinetic() const { return energy.initial; } // J
  double driven_kinetic() const { return driven_energy; }   // J, if all moved as fast as what drives it
  double heat_dt() const { return heat_step; }              // s, stable step of conduction; 0 without
  double particle_steps() const {
    return moved_particles;
  } // of this run: active particles, summed over the steps
  long rebuilds() const { return rebuild_count; }
  const std::string& limiter() const { return step_limiter; }
  std::string place_of_limiter() const;
  const Scene& scene() const { return model; }
  const Neighbors& neighbors() const { return lists; }
  ToolPose pose() const { return deck.tool ? tool_pose(*deck.tool, now) : ToolPose{}; }
  PhaseTimer timer;

 private:
  void kick_half();
  void move();
  bool shift_is_due();
  void shift(); // particles of flowing material back into an even order
  void rebuild_lists();
  void follow_hexes_and_ghosts();
  void update_rates_and_stresses();
  void smooth_pressure();
  void compute_forces();
  void press_tool();
  void follow_bodies();                                // lists of what may meet
  long plan_body_contact(double reach, long interval); // when they are made again; steps to the next check
  void write_body_contact(CheckpointWriter&) const;
  void read_body_contact(const CheckpointReader&);
  void conduct();
  void take_contact_heat(); // what the contact has brought shows as temperature, of the work and of the tool
  void take_surface_sums(); // what points have done to the tool's surface, to its patches
  void convert();           // hexes that are near to the tool or strained become particles
  void plan_conversion();
  double energy_in_contact();           // J, all there is, with the springs as the tool presses them now
  double step_of_new_particles() const; // s, about; infinite where no hex converts
  Freeze freeze_of() const;
  void freeze(); // decides what is frozen
  void retire(); // and what leaves
  void freeze_at_start();
  void plan_freeze(double speed);
  void fade_waves(); // where freezing begins
  bool shifts() const {
    return deck.particles.shifting && model.particles.count > 0 && !particle_method.initial_frame;
  }
  bool bodies_meet() const { return model.contact_groups.count > 0; }
  bool has_surfaces() const { return model.particles.surface_shift.extent(0) > 0; }
  double shift_way() const { return model.spacing / 16; } // m, of the tool between two shifts
  StableStep limit_step();
  static constexpr int most_steps_between_modes = 25, first_iterations = 40;
  void follow_highest_mode();
  void find_highest_mode(int iterations); // and the step of the particles' waves from it
  HeatSums sum_heats() const;
  void book_heat(HistorySample&) const;
  void check_status();                               // throws SimulationFault
  void check_energy(const HistorySample&) const;     // throws SimulationFault
  void check_numbers(const CheckpointReader&) const; // throws ResultsError
  // Every number that the next step depends on, with its name in a checkpoint: written and read by the same
  // list.
  template <class Self, class Visit>
  static void visit_state(Self&, const Visit&);
  [[noreturn]] void fail(Fault fault, const std::string& where) const;
  [[noreturn]] void fail(const std::string& what) const;
  std::string place_of_particle(unsigned row) const; // "particle 12 (row 3) at (x, y, z) m"
  std::string place_of_hex(unsigned row) const;
  std::string place_of_fastest() const;

  Deck deck;
  Scene model;
  Neighbors lists;
  BodyContact meeting; // of bodies
  ParticleMethod particle_method;
  HexMethod hex_method;
  ContactLaw contact_law;
  Vector3 gravity;
  Status status, hex_status; // of particles; of hexes
  ToolLoadSums loads;

  double particle_step = 0;                     // s: stable step of the particles
  double wave_step = 0;                         // s: 2 over the highest frequency of the particles' waves
  int mode_interval = most_steps_between_modes; // steps until the next look at their mode
  long next_mode = 0;                           // the step of that look
  bool conducts = false;
  double heat_step = 0; // s: stable step of conduction
  Pace heat_pace, pressure_pace;
  FreezePlan freezing;
  ConversionPlan conversion;
  EnergyLedger energy;
  double tool_heat_step = 0;    // s: of conduction in the tool
  double initial_heat = 0;      // J, of the work above the temperature that heats are counted from
  double initial_tool_heat = 0; // J, the same of the tool
  double shown_since = 0;       // s, what the surface of the tool has felt
  double now = 0, step_size = 0, mass_factor = 1;
  long steps = 0, first_step = 0, next_check = 0, rebuild_count = 0;
  long steps_at_sample = 0;
  bool lists_due = false, meeting_due = false;
  VectorField first_position;                  // of each particle's identity; 0 rows where nothing retires
  double shift_speed = 0, way_since_shift = 0; // m/s, of the tool, faces or bodies; m
  double moved_particles = 0;
  double driving_speed = 0, slowest_drive = 0; // m/s
  double elastic_scale = 0, driven_energy = 0; // J
  std::string step_limiter;
  int limiting_row = -1; // a hex's after all particles'
};

double elastic_scale_of(const MaterialPoints&,
                        const MaterialTable&); // J: mass times square of the wave speed
unsigned long long value_of(const Status&);    // on the host
void release_freed_memory();
// Views of the fields that Newton's law moves, and that the tool touches. Made anew in each step: fields move
// when ghosts need room.
Motion motion_of(const Particles&);
Motion motion_of(const HexMesh&);
ContactPoints contact_points_of(const Particles&);
ContactPoints contact_points_of(const HexMesh&);

} // namespace swarf
