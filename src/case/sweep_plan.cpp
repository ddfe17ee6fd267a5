#include "case/sweep_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "case/kept_inputs.hpp"
#include "case/read.hpp"
#include "case/reader.hpp"
#include "case/run_name.hpp"
#include "case/planned_runs.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// The file as it stands, but for its tables [[over]].
struct SweepText {
    std::int64_t format = 1;
    std::string name;
    std::string case_file;
    std::vector<std::string> set;
    std::vector<std::string> over;
};

}  // namespace

template <>
struct FieldList<SweepText> {
    using T = SweepText;
    static constexpr auto entries = std::tuple{
        FieldEntry{"format", &T::format, "of this file", Range{1.0, 1.0}, {}, "1"},
        FieldEntry{"name", &T::name, "of the results", any_value, "", "shear-number"},
        FieldEntry{"case", &T::case_file, "the case file", any_value, "", "channel.toml"},
        FieldEntry{"set", &T::set, "for all runs", any_value, "", "[\"numerics.dx=0.4 um\"]"},
        FieldEntry{"over", &T::over, "an axis", any_value, "", "[]"},
    };
};

namespace {

/// In the order of the file; those without a line last.
[[noreturn]] void refuse(std::vector<Fault> faults) {
    const auto key = [](const Fault& f) {
        return std::tuple(f.line == 0, f.file, f.line, f.column);
    };
    std::stable_sort(faults.begin(), faults.end(),
                     [&](const Fault& a, const Fault& b) { return key(a) < key(b); });
    throw CaseError(std::move(faults));
}

Fault place_of(const TomlNode& root, std::string_view key, const std::string& file) {
    const TomlEntry* entry = root.find(key);
    return entry ? Fault{file, entry->value.line, entry->value.column, {}} : Fault{file, 0, 0, {}};
}

/// The tables [[over]], taken out of the file's tree.
std::vector<SweepAxis> take_axes(TomlNode& root, const std::string& file,
                                 std::vector<Fault>& faults) {
    std::vector<SweepAxis> axes;
    const TomlEntry* entry = root.find("over");
    const auto tell = [&](int line, int column, const char* message) {
        faults.push_back({file, line, column, message});
    };
    if (entry == nullptr)
        tell(0, 0,
             "there is no axis; write [[over]] and below it flow.shear_number = \"0.1:1:0.1\"");
    else if (entry->value.kind != TomlNode::Kind::array || entry->value.items.empty())
        tell(entry->line, entry->column, "write [[over]] on a line of its own before each axis");
    else
        for (const TomlNode& item : entry->value.items) {
            if (item.kind == TomlNode::Kind::table)
                axes.push_back(axis_of_table(item, file, faults));
            else
                tell(item.line, item.column,
                     "write [[over]] on a line of its own before each axis");
        }
    std::erase_if(root.entries, [](const TomlEntry& e) { return e.key == "over"; });
    return axes;
}

/// As a file in the directory of the sweep.
std::string text_of(const SweepPlan& plan, const std::vector<CommonSetting>& set) {
    std::string list;
    for (const CommonSetting& each : set) {
        if (!list.empty()) list += ", ";
        list += toml_string(each.text);
    }
    const std::string name = "inputs/" + plan.case_file.filename().string();
    std::string text = fmt::format("format = 1\nname = {}\ncase = {}\nset = [{}]\n",
                                   toml_string(plan.name), toml_string(name), list);
    for (const SweepAxis& axis : plan.axes) text += "\n" + to_toml(axis);
    return text;
}

}  // namespace

SweepPlan read_sweep(const fs::path& path, const std::vector<std::string>& set) {
    const std::string file = path.string();
    SweepPlan plan;
    plan.text = read_file(path, Author::user);
    TomlText toml = parse_toml(plan.text, file);
    if (!toml.faults.empty()) throw CaseError(toml.faults);
    std::vector<Fault> faults;
    plan.axes = take_axes(toml.root, file, faults);
    SweepText given;
    Reader<SweepText> reader(file);
    reader.read_table(toml.root, nullptr, "", given);
    faults.insert(faults.end(), reader.faults.begin(), reader.faults.end());
    plan.name = given.name;
    if (toml.root.find("name") == nullptr) {
        plan.name = name_from(path.stem().string());
    } else if (const auto fault = fault_of_name(given.name)) {
        faults.push_back(place_of(toml.root, "name", file));
        faults.back().message = *fault;
    }
    std::vector<CommonSetting> common;
    const TomlEntry* list = toml.root.find("set");
    for (std::size_t k = 0; k < given.set.size(); ++k) {
        const TomlNode& item = list->value.items[k];
        common.push_back({given.set[k], {file, item.line, item.column, {}}});
    }
    for (const std::string& item : set) common.push_back({item, {origin_of(item), 0, 0, {}}});
    if (given.case_file.empty()) {
        faults.push_back(place_of(toml.root, "case", file));
        faults.back().message = "case is missing; write case = \"channel.toml\"";
        refuse(std::move(faults));
    }
    plan.case_file = find_case(path.parent_path(), given.case_file);
    if (!fs::exists(plan.case_file)) {
        faults.push_back(place_of(toml.root, "case", file));
        faults.back().message = fmt::format("there is no case file '{}'", plan.case_file.string());
        refuse(std::move(faults));
    }
    make_runs(plan, common, faults);
    if (!faults.empty()) refuse(std::move(faults));
    if (!set.empty()) plan.text = text_of(plan, common);
    return plan;
}

SweepPlan sweep_over(const fs::path& case_file, const std::vector<std::string>& set,
                     const std::vector<std::string>& over) {
    SweepPlan plan;
    plan.case_file = case_file;
    std::vector<Fault> faults;
    for (const std::string& text : over) plan.axes.push_back(axis_of_option(text, faults));
    std::vector<CommonSetting> common;
    for (const std::string& item : set) common.push_back({item, {origin_of(item), 0, 0, {}}});
    make_runs(plan, common, faults);
    if (!faults.empty()) refuse(std::move(faults));
    plan.name = name_from(plan.runs.front().c.name + "-sweep");
    plan.text = text_of(plan, common);
    return plan;
}

bool is_sweep_file(const std::string& text) {
    const TomlText toml = parse_toml(text, "");
    if (!toml.faults.empty()) return text.find("[[over]]") != text.npos;
    const bool names = toml.root.find("case") != nullptr || toml.root.find("over") != nullptr;
    return names && toml.root.find("domain") == nullptr;
}

}  // namespace tt
