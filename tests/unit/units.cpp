#include "base/units.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using tt::Dimension;
using tt::parse_measure;
using tt::to_text;

double si(const char* text) { return parse_measure(text).si; }

std::string complaint(const char* text) {
    try {
        parse_measure(text);
    } catch (const tt::UnitError& error) {
        return error.what();
    }
    return "none";
}

TEST(Units, same_length_same_bits) {
    for (const char* text :
         {"0.08 mm", "8e-5 m", "80000 nm", "8.0e1um", "+80 um", "0.008 cm", " 80   um "})
        EXPECT_EQ(si(text), si("80 um")) << text;
    EXPECT_EQ(si("80 um"), 8e-5);
    EXPECT_EQ(si("1.2 cP"), 1.2e-3);
    EXPECT_EQ(si("1.2 mPa s"), si("0.012 P"));
    EXPECT_EQ(si("6e-3 dyn/cm"), 6e-6);
    EXPECT_EQ(si("6 uN/m"), 6e-6);
    EXPECT_EQ(si("1.8e-12 dyn cm"), 1.8e-19);
    EXPECT_EQ(si("1.8e-19 N m"), si("1.8e-19 J"));
    EXPECT_EQ(si("5 min"), 300.0);
    EXPECT_EQ(si("0.1 h"), 360.0);
    EXPECT_EQ(si("1 mmHg"), 133.322387415);
    EXPECT_EQ(si("10 mmH2O"), 98.0665);
    EXPECT_EQ(si("1 cmH2O"), si("10 mmH2O"));
    EXPECT_EQ(si("1 eV"), 1.602176634e-19);
    EXPECT_EQ(si("1 kT"), 4.2800119e-21);  // 1.380649e-23 J/K at 310 K
    EXPECT_EQ(si("50 kBT"), si("50 kT"));
    EXPECT_EQ(si("200 zJ"), 2e-19);
    EXPECT_EQ(si("0.2 aJ"), 2e-19);
    EXPECT_EQ(si("1.2 mPa.s"), si("1.2 cP"));
    EXPECT_EQ(si("0.1 L"), si("1 dL"));
}

TEST(Units, products_quotients_and_powers_have_their_dimension) {
    EXPECT_EQ(parse_measure("500 /s").dimension, (Dimension{0, 0, -1}));
    EXPECT_EQ(parse_measure("500 1/s").dimension, (Dimension{0, 0, -1}));
    EXPECT_EQ(parse_measure("500 s^-1").dimension, (Dimension{0, 0, -1}));
    EXPECT_EQ(parse_measure("500 s-1").dimension, (Dimension{0, 0, -1}));
    EXPECT_EQ(parse_measure("6 kg.m.s-2").dimension, (Dimension{1, 1, -2}));
    EXPECT_EQ(parse_measure("1 kg m-1 s-1").dimension, (Dimension{1, -1, -1}));
    EXPECT_EQ(parse_measure("3 mmH2O/m").dimension, (Dimension{1, -2, -2}));
    EXPECT_EQ(parse_measure("1025 kg/m^3").dimension, (Dimension{1, -3, 0}));
    EXPECT_EQ(parse_measure("1025 kg/m3").dimension, (Dimension{1, -3, 0}));
    EXPECT_EQ(parse_measure("1 kg/(m s)").dimension, (Dimension{1, -1, -1}));
    EXPECT_EQ(parse_measure("1 kg/m/s").dimension, (Dimension{1, -1, -1}));
    EXPECT_EQ(parse_measure("1 Pa*s").dimension, (Dimension{1, -1, -1}));
    EXPECT_EQ(parse_measure("1 Pa/m").dimension, (Dimension{1, -2, -2}));
    EXPECT_EQ(parse_measure("1.3e-7 uJ/um^2").dimension, tt::SurfaceEnergy::dimension);
    EXPECT_EQ(si("1.3e-7 uJ/um^2"), 0.13);
    EXPECT_EQ(si("1.3e-7 J/m^2"), 1.3e-7);
    EXPECT_EQ(si("3.84 /um"), 3.84e6);
    EXPECT_EQ(si("38 %"), 0.38);
    EXPECT_EQ(parse_measure("0.2").dimension, Dimension{});
    EXPECT_EQ(parse_measure("90 deg").dimension, tt::Angle::dimension);
}

TEST(Units, what_is_wrong_is_told) {
    EXPECT_EQ(complaint("4 micron"), "unknown unit 'micron'; write 'um'");
    EXPECT_EQ(complaint("4 Um"), "unknown unit 'Um'; did you mean 'um'?");
    EXPECT_EQ(complaint("1 mpa s"), "unknown unit 'mpa'; did you mean 'mPa'?");
    EXPECT_EQ(complaint("0,2 um"), "has a decimal comma; write a point");
    EXPECT_EQ(complaint("um"), "does not start with a number");
    EXPECT_EQ(complaint("nan um"), "does not start with a number");
    EXPECT_EQ(complaint("0x10 um"), "unknown unit 'x'");
    EXPECT_EQ(complaint("1 kg/m s"),
              "what stands under '/' is ambiguous; write brackets, as in kg/(m s)");
    EXPECT_EQ(complaint("1 kg/(m s"), "a bracket is not closed");
    EXPECT_EQ(complaint("1 m^"), "a power in a unit is a whole number from -6 to 6, as in m^3");
    EXPECT_EQ(complaint("1 m-7"), "a power in a unit is a whole number from -6 to 6, as in m^3");
    EXPECT_EQ(complaint("1 m-"), "'-' is not expected in a unit");
    EXPECT_EQ(complaint("1 .s"), "'.' is not expected in a unit");
    EXPECT_EQ(complaint("1 Pa\u00b7s"), "'\u00b7' is not expected in a unit; write a space or '*'");
    EXPECT_EQ(complaint("90\u00b0"), "'\u00b0' is not expected in a unit; write ' deg'");
    EXPECT_EQ(complaint("1 g/ml"), "unknown unit 'ml'; write 'mL'");
    EXPECT_EQ(complaint("1 \xb7s"), "'?' is not expected in a unit");
    EXPECT_EQ(complaint("50 k_BT"), "unknown unit 'k_BT'; write 'kT'");
    EXPECT_EQ(complaint("1 m/"), "a unit is missing at the end");
    EXPECT_EQ(complaint("1 um)"), "')' is not expected in a unit");
    EXPECT_EQ(complaint("1e999 um"), "the number is too large or too small");
    EXPECT_EQ(complaint("1e99999999999999999999 um"), "the number is too large or too small");
    EXPECT_EQ(complaint("1e-400 um"), "the number is too large or too small");
    EXPECT_EQ(complaint("1 mmHg^6"), "a unit this large or small has no use here");
    EXPECT_EQ(complaint("1 ((((((m))))))"), "too many brackets in a unit");
}

TEST(Units, a_number_is_written_as_people_write_it) {
    EXPECT_EQ(to_text(tt::Length{2e-7}), "0.2 um");
    EXPECT_EQ(to_text(tt::Length{8e-5}), "80 um");
    EXPECT_EQ(to_text(tt::Length{0.16e-3}), "160 um");
    EXPECT_EQ(to_text(tt::Length{5e-9}), "5 nm");
    EXPECT_EQ(to_text(tt::Viscosity{1.2e-3}), "1.2 cP");
    EXPECT_EQ(to_text(tt::Rate{500.0}), "500 /s");
    EXPECT_EQ(to_text(tt::BendingModulus{1.8e-19}), "1.8e-19 J");
    EXPECT_EQ(to_text(tt::Tension{6e-6}), "6 uN/m");
    EXPECT_EQ(to_text(300.0, "min"), "5 min");
    EXPECT_EQ(to_text(1.8e-19, "dyn cm"), "1.8e-12 dyn cm");
    EXPECT_EQ(to_text(0.0, "um"), "0 um");
    EXPECT_EQ(to_text(-0.00025), "-0.00025");
    EXPECT_EQ(to_text(1234567.0), "1234567");
    EXPECT_EQ(to_text(3.0, Dimension{1, 2, 3}), "3 kg m^2 s^3");
}

TEST(Units, what_is_written_reads_back_to_the_same_bits) {
    double value = 3.0;
    for (int i = 0; i < 1000; ++i) {
        value = value * 1.0137 + 1e-3 / (i + 7.0);
        for (const char* unit :
             {"um", "ms", "min", "h", "deg", "dyn/cm", "%", "mmHg", "/um", "kg/m^3"}) {
            const std::string text = to_text(value, unit);
            EXPECT_EQ(parse_measure(text).si, value) << text;
        }
        EXPECT_EQ(parse_measure(to_text(value, Dimension{2, -1, 1})).si, value);
    }
}

}  // namespace
