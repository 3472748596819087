// Files of bodies: found beside the deck, kept with the results, and read no more once these have moved.
#include "src/deck/deck.hpp"
#include "src/geometry/facet_surface.hpp"
#include "tests/src/stl_bodies.hpp"
#include "tests/support/run_program.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

const std::string material = R"([material.steel]
law = "elastic"
density = "7800 kg/m3"
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
)";

std::string body_of(const std::string& name, const std::string& shape, const std::string& more) {
  return "[[body]]\nname = \"" + name + "\"\nshape = \"" + shape + "\"\nmaterial = \"steel\"\n" + more;
}

// A ball that flies at a wall, a plate of hexes and one of particles beside it, each from a file.
const std::string three_files =
    material +
    body_of("ball", "stl",
            "fill = \"particles\"\nfile = \"ball.stl\"\nspacing = \"4 um\"\norigin = [\"0 um\", \"0 um\", "
            "\"21 um\"]\n"
            "velocity = [\"0 m/s\", \"0 m/s\", \"-100 m/s\"]\n") +
    body_of("plate", "mesh",
            "fill = \"hexes\"\nfile = \"plate.inp\"\nfile_scale = \"1 um\"\norigin = [\"60 um\", \"0 um\", "
            "\"5 um\"]\n"
            "[body.faces]\n\"left side\" = \"fixed\"\n") +
    body_of(
        "dust", "mesh",
        "fill = \"particles\"\nfile = \"dust.csv\"\nfile_scale = \"1 um\"\norigin = [\"-60 um\", \"0 um\", "
        "\"5 um\"]\n") +
    R"([tool]
kind = "wall"
size = "200 um"
[contact]
friction = 0.0
[run]
end_time = "20 ns"
)";

const std::string plate =
    "*NODE\n1, 0, 0, 0\n2, 9, 0, 0\n3, 9, 9, 0\n4, 0, 9, 0\n5, 0, 0, 9\n6, 9, 0, 9\n7, 9, 9, 9\n"
    "8, 0, 9, 9\n*ELEMENT, TYPE=C3D8R, ELSET=ALL\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
    "*NSET, NSET=\"LEFT SIDE\"\n1, 4, 5, 8\n";

class BodyFiles : public testing::Test {
 protected:
  TemporaryFolder folder;
  fs::path results = folder / "results";
  std::string deck = folder.write("deck.toml", three_files);
  BodyFiles() {
    write_stl(make_sphere(0.02, 3), (folder / "ball.stl").string()); // mm
    folder.write("plate.inp", plate);
    folder.write("dust.csv", "0, 0, 0, 64\n4, 0, 0, 64\n0, 4, 0, 64\n0, 0, 4, 64\n");
  }
  Ended run(const fs::path& into, const std::vector<std::string>& more = {}, const std::string& other = "") {
    std::vector<std::string> all{
        "run", other.empty() ? deck : other, "--output", into.string(), "--threads", "1", "--no-pictures"};
    all.insert(all.end(), more.begin(), more.end());
    return run_program(all);
  }
};

} // namespace

TEST_F(BodyFiles, go_on_plot_and_render_without_the_originals) {
  const Ended whole = run(folder / "whole");
  ASSERT_EQ(whole.status, 0) << whole.output;
  const Ended part = run(results, {"--stop-after", "5"});
  ASSERT_EQ(part.status, 0) << part.output;
  EXPECT_EQ(read_bytes(results / "body_1.stl"), read_bytes(folder / "ball.stl")) << "to the last byte";
  EXPECT_EQ(read_bytes(results / "body_2.mesh"), plate);
  fs::create_directories(folder / "elsewhere");
  fs::rename(results, folder / "elsewhere/moved");
  for (const char* file : {"ball.stl", "plate.inp", "dust.csv"}) fs::remove(folder / file);
  const fs::path moved = folder / "elsewhere/moved";
  EXPECT_EQ(run_program({"plot", moved.string()}).status, 0);
  const Ended rest = run(moved, {"--resume"});
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_EQ(read_bytes(moved / "history.csv"), read_bytes(folder / "whole/history.csv"));
  const Ended own = run(moved, {"--resume"}, (moved / "deck.toml").string());
  EXPECT_EQ(own.status, 0) << "with its own deck\n" << own.output;
  const Ended drawn = run_program({"render", moved.string()});
  EXPECT_EQ(drawn.status, 0) << drawn.output;
  EXPECT_TRUE(fs::exists(moved / "pictures/chip.png"));
}

TEST_F(BodyFiles, another_file_is_another_deck) {
  ASSERT_EQ(run(results, {"--stop-after", "5"}).status, 0);
  write_stl(make_sphere(0.0199, 3), (folder / "ball.stl").string());
  const Ended rest = run(results, {"--resume"});
  EXPECT_EQ(rest.status, 1);
  EXPECT_THAT(rest.output, AllOf(HasSubstr("belongs to another deck"), HasSubstr("the file of body 1"),
                                 HasSubstr("512 facets with the checksum")));
}

TEST_F(BodyFiles, are_never_written_over) {
  fs::rename(folder / "ball.stl", folder / "body_1.stl");
  std::string text = three_files;
  text.replace(text.find("ball.stl"), 8, "body_1.stl");
  const std::string before = read_bytes(folder / "body_1.stl");
  const Ended end = run(folder.path, {"--overwrite"}, folder.write("t.toml", text));
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.output, HasSubstr("body_1.stl: the results would be written over this file"));
  EXPECT_EQ(read_bytes(folder / "body_1.stl"), before);
}

TEST_F(BodyFiles, check_says_box_and_volume) {
  const Ended end = run_program({"check", deck, "--threads", "1"});
  EXPECT_EQ(end.status, 0) << end.output;
  EXPECT_THAT(end.output,
              AllOf(HasSubstr("box of \"ball\""), HasSubstr("z 1 to 41 um"), HasSubstr("volume of \"ball\""),
                    HasSubstr("scaled to that of the surface from"), HasSubstr("729 um3 in 1 hexes"),
                    HasSubstr("256 um3 in 4 particles")));
}

TEST_F(BodyFiles, the_resolved_deck_says_the_same) {
  const Deck first = read_deck(deck);
  EXPECT_EQ(first.bodies[0].file, (folder / "ball.stl").string());
  EXPECT_EQ(first.bodies[0].file_scale, 1e-3);
  Deck second = read_deck(folder.write("again.toml", resolved_deck(first)));
  second.file = first.file;
  for (std::size_t b = 0; b < 3; ++b) second.bodies[b].line = first.bodies[b].line;
  EXPECT_TRUE(second == first) << resolved_deck(second);
}

TEST_F(BodyFiles, mistakes_in_the_deck_are_named) {
  const auto fault = [&](const std::string& from, const std::string& to) {
    std::string text = three_files;
    text.replace(text.find(from), from.size(), to);
    return message_of<DeckError>([&] { read_deck(folder.write("faulty.toml", text)); });
  };
  EXPECT_THAT(
      fault("\"ball.stl\"", "\"bull.stl\""),
      AllOf(HasSubstr("faulty.toml:11: body.file: there is no file"), HasSubstr("relative to the deck")));
  EXPECT_THAT(fault("spacing = \"4 um\"\n", ""), HasSubstr("body.spacing: is missing. Give spacing"));
  EXPECT_THAT(fault("spacing = \"4 um\"\n", "cells = [9, 9, 9]\n"),
              HasSubstr("does not apply to shape = \"stl\""));
  EXPECT_THAT(fault("file_scale = \"1 um\"\n", ""), HasSubstr("body.file_scale: is missing"));
  EXPECT_THAT(fault("file_scale = \"1 um\"\n", "file_scale = \"1 um\"\nspacing = \"1 um\"\n"),
              HasSubstr("does not apply to shape = \"mesh\""));
  EXPECT_THAT(fault("side\" = \"fixed\"", "side\" = \"symmetric\""),
              HasSubstr("need not be plane, so it is not symmetric"));
  EXPECT_THAT(fault("velocity = [\"0 m/s\", \"0 m/s\", \"-100 m/s\"]\n", "[body.faces]\ntop = \"fixed\"\n"),
              AllOf(HasSubstr("body.faces.top: this stl has no such face"), HasSubstr("x_min, x_max")));
}
