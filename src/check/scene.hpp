// Whether a scene is what its deck seems to mean: where bodies and tool are and go, what holds and joins
// them.
#pragma once
#include "src/scene/scene.hpp"

namespace swarf {

struct SceneReport {
  std::vector<std::pair<std::string, std::string>> lines; // name, value
  std::vector<std::string> warnings;
};

// Of the scene before its first step.
SceneReport look_at_scene(const Deck& deck, const Scene& scene);

// Of a deck of too many cells to build in seconds: steps, hours and GiB from a small block of each body,
// boxes from the shapes. Says nothing of overlaps and ties.
SceneReport estimate_large(const Deck& deck);

// --- its parts, each in a file of its own
struct Box {
  Triple low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  void grow(const Triple& x, double margin = 0);
  void add(const Box& other);
  Box moved(const Triple& way) const;
  bool meets(const Box& other) const;
  double diagonal() const;
  bool empty() const { return low[0] > high[0]; }
};
std::vector<Box> boxes_of_bodies(const Deck& deck, const Scene& scene);
Box box_of_tool(const Deck& deck, const Scene& scene, double time); // of a spinning one, of all its angles
Box way_of_tool(const Deck& deck, const Scene& scene);              // of the whole run
std::string describe_length(double metres);
std::string describe_box(const Box& box);
std::string describe_facets(const Scene& scene); // of the tool: how many, and how many were left out

std::vector<std::string> warn_of_tool(const Deck& deck,
                                      const Scene& scene); // that it misses, or is too narrow
struct BodyReport {
  std::vector<std::string> warnings; // not held, not joined, not felt
  std::vector<std::string> joined;   // pairs that act as one, now or once they meet
  std::vector<std::string> met;      // pairs that will press each other by contact
};
BodyReport look_at_bodies(const Deck& deck, const Scene& scene);

} // namespace swarf
