#include "base/error.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/words.hpp"

namespace tt {
namespace {

std::string joined(const std::vector<Fault>& faults) {
    std::string text;
    for (const Fault& fault : faults) {
        if (!text.empty()) text += '\n';
        text += to_string(fault);
    }
    return text;
}

/// "cell 3, node 17, at x = 12.31 um, y = 4.02 um"; empty if it is nowhere in particular.
std::string place_of(const Instability& what) {
    std::string place;
    const auto add = [&](const std::string& words) {
        place += (place.empty() ? "" : ", ") + words;
    };
    if (what.cell >= 0) add(fmt::format("cell {}", what.cell));
    if (what.node >= 0) add(fmt::format("node {}", what.node));
    if (std::isfinite(what.x) && std::isfinite(what.y))
        add(fmt::format("at x = {:.4g} um, y = {:.4g} um", what.x * 1e6, what.y * 1e6));
    return place;
}

std::string described(const Instability& what, const std::string& more) {
    std::string text =
        fmt::format("unstable at step {}, t = {:.6g} ms", what.step, what.time * 1e3);
    const std::string unit = what.unit.empty() ? "" : ' ' + what.unit;
    text += '\n' + labelled("what", fmt::format("{} is {:.4g}{}; the limit is {:.4g}{}",
                                                what.quantity, what.value, unit, what.limit, unit));
    const std::string place = place_of(what);
    if (!place.empty()) text += '\n' + labelled("where", place);
    text += '\n' + labelled("cause", what.cause);
    text += '\n' + (more.empty() ? labelled("cure", what.cure) : more);
    return text;
}

}  // namespace

std::string to_string(const Fault& fault) {
    if (fault.file.empty()) return fault.message;
    if (fault.line <= 0) return fmt::format("{}: {}", fault.file, fault.message);
    return fmt::format("{}:{}:{}: {}", fault.file, fault.line, fault.column, fault.message);
}

CaseError::CaseError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

std::string labelled(const std::string& label, const std::string& text) {
    constexpr std::size_t indent = 9;
    return fmt::format("{:<{}}{}", fmt::format("  {}:", label), indent, wrapped(text, 79, indent));
}

SimulationError::SimulationError(Instability what, const std::string& more)
    : std::runtime_error(described(what, more)), what_(std::move(what)) {}

}  // namespace tt
