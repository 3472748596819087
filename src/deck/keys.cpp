#include "src/deck/keys.hpp"

namespace swarf {
namespace {

using D = Dimension;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Bounds any{}, positive{0, infinity, true, false}, not_negative{0, infinity}, share{0, 1};
const std::vector<Condition> always;
constexpr std::monostate custom;
const std::string required = "required", optional = "optional";
const std::string zero_velocity = R"(["0 m/s", "0 m/s", "0 m/s"])", zero_point = R"(["0 m", "0 m", "0 m"])";

std::vector<Condition> law(std::vector<std::string> laws) { return {{"law", std::move(laws)}}; }
std::vector<Condition> shape(std::vector<std::string> shapes) { return {{"shape", std::move(shapes)}}; }
std::vector<Condition> fill(std::vector<std::string> fills) { return {{"fill", std::move(fills)}}; }
std::vector<Condition> kind(std::vector<std::string> kinds) { return {{"kind", std::move(kinds)}}; }

} // namespace

const Keys<Deck>& top_keys() {
  static const Keys<Deck> keys = {
      {"title", &Deck::title, D::none, Text{}, R"("untitled")", always, "one line that names the scene"},
  };
  return keys;
}

const Keys<MaterialDeck>& material_keys() {
  using M = MaterialDeck;
  const auto deforms =
      law({"elastic", "linear_hardening", "johnson_cook", "johnson_cook_tanh", "zerilli_armstrong"});
  const auto johnson_cook = law({"johnson_cook", "johnson_cook_tanh"}), tanh = law({"johnson_cook_tanh"});
  const auto zerilli = law({"zerilli_armstrong"});
  const auto of_power_law = law({"johnson_cook", "johnson_cook_tanh", "zerilli_armstrong"});
  static const Keys<M> keys = {
      {"law", word<&M::law>(), D::none, words<Law>(), required, always,
       "flow law; all are isotropic, with the Jaumann rate; rigid: of a tool, which only conducts"},
      {"density", &M::density, D::density, positive, required, always, "mass per volume, unloaded"},
      {"youngs_modulus", &M::youngs_modulus, D::pressure, positive, required, deforms,
       "E; this, specific_heat and conductivity may be tables over temperature, such as [[\"300 K\", \"110 "
       "GPa\"], [\"900 K\", \"80 GPa\"]]: straight lines between the points, constant outside. The stable "
       "step "
       "is that of the stiffest, the best conductor and the least heat capacity in them"},
      {"poissons_ratio", &M::poissons_ratio, D::none, Bounds{-1, 0.5, true, true}, required, deforms, "nu"},
      {"specific_heat", &M::specific_heat, D::specific_heat, positive, required,
       law({"johnson_cook", "johnson_cook_tanh", "zerilli_armstrong", "rigid"}), "heat per mass and kelvin"},
      {"specific_heat", &M::specific_heat, D::specific_heat, positive, R"("500 J/kg/K")",
       law({"elastic", "linear_hardening"}), "heat per mass and kelvin; changes no force under these laws"},
      {"conductivity", &M::conductivity, D::conductivity, not_negative, R"("0 W/m/K")", deforms,
       "of heat; 0: adiabatic"},
      {"conductivity", &M::conductivity, D::conductivity, positive, required, law({"rigid"}), "of heat"},
      {"thermal_expansion", &M::thermal_expansion, D::per_kelvin, Bounds{0, 0.01}, R"("0 1/K")", deforms,
       "of a length, per length as it is; 0: heat makes no stress"},
      {"taylor_quinney", &M::taylor_quinney, D::none, share, "0.9",
       law({"linear_hardening", "johnson_cook", "johnson_cook_tanh", "zerilli_armstrong"}),
       "share of the plastic work that becomes heat"},
      {"yield_stress", &M::yield_stress, D::pressure, positive, required, law({"linear_hardening"}),
       "flow stress at zero plastic strain"},
      {"hardening_modulus", &M::hardening_modulus, D::pressure, not_negative, required,
       law({"linear_hardening"}), "slope of flow stress over equivalent plastic strain"},
      {"A", &M::A, D::pressure, positive, required, johnson_cook,
       "flow stress = (A + B e^n) (1 + C ln(rate/reference_rate)) (1 - T*^m); below the reference rate the "
       "second factor is 1"},
      {"B", &M::B, D::pressure, not_negative, required, johnson_cook, "hardening"},
      {"n", &M::n, D::none, Bounds{0, 10, true, false}, required, of_power_law, "hardening exponent"},
      {"C", &M::C, D::none, Bounds{0, 10}, required, johnson_cook, "rate sensitivity"},
      {"m", &M::m, D::none, Bounds{0, 10, true, false}, required, johnson_cook, "softening exponent"},
      {"reference_rate", &M::reference_rate, D::rate, positive, R"("1 1/s")", of_power_law,
       "plastic strain rate where the rate factor is 1; lower ones count as this"},
      {"reference_temperature", &M::reference_temperature, D::temperature, positive, required, johnson_cook,
       "T* = 0 here and below"},
      {"melt_temperature", &M::melt_temperature, D::temperature, positive, required, johnson_cook,
       "T* = 1: no strength"},
      {"softening_a", &M::softening_a, D::none, Bounds{0, 10, true, false}, required, tanh,
       "Johnson-Cook with B e^n exp(-e^a), times D + (1 - D) tanh((e + S)^-c) (Calamaz et al. 2008)"},
      {"softening_b", &M::softening_b, D::none, Bounds{0, 10, true, false}, required, tanh,
       "S = (T / melt_temperature)^b"},
      {"softening_c", &M::softening_c, D::none, Bounds{0, 20, true, false}, required, tanh,
       "how suddenly it softens"},
      {"softening_d", &M::softening_d, D::none, Bounds{0, 10, true, false}, required, tanh,
       "D = 1 - (T / melt_temperature)^d, what is left"},
      {"C0", &M::C0, D::pressure, not_negative, required, zerilli,
       "flow stress = C0 + (C1 + C2 e^0.5) exp(-C3 T + C4 T ln rate) + C5 e^n, rate in 1/s"},
      {"C1", &M::C1, D::pressure, not_negative, R"("0 Pa")", zerilli, "of body-centred metals"},
      {"C2", &M::C2, D::pressure, not_negative, R"("0 Pa")", zerilli, "of face-centred metals"},
      {"C3", &M::C3, D::per_kelvin, not_negative, required, zerilli, "softening"},
      {"C4", &M::C4, D::per_kelvin, not_negative, required, zerilli, "rate sensitivity"},
      {"C5", &M::C5, D::pressure, not_negative, R"("0 Pa")", zerilli, "hardening of body-centred metals"},
      {"damage", &M::damage, D::none, any, optional, johnson_cook,
       "D1 to D5 of the Johnson-Cook fracture strain (1985); without it nothing fails"},
  };
  return keys;
}

const Keys<BodyDeck>& body_keys() {
  using B = BodyDeck;
  const Bounds ring_angle{-360, 720};
  const std::vector<Condition> block_or_ring = shape({"block", "ring"}), cylinder = shape({"cylinder"});
  const auto of_lattice = shape({"block", "cylinder", "ring", "sphere", "stl"});
  const std::vector<Condition> lattice_of_hexes = {{"fill", {"hexes"}}, {"shape", {"block", "ring"}}};
  static const Keys<B> keys = {
      {"name", &B::name, D::none, Text{}, required, always, "unique among the bodies"},
      {"shape", word<&B::shape>(), D::none, words<BodyShape>(), required, always,
       "cylinder and ring have their axis along z; stl: what a closed surface encloses; mesh: hexes or "
       "particles "
       "as a file has them"},
      {"fill", word<&B::fill>(), D::none, words<Fill>(), required, always, "how the body is discretised"},
      {"material", &B::material, D::none, Text{}, required, always,
       "NAME of a [material.NAME], or \"library:NAME\" of those that swarf materials lists"},
      {"origin", &B::origin, D::length, any, zero_point, always,
       "block: corner of least x, y, z; cylinder and ring: centre of the base; sphere: centre; stl and mesh: "
       "where the origin of the file comes to lie"},
      {"size", &B::size, D::length, positive, required, shape({"block"}), "edges along x, y, z"},
      {"radius", &B::radius, D::length, positive, required, cylinder, "of the cylinder"},
      {"inner_radius", &B::inner_radius, D::length, positive, required, shape({"ring"}), "of the bore"},
      {"inner_radius", &B::inner_radius, D::length, not_negative, R"("0 m")", shape({"sphere"}),
       "of the hollow; 0: solid"},
      {"outer_radius", &B::outer_radius, D::length, positive, required, shape({"ring", "sphere"}),
       "of the outer surface"},
      {"height", &B::height, D::length, positive, required, shape({"cylinder", "ring"}), "along z"},
      {"start_angle", &B::start_angle, D::angle, ring_angle, R"("0 deg")", shape({"ring"}),
       "of the sector, counter-clockwise from +x"},
      {"end_angle", &B::end_angle, D::angle, ring_angle, R"("360 deg")", shape({"ring"}),
       "of the sector; a whole turn closes the ring"},
      {"file", &B::file, D::none, Text{}, required, shape({"stl"}),
       "STL file, relative to the deck; closed, normals outwards"},
      {"file_scale", &B::file_scale, D::length, positive, R"("1 mm")", shape({"stl"}),
       "length of one unit of the file"},
      {"file", &B::file, D::none, Text{}, required, shape({"mesh"}),
       "relative to the deck; of hexes: *NODE, *ELEMENT, TYPE=C3D8R and *NSET as Abaqus writes them; of "
       "particles: a line x, y, z, volume for each"},
      {"file_scale", &B::file_scale, D::length, positive, required, shape({"mesh"}),
       "length of one unit of the file"},
      {"spacing", &B::spacing, D::length, positive, optional, of_lattice,
       "distance of particles, or edge of hexes; rounded so that whole cells fit. Instead of cells"},
      {"cells", &B::cells, D::none, Counts{3}, optional, block_or_ring,
       "exact counts instead of spacing; block [x, y, z], ring [around, axial, radial]"},
      {"cells", &B::cells, D::none, Counts{2}, optional, cylinder,
       "exact counts instead of spacing: [across the diameter, axial]"},
      {"previous_tooth", &B::previous_tooth, D::none, any, "false", shape({"ring"}),
       "inner surface as the previous tooth of the end mill left it, not round"},
      {"velocity", &B::velocity, D::velocity, any, zero_velocity, always, "at the start"},
      {"temperature", &B::temperature, D::temperature, positive, R"("25 degC")", always, "at the start"},
      {"tie", &B::tie, D::none, Text{}, optional, fill({"particles"}),
       "name of the body of hexes that these particles are tied to"},
      {"convert_distance", &B::convert_distance, D::length, positive, optional, lattice_of_hexes,
       "hexes whose centre is nearer than this to the tool become particles, for good; those on a fixed or "
       "driven face stay hexes"},
      {"convert_strain", &B::convert_strain, D::none, positive, optional, lattice_of_hexes,
       "hexes whose equivalent plastic strain reaches this become particles; with convert_distance: either"},
      {"convert_particles", &B::convert_particles, D::none, Bounds{1, 4}, "2", lattice_of_hexes,
       "particles along each edge of a hex that becomes particles"},
      {"faces", custom, D::none, any, optional, always,
       "table [body.faces]: FACE = \"fixed\" | \"symmetric\" | \"periodic\" | { velocity = [...] }, and in "
       "the braces, if heat goes through the face, temperature and film. "
       "Faces of a block: x_min x_max y_min y_max z_min z_max; of a cylinder: bottom top side; of a ring: "
       "inner "
       "outer bottom top start end; of a sphere: inner outer; of an stl: the sides of its box, as of a "
       "block; of a "
       "mesh: its sets of nodes. Faces not named are free; periodic ones come "
       "in "
       "opposite pairs; symmetric and periodic ones are plane"},
  };
  return keys;
}

const Keys<FaceDeck>& face_keys() {
  static const Keys<FaceDeck> keys = {
      {"velocity", &FaceDeck::velocity, D::velocity, any, zero_velocity, always,
       "prescribed for the whole face; not given: the face is free, or fixed"},
      {"fixed", &FaceDeck::fixed, D::none, any, "false", always, "the face does not move"},
      {"temperature", &FaceDeck::temperature, D::temperature, positive, optional, always,
       "of the surface, which is held at it; with a film, of what is around it; not given: no heat crosses"},
      {"film", &FaceDeck::film, D::conductance, positive, optional, always,
       "film coefficient of the convection to surroundings of that temperature; not given: perfect"},
  };
  return keys;
}

const Keys<ToolDeck>& tool_keys() {
  using T = ToolDeck;
  const auto mill = kind({"end_mill"}), wedge = kind({"wedge"}), wall = kind({"wall"}), stl = kind({"stl"});
  const auto cutting = kind({"end_mill", "wedge"});
  static const Keys<T> keys = {
      {"kind", word<&T::kind>(), D::none, words<ToolKind>(), required, always, "rigid, any of these"},
      {"diameter", &T::diameter, D::length, positive, required, mill, "of the circle of the tips"},
      {"flutes", &T::flutes, D::none, Bounds{1, 8}, "2", mill, "number of teeth, evenly spaced"},
      {"helix", &T::helix, D::angle, Bounds{0, 70}, R"("0 deg")", mill, "angle; right-handed"},
      {"rake", &T::rake, D::angle, Bounds{-60, 60}, required, cutting,
       "angle of the face the chip runs up; positive leans it back, away from the cut"},
      {"clearance", &T::clearance, D::angle, Bounds{0, 45, true, false}, required, cutting,
       "angle behind the edge"},
      {"edge_radius", &T::edge_radius, D::length, not_negative, required, cutting,
       "of the rounded cutting edge; 0: sharp"},
      {"length", &T::length, D::length, positive, required, mill,
       "of the modelled part of the mill, along its axis"},
      {"core_ratio", &T::core_ratio, D::none, Bounds{0, 1, true, true}, "0.6", mill,
       "diameter of the core / diameter"},
      {"runout", &T::runout, D::length, not_negative, R"("0 m")", mill,
       "distance of the mill's axis from the spindle's"},
      {"runout_angle", &T::runout_angle, D::angle, Bounds{-360, 360}, R"("0 deg")", mill,
       "direction of the run-out, clockwise from tooth 0; 0: tooth 0 cuts more"},
      {"inclination", &T::inclination, D::angle, Bounds{-60, 60}, R"("0 deg")", wedge,
       "of the edge, about +y; 0: the edge lies along z (orthogonal cutting along +x)"},
      {"width", &T::width, D::length, positive, required, wedge, "along the edge"},
      {"height", &T::height, D::length, positive, required, wedge, "of the wedge above its edge"},
      {"normal", &T::normal, D::none, Direction{}, "[0.0, 0.0, 1.0]", wall,
       "of the wall, towards the bodies"},
      {"size", &T::size, D::length, positive, required, wall, "edge of the square wall"},
      {"file", &T::file, D::none, Text{}, required, stl,
       "STL file, relative to the deck; closed, normals outwards"},
      {"file_scale", &T::file_scale, D::length, positive, R"("1 mm")", stl, "length of one unit of the file"},
      {"position", &T::position, D::length, any, zero_point, always,
       "of the tool's origin at the start: end_mill centre of the end face, wedge lowest point of the middle "
       "of "
       "the edge, wall centre, stl origin of the file"},
      {"velocity", &T::velocity, D::velocity, any, required, wedge, "straight motion"},
      {"velocity", &T::velocity, D::velocity, any, zero_velocity, kind({"wall", "stl"}), "straight motion"},
      {"spindle_speed", &T::spindle_speed, D::angular_velocity, positive, required, mill,
       "clockwise seen from +z"},
      {"spindle_speed", &T::spindle_speed, D::angular_velocity, not_negative, R"("0 rpm")", stl,
       "about the file's z axis, clockwise seen from +z"},
      {"feed_per_tooth", &T::feed_per_tooth, D::length, not_negative, required, mill,
       "advance between two teeth; feed = feed_per_tooth * flutes * spindle speed"},
      {"feed_direction", &T::feed_direction, D::none, Direction{}, "[1.0, 0.0, 0.0]", mill, "of the advance"},
      {"start_angle", &T::start_angle, D::angle, Bounds{-360, 720}, R"("0 deg")", mill,
       "immersion angle of tooth 0 at the end face at time 0: clockwise from +y"},
      {"material", &T::material, D::none, Text{}, optional, always,
       "NAME of a [material.NAME] with law = \"rigid\", or \"library:carbide-wc-co\": the tool conducts, and "
       "takes heat from the bodies "
       "and "
       "from friction by itself; not given: contact.heat_to_workpiece"},
      {"temperature", &T::temperature, D::temperature, positive, R"("25 degC")", always,
       "of a tool with a material, at the start"},
      {"held_beyond", &T::held_beyond, D::length, positive, optional, always,
       "a tool with a material stays at that temperature farther than this from where the bodies come; not "
       "given: its far faces are insulated"},
      {"temperature_from", &T::temperature_from, D::none, Text{}, optional, always,
       "folder of the results of a run with the same tool, such as results/NAME: a tool with a material "
       "starts "
       "with the temperatures that it had at the end of that run; not given: with `temperature`"},
      {"idle_time", &T::idle_time, D::time, not_negative, R"("0 s")", always,
       "between that run and this one, in which the tool only conducts: of a mill what is left of a turn"},
      {"heat_time", &T::heat_time, D::time, positive, optional, always,
       "that heat has to spread in a tool with a material, over all runs whose temperatures are handed on, "
       "with "
       "the idle times: how far from the work the tool has cells; not given: that of the run"},
      {"wear_A", &T::wear_A, D::per_pressure, positive, optional, always,
       "depth of wear per time A p v exp(-B / T) of a tool with a material, p the pressure, v the sliding "
       "speed, T "
       "the temperature of its surface (Usui et al. 1984); the shape of the tool stays; not given: no wear"},
      {"wear_B", &T::wear_B, D::temperature, not_negative, optional, always,
       "of the same; 0 K: wear does not depend on the temperature"},
      {"lift_time", &T::lift_time, D::time, positive, optional, always,
       "when the tool lifts off, so that the work unloads: from then on lift_velocity takes the place of "
       "velocity "
       "and feed, and the spindle goes on"},
      {"lift_velocity", &T::lift_velocity, D::velocity, any, zero_velocity, always, "from lift_time on"},
  };
  return keys;
}

const Keys<ContactDeck>& contact_keys() {
  using C = ContactDeck;
  static const Keys<C> keys = {
      {"friction", &C::friction, D::none, Bounds{0, 10}, required, always,
       "Coulomb coefficient between tool and bodies, and between bodies"},
      {"between_bodies", word<&C::between_bodies>(), D::none, words<BetweenBodies>(), R"("hexes")", always,
       "who presses whom where bodies meet that no tie joins: two bodies of which one at least is of hexes "
       "(particles of two bodies share kernels, which push and pull); none: bodies pass through hexes"},
      {"shear_limit", &C::shear_limit, D::pressure, positive, optional, always, "largest friction stress"},
      {"stiffness", &C::stiffness, D::none, Bounds{0, 1, true, false}, "1.0", always,
       "most of the contact's spring, in units of (scaled mass) / dt^2; a particle's is that of the material "
       "between it and its surface, as far as this allows; softer, the tool sinks in, and the thrust force "
       "of a cut grows"},
      {"heat_to_workpiece", &C::heat_to_workpiece, D::none, share, optional, always,
       "share of the friction work that heats the bodies; the rest is lost to the tool; not given: 0.5. Of a "
       "tool without a material only"},
      {"conductance", &C::conductance, D::conductance, positive, optional, always,
       "of heat through the interface, of a tool with a material; not given: perfect contact, no jump of the "
       "temperature"},
  };
  return keys;
}

} // namespace swarf
