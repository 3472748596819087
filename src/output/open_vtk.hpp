// How a file of a frame is opened, by any of VTK's readers.
#pragma once
#include "src/output/read_parts.hpp"
#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

namespace swarf {

// Throws ResultsError for a file that is not the one that the run wrote, or that VTK cannot read.
template <class Reader>
void open_frame_file(Reader* reader, const ResultsFolder& results, const FrameEntry& entry,
                     const std::string& part) {
  const auto file = frame_file(results, entry.index, part);
  check_frame_file(file, entry, part);
  vtkNew<vtkCallbackCommand> quiet; // an observer keeps VTK from printing errors
  reader->AddObserver(vtkCommand::ErrorEvent, quiet);
  reader->SetParserErrorObserver(quiet);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
    throw ResultsError(
        fmt::format("{}: is no frame that VTK can read; it was damaged after the run", file.string()));
}

} // namespace swarf
