// swarf check: what a scene that is not what its deck seems to mean must be told, and that it answers at
// once.
#include "tests/support/run_program.hpp"
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf::test;
using testing::HasSubstr;
using testing::Not;

namespace {

// A wedge that cuts a periodic slice of steel: particles tied to hexes that are held below.
const std::string slice = R"([material.steel]
law = "elastic"
density = "7800 kg/m3"
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
conductivity = "40 W/m/K"
[[body]]
name = "zone"
shape = "block"
fill = "particles"
material = "steel"
origin = ["0 um", "-20 um", "0 um"]
size = ["100 um", "60 um", "40 um"]
spacing = "10 um"
tie = "bulk"
[body.faces]
z_min = "periodic"
z_max = "periodic"
[[body]]
name = "bulk"
shape = "block"
fill = "hexes"
material = "steel"
origin = ["0 um", "-60 um", "0 um"]
size = ["100 um", "40 um", "40 um"]
spacing = "20 um"
[body.faces]
y_min = "fixed"
z_min = "periodic"
z_max = "periodic"
[tool]
kind = "wedge"
rake = "10 deg"
clearance = "5 deg"
edge_radius = "20 um"
width = "60 um"
height = "100 um"
position = ["-25 um", "0 um", "20 um"]
velocity = ["1 m/s", "0 m/s", "0 m/s"]
[contact]
friction = 0.1
[run]
end_time = "30 us"
mass_factor = 1e3
)";

std::string edit(std::string text, const std::vector<std::pair<std::string, std::string>>& edits) {
  for (const auto& [from, to] : edits) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("no \"" + from + "\" in the deck");
    text.replace(at, from.size(), to);
  }
  return text;
}

Ended check(const std::string& text) {
  const TemporaryFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  const Ended end = run_program({"check", write_deck(folder, text), "--threads", "1"});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(taken.count(), 30) << "an answer within seconds, also on a busy machine";
  return end;
}

void expect_words(const std::string& text, const std::vector<std::string>& words, int status = 0) {
  const Ended end = check(text);
  EXPECT_EQ(end.status, status) << end.output;
  for (const std::string& word : words) EXPECT_THAT(end.output, HasSubstr(word));
}

// Blocks of hexes or particles, without a tool.
std::string blocks(const std::string& first_fill, const std::string& second_fill, const std::string& second) {
  const auto block = [](const std::string& name, const std::string& fill, const std::string& more) {
    return "[[body]]\nname = \"" + name + "\"\nshape = \"block\"\nfill = \"" + fill +
           "\"\nmaterial = \"steel\"\nsize = [\"40 um\", \"40 um\", \"20 um\"]\nspacing = \"10 um\"\n" + more;
  };
  return slice.substr(0, slice.find("[[body]]")) + block("lower", first_fill, "") +
         block("upper", second_fill, second) + "[run]\nend_time = \"0.2 us\"\n";
}

const std::string above = "origin = [\"0 um\", \"0 um\", \"20 um\"]\n";
const std::string flies =
    "origin = [\"0 um\", \"0 um\", \"25 um\"]\nvelocity = [\"0 m/s\", \"0 m/s\", \"-100 m/s\"]\n";

} // namespace

TEST(Check, has_nothing_against_a_good_scene) {
  expect_words(slice, {"fit to run", "box of \"zone\"", "x 0 to 100, y -20 to 40, z 0 to 40 um",
                       "box of the tool", "box of all its way"});
}

TEST(Check, a_tool_that_never_meets_the_bodies) {
  expect_words(edit(slice, {{"\"1 m/s\"", "\"-1 m/s\""}}),
               {"WARNING: tool and bodies never meet", "tool.position", "velocity"});
  expect_words(edit(slice, {{"\"-25 um\", \"0 um\"", "\"-25 um\", \"45 um\""}}), {"never meet"});
  expect_words(edit(slice, {{"end_time = \"30 us\"", "end_time = \"4 us\""}}),
               {"never meet"}); // 5 um away, 4 um of way
  EXPECT_THAT(check(edit(slice, {{"end_time = \"30 us\"", "end_time = \"6 us\""}})).output,
              Not(HasSubstr("never meet")));
}

TEST(Check, a_tool_narrower_than_the_slice) {
  expect_words(edit(slice, {{"width = \"60 um\"", "width = \"20 um\""}}),
               {"narrower than the periodic slice \"zone\"", "from 10 um to 30 um", "tool.width"});
}

TEST(Check, an_edge_that_leans_in_a_slice_is_refused) {
  expect_words(
      edit(slice, {{"width =", "inclination = \"10 deg\"\nwidth ="}}),
      {"deck.toml:36: tool.inclination: an edge that leans does not go with the periodic slice \"zone\"",
       "\"0 deg\""},
      1);
}

TEST(Check, bodies_that_nothing_holds_or_joins) {
  expect_words(edit(slice, {{"tie = \"bulk\"\n", ""}}),
               {"\"zone\" of line 7 and \"bulk\" of line 18 touch, and nothing joins them", "tie = \"bulk\"",
                "nothing holds body \"zone\""});
  expect_words(edit(slice, {{"y_min = \"fixed\"\n", ""}}),
               {"nothing holds body \"zone\"", "nothing holds body \"bulk\""});
  expect_words(blocks("hexes", "hexes", above),
               {"\"lower\" of line 7 and \"upper\" of line 14 touch, and nothing joins them"});
  EXPECT_THAT(check(blocks("particles", "particles", above)).output, HasSubstr("fit to run"));
}

TEST(Check, bodies_that_do_not_feel_each_other) {
  for (const auto& [first, second] :
       {std::pair("hexes", "hexes"), {"hexes", "particles"}, {"particles", "hexes"}})
    expect_words(blocks(first, second, flies) + "[contact]\nfriction = 0.0\nbetween_bodies = \"none\"\n",
                 {"\"lower\" of line 7 and \"upper\" of line 14 come together and do not feel",
                  "Leave contact.between_bodies"});
  EXPECT_THAT(check(blocks("particles", "particles", flies)).output, HasSubstr("fit to run"));
  EXPECT_THAT(check(edit(blocks("hexes", "hexes", flies), {{"\"-100 m/s\"", "\"100 m/s\""}})).output,
              HasSubstr("fit to run"))
      << "it flies away";
}

// A wall that stands in a block by a hundredth of a spacing: contact begins at the particles' own surfaces.
TEST(Check, an_overlap_of_a_hundredth_of_a_spacing) {
  for (const char* fill : {"particles", "hexes"}) {
    const auto wall_at = [&](const std::string& z) {
      const std::string all = blocks(fill, fill, above);
      return all.substr(0, all.rfind("[[body]]")) +
             "[tool]\nkind = \"wall\"\nnormal = [0.0, 0.0, -1.0]\nsize = \"200 um\"\n" +
             "position = [\"20 um\", \"20 um\", \"" + z +
             "\"]\n[contact]\nfriction = 0.0\n[run]\nend_time = \"0.2 us\"\n";
    };
    expect_words(
        wall_at("19.9 um"),
        {"deck.toml:18: tool.position: the tool overlaps body \"lower\" of line 7 by 0.1 um", "deepest at ("},
        1);
    EXPECT_EQ(check(wall_at("20 um")).status, 0) << "they touch";
  }
}

TEST(Check, numbers_without_end_are_answered_at_once) {
  expect_words(edit(slice, {{"\"30 us\"", "\"1e300 s\""}}),
               {"run.end_time: makes ", "limited by particle", "expected at most 1e+10"}, 1);
  expect_words(edit(slice, {{"\"40 W/m/K\"", "\"4e10 W/m/K\""}}),
               {"deck.toml:6: material.steel.conductivity: 4e+10 W/m/K needs", "steps of conduction"}, 1);
  expect_words(edit(slice, {{"\"200 GPa\"", "\"1e-300 Pa\""}}),
               {"only 1 step(s) to the end", "material.steel.youngs_modulus"});
  expect_words(edit(slice, {{"[\"100 um\", \"60 um\", \"40 um\"]\nspacing = \"10 um\"",
                             "[\"100 um\", \"60 um\", \"40 m\"]\ncells = [10, 6, 4]"}}),
               {"body.cells: \"zone\" makes cells of 1e-05 m by 1e-05 m by 10 m", "units"}, 1);
}

TEST(Check, bodies_that_fit_alone_but_not_together) {
  std::string many = slice.substr(0, slice.find("[[body]]"));
  for (int k = 0; k < 40; ++k)
    many += "[[body]]\nname = \"b" + std::to_string(k) +
            "\"\nshape = \"block\"\nfill = \"hexes\"\nmaterial = \"steel\"\ncells = [1000, 1000, 5]\nsize = "
            "[\"1 mm\", \"1 mm\", "
            "\"5 um\"]\norigin = [\"0 m\", \"0 m\", \"" +
            std::to_string(k) + " mm\"]\n";
  expect_words(many + "[run]\nend_time = \"1 us\"\n", {"2e+08 cells", "GiB (\"b0\" ", "of this machine"}, 1);
}

TEST(Check, gives_advice_that_helps) {
  EXPECT_THAT(check(slice).output, Not(HasSubstr("across the uncut chip: take")))
      << "40 um by 10 um are four";
  expect_words(edit(slice, {{"\"200 GPa\"", "200e9"}}), {"write youngs_modulus = \"200000000000 Pa\""}, 1);
}

TEST(Check, a_size_that_is_a_slip_names_its_key) {
  expect_words(edit(slice, {{"[\"-25 um\", \"0 um\"", "[\"1e200 m\", \"0 um\""}}),
               {"deck.toml:38: tool.position: entry 1: 1e+200 m is farther than the planets"}, 1);
  expect_words(edit(slice, {{"height = \"100 um\"", "height = \"1e-200 m\""}}), {"tool.height: 1e-200 m"}, 1);
  expect_words(edit(slice, {{"\"1 m/s\"", "\"1e200 m/s\""}}),
               {"tool.velocity: entry 1: ", "faster than light"}, 1);
}

TEST(Check, frames_and_pictures_that_never_come) {
  const auto with = [](const std::string& output) { return slice + "[output]\n" + output + "\n"; };
  expect_words(with("frame_time = \"1 s\""), {"WARNING: output.frame_time is 3.33e+04 times the run"});
  expect_words(with("frame_time = \"1e-15 s\""), {"WARNING: output.frame_time: 3e+10 frames"});
  expect_words(with("checkpoint_time = \"1 s\""),
               {"WARNING: output.checkpoint_time is 3.33e+04 times the run"});
  expect_words(with("picture_time = [\"10 us\", \"1 s\"]"),
               {"WARNING: output.picture_time: 1 s lies beyond the end of the run, 3e-05 s"});
  EXPECT_THAT(check(with("picture_time = [\"30 us\"]\nframe_time = \"30 us\"")).output,
              HasSubstr("fit to run"));
}

TEST(Check, constants_that_no_material_has_are_named) {
  expect_words(edit(slice, {{"\"200 GPa\"", "\"200e15 GPa\""}, {"\"30 us\"", "\"1 s\""}}),
               {"deck.toml:4: material.steel.youngs_modulus: E = 2e+26 Pa", "Look at the units"}, 1);
  expect_words(edit(slice, {{"\"7800 kg/m3\"", "\"7.8e-15 kg/m3\""}, {"\"30 us\"", "\"1 s\""}}),
               {"deck.toml:3: material.steel.density: "}, 1);
}

TEST(Check, bodies_that_will_meet_by_contact) {
  for (const auto& [first, second] : {std::pair("hexes", "hexes"), {"hexes", "particles"}})
    expect_words(blocks(first, second, flies) + "[contact]\nfriction = 0.3\n",
                 {"will meet", "come together: contact, with friction 0.3"});
}

TEST(Check, particles_that_will_act_as_one_body) {
  expect_words(blocks("particles", "particles", flies),
               {"act as one body", "come together: from where they meet"});
  expect_words(blocks("particles", "particles", above),
               {"act as one body", "touch: their particles push and pull"});
  const TemporaryFolder folder;
  const Ended run =
      run_program({"run", write_deck(folder, blocks("particles", "particles", flies)), "--output",
                   (folder / "results").string(), "--threads", "1", "--no-pictures", "--stop-after", "1"});
  EXPECT_THAT(run.output, HasSubstr("come together: from where they meet"));
  const Ended hexes =
      run_program({"run", write_deck(folder, blocks("hexes", "hexes", above)), "--output",
                   (folder / "hexes").string(), "--threads", "1", "--no-pictures", "--stop-after", "1"});
  EXPECT_THAT(hexes.output,
              HasSubstr("warning: bodies \"lower\" of line 7 and \"upper\" of line 14 touch, and nothing"));
}

// Three million particles: worked out, not built.
TEST(Check, a_large_deck_is_answered_at_once) {
  expect_words(edit(slice, {{"spacing = \"10 um\"", "spacing = \"0.42 um\""}}),
               {"cells of all bodies", "time step                          about",
                "predicted run time                 about", "box of all its way",
                "too many to build and look at here"});
}

// A sharp wedge of high rake, whose edge goes between nodes that are 20 um apart.
TEST(Check, a_tool_that_goes_in_between_the_nodes) {
  const std::string hexes = edit(slice, {{"fill = \"particles\"", "fill = \"hexes\""},
                                         {"spacing = \"10 um\"\ntie = \"bulk\"", "spacing = \"20 um\""},
                                         {"rake = \"10 deg\"", "rake = \"60 deg\""},
                                         {"edge_radius = \"20 um\"", "edge_radius = \"1 um\""},
                                         {"\"-25 um\", \"0 um\"", "\"-25 um\", \"8 um\""},
                                         {"\"30 us\"", "\"60 us\""}});
  expect_words(hexes, {"into the hexes between their nodes", "until then it is not felt"});
}

TEST(Check, draws_the_scene) {
  const TemporaryFolder folder;
  const std::string png = (folder / "scene.png").string();
  const Ended end = run_program({"check", write_deck(folder, slice), "--threads", "1", "--picture", png});
  if (end.status != 0) GTEST_SKIP() << end.output; // no display
  EXPECT_GT(std::filesystem::file_size(png), 20000u);
}
