#include "src/pictures/render_view.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkClipClosedSurface.h>
#include <vtkFeatureEdges.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

constexpr const char* shown = "shown";

void show_field(vtkMapper* mapper, vtkLookupTable* colours) {
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOff();
}

vtkNew<vtkActor> particle_actor(vtkPolyData* particles, vtkLookupTable* colours) {
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(particles);
  mapper->SetScaleArray("radius");
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(shown);
  show_field(mapper, colours);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

vtkNew<vtkActor> hex_actor(vtkPolyData* surface, vtkLookupTable* colours) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  if (surface->GetCellData()->HasArray(shown))
    mapper->SetScalarModeToUseCellFieldData();
  else
    mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(shown);
  show_field(mapper, colours);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.7);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetEdgeColor(0.45, 0.45, 0.5);
  return actor;
}

// The part of the tool between two planes across `direction`, closed.
vtkSmartPointer<vtkPolyData> cut_to_slice(vtkPolyData* tool, const LoadedFrame& frame, const Camera& camera) {
  const double* box = (frame.particles ? frame.particles : frame.hexes)->GetBounds();
  vtkNew<vtkPlaneCollection> planes;
  for (const int side : {0, 1}) {
    std::array<double, 3> origin{}, normal{};
    for (std::size_t c = 0; c < 3; ++c) {
      const bool upper = (camera.direction[c] > 0) == (side == 1);
      origin[c] = box[2 * c + (upper ? 1 : 0)];
      normal[c] = camera.direction[c] * (side == 1 ? -1 : 1);
    }
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    plane->SetNormal(normal.data());
    planes->AddItem(plane);
  }
  vtkNew<vtkClipClosedSurface> clip;
  clip->SetInputData(tool);
  clip->SetClippingPlanes(planes);
  clip->Update();
  return clip->GetOutput()->GetNumberOfPolys() > 0 ? clip->GetOutput() : tool;
}

void add_tool(vtkRenderer* renderer, const LoadedFrame& frame, const Camera& camera) {
  vtkNew<vtkCleanPolyData> merged; // the file has three points of its own for each facet
  merged->SetInputData(frame.tool);
  merged->Update();
  vtkSmartPointer<vtkPolyData> solid = merged->GetOutput();
  if (camera.section) solid = cut_to_slice(solid, frame, camera);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(solid);
  normals->SetFeatureAngle(35);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> body;
  body->SetMapper(mapper);
  body->GetProperty()->SetColor(0.72, 0.75, 0.80);
  body->GetProperty()->SetAmbient(0.3);
  body->GetProperty()->SetDiffuse(0.7);
  body->GetProperty()->SetSpecular(camera.section ? 0 : 0.5);
  body->GetProperty()->SetSpecularPower(30);
  if (!camera.section) body->GetProperty()->SetOpacity(0.45);
  renderer->AddActor(body);
  renderer->AddActor(line_actor(solid));
}

} // namespace

vtkNew<vtkActor> line_actor(vtkPolyData* surface) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(35);
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkPolyDataMapper> line_mapper;
  line_mapper->SetInputConnection(edges->GetOutputPort());
  line_mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> lines;
  lines->SetMapper(line_mapper);
  lines->GetProperty()->SetColor(0.2, 0.22, 0.26);
  lines->GetProperty()->SetLineWidth(2);
  lines->GetProperty()->LightingOff();
  return lines;
}

// Dark blue over violet and orange to pale yellow, rising in lightness: reads in grey print and by all eyes.
// Control colours after "inferno" and "plasma" of N. Smith and S. van der Walt (CC0).
vtkNew<vtkLookupTable> make_colours(double least, double most) {
  static constexpr double control[][3] = {{0.10, 0.13, 0.40}, {0.25, 0.18, 0.58}, {0.45, 0.14, 0.60},
                                          {0.65, 0.17, 0.52}, {0.82, 0.26, 0.38}, {0.93, 0.40, 0.22},
                                          {0.98, 0.60, 0.12}, {0.98, 0.81, 0.28}, {0.99, 0.98, 0.72}};
  constexpr int last = int(std::size(control)) - 1;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for (int k = 0; k < 256; ++k) {
    const double at = last * k / 255.0;
    const int i = std::min(int(at), last - 1);
    double rgb[3];
    for (int c = 0; c < 3; ++c) rgb[c] = control[i][c] + (at - i) * (control[i + 1][c] - control[i][c]);
    table->SetTableValue(k, rgb[0], rgb[1], rgb[2]);
  }
  table->SetRange(least, most);
  return table;
}

vtkNew<vtkRenderer> make_view(const LoadedFrame& frame, const Camera& camera,
                              const std::array<double, 3>& focus, vtkLookupTable* colours) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  if (frame.hexes) renderer->AddActor(hex_actor(frame.hexes, colours));
  if (frame.particles) renderer->AddActor(particle_actor(frame.particles, colours));
  if (frame.tool) add_tool(renderer, frame, camera);
  vtkCamera* eye = renderer->GetActiveCamera();
  eye->ParallelProjectionOn();
  eye->SetFocalPoint(focus.data());
  const double distance = 10 * camera.half_height;
  eye->SetPosition(focus[0] + distance * camera.direction[0], focus[1] + distance * camera.direction[1],
                   focus[2] + distance * camera.direction[2]);
  eye->SetViewUp(camera.up.data());
  eye->SetParallelScale(camera.half_height);
  renderer->ResetCameraClippingRange();
  return renderer;
}

} // namespace swarf
