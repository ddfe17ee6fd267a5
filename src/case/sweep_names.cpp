#include "case/sweep_names.hpp"

#include <set>

#include "base/units.hpp"
#include "case/sweep_plan.hpp"
#include "io/checksum.hpp"
#include "observe/sweep_record.hpp"

namespace tt {
namespace {

bool needs_no_quotes(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("+-.,=").find(c) != std::string_view::npos;
}

/// "20 um" is 20um, "50 /s" is 50_per_s, "shear, area" is shear,area.
std::string name_of(const std::string& value) {
    const bool quantity = number_length(value) > 0;
    std::string name;
    for (std::size_t k = 0; k < value.size(); ++k) {
        const char c = value[k];
        if (needs_no_quotes(c))
            name += c;
        else if (c == '/' && quantity)
            name += "_per_";
        else if (c == '%' && quantity)
            name += "percent";
        else if (c != ' ')
            name += '_';
    }
    return name.empty() ? "_" : name;
}

}  // namespace

void name_runs(SweepPlan& plan) {
    constexpr std::size_t longest = 100;
    const std::vector<std::string> keys = short_keys(plan.keys);
    std::set<std::string> known;
    for (PlannedRun& run : plan.runs) {
        std::string name, whole;
        for (std::size_t k = 0; k < keys.size(); ++k) {
            name += (name.empty() ? "" : "_") + keys[k] + "=" + name_of(run.values[k]);
            whole += plan.keys[k] + "=" + run.values[k] + ";";
        }
        if (name.size() > longest || known.contains(name))
            name = name.substr(0, longest - 9) + "-" + hexadecimal(checksum(whole)).substr(0, 8);
        known.insert(name);
        run.name = name;
    }
}

}  // namespace tt
