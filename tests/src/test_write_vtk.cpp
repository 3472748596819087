#include "src/output/write_vtk.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>

namespace fs = std::filesystem;
using namespace swarf;
using ::testing::HasSubstr;

namespace {

// Two particles, one hex, a tool of one facet; every number differs.
void build_scene(Particles& p, HexMesh& h, Tool& tool) {
  p.count = p.points.count = p.stored = 2, p.whole = 12, p.total = 3; // the third is an image: not written
  p.position = VectorField("x", 3), p.velocity = VectorField("v", 3), p.contact_force = VectorField("f", 3);
  p.volume = ScalarField("V", 3), p.identity = IndexField("id", 3), p.body = IndexField("body", 3);
  p.points.temperature = ScalarField("T", 3), p.points.stress = SymmetricField("s", 3);
  p.points.equivalent_plastic_strain = ScalarField("e", 3),
  p.points.plastic_strain_rate = ScalarField("r", 3);
  for (int i = 0; i < 2; ++i) {
    for (int c = 0; c < 3; ++c) p.position(i, c) = 1e-6 * (i + 0.1 * c), p.velocity(i, c) = i - c;
    p.identity(i) = 10 + i, p.points.temperature(i) = 300 + i, p.volume(i) = 1e-18;
  }
  p.points.stress(1, 0) = 300e6, p.points.stress(1, 3) = 50e6;
  h.nodes = 8, h.points.count = 1;
  h.position = VectorField("X", 8), h.velocity = VectorField("w", 8);
  h.connectivity = View<int* [8]>("c", 1), h.active = View<int*>("a", 1), h.volume = ScalarField("hV", 1);
  h.points.temperature = ScalarField("hT", 1), h.points.stress = SymmetricField("hs", 1);
  const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int a = 0; a < 8; ++a) {
    h.connectivity(0, a) = a;
    for (int c = 0; c < 3; ++c) h.position(a, c) = corner[a][c];
  }
  h.points.temperature(0) = 500, h.active(0) = 1;
  tool.facets = 1, tool.vertex = View<Real* [3][3]>("facets", 1);
  tool.vertex(0, 1, 0) = 1, tool.vertex(0, 2, 1) = 1, tool.vertex(0, 2, 2) = 5;
}

FrameData make_frame(double time) {
  Particles p;
  HexMesh h;
  Tool tool;
  build_scene(p, h, tool);
  ToolPose pose;
  pose.angle = Real(M_PI / 2), pose.position = {10, 20, 30};
  FrameData frame = copy_frame(p, h, tool, pose);
  frame.time = time, frame.immersion = 35.5;
  return frame;
}

template <class Reader>
vtkSmartPointer<typename std::remove_pointer_t<decltype(std::declval<Reader>().GetOutput())>>
load(const fs::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

} // namespace

TEST(WriteVtk, particles_read_back) {
  const TemporaryFolder folder;
  const auto results = create_results(folder / "run");
  FrameSeries(results).write(make_frame(1.25e-3));
  const auto grid = load<vtkXMLUnstructuredGridReader>(results.frames() / "frame_0000_particles.vtu");
  ASSERT_EQ(grid->GetNumberOfPoints(), 2);
  EXPECT_EQ(grid->GetNumberOfCells(), 2);
  EXPECT_EQ(grid->GetCellType(1), VTK_VERTEX);
  EXPECT_FLOAT_EQ(float(grid->GetPoint(1)[2]), 1.2e-6f);
  auto* points = grid->GetPointData();
  EXPECT_EQ(points->GetArray("temperature")->GetTuple1(1), 301);
  // sqrt(sxx^2 + 3 sxy^2) for uniaxial stress with shear
  EXPECT_FLOAT_EQ(float(points->GetArray("von_mises")->GetTuple1(1)), float(std::sqrt(9e16 + 3 * 2.5e15)));
  EXPECT_FLOAT_EQ(float(points->GetArray("pressure")->GetTuple1(1)), -100e6f);
  EXPECT_EQ(points->GetArray("identity")->GetTuple1(1), 11);
  EXPECT_EQ(points->GetArray("velocity")->GetComponent(1, 2), -1);
  for (const char* name : {"equivalent_plastic_strain", "plastic_strain_rate", "stress", "body", "volume"})
    EXPECT_TRUE(points->HasArray(name)) << name;
  EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 1.25e-3);
  EXPECT_EQ(grid->GetFieldData()->GetArray("immersion")->GetTuple1(0), 35.5);
}

TEST(WriteVtk, hexes_and_tool_read_back) {
  const TemporaryFolder folder;
  const auto results = create_results(folder / "run");
  FrameSeries(results).write(make_frame(0));
  const auto grid = load<vtkXMLUnstructuredGridReader>(results.frames() / "frame_0000_hexes.vtu");
  ASSERT_EQ(grid->GetNumberOfCells(), 1);
  EXPECT_EQ(grid->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_EQ(grid->GetPoint(6)[2], 1);
  EXPECT_EQ(grid->GetCellData()->GetArray("temperature")->GetTuple1(0), 500);
  // A quarter turn about z, then the shift: (1, 0, 0) -> (10, 21, 30), (0, 1, 5) -> (9, 20, 35).
  const auto tool = load<vtkXMLPolyDataReader>(results.frames() / "frame_0000_tool.vtp");
  ASSERT_EQ(tool->GetNumberOfPolys(), 1);
  EXPECT_FLOAT_EQ(float(tool->GetPoint(1)[1]), 21);
  EXPECT_FLOAT_EQ(float(tool->GetPoint(2)[0]), 9);
  EXPECT_FLOAT_EQ(float(tool->GetPoint(2)[2]), 35);
}

TEST(WriteVtk, binary_compressed_and_without_time_of_day) {
  const TemporaryFolder folder;
  const auto a = create_results(folder / "a"), b = create_results(folder / "b");
  FrameSeries(a).write(make_frame(0));
  sleep(1); // a time stamp would differ
  FrameSeries(b).write(make_frame(0));
  for (const char* part : {"particles", "hexes", "tool"})
    EXPECT_TRUE(read_text(frame_file(a, 0, part)) == read_text(frame_file(b, 0, part))) << part;
  EXPECT_THAT(read_text(frame_file(a, 0, "particles")),
              AllOf(HasSubstr("vtkZLibDataCompressor"), HasSubstr("encoding=\"raw\"")));
}

TEST(WriteVtk, lists_name_every_frame_and_part) {
  const TemporaryFolder folder;
  const auto results = create_results(folder / "run");
  FrameSeries series(results);
  for (int k = 0; k < 3; ++k) series.write(make_frame(0.1 * k));
  FrameData bare;
  bare.time = 0.3, bare.tool = std::vector<float>(9);
  series.write(bare);
  EXPECT_THAT(
      read_text(results.paraview()),
      HasSubstr("timestep=\"0.2\" part=\"1\" name=\"particles\" file=\"frames/frame_0002_particles.vtu\""));
  const auto list = read_frame_list(results);
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[1].time, 0.1);
  EXPECT_EQ(*list[1].immersion, 35.5);
  EXPECT_TRUE(list[1].particles && list[1].hexes && list[1].tool);
  EXPECT_FALSE(list[3].immersion);
  EXPECT_TRUE(list[3].tool && !list[3].particles && !list[3].hexes);
}

TEST(WriteVtk, restart_removes_the_frames_after_the_checkpoint) {
  const TemporaryFolder folder;
  const auto results = create_results(folder / "run");
  {
    FrameSeries series(results);
    for (int k = 0; k < 4; ++k) series.write(make_frame(k));
  }
  FrameSeries series(results, 2);
  EXPECT_EQ(series.count(), 2);
  EXPECT_TRUE(fs::exists(frame_file(results, 1, "tool")));
  EXPECT_FALSE(fs::exists(frame_file(results, 2, "tool")));
  EXPECT_EQ(read_frame_list(results).size(), 2u);
  EXPECT_THAT(message_of<ResultsError>([&] { FrameSeries(results, 5); }), HasSubstr("lists 2 frames"));
}

TEST(WriteVtk, says_what_is_wrong) {
  const TemporaryFolder folder;
  const auto results = create_results(folder / "run");
  fs::create_symlink("/dev/full", results.frames() / "frame_0000_hexes.vtu.tmp");
  EXPECT_THAT(message_of<ResultsError>([&] { FrameSeries(results).write(make_frame(0)); }),
              AllOf(HasSubstr("frame_0000_hexes.vtu"), HasSubstr("No space left")));
  write_file(results.frame_list(), "frame,time [s],immersion [deg],parts\n0,abc,1,tool\n");
  EXPECT_THAT(message_of<ResultsError>([&] { read_frame_list(results); }), HasSubstr("frames.csv:2"));
}
