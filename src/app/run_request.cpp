#include "app/run_request.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "app/verb.hpp"
#include "case/resolve.hpp"

namespace tt {

RunRequest request_for(const Case& c, const Choice& choice, const Model& model) {
    RunRequest request;
    request.name = c.name;
    request.resolved_toml = resolved_toml(c, choice, model);
    request.inputs = inputs_of(c);
    request.settings = settings_of(c, choice);
    if (c.cells.outline && !c.numerics.fluid_only) {
        request.notes.push_back("outline " + description(*c.cells.outline));
        for (const std::string& remark : c.cells.outline->remarks) request.notes.push_back(remark);
    }
    request.end = c.time.end;
    request.average_from = c.time.average_from.value_or(Time{0.5 * c.time.end.si});
    request.series = c.output.series;
    request.frames = c.output.frames;
    request.fields = c.output.fields;
    request.compress = c.output.compress;
    request.checkpoint = c.output.checkpoint;
    if (!c.numerics.fluid_only && choice.shear_rate.si != 0.0)
        request.shear_number = c.plasma.viscosity.si * std::abs(choice.shear_rate.si) *
                               equivalent_radius(c).si / c.membrane.shear_modulus.si;
    return request;
}

ProgressMode progress_mode(const std::string& word) {
    static const std::map<std::string, ProgressMode> modes{{"auto", ProgressMode::automatic},
                                                           {"bar", ProgressMode::bar},
                                                           {"log", ProgressMode::log},
                                                           {"json", ProgressMode::json},
                                                           {"none", ProgressMode::none}};
    const auto mode = modes.find(word);
    if (mode == modes.end())
        throw CommandError(
            fmt::format("--progress {} is not one of auto, bar, log, json, none", word));
    return mode->second;
}

}  // namespace tt
