#include "report/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "observe/measures.hpp"
#include "report/frames.hpp"

namespace tt {
namespace {

/// "80 um" → "80 µm".
std::string pretty(std::string text) {
    if (const auto at = text.find(" um"); at != std::string::npos) text.replace(at, 3, " µm");
    return text;
}

/// What each port holds.
std::string port_words(const Results& run) {
    std::vector<std::string> ports;
    std::string feeds;
    for (const auto& [key, value] : run.settings) {
        if (key.rfind("port.", 0) != 0) continue;
        const std::size_t dot = key.rfind('.');
        const std::string name = key.substr(5, dot - 5), what = key.substr(dot + 1);
        if (what == "pressure") ports.push_back(fmt::format("{} at {}", name, pretty(value)));
        if (what == "flow_rate")
            ports.push_back(fmt::format("{} with a flow rate of {}", name, pretty(value)));
        if (what == "mean_velocity")
            ports.push_back(fmt::format("{} with a mean velocity of {}", name, pretty(value)));
        if (key.ends_with(".feed.hematocrit"))
            feeds += fmt::format(" Cells come in through {}, from a channel at {}.",
                                 name.substr(0, name.rfind('.')), pretty(value));
    }
    if (ports.empty()) return "";
    return fmt::format("Ports drive the flow: {}.{}", fmt::join(ports, ", "), feeds);
}

std::string flow_words(const Results& run) {
    const std::string drive = run.setting("flow.drive");
    const std::string pseudo = run.setting("flow.pseudo_shear_rate");
    if (drive == "shear") {
        const std::string rate = run.setting("flow.shear_rate"),
                          number = run.setting("flow.shear_number");
        if (!rate.empty())
            return "Walls that move against each other shear the fluid at " + rate + ".";
        return number.empty()
                   ? "Walls that move against each other shear the fluid."
                   : "Walls that move against each other shear the fluid at a shear number of " +
                         number + ".";
    }
    if (const std::string ports = port_words(run); !ports.empty()) return ports;
    if (drive == "none") return "Nothing drives the flow.";
    if (drive.empty()) return "";
    const std::string how = drive == "body-force" ? "A body force" : "A pressure difference";
    std::string text = how + " drives the flow along the channel";
    if (!pseudo.empty())
        text += ", at a nominal pseudo-shear rate (mean velocity / width) of " + pseudo;
    constexpr std::pair<const char*, const char*> others[] = {
        {"flow.mean_velocity", "mean velocity"},
        {"flow.largest_velocity", "largest velocity"},
        {"flow.flow_rate", "flow rate per depth"},
        {"flow.wall_stress", "wall shear stress"},
        {"flow.pressure_gradient", "pressure gradient"}};
    for (const auto& [key, name] : others)
        if (const std::string value = run.setting(key); !value.empty())
            text += fmt::format(", at a nominal {} of {}", name, value);
    if (run.setting("flow.hold") == "mean-velocity") text += ", with the mean velocity held";
    if (run.setting("flow.hold") == "pressure-drop") text += ", with the pressure drop held";
    return text + ".";
}

/// Names of the kinds of cells, if there are several.
std::vector<std::string> kinds_of(const Results& run) {
    return run.frames ? kind_names(run.frames->header()) : std::vector<std::string>{};
}

std::string cells_words(const Results& run) {
    if (run.setting("numerics.fluid_only") == "true") return "There are no cells.";
    std::string count = run.setting("cells.count");
    if (count.empty() && run.frames && run.frames->count() > 0) {
        // Those of the first frame: others may have come in since.
        const auto& first = run.frames->header().first;
        const auto nodes = static_cast<std::int32_t>(run.frames->stored(0).nodes.size() / 2);
        count = std::to_string(std::lower_bound(first.begin(), first.end(), nodes) - first.begin());
    }
    std::string text = count.empty() ? "Cells" : count + (count == "1" ? " cell" : " cells");
    const std::vector<std::string> kinds = kinds_of(run);
    const bool rigid = run.setting("membrane.rigid") == "true";
    if (kinds.size() > 1)
        text += fmt::format(" of {} kinds ({})", kinds.size(), fmt::join(kinds, ", "));
    else if (rigid)
        text += count == "1" ? ", a rigid body" : ", rigid bodies";
    std::vector<std::string> details;
    const auto add = [&](const std::string& label, const char* key) {
        const std::string value = run.setting(key);
        if (!value.empty()) details.push_back(label + pretty(value));
    };
    const bool alike = kinds.size() < 2;
    if (alike) add("at the start ", "cells.shape");
    if (alike) add("radius ", "cells.radius");
    add("hematocrit ", "cells.hematocrit");
    if (alike && !rigid) add("cytoplasm ", "cells.cytoplasm_viscosity");
    add("plasma ", "plasma.viscosity");
    if (!details.empty()) text += fmt::format(": {}", fmt::join(details, ", "));
    return text + ".";
}

std::string membrane_words(const Results& run) {
    const std::string law = run.setting("membrane.law");
    if (law.empty() || run.setting("membrane.rigid") == "true") return "";
    if (kinds_of(run).size() > 1) return "";  // each has its own
    std::string text = "Membrane law " + law;
    const std::string apply = run.setting("membrane.hardening.apply_to");
    if (apply.empty()) return text + ", no hardening.";
    text += ", hardening of " + apply;
    const std::string form = run.setting("membrane.hardening.form");
    const std::string D = run.setting("membrane.hardening.D"),
                      beta = run.setting("membrane.hardening.beta");
    if (!form.empty())
        text += " (" + form + (D.empty() ? "" : ", D = " + D) +
                (beta.empty() ? "" : ", β = " + beta) + ")";
    return text + ".";
}

std::string grid_words(const Results& run) {
    std::string text;
    if (run.frames) {
        const FramesHeader& header = run.frames->header();
        text = fmt::format("{} × {} sites, {:.4g} µm apart; time step {:.4g} µs", header.nx,
                           header.ny, header.dx * 1e6, header.dt * 1e6);
    }
    if (const std::string end = run.setting("time.end"); !end.empty())
        text += (text.empty() ? "" : "; ") + ("end at " + end);
    return text.empty() ? "" : text + ".";
}

/// " × 10⁻⁴".
std::string times_power_of_ten(int power) {
    static constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴",
                                                        "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = power < 0 ? " × 10⁻" : " × 10";
    for (const char digit : std::to_string(std::abs(power)))
        text += raised[static_cast<std::size_t>(digit - '0')];
    return text;
}

/// The sign that is as wide as a plus.
std::string with_minus(std::string text) {
    if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
    return text;
}

/// Walls that are not those of the box.
std::string walls_words(const Results& run) {
    const std::string shape = run.setting("geometry.shape");
    const auto key = [&](const char* name) { return run.setting(std::string("geometry.") + name); };
    if (shape == "stenosis")
        return fmt::format("Its walls narrow it to {} in the middle, over {}.",
                           pretty(key("throat")), pretty(key("throat_length")));
    if (shape == "posts")
        return fmt::format(
            "It holds {} × {} posts of {}; each column is {} rows higher than the one "
            "before.",
            key("columns"), key("rows"), pretty(key("diameter")), key("row_shift"));
    if (shape == "file") return fmt::format("Its walls are those of {}.", key("file"));
    return {};
}

}  // namespace

std::string case_in_words(const Results& run) {
    std::string text;
    const std::string length = run.setting("domain.length"), width = run.setting("domain.width");
    if (!length.empty() && !width.empty())
        text = port_words(run).empty() ? fmt::format("A box {} long (periodic) and {} wide.",
                                                     pretty(length), pretty(width))
                                       : fmt::format("Channels, {} long and {} wide in all.",
                                                     pretty(length), pretty(width));
    for (const std::string& sentence : {walls_words(run), flow_words(run), cells_words(run),
                                        membrane_words(run), grid_words(run)})
        if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
    return text;
}

std::string unfinished_note(const Results& run) {
    const std::string state = text_of(run.status, "status", text_of(run.status, "state"));
    if (run.finished() && (state.empty() || state == "done")) return "";
    const double reached = number_of(run.status, "time", 0.0);
    const double end = number_of(run.status, "end", 0.0);
    std::string text = "This run is not finished";
    if (!state.empty() && state != "done") text += " (" + state + ")";
    if (end > 0.0)
        text += fmt::format(": it had reached {} of {} ms", number_text(reached * 1e3),
                            number_text(end * 1e3));
    return text +
           ". Figures show what there is; means over the stated window are missing or provisional.";
}

std::string changes_note(const Results& run) {
    std::string text;
    const Json sessions = run.provenance.value("sessions", Json::array());
    for (const Json& session : sessions) {
        if (!session.is_object() || !session.contains("changes")) continue;
        text += text.empty() ? "" : " ";
        text += fmt::format("Numerics changed at {} ms, after a blow-up:",
                            number_text(number_of(session, "from_time", 0.0) * 1e3));
        for (const auto& [key, values] : session["changes"].items())
            if (values.is_array() && values.size() == 2 && values[0].is_string() &&
                values[1].is_string())
                text += fmt::format(" {} = {}, before {};", key, values[1].get<std::string>(),
                                    values[0].get<std::string>());
        text.back() = '.';
    }
    return text;
}

std::string meaning_of_quantity(const std::string& name) {
    std::string meaning;
    const auto match = [&](const auto& entry) {
        if (entry.key == name) meaning = entry.meaning;
    };
    for_each_field<CellMeasures>(match);
    for_each_field<RunMeasures>(match);
    constexpr std::pair<const char*, const char*> of_places[] = {
        {".flow_rate", "flow rate per depth; of a port into the channels, of a section forward"},
        {".mean_velocity", "flow rate / width"},
        {".pressure", "mean pressure on it"},
        {".hematocrit_tube", "share of the section that lies in cells"},
        {".hematocrit_discharge", "area of the cells / volume that passed"},
        {".cfl_from", "wall to the first membrane on the section, at the end `from`"},
        {".cfl_to", "the same at the end `to`"},
        {".mu_rel", "resistance of the stretch / that of plasma alone"},
        {".mu_app", "the same times the viscosity of plasma"},
        {".cells_left", "cells that have left through this port"},
        {".cells_forward", "cells that have passed forward"},
        {".cells_backward", "cells that have passed backward"},
        {".cell_area", "area of the cells that has passed, net, per depth"},
        {".volume", "volume that has passed, net, per depth"},
        {".residence",
         "time in the channels of the cells that left there, at most since the start"},
        {".flow_fraction", "share of the flow of both daughters"},
        {".cell_fraction", "share of the cells of both daughters, counted"},
        {".hematocrit_ratio", "discharge hematocrit / that of the parent"},
        {".pries_cell_fraction", "share of the cells by Pries' law, of round vessels"}};
    if (meaning.empty())
        for (const auto& [ending, words] : of_places)
            if (name.ends_with(ending)) meaning = words;
    if (name == "tank_treading_kT") meaning = "shear rate × period of tank-treading";
    if (name == "lateral_displacement") meaning = "way across the flow / way along it";
    return meaning;
}

DisplayUnit display_unit(const std::string& si_unit) {
    static const std::array<std::pair<const char*, DisplayUnit>, 6> known{
        {{"m", {1e6, "µm"}},
         {"s", {1e3, "ms"}},
         {"m/s", {1e3, "mm/s"}},
         {"Pa s", {1e3, "mPa s"}},
         {"Pa/m", {1e-3, "kPa/m"}},
         {"m^2/s", {1e9, "10⁻⁹ m²/s"}}}};
    for (const auto& [si, unit] : known)
        if (si_unit == si) return unit;
    return {1.0, si_unit};
}

std::string number_text(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (const auto at = text.find('e'); at != std::string::npos) {
        text = text.substr(0, at) + times_power_of_ten(std::atoi(text.c_str() + at + 1));
    }
    return with_minus(text);
}

std::string with_scatter(double mean, double scatter) {
    if (!std::isfinite(mean) || !std::isfinite(scatter) || scatter <= 0.0) return number_text(mean);
    const double largest = std::max(std::abs(mean), scatter);
    const int power = static_cast<int>(std::floor(std::log10(largest)));
    const bool plain = power >= -3 && power < 5;
    const double unit = plain ? 1.0 : std::pow(10.0, power);
    const int decimals = std::max(1 - static_cast<int>(std::floor(std::log10(scatter / unit))), 0);
    if (decimals > 6) return number_text(mean);  // too little to be of interest
    const std::string text = with_minus(fmt::format("{:.{}f}", mean / unit, decimals)) +
                             fmt::format(" ± {:.{}f}", scatter / unit, decimals);
    return plain ? text : fmt::format("({}){}", text, times_power_of_ten(power));
}

}  // namespace tt
