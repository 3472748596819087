#include "src/output/tool_heat_file.hpp"
#include "src/output/write_hdf5.hpp"
#include <fmt/format.h>

namespace swarf {
namespace {

template <class Field>
bool are_equal(const Field& a, const Field& b) {
  const auto x = host_copy(a), y = host_copy(b);
  for (std::size_t i = 0; x.size() == y.size() && i < x.size(); ++i)
    if (!(x.data()[i] == y.data()[i])) return false;
  return x.size() == y.size();
}

} // namespace

void write_tool_heat(const std::filesystem::path& file, const std::string& tool, const ToolHeat& heat) {
  CheckpointWriter out(file, tool);
  out.put("temperature", heat.temperature), out.put("capacity", heat.capacity);
  out.put("centre", heat.centre);
  out.finish();
}

void read_tool_heat(const std::filesystem::path& file, const std::string& tool, const ToolHeat& heat) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw ResultsError(fmt::format(
        "{}: is not there, so tool.temperature_from has nothing to start with. Give the folder of a run "
        "whose tool has a material and that has come to its end",
        file.string()));
  const CheckpointReader in(file);
  if (in.deck() != tool)
    throw ResultsError(
        fmt::format("{}: was written by a run with another tool or material of it, and tool.temperature_from "
                    "wants the same one. Use the deck of that run, or leave the key out",
                    file.string()));
  VectorField centre;
  ScalarField capacity, temperature;
  in.get("centre", centre), in.get("capacity", capacity);
  if (!are_equal(centre, heat.centre) || !are_equal(capacity, heat.capacity))
    throw ResultsError(fmt::format(
        "{}: is of cells that are laid out otherwise than here ({} of them, here {}). The bodies, the "
        "spacing, the way of the tool and tool.heat_time (without it: the end of the run) must be those of "
        "that run",
        file.string(), centre.extent(0), heat.cells));
  in.get("temperature", temperature, std::uint64_t(heat.cells));
  Kokkos::deep_copy(heat.temperature, temperature);
}

} // namespace swarf
