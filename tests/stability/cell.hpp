// One cell of the stability matrix: a formulation put to one test that breaks formulations.
#pragma once
#include "src/deck/deck.hpp"
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace swarf::stability {

struct Formulation {
  std::string name, text;
  std::string fill;     // particles | hexes
  bool deletes = false; // hexes: elastic tests say nothing new of it
  bool follows = true;  // any flow; false: bound to the neighbours of the start
  std::function<void(Deck&)> apply;
};
const std::vector<Formulation>& formulations();

// What a cell measures, and where the classes end. Stable up to `stable`, failed beyond `failed`, degraded
// between. All were set before the first run.
struct Limit {
  std::string measure, shown, text; // `shown` in the picture; with % where the value is a share
  double stable, failed;
  std::string reason;
  bool more_is_better = false;
};
const std::vector<Limit>& limits();

struct Outcome {
  std::vector<std::pair<std::string, double>> measures; // each has a Limit
  std::string fault;                                    // what ended it before its time, or empty
  double when = 1;                                      // share of its time that it reached
  long steps = 0;
};

enum class Kind { elastic, plastic, cut };
struct Test {
  std::string name, title, text;
  std::string why; // what fails fails so, as far as is known
  Kind kind;
  bool particles_only;
  Outcome (*run)(const Formulation&);
};
const std::vector<Test>& tests();

Outcome collide_ring(const Formulation&);
Outcome bend_plate(const Formulation&);
Outcome pull_strip(const Formulation&);
Outcome shake_block(const Formulation&);
Outcome spin_plate(const Formulation&);
Outcome disturb_lattice(const Formulation&);
Outcome hit_wall(const Formulation&);
Outcome lose_particle(const Formulation&);
Outcome scale_scene(const Formulation&);
Outcome raise_courant(const Formulation&);
Outcome raise_mass(const Formulation&);
Outcome raise_viscosity(const Formulation&);
Outcome pull_metal(const Formulation&);
Outcome shear_metal(const Formulation&);
Outcome cut(const Formulation&);
Outcome cut_fast(const Formulation&);
Outcome fill_chip(const Formulation&);

bool applies(const Formulation&, const Test&);
// The limit that decides, or nullptr if the run ended before its time; and the class.
struct Verdict {
  std::string name; // stable | degraded | failed
  const Limit* decisive = nullptr;
  double value = 0;
};
Verdict judge(const Outcome&);

} // namespace swarf::stability
