// What is said where swarf is built without VTK and a picture is asked for.
#pragma once

namespace swarf {

inline constexpr const char* without_vtk =
    "this swarf was built without VTK and draws nothing. Install VTK 9.1 (Debian: libvtk9-dev) and build it "
    "with -DSWARF_PICTURES=ON, or plot the history with the Python package: swarf.read(\"results/NAME\")";

} // namespace swarf
