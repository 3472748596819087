// Where a key stands in the deck's file, which a Deck does not keep: for faults that only the scene shows.
#pragma once
#include <string>

namespace swarf {

// "file:line" of the key in the first section of this heading, "[tool]" for instance; of the heading where
// the section leaves the key out, "file" where the file has no such section.
std::string line_of(const std::string& file, const std::string& heading, const std::string& key = "");

} // namespace swarf
