// Units against their definitions in the SI brochure (BIPM 2019): exact decimal prefixes, min = 60 s, 0 degC
// = 273.15 K.
#include "src/units/units.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace swarf;

namespace {

double si(const std::string& text, Dimension dimension) {
  const auto parsed = parse_quantity(text, dimension);
  if (const auto* error = std::get_if<UnitError>(&parsed)) {
    ADD_FAILURE() << text << ": " << error->message;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::get<double>(parsed);
}

std::string fault(const std::string& text, Dimension dimension) {
  const auto parsed = parse_quantity(text, dimension);
  const auto* error = std::get_if<UnitError>(&parsed);
  return error ? error->message : "";
}

} // namespace

TEST(units, decimal_prefixes_are_exact) {
  EXPECT_EQ(si("10 um", Dimension::length), 10e-6); // 10 * 1e-6 is another double
  EXPECT_EQ(si("2.5um", Dimension::length), 2.5e-6);
  EXPECT_EQ(si("36.3 µm", Dimension::length), 36.3e-6);
  EXPECT_EQ(si("-1.5e3 nm", Dimension::length), -1.5e-6);
  EXPECT_EQ(si("+2 cm", Dimension::length), 0.02);
  EXPECT_EQ(si("110 GPa", Dimension::pressure), 110e9);
  EXPECT_EQ(si("862 N/mm2", Dimension::pressure), 862e6);
  EXPECT_EQ(si("4430 kg/m3", Dimension::density), 4430.0);
  EXPECT_EQ(si("4.43 g/cm^3", Dimension::density), 4430.0);
  EXPECT_EQ(si("526.3 J/kg/K", Dimension::specific_heat), 526.3);
  EXPECT_EQ(si("6.3 W/m/K", Dimension::conductivity), 6.3);
  EXPECT_EQ(si("1 1/s", Dimension::rate), 1.0);
  EXPECT_EQ(si("20 kHz", Dimension::rate), 20e3);
  EXPECT_EQ(si("9.81 m/s2", Dimension::acceleration), 9.81);
  EXPECT_EQ(si("10.1 N", Dimension::force), 10.1);
}

TEST(units, minutes_turns_and_celsius_follow_their_definitions) {
  constexpr double pi = std::numbers::pi;
  EXPECT_EQ(si("30 m/min", Dimension::velocity), 0.5);
  EXPECT_DOUBLE_EQ(si("25.2 deg", Dimension::angle), 25.2 * pi / 180);
  EXPECT_EQ(si("360 deg", Dimension::angle), 2 * pi);
  EXPECT_DOUBLE_EQ(si("10000 rpm", Dimension::angular_velocity), 10000 * 2 * pi / 60);
  EXPECT_DOUBLE_EQ(si("10000 rev/min", Dimension::angular_velocity), 10000 * 2 * pi / 60);
  EXPECT_DOUBLE_EQ(si("25 degC", Dimension::temperature), 298.15);
  EXPECT_EQ(si("298.15 K", Dimension::temperature), 298.15);
  EXPECT_EQ(si("3 %", Dimension::percentage), 3.0);
  EXPECT_EQ(si("2.5%", Dimension::percentage), 2.5);
}

TEST(units, what_is_written_reads_back_bit_by_bit) {
  for (double x :
       {0.1, 1e-5, 298.15, 4430.0, -0.0, 1.0 / 3, 6.283185307179586, 5e-324, 1.7976931348623157e308})
    for (Dimension d : {Dimension::length, Dimension::density, Dimension::angle, Dimension::specific_heat}) {
      const double back = si(format_quantity(x, d), d);
      EXPECT_EQ(std::signbit(back), std::signbit(x));
      EXPECT_EQ(back, x) << format_quantity(x, d);
    }
}

TEST(units, a_wrong_unit_is_named) {
  EXPECT_NE(fault("2.5", Dimension::length).find("has no unit"), std::string::npos);
  EXPECT_NE(fault("2.5 s", Dimension::length).find("which is a time"), std::string::npos);
  EXPECT_NE(fault("2.5 furlong", Dimension::length).find("no unit \"furlong\""), std::string::npos);
  EXPECT_NE(fault("um", Dimension::length).find("does not begin with a number"), std::string::npos);
  EXPECT_NE(fault("nan um", Dimension::length).find("not a finite number"), std::string::npos);
  EXPECT_NE(fault("1e999 um", Dimension::length).find("out of the range"), std::string::npos);
  EXPECT_NE(fault("1e308 km", Dimension::length).find("out of the range"), std::string::npos);
  EXPECT_NE(fault("25 C", Dimension::temperature).find("write degC"), std::string::npos);
  EXPECT_NE(fault("3 %", Dimension::length).find("\"%\" is not a unit of this"), std::string::npos);
  EXPECT_NE(fault("3 um/um", Dimension::percentage).find("not a unit of this"), std::string::npos);
  EXPECT_NE(fault("1 rad/s", Dimension::rate).find("speed of rotation"), std::string::npos);
  EXPECT_NE(fault("1 m/", Dimension::length).find("no unit \"m/\""), std::string::npos);
}
