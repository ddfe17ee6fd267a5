// Every case that comes with the program, at the product's defaults, some hundred steps: its
// numbers and the hash of its state are those of tests/regression/<scene>/numbers.toml. A change
// that moves one says so: `test_regression --update` writes them anew, and the diff shows by how
// much.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "io/file.hpp"
#include "io/toml.hpp"
#include "observe/cell_measures.hpp"
#include "observe/run_measures.hpp"
#include "simulation/advance.hpp"
#include "simulation/state_archive.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

bool update = false;

/// What a numbers.toml says: a case, what --set changes of it, and the numbers after so many steps.
struct Scene {
    std::string name;
    std::string case_name;
    std::vector<std::string> changes;
    std::int64_t steps = 0;
    TomlNode pinned;
};

fs::path file_of(const std::string& scene) {
    return fs::path(TT_SOURCE_DIR) / "tests/regression" / scene / "numbers.toml";
}

Scene read_scene(const std::string& name) {
    const TomlText toml = parse_toml(read_file(file_of(name)), name);
    if (!toml.faults.empty()) throw std::runtime_error(name + ": " + toml.faults.front().message);
    Scene scene;
    scene.name = name;
    scene.case_name = toml.root.find("case")->value.text;
    scene.steps = toml.root.find("steps")->value.integer;
    if (const TomlEntry* set = toml.root.find("set")) {
        for (const TomlNode& change : set->value.items) scene.changes.push_back(change.text);
    }
    if (const TomlEntry* pinned = toml.root.find("pinned")) scene.pinned = pinned->value;
    return scene;
}

std::vector<std::string> all_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(TT_SOURCE_DIR) / "tests/regression")) {
        if (fs::exists(entry.path() / "numbers.toml"))
            names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

using Numbers = std::vector<std::pair<std::string, std::string>>;

/// The state's hash and what a paper would quote of it, each as it is written.
Numbers numbers_of(const Model& model, const State& state) {
    const std::vector<CellMeasures> cells = measure_cells(model, state);
    const RunMeasures run = measure_run(model, state, cells);
    Numbers numbers{{"hash", fmt::format("\"{}\"", hexadecimal(state_hash(state)))},
                    {"time_step", fmt::format("\"{:.12g} us\"", 1e6 * model.scales.time)},
                    {"mean_velocity", fmt::format("{:.9e}", run.mean_velocity.si)}};
    const auto add = [&](const char* name, double value) {
        if (std::isfinite(value)) numbers.emplace_back(name, fmt::format("{:.9e}", value));
    };
    add("mu_rel", run.mu_rel);
    if (cells.empty()) return numbers;
    double phase_rate = 0.0;
    for (const CellMeasures& cell : cells) phase_rate += cell.phase_rate.si;
    phase_rate /= static_cast<double>(cells.size());
    add("taylor_inertia", run.taylor_inertia);
    add("strain", run.strain);
    add("lambda_C", run.lambda_C);
    add("inclination_deg", run.inclination_deg);
    add("period", phase_rate == 0.0 ? NAN : 2.0 * std::numbers::pi / std::abs(phase_rate));
    add("area_error_max", run.area_error_max);
    return numbers;
}

void write(const Scene& scene, const Numbers& numbers) {
    const std::string text = read_file(file_of(scene.name));
    std::string head = text.substr(0, text.find("[pinned]"));
    head += "[pinned]\n";
    for (const auto& [key, value] : numbers) head += fmt::format("{} = {}\n", key, value);
    replace_file(file_of(scene.name), head, Durability::process);
}

std::string written(const TomlNode& node) {
    return node.kind == TomlNode::Kind::string ? fmt::format("\"{}\"", node.text)
                                               : fmt::format("{:.9e}", node.real);
}

class PinnedNumbers : public testing::TestWithParam<std::string> {};

TEST_P(PinnedNumbers, are_as_they_were) {
    const Scene scene = read_scene(GetParam());
    const Case c =
        read_case(TT_SOURCE_DIR "/cases/" + scene.case_name + "/case.toml", scene.changes);
    const Model model = discretise(c);
    State state = initial_state(c, model);
    Periodic ends;
    while (state.step < scene.steps) advance(model, state, ends);
    const Numbers numbers = numbers_of(model, state);
    if (update) {
        write(scene, numbers);
        return;
    }
    EXPECT_EQ(scene.pinned.entries.size(), numbers.size()) << "test_regression --update";
    for (const auto& [key, value] : numbers) {
        const TomlEntry* pinned = scene.pinned.find(key);
        if (!pinned) {
            ADD_FAILURE() << key << " = " << value << " is not pinned";
        } else {
            EXPECT_EQ(value, written(pinned->value)) << key;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PinnedNumbers, testing::ValuesIn(all_scenes()),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace tt

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    tt::update = std::any_of(argv, argv + argc,
                             [](const char* word) { return std::string(word) == "--update"; });
    return RUN_ALL_TESTS();
}
