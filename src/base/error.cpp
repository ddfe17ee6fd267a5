#include "base/error.hpp"

#include <fmt/format.h>

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

std::string described(const Instability& what) {
    std::string place;
    if (what.cell >= 0) place += fmt::format(", cell {}", what.cell);
    if (what.node >= 0) place += fmt::format(", node {}", what.node);
    return fmt::format(
        "unstable at step {} (t = {:.6g} ms{}): {} is {:.4g} {}, limit {:.4g} {}\n  cause: {}\n  "
        "cure: {}",
        what.step, what.time * 1e3, place, what.quantity, what.value, what.unit, what.limit,
        what.unit, what.cause, what.cure);
}

}  // namespace

std::string to_string(const Fault& fault) {
    if (fault.file.empty()) return fault.message;
    if (fault.line <= 0) return fmt::format("{}: {}", fault.file, fault.message);
    return fmt::format("{}:{}:{}: {}", fault.file, fault.line, fault.column, fault.message);
}

CaseError::CaseError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

SimulationError::SimulationError(Instability what)
    : std::runtime_error(described(what)), what_(std::move(what)) {}

}  // namespace tt
