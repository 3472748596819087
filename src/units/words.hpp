// The words that a deck chooses between: enums from where they are read. Each list of words has the order of
// its enum, and is all that reading, messages and the reference page know of them.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace swarf {

using Words = std::vector<std::string>;
template <class Enum>
const Words& words();

enum class Law { elastic, linear_hardening, johnson_cook, johnson_cook_tanh, zerilli_armstrong, rigid };
template <>
inline const Words& words<Law>() {
  static const Words all = {"elastic",           "linear_hardening",  "johnson_cook",
                            "johnson_cook_tanh", "zerilli_armstrong", "rigid"};
  return all;
}

enum class BodyShape { block, cylinder, ring, sphere, stl, mesh };
template <>
inline const Words& words<BodyShape>() {
  static const Words all = {"block", "cylinder", "ring", "sphere", "stl", "mesh"};
  return all;
}

enum class Fill { particles, hexes };
template <>
inline const Words& words<Fill>() {
  static const Words all = {"particles", "hexes"};
  return all;
}

enum class FaceKind { free, fixed, symmetric, periodic, velocity };
template <>
inline const Words& words<FaceKind>() {
  static const Words all = {"free", "fixed", "symmetric", "periodic", "velocity"};
  return all;
}

enum class ToolKind { end_mill, wedge, wall, stl };
template <>
inline const Words& words<ToolKind>() {
  static const Words all = {"end_mill", "wedge", "wall", "stl"};
  return all;
}

enum class BetweenBodies { hexes, none };
template <>
inline const Words& words<BetweenBodies>() {
  static const Words all = {"hexes", "none"};
  return all;
}

enum class KernelFrame { current, initial };
template <>
inline const Words& words<KernelFrame>() {
  static const Words all = {"current", "initial"};
  return all;
}

enum class SmoothingLength { fixed, evolving };
template <>
inline const Words& words<SmoothingLength>() {
  static const Words all = {"fixed", "evolving"};
  return all;
}

enum class DensityRule { continuity, summation };
template <>
inline const Words& words<DensityRule>() {
  static const Words all = {"continuity", "summation"};
  return all;
}

enum class HourglassMethod { stiffness, viscous };
template <>
inline const Words& words<HourglassMethod>() {
  static const Words all = {"stiffness", "viscous"};
  return all;
}

enum class PictureField { temperature, equivalent_plastic_strain, von_mises, velocity };
template <>
inline const Words& words<PictureField>() {
  static const Words all = {"temperature", "equivalent_plastic_strain", "von_mises", "velocity"};
  return all;
}

template <class Enum>
const std::string& word_of(Enum value) {
  return words<Enum>()[std::size_t(value)];
}

// The value that a word names. Throws std::out_of_range where it names none: what a user writes is checked
// before.
template <class Enum>
Enum value_of_word(const std::string& word) {
  const Words& known = words<Enum>();
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known[k] == word) return Enum(int(k));
  throw std::out_of_range("no such word: " + word);
}

} // namespace swarf
