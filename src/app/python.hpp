// Commands that the Python package swarf carries out: tables, fits, pictures and pages by its libraries.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace swarf {

inline constexpr std::array<std::pair<const char*, const char*>, 3> python_commands{
    {{"study", "many runs of a deck as one: swarf study --help"},
     {"report", "one page of one or several runs: swarf report --help"},
     {"import", "a deck from a model for Abaqus: swarf import --help"}}};

// Becomes `python3 -m swarf COMMAND ARGUMENTS`; returns only where there is no Python with what it needs (1).
int run_python(const std::string& command, std::vector<std::string> arguments);

} // namespace swarf
