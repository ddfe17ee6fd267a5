#include "case/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "base/words.hpp"
#include "case/kept_inputs.hpp"
#include "case/read.hpp"
#include "case/reader.hpp"
#include "case/run_name.hpp"
#include "case/targets_text.hpp"
#include "io/file.hpp"
#include "observe/summary.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// The value at a path of keys, or the nearest thing above it.
struct Spot {
    const TomlNode* node = nullptr;
    int line = 0, column = 0;

    Spot under(std::string_view key) const {
        const TomlEntry* entry = node != nullptr ? node->find(key) : nullptr;
        if (entry == nullptr) return {nullptr, line, column};
        const TomlNode& value = entry->value;
        const bool table = value.kind == TomlNode::Kind::table;
        return {&value, table ? entry->line : value.line, table ? entry->column : value.column};
    }
    Spot item(std::size_t k) const {
        if (node == nullptr || k >= node->items.size()) return {nullptr, line, column};
        return {&node->items[k], node->items[k].line, node->items[k].column};
    }
};

/// From the text of a file to Targets, gathering faults.
class TargetsReader {
public:
    TargetsReader(const TomlNode& root, const fs::path& path)
        : root_{&root, 0, 0}, file_(path.string()), folder_(path.parent_path()) {}

    Targets read();
    std::vector<Fault> faults;

private:
    void tell(const Spot& spot, std::string message) {
        faults.push_back({file_, spot.line, spot.column, std::move(message)});
    }
    LogRange range(std::string_view key, const std::vector<double>& ends);
    Target target(const TargetTable& table, const Spot& spot);
    void check_measure(const Spot& spot, std::string_view key, const Measure& given,
                       Dimension wanted);
    fs::path case_path() const;
    std::size_t condition(const TargetTable& table, const Spot& spot, Targets& result);
    std::vector<InputFile> inputs(const std::vector<Condition>& conditions) const;
    void tell_case_faults(const CaseError& error, const TargetTable& table, const Spot& spot);
    void check_condition(const Case& c, const Spot& spot);
    std::string name_of_targets();

    Spot root_;
    std::string file_;
    fs::path folder_;
    TargetsText text_;
};

LogRange TargetsReader::range(std::string_view key, const std::vector<double>& ends) {
    const Spot spot = root_.under("search").under(key);
    if (ends.size() == 2 && ends[0] < ends[1]) return {ends[0], ends[1]};
    for (const Fault& fault : faults)
        if (fault.line == spot.line && spot.node != nullptr) return {};  // told already
    const std::string example = key == "D" ? "[0.1, 2]" : "[5, 30]";
    tell(spot, spot.node == nullptr
                   ? fmt::format("{} is missing from [search]; write {} = {}", key, key, example)
                   : fmt::format("{} must be the lower and the upper end of its range, as in {}",
                                 key, example));
    return {};
}

void TargetsReader::check_measure(const Spot& spot, std::string_view key, const Measure& given,
                                  Dimension wanted) {
    if (given.dimension == wanted) return;
    const std::string unit = si_unit(wanted);
    if (given.dimension == Dimension{})
        tell(spot, fmt::format("{} = {} has no unit; write {} = \"{} {}\"", key, to_text(given.si),
                               key, to_text(given.si), unit));
    else
        tell(spot,
             fmt::format(
                 "{} is of the kind {}, and {} is wanted", key, dimension_name(given.dimension),
                 wanted == Dimension{} ? "a number without a unit" : dimension_name(wanted)));
}

Target TargetsReader::target(const TargetTable& table, const Spot& spot) {
    Target result;
    result.quantity = table.quantity;
    result.goal = {table.value.si, table.uncertainty.si};
    const auto dimension = summary_dimension(table.quantity);
    if (!dimension) {
        const auto known = summary_quantities();
        const auto near = closest(table.quantity, known);
        tell(spot.under("quantity"),
             table.quantity.empty()
                 ? std::string("quantity is missing from [[target]]; write quantity = \"lambda_C\"")
                 : fmt::format("quantity = {} is not one of {}{}", toml_string(table.quantity),
                               fmt::join(known, ", "),
                               near ? fmt::format("; did you mean \"{}\"?", *near) : ""));
        return result;
    }
    result.unit = si_unit(*dimension);
    if (std::isfinite(table.value.si))
        check_measure(spot.under("value"), "value", table.value, *dimension);
    if (table.uncertainty.si > 0.0)
        check_measure(spot.under("uncertainty"), "uncertainty", table.uncertainty, *dimension);
    return result;
}

/// A fault of an override belongs to the item of `set` that made it.
void TargetsReader::tell_case_faults(const CaseError& error, const TargetTable& table,
                                     const Spot& spot) {
    for (const Fault& fault : error.faults()) {
        Fault told = fault;
        const auto take = [&](const Spot& set, const std::vector<std::string>& items) {
            for (std::size_t k = 0; k < items.size(); ++k) {
                if (fault.file != origin_of(items[k])) continue;
                const Spot item = set.item(k);
                told = {file_, item.line, item.column, fault.message};
            }
        };
        take(root_.under("set"), text_.set);
        take(spot.under("set"), table.set);
        faults.push_back(told);
    }
}

void TargetsReader::check_condition(const Case& c, const Spot& spot) {
    if (c.membrane.hardening.apply_to.empty())
        tell(spot,
             "nothing hardens in this case, so D and beta mean nothing; write "
             "set = [\"membrane.hardening.apply_to=[shear, bending, area, contact]\"]");
    if (!c.kinds.empty())
        tell(spot,
             "the cells are of several kinds, and D and beta would have to be those of one: take "
             "[[kind]] out of the case");
    const bool random = std::holds_alternative<PaperRows>(c.cells.layout) ||
                        std::holds_alternative<AtRandom>(c.cells.layout);
    if (!text_.search.seeds.empty() && !random)
        tell(root_.under("search").under("seeds"),
             fmt::format("layout = \"{}\" uses no random numbers; take seeds out",
                         word_of(c.cells.layout)));
}

fs::path TargetsReader::case_path() const { return find_case(folder_, text_.case_file); }

std::vector<InputFile> TargetsReader::inputs(const std::vector<Condition>& conditions) const {
    std::vector<const Case*> cases;
    for (const Condition& condition : conditions) cases.push_back(&condition.c);
    return kept_inputs(case_path(), read_file(case_path(), Author::user), cases);
}

std::size_t TargetsReader::condition(const TargetTable& table, const Spot& spot, Targets& result) {
    std::vector<std::string> overrides = text_.set;
    overrides.insert(overrides.end(), table.set.begin(), table.set.end());
    try {
        const Case c = read_case(case_path(), overrides);
        check_condition(c, spot);
        for (std::size_t k = 0; k < result.conditions.size(); ++k)
            if (result.conditions[k].c == c) return k;
        result.conditions.push_back({c, fmt::format("{}", fmt::join(table.set, ", "))});
    } catch (const CaseError& error) {
        tell_case_faults(error, table, spot);
    } catch (const IoError& error) {
        tell(root_.under("case"), error.what());
    }
    return result.conditions.empty() ? 0 : result.conditions.size() - 1;
}

std::string TargetsReader::name_of_targets() {
    if (root_.node->find("name") == nullptr) return name_from(fs::path(file_).stem().string());
    if (const auto fault = fault_of_name(text_.name)) tell(root_.under("name"), *fault);
    return text_.name;
}

Targets TargetsReader::read() {
    Reader<TargetsText> reader(file_);
    reader.read_table(*root_.node, nullptr, "", text_);
    faults = std::move(reader.faults);
    Targets result;
    result.name = name_of_targets();
    result.D = range("D", text_.search.D);
    result.beta = range("beta", text_.search.beta);
    result.seeds = text_.search.seeds;
    result.limits = {static_cast<int>(text_.search.first_pairs),
                     static_cast<int>(text_.search.most_pairs), text_.search.tolerance};
    if (result.limits.most < result.limits.first)
        tell(root_.under("search").under("most_pairs"),
             fmt::format("most_pairs = {} is less than first_pairs = {}", result.limits.most,
                         result.limits.first));
    if (text_.target.empty())
        tell(root_, "there is no target; write [[target]] with quantity, value and uncertainty");
    if (text_.case_file.empty()) tell(root_, "case is missing; write case = \"channel.toml\"");
    for (std::size_t k = 0; k < text_.target.size(); ++k) {
        const Spot spot = root_.under("target").item(k);
        Target next = target(text_.target[k], spot);
        if (!text_.case_file.empty()) next.condition = condition(text_.target[k], spot, result);
        result.targets.push_back(std::move(next));
    }
    if (faults.empty()) result.inputs = inputs(result.conditions);
    return result;
}

/// In the order of the file, each once: several targets may share what is wrong.
void sort_and_thin(std::vector<Fault>& faults, const std::string& file) {
    const auto key = [&](const Fault& f) {
        return std::tuple(f.file != file, f.file, f.line == 0, f.line, f.column);
    };
    std::stable_sort(faults.begin(), faults.end(),
                     [&](const Fault& a, const Fault& b) { return key(a) < key(b); });
    const auto same = [](const Fault& a, const Fault& b) { return to_string(a) == to_string(b); };
    faults.erase(std::unique(faults.begin(), faults.end(), same), faults.end());
}

}  // namespace

Targets read_targets(const fs::path& path) {
    const std::string text = read_file(path, Author::user);
    const TomlText toml = parse_toml(text, path.string());
    if (!toml.faults.empty()) throw CaseError(toml.faults);
    TargetsReader reader(toml.root, path);
    Targets result = reader.read();
    sort_and_thin(reader.faults, path.string());
    if (!reader.faults.empty()) throw CaseError(reader.faults);
    result.text = text;
    return result;
}

Case case_at(const Condition& condition, double D, double beta, std::int64_t seed) {
    Case c = condition.c;
    c.membrane.hardening.D = D;
    c.membrane.hardening.beta = beta;
    c.cells.seed = seed;
    c.output.frames = c.time.end;
    return c;
}

}  // namespace tt
