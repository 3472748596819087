// The keys of the method, the run and its output.
#include "src/deck/keys.hpp"

namespace swarf {
namespace {

using D = Dimension;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Bounds any{}, positive{0, infinity, true, false}, not_negative{0, infinity}, share{0, 1};
const std::vector<Condition> always;
constexpr std::monostate custom;
const std::string required = "required", optional = "optional";

} // namespace

const Keys<ParticlesDeck>& particles_keys() {
  using P = ParticlesDeck;
  static const Keys<P> keys = {
      {"kernel_frame", word<&P::kernel_frame>(), D::none, words<KernelFrame>(), R"("current")", always,
       "positions that the kernels and the neighbour lists see; initial (total Lagrangian): no tensile "
       "instability, but who is a neighbour at the start stays one, and no other body is felt but the tool"},
      {"smoothing_ratio", &P::smoothing_ratio, D::none, Bounds{0.8, 3}, "1.2", always,
       "smoothing length h / spacing; the kernel reaches 2 h"},
      {"smoothing_length", word<&P::smoothing_length>(), D::none, words<SmoothingLength>(), R"("fixed")",
       always, "evolving: h follows the density"},
      {"density", word<&P::density>(), D::none, words<DensityRule>(), R"("continuity")", always,
       "from the divergence of the velocity (and by pressure_diffusion), or from the sum over neighbours"},
      {"correction", &P::correction, D::none, any, "true", always,
       "correct the kernel gradient (Randles & Libersky 1996): exact for linear fields"},
      {"correct_forces", &P::correct_forces, D::none, any, "true", always,
       "correct the gradient in the forces as well (Bonet & Lok 1999): conserves angular momentum and "
       "energy"},
      {"viscosity_linear", &P::viscosity_linear, D::none, Bounds{0, 10}, "0.3", always,
       "artificial viscosity, share of density * wave speed * h: damps motion that the velocity gradient "
       "does not see; a linear velocity field feels nothing"},
      {"viscosity_quadratic", &P::viscosity_quadratic, D::none, Bounds{0, 10}, "1.0", always,
       "artificial viscosity in shocks"},
      {"hourglass_stiffness", &P::hourglass_stiffness, D::none, Bounds{0, 10}, "0.3", always,
       "resistance to displacements that no gradient sees, share of the shear modulus (rubber stretched by a "
       "fifth needs 2, flowing metal gains energy above 1); in the initial frame to elongations that the "
       "deformation gradient does not explain (Ganzenmueller 2015)"},
      {"pressure_diffusion", &P::pressure_diffusion, D::none, Bounds{0, 1}, "0.0", always,
       "of pressures that alternate between neighbours, and of the density with them, share of wave "
       "speed * h (Antuono et al. 2010); 0: off"},
      {"shifting", &P::shifting, D::none, any, "true", always,
       "particles of material that flows are moved back into an even order, and take what the fields are "
       "there; "
       "nothing elastic moves. In the current frame only"},
      {"skin", &P::skin, D::none, Bounds{0, 2, true, false}, "0.1", always,
       "reach of the neighbour lists beyond the kernel's, over the kernel's; changes the cost only"},
  };
  return keys;
}

const Keys<HexesDeck>& hexes_keys() {
  using H = HexesDeck;
  static const Keys<H> keys = {
      {"hourglass", word<&H::hourglass>(), D::none, words<HourglassMethod>(), R"("stiffness")", always,
       "control of the zero-energy modes (Flanagan & Belytschko 1981)"},
      {"hourglass_coefficient", &H::hourglass_coefficient, D::none, share, "0.1", always, "strength of it"},
      {"viscosity_linear", &H::viscosity_linear, D::none, Bounds{0, 10}, "0.06", always,
       "bulk viscosity, in compression"},
      {"viscosity_quadratic", &H::viscosity_quadratic, D::none, Bounds{0, 10}, "1.2", always,
       "bulk viscosity in shocks"},
      {"delete_failed", &H::delete_failed, D::none, any, "false", always,
       "delete a hex whose damage reaches 1"},
      {"delete_at_strain", &H::delete_at_strain, D::none, positive, optional, always,
       "delete a hex whose equivalent plastic strain reaches this"},
  };
  return keys;
}

const Keys<SleepDeck>& sleep_keys() {
  using S = SleepDeck;
  static const Keys<S> keys = {
      {"distance", &S::distance, D::length, positive, optional, always,
       "points farther than this from the active region are held, and freeze; not given: all points move"},
      {"ramp", &S::ramp, D::none, Bounds{0, 1, true, true}, "0.5", always,
       "last part of the distance, over which velocities are damped so that waves do not come back"},
      {"speed", &S::speed, D::none, Bounds{0, 2, true, false}, "0.05", always,
       "the active region is what the tool comes near to, and what moves faster than this share of the speed "
       "of the tool (or of the fastest held face)"},
  };
  return keys;
}

const Keys<RetireDeck>& retire_keys() {
  using R = RetireDeck;
  static const Keys<R> keys = {
      {"distance", &R::distance, D::length, positive, optional, always,
       "spent chip: particles farther than this from where they began, from what has moved less and from "
       "what "
       "the tool comes near to leave for good and fly on without forces; needs sleep.distance; not given: "
       "nothing leaves"},
  };
  return keys;
}

const Keys<RunDeck>& run_keys() {
  using R = RunDeck;
  static const Keys<R> keys = {
      {"end_time", &R::end_time, D::time, positive, optional, always,
       "when the run ends; this or end_immersion"},
      {"end_immersion", &R::end_immersion, D::angle, Bounds{-360, 3.6e6}, optional, always,
       "immersion angle of the first tooth where the run ends; needs a spindle"},
      {"courant", &R::courant, D::none, Bounds{0, 1, true, false}, "0.8", always,
       "step over the stable step, 2 over the highest frequency of the particles and of the hexes"},
      {"mass_factor", &R::mass_factor, D::none, Bounds{1, 1e8}, "1.0", always,
       "inertia is that of this many times the mass: the step grows with its root, heat and rates stay "
       "right"},
      {"accuracy", &R::accuracy, D::percentage, Bounds{0, 100, true, false}, optional, always,
       "asked of the mean cutting force: takes the cheapest settings of the measured chart "
       "(docs/reports/accuracy_cost.md) that keep it, and says which and why (swarf check: before running). "
       "They "
       "take "
       "the place of what the deck has for body.spacing and cells, the thickness of a periodic slice with "
       "the "
       "tool's extent and output.force_scale, body.tie, courant, mass_factor, sleep.distance and [particles] "
       "but skin; [windows] are left out where the whole pass is the better choice. Needs a wedge and "
       "blocks, or an end mill and rings"},
      {"energy_tolerance", &R::energy_tolerance, D::percentage, positive, R"("2 %")", always,
       "the run warns where its energy balance is off by more than this share of what it was given: initial "
       "energy, the most external work so far, and what all bodies would have at the speed of the tool or of "
       "driven faces"},
      {"energy_limit", &R::energy_limit, D::percentage, positive, R"("10 %")", always,
       "where the balance is off by more the run ends, with exit status 3"},
      {"threads", &R::threads, D::none, Bounds{0, 4096}, "0", always,
       "of the computation, at most one a core; 0: all cores"},
      {"gravity", &R::gravity, D::acceleration, any, R"(["0 m/s2", "0 m/s2", "0 m/s2"])", always,
       "acts on all bodies"},
  };
  return keys;
}

const Keys<OutputDeck>& output_keys() {
  using O = OutputDeck;
  static const Keys<O> keys = {
      {"force_scale", &O::force_scale, D::none, positive, "1.0", always,
       "factor of all reported forces and torques: depth of cut / thickness of the modelled slice"},
      {"history_steps", &O::history_steps, D::none, Bounds{1, 1e6}, "10", always,
       "most steps between two history samples"},
      {"frame_time", &O::frame_time, D::time, positive, optional, always,
       "between two frames; or frame_immersion"},
      {"frame_immersion", &O::frame_immersion, D::angle, positive, optional, always,
       "between two frames; needs a spindle"},
      {"checkpoint_time", &O::checkpoint_time, D::time, positive, optional, always,
       "simulated time between two checkpoints; not given: with every frame"},
      {"filter_frequency", &O::filter_frequency, D::rate, not_negative, R"("0 Hz")", always,
       "low pass of the filtered forces; 0: chosen from the length of the run"},
      {"picture_immersion", &O::picture_immersion, D::angle, any, "[]", always,
       "immersion angles of the rendered views; empty: spread over the run; needs a spindle"},
      {"picture_time", &O::picture_time, D::time, not_negative, "[]", always,
       "times of the rendered views, for scenes without a spindle; empty: spread over the run"},
      {"picture_field", word<&O::picture_field>(), D::none, words<PictureField>(), R"("temperature")", always,
       "what colours the rendered views"},
      {"picture_view", &O::picture_view, D::none, Direction{}, "[0.0, 0.0, 1.0]", always,
       "from the scene to the camera"},
      {"published", custom, D::none, any, optional, always,
       "list of { label, force }: values drawn as lines in the plot of the planar force"},
  };
  return keys;
}

const Keys<WindowsDeck>& windows_keys() {
  using W = WindowsDeck;
  const Bounds immersion{-360, 720}, length{0, 180, true, false};
  static const Keys<W> keys = {
      {"first", &W::first, D::angle, immersion, R"("10 deg")", always, "immersion at the first centre"},
      {"last", &W::last, D::angle, immersion, R"("170 deg")", always, "no centre lies beyond it"},
      {"step", &W::step, D::angle, length, R"("20 deg")", always, "from centre to centre"},
      {"width", &W::width, D::angle, length, R"("6 deg")", always,
       "of the measurement about the centre; the standard error falls with its root"},
      {"run_in", &W::run_in, D::angle, Bounds{0, 180}, R"("5 deg")", always,
       "cut before the measurement, until the chip has formed; a helix adds its lag over the depth of cut"},
      {"ahead", &W::ahead, D::angle, length, R"("7 deg")", always,
       "of the end of the measurement, that the material goes on"},
  };
  return keys;
}

const Keys<MechanisticDeck>& mechanistic_keys() {
  using M = MechanisticDeck;
  static const Keys<M> keys = {
      {"K_tc", &M::K_tc, D::pressure, any, required, always,
       "tangential force per area of uncut chip; on the tool, against the motion of its edge"},
      {"K_rc", &M::K_rc, D::pressure, any, required, always, "radial; on the tool, towards its axis"},
      {"K_ac", &M::K_ac, D::pressure, any, R"("0 N/mm2")", always,
       "axial; positive pulls the tool out of its holder, -z"},
      {"K_te", &M::K_te, D::line_force, any, R"("0 N/mm")", always,
       "tangential force of the edge per depth of cut, whatever the chip"},
      {"K_re", &M::K_re, D::line_force, any, R"("0 N/mm")", always, "radial"},
      {"K_ae", &M::K_ae, D::line_force, any, R"("0 N/mm")", always, "axial"},
      {"minimum_chip", &M::minimum_chip, D::length, not_negative, R"("0 um")", always,
       "a chip thinner than this is not cut: the edge only presses, and leaves it to the next tooth"},
      {"depth", &M::depth, D::length, positive, optional, always,
       "axial depth of cut; not given: what the tool overlaps of the bodies, times output.force_scale"},
      {"helix", &M::helix, D::angle, Bounds{0, 70}, optional, always,
       "not given: tool.helix. A periodic slice has none, its mill may"},
      {"entry", &M::entry, D::angle, Bounds{0, 360}, R"("0 deg")", always,
       "immersion where the work begins; a slot: 0 deg"},
      {"exit", &M::exit, D::angle, Bounds{0, 360}, R"("180 deg")", always,
       "immersion where it ends; a slot: 180 deg"},
  };
  return keys;
}

const Keys<LabelledForce>& published_keys() {
  using L = LabelledForce;
  static const Keys<L> keys = {
      {"label", &L::label, D::none, Text{}, required, always, "of the line"},
      {"force", &L::force, D::force, any, required, always, "planar resultant"},
  };
  return keys;
}

} // namespace swarf
