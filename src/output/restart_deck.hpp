// What of a deck a restart must find unchanged.
#pragma once
#include "src/scene/scene.hpp"

namespace swarf {

// The resolved deck without what is no physics (title, end, threads, output but for the force scale, limits
// of the balance, where the tool's file lies), and the tool's facets as a number.
std::string restart_text(const Deck& deck, const Scene& scene);

// The tool's facets, their count and a checksum, "" without a tool.
std::string facets_text(const Scene& scene);

// Each key of two such texts whose value differs, with both values.
std::vector<std::string> list_restart_changes(const std::string& before, const std::string& now);

} // namespace swarf
