#include "case/kinds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "case/write.hpp"
#include "command.hpp"
#include "exchange/periodic.hpp"
#include "faults_of.hpp"
#include "io/archive.hpp"
#include "io/csv.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "interaction/contact.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"
#include "simulation/health.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

/// A short channel of small cells, to which kinds are added.
std::string channel(const std::string& cells, const std::string& kinds) {
    return fmt::format(R"(format = 1
[domain]
length = "40 um"
width = "16 um"
[flow]
drive = "pressure"
pseudo_shear_rate = "100 /s"
[cells]
{}
[membrane]
shear_modulus = "6 uN/m"
[numerics]
dx = "0.4 um"
[time]
end = "4 ms"
[output]
series = "1 ms"
frames = "2 ms"
{})",
                       cells, kinds);
}

const std::string at_random = "layout = \"random\"\nhematocrit = \"30 %\"\nradius = \"2.2 um\"\n";
const std::string same_twice =
    "[[kind]]\nname = \"one\"\nshare = \"50 %\"\n[[kind]]\nname = \"other\"\nshare = 0.5\n";

void run_to(const Model& model, State& state, std::int64_t until, int threads = 1) {
    Model with = model;
    with.threads = threads;
    Periodic exchange;
    Health health({}, state);
    run_steps(with, state, exchange, health, until, Clock::time_point::max());
}

State after(const std::string& text, std::int64_t steps, int threads = 1) {
    const Case c = parse_case(text, "case.toml");
    const Model model = discretise(c);
    State state = initial_state(c, model, {});
    run_to(model, state, steps, threads);
    return state;
}

TEST(Kinds, two_of_the_same_values_give_the_bits_of_one) {
    const std::string rows = "layout = \"paper\"\ncount = 6\nradius = \"2.2 um\"\n";
    for (const std::string& cells : {at_random, rows}) {
        const State one = after(channel(cells, ""), 60);
        const State two = after(channel(cells, same_twice), 60);
        EXPECT_EQ(state_hash(one), state_hash(two)) << cells;
        EXPECT_EQ(std::count(two.cells.kind.begin(), two.cells.kind.end(), 1),
                  two.cells.cell_count() / 2);
    }
}

/// A stiff thick kind, a drop of thin fluid, a small rigid body, and the usual cell.
const std::string four = R"(
[[kind]]
name = "red"
share = "40 %"
[[kind]]
name = "stiff"
share = "20 %"
shear_modulus = "60 uN/m"
cytoplasm_viscosity = "12 cP"
[[kind]]
name = "drop"
share = "20 %"
law = "surface-tension"
shear_modulus = "10 uN/m"
cytoplasm_viscosity = "0.9 cP"
[kind.hardening]
apply_to = []
[[kind]]
name = "platelet"
share = "20 %"
rigid = true
shape = "ellipse"
aspect_ratio = 2
radius = "1.7 um"
[[contact.pair]]
kinds = ["red", "platelet"]
energy = "0 J/m^2"
)";

TEST(Kinds, of_all_sorts_run_to_the_same_bits_on_any_threads_and_after_any_stop) {
    const std::string text = channel(at_random, four);
    const Case c = parse_case(text, "case.toml");
    const Model model = discretise(c);
    ASSERT_EQ(model.kinds.size(), 4u);
    State straight = initial_state(c, model, {});
    run_to(model, straight, 120, 1);
    State threads = initial_state(c, model, {});
    run_to(model, threads, 120, 3);
    EXPECT_EQ(state_hash(straight), state_hash(threads));
}

class KindsRun : public TemporaryDirectory {};

TEST_F(KindsRun, are_saved_with_the_state_and_a_kind_that_is_not_there_is_refused) {
    const Case c = parse_case(channel(at_random, four), "case.toml");
    Model model = discretise(c);
    State straight = initial_state(c, model, {}), stopped = initial_state(c, model, {});
    run_to(model, straight, 101);
    run_to(model, stopped, 50);
    ArchiveWriter archive(path("state"));
    save_state(archive, stopped);
    archive.commit();
    Periodic exchange;
    State loaded = load_state(ArchiveReader(path("state")), model, exchange);
    EXPECT_EQ(loaded.cells.kind, stopped.cells.kind);
    run_to(model, loaded, 101);
    EXPECT_EQ(state_hash(loaded), state_hash(straight));
    model.kinds.resize(3);
    EXPECT_THROW(load_state(ArchiveReader(path("state")), model, exchange), DamagedArchive);
}

TEST(Kinds, share_the_hematocrit_that_is_asked_for) {
    const Case c = parse_case(channel(at_random, four), "case.toml");
    const Model model = discretise(c);
    const State state = initial_state(c, model, {});
    const double area =
        std::accumulate(state.cells.reference_area.begin(), state.cells.reference_area.end(), 0.0);
    EXPECT_NEAR(area / model.open_area(), 0.30, 0.01);
    const auto count = [&](int kind) {
        return std::count(state.cells.kind.begin(), state.cells.kind.end(), kind);
    };
    const double all = state.cells.cell_count();
    EXPECT_NEAR(static_cast<double>(count(0)) / all, 0.4, 0.05);
    for (const int kind : {1, 2, 3}) EXPECT_NEAR(static_cast<double>(count(kind)) / all, 0.2, 0.05);
    EXPECT_TRUE(find_overlaps(model.lattice, state.cells).empty());
}

TEST(Kinds, with_a_count_leave_the_rest_to_those_with_a_share) {
    Case c = parse_case(channel(at_random, same_twice), "case.toml");
    c.kinds[0].share.reset();
    c.kinds[0].count = 2;
    c.kinds[1].share = 1.0;
    EXPECT_EQ(cells_of_kinds(c, {10.0, 5.0}, 200.0), (std::vector<int>{2, 8}));  // 60 = 20 + 8 · 5
    c.kinds.push_back(c.kinds[1]);
    c.kinds[1].share = 0.75;
    c.kinds[2].share = 0.25;
    EXPECT_EQ(cells_of_kinds(c, {10.0, 5.0, 5.0}, 200.0), (std::vector<int>{2, 6, 2}));
    c.cells.hematocrit.reset();
    c.cells.count = 11;
    EXPECT_EQ(cells_of_kinds(c, {10.0, 5.0, 5.0}, 200.0), (std::vector<int>{2, 7, 2}));
    c.cells.count = 3;
    EXPECT_THAT(faults_of([&] {
                    cells_of_kinds(c, {10.0, 5.0, 5.0}, 200.0);
                }),
                testing::HasSubstr("has no cell"));
}

TEST(Kinds, lie_where_their_positions_are) {
    const std::string kinds = R"([[kind]]
name = "small"
radius = "1.8 um"
positions = [["10 um", "4 um"], ["30 um", "4 um"]]
[[kind]]
name = "large"
radius = "3 um"
positions = [["20 um", "8 um"]]
)";
    const State state = after(channel("layout = \"explicit\"\n", kinds), 0);
    EXPECT_EQ(state.cells.kind, (std::vector<std::int32_t>{0, 0, 1}));
    EXPECT_NEAR(area_moments(outline(state.cells, 2)).centroid.x, 50.0, 0.05);
    EXPECT_NEAR(state.cells.reference_area[2] / state.cells.reference_area[0],
                std::pow(3.0 / 1.8, 2), 0.05);
}

TEST(Kinds, have_what_cells_and_membrane_say_unless_they_say_otherwise) {
    const Case c = parse_case(channel(at_random, four), "case.toml",
                              {"kind.stiff.shear_modulus=30 uN/m", "cells.radius=2.1 um"});
    EXPECT_DOUBLE_EQ(c.kinds[1].shear_modulus.si, 30e-6);
    EXPECT_DOUBLE_EQ(c.kinds[1].radius.si, 2.1e-6);
    EXPECT_DOUBLE_EQ(c.kinds[3].radius.si, 1.7e-6);
    EXPECT_DOUBLE_EQ(c.kinds[0].shear_modulus.si, 6e-6);
    EXPECT_TRUE(c.kinds[2].hardening.apply_to.empty());
    EXPECT_EQ(parse_case(to_toml(c), "again.toml"), c);
}

TEST(Kinds, that_are_rigid_are_not_pressed_into_a_dense_start) {
    const std::string dense = "layout = \"random\"\nhematocrit = \"75 %\"\nradius = \"2.2 um\"\n";
    const std::string bead = same_twice + "rigid = true\n";
    const Case c = parse_case(channel(dense, bead), "case.toml");
    try {
        initial_state(c, discretise(c), {});
        FAIL() << "taken";
    } catch (const CaseError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("those of kind 'other' keep their shape"));
    }
    const Case soft = parse_case(channel(dense, same_twice), "case.toml");
    EXPECT_NO_THROW(initial_state(soft, discretise(soft), {}));
}

TEST(Kinds, that_do_not_exist_cannot_be_set) {
    const auto set = [](const char* item) {
        return faults_of([&] { parse_case(channel(at_random, four), "case.toml", {item}); });
    };
    EXPECT_THAT(set("kind.blue.radius=2 um"), testing::HasSubstr("there is no [[kind]] 'blue'"));
    EXPECT_THAT(set("kind.stiff=2 um"), testing::HasSubstr("there is no [[kind]] 'stiff'"));
}

TEST(Kinds, feel_each_other_as_their_pair_says) {
    const Case c = parse_case(channel(at_random, four), "case.toml");
    const ContactModel contact = discretise(c).contact;
    ASSERT_EQ(contact.pairs.size(), 16u);
    EXPECT_EQ(contact.pairs[0 * 4 + 3].energy, 0.0);
    EXPECT_EQ(contact.pairs[3 * 4 + 0].energy, 0.0);
    EXPECT_GT(contact.pairs[0 * 4 + 1].energy, 0.0);
    EXPECT_FALSE(contact.pairs[2 * 4 + 0].scale_repulsion) << "a drop does not harden";
    EXPECT_TRUE(contact.pairs[0 * 4 + 2].scale_repulsion);
    const Case alike = parse_case(channel(at_random, same_twice), "case.toml");
    EXPECT_TRUE(discretise(alike).contact.pairs.empty());
}

/// Forces between two cells beside each other, of the kinds given.
Vec2 force_between(const ContactModel& contact, int left, int right) {
    const Lattice lattice{64, 40, true};
    Suspension cells;
    add_cell(cells, placed(circle(8.0, 50), 0.0, {20.0, 20.0}), left);
    add_cell(cells, placed(circle(8.0, 50), 0.0, {36.8, 20.0}), right);
    ContactState state;
    add_pair_forces(contact, lattice, 0, cells, state);
    Vec2 sum, all;
    for (int n = 0; n < cells.node_count(); ++n) {
        all += cells.force(n);
        if (n < cells.first[1]) sum += cells.force(n);
    }
    EXPECT_NEAR(norm(all), 0.0, 1e-15);
    return sum;
}

TEST(Kinds, of_a_pair_push_with_their_own_law_and_as_hard_back) {
    ContactModel contact;
    const Morse weak{1e-4, 0.8, 2.0, false}, strong{5e-4, 0.8, 2.0, false},
        none{0.0, 0.8, 2.0, false};
    contact.law = weak;
    contact.range = 6.0;
    contact.kinds = 2;
    contact.pairs = {weak, strong, strong, none};
    const double plain = force_between(contact, 0, 0).x;
    EXPECT_LT(plain, 0.0) << "pushed apart";
    EXPECT_NEAR(force_between(contact, 0, 1).x, 5.0 * plain, 1e-12 * std::abs(plain));
    EXPECT_NEAR(force_between(contact, 1, 0).x, 5.0 * plain, 1e-12 * std::abs(plain));
    EXPECT_EQ(force_between(contact, 1, 1).x, 0.0);
}

TEST_F(KindsRun, are_told_of_in_every_result) {
    replace_file(path("case.toml"), channel(at_random, four), Durability::process);
    const std::string out = (path("run")).string();
    ASSERT_EQ(run({"run", path("case.toml").string(), "-o", out, "-j", "1"}).code, 0);
    const Table cells = read_csv(path("run") / "cells.csv");
    const Json summary = Json::parse(read_file(path("run") / "summary.json"));
    ASSERT_TRUE(summary.contains("kinds"));
    double total = 0.0;
    for (const char* name : {"red", "stiff", "drop", "platelet"}) {
        const Json& kind = summary["kinds"][name];
        total += kind["cells"]["value"].get<double>();
        EXPECT_TRUE(kind["lambda_C"]["value"].is_number()) << name;
    }
    EXPECT_EQ(total,
              1.0 + *std::max_element(cells.column("cell").begin(), cells.column("cell").end()));
    EXPECT_LT(summary["kinds"]["stiff"]["strain"]["value"].get<double>(),
              0.5 * summary["kinds"]["red"]["strain"]["value"].get<double>())
        << "a stiff membrane stretches less";
    EXPECT_EQ(*std::max_element(cells.column("kind").begin(), cells.column("kind").end()), 3.0);
    const Outcome reported = run({"report", out});
    ASSERT_EQ(reported.code, 0);
    const std::string page = read_file(reported.out.substr(0, reported.out.find('\n')));
    EXPECT_NE(page.find(" of 4 kinds (red, stiff, drop, platelet): hematocrit"), std::string::npos);
    EXPECT_NE(page.find("\"kinds\":[\"red\",\"stiff\",\"drop\",\"platelet\"]"), std::string::npos);
    const Outcome checked = run({"check", path("case.toml").string()});
    EXPECT_THAT(checked.out, testing::HasSubstr("kind platelet"));
    EXPECT_THAT(checked.out, testing::HasSubstr("of kind 'platelet' are few"));
}

}  // namespace
}  // namespace tt
