// swarf import: a small milling-like model in Abaqus' text becomes a deck that runs as it is.
#include "tests/support/run_program.hpp"
#include <array>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

// So many nodes each way, `h` mm apart.
std::string nodes(const std::array<int, 3>& n, double h, double from) {
  std::string text = "*Node\n";
  for (int k = 0, label = 1; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        text +=
            fmt::format("{}, {:.6f}, {:.6f}, {:.6f}\n", label++, from + h * i, from + h * j, from + h * k);
  return text;
}

std::string work() { // 8 x 3 x 4 hexes of 10 um
  std::string text = "*Part, name=WORK\n" + nodes({9, 4, 5}, 0.01, 0) + "*Element, type=C3D8R, elset=All\n";
  const auto node = [](int i, int j, int k) { return 1 + i + 9 * (j + 4 * k); };
  for (int k = 0, label = 1; k < 4; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 8; ++i)
        text += fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}\n", label++, node(i, j, k), node(i + 1, j, k),
                            node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
                            node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1));
  text += "*Nset, nset=Everything, generate\n1, 180\n*Nset, nset=Base\n";
  for (int k = 0; k < 5; ++k)
    for (int i = 0; i < 9; ++i) text += fmt::format("{}{}", node(i, 0, k), i == 8 ? "\n" : ", ");
  return text + "*Solid Section, elset=All, material=Ti\n,\n*End Part\n";
}

std::string zone() { // 16 x 6 x 8 particles of 5 um
  std::string text =
      "*Part, name=ZONE\n" + nodes({16, 6, 8}, 0.005, 0.0025) + "*Element, type=PC3D, elset=All\n";
  for (int k = 1; k <= 768; ++k) text += fmt::format("{}, {}\n", k, k);
  return text + "*Nset, nset=Everything, generate\n1, 768\n*Solid Section, elset=All, "
                "material=Ti\n0.0025\n*End Part\n";
}

const std::string rest = R"(*Part, name=TOOL
*Node
1, 0, 0, 0
2, .02, 0, 0
3, .02, .04, 0
4, 0, .04, 0
5, 0, 0, .06
6, .02, 0, .06
7, .02, .04, .06
8, 0, .04, .06
9, .01, .02, .03
*Element, type=R3D4, elset=Skin
1, 1, 4, 3, 2
2, 5, 6, 7, 8
3, 1, 2, 6, 5
4, 2, 3, 7, 6
5, 3, 4, 8, 7
6, 4, 1, 5, 8
*Nset, nset=RP
9,
*Rigid Body, ref node=RP, elset=Skin
*End Part
*Assembly, name=Assembly
*Instance, name=WORK-1, part=WORK
*End Instance
*Instance, name=ZONE-1, part=ZONE
0., 0.03, 0.
*End Instance
*Instance, name=TOOL-1, part=TOOL
-0.021, 0.05, -0.01
*End Instance
*Elset, elset=Upper, instance=WORK-1, generate
17, 24
*Surface, type=ELEMENT, name=Top
Upper, S5
*Surface, type=NODE, name=Dots
ZONE-1.Everything,
*Tie, name=Joint
Dots, Top
*End Assembly
*Material, name=Ti
*Density
4.43e-09,
*Elastic
110000., 0.33
*Specific Heat
5.263e+08,
*Plastic, hardening=JOHNSON COOK
862., 331., 0.34, 0.8, 1605., 25.
*Rate Dependent, type=JOHNSON COOK
0.012, 1.
*Inelastic Heat Fraction
0.9,
*Surface Interaction, name=Int
*Friction
0.3,
*Initial Conditions, type=TEMPERATURE
WORK-1.Everything, 25.
ZONE-1.Everything, 25.
*Step, name=Cut
*Dynamic, Explicit
, 4e-7
*Bulk Viscosity
0.06, 1.2
*Fixed Mass Scaling, factor=100.
*Boundary
WORK-1.Base, ENCASTRE
*Boundary, type=VELOCITY
TOOL-1.RP, 1, 1, 20000.
TOOL-1.RP, 2, 6
*Output, history
*End Step
)";

double last_of(const std::string& history, const std::string& name) {
  std::istringstream lines(history);
  std::string head, row, last, field;
  std::getline(lines, head);
  while (std::getline(lines, row)) last = row;
  std::istringstream names(head), values(last);
  while (std::getline(names, field, ',') && std::getline(values, row, ','))
    if (field.starts_with(name)) return std::stod(row);
  throw std::runtime_error("no " + name);
}

} // namespace

TEST(Import, a_model_runs_as_it_is) {
  const TemporaryFolder folder;
  const std::string model = folder.write("cut.inp", "*Heading\n" + work() + zone() + rest);
  const std::string deck = (folder / "cut.toml").string();
  const Ended imported =
      run_program({"import", model, "--units", "mm-tonne-s", "--temperature", "degC", "--output", deck});
  if (imported.output.find("needs Python 3.11") != std::string::npos) GTEST_SKIP() << imported.output;
  ASSERT_EQ(imported.status, 0) << imported.output;
  EXPECT_THAT(imported.output,
              AllOf(HasSubstr("*BULK VISCOSITY"), HasSubstr("*OUTPUT, HISTORY"), Not(HasSubstr("*TIE"))));

  const Ended checked = run_program({"check", deck, "--threads", "1"});
  EXPECT_EQ(checked.status, 0) << checked.output;
  EXPECT_THAT(checked.output,
              AllOf(HasSubstr("768 (+ 384 tied"), HasSubstr("96 (180 nodes)"),
                    HasSubstr("x 0 to 80, y 0 to 30, z 0 to 40 um"), Not(HasSubstr("never meet"))));
  const Ended ran = run_program(run_arguments(deck, folder / "results"));
  EXPECT_EQ(ran.status, 0) << ran.output;
  EXPECT_THAT(read_bytes(folder / "results/summary.json"), HasSubstr("\"ended\": \"complete\""));
  EXPECT_LT(last_of(read_bytes(folder / "results/history.csv"), "force_x"), -0.01)
      << "the tool is in the work, N";
}
