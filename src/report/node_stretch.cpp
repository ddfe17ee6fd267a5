#include "report/node_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "report/frames.hpp"
#include "report/page_data.hpp"

namespace tt {

std::vector<double> chosen_stretches(const FramesHeader& header, const Frame& frame,
                                     const std::vector<int>& chosen,
                                     const std::vector<int>& first) {
    if (header.rest_length.empty()) return {};
    const std::vector<double> lengths = segment_lengths(header, frame);
    std::vector<double> stretches;
    for (std::size_t c = 0; c + 1 < first.size(); ++c) {
        for (int k = first[c]; k < first[c + 1]; ++k) {
            const auto begin = static_cast<std::size_t>(chosen[static_cast<std::size_t>(k)]);
            const auto end = static_cast<std::size_t>(k + 1 < first[c + 1]
                                                          ? chosen[static_cast<std::size_t>(k) + 1]
                                                          : header.first[c + 1]);
            double length = 0.0, rest = 0.0;
            for (std::size_t n = begin; n < end; ++n) {
                length += lengths[n];
                rest += header.rest_length[n];
            }
            // Of a cell that has left: as at rest.
            stretches.push_back(std::isfinite(length) ? length / rest : 1.0);
        }
    }
    return stretches;
}

double MembraneLaw::tension(double stretch) const {
    const double plain = std::visit([&](const auto& l) { return l.tension(stretch); }, law);
    return hardening.shear ? plain * hardening(stretch) : plain;
}

std::optional<MembraneLaw> membrane_law(const Results& run, const std::string& table) {
    const auto setting = [&](const char* key, const std::string& absent = {}) {
        return run.setting(fmt::format("{}.{}", table, key), absent);
    };
    MembraneLaw membrane;
    const double modulus = setting_si(setting("shear_modulus"));
    if (!choose_word(setting("law"), membrane.law) || !std::isfinite(modulus)) return std::nullopt;
    std::visit([&](auto& law) { law.shear_modulus = modulus; }, membrane.law);
    if (auto* skalak = std::get_if<Skalak>(&membrane.law)) {
        const double ratio = setting_si(setting("area_dilation_ratio", "1"));
        if (!std::isfinite(ratio)) return std::nullopt;
        skalak->area_dilation_ratio = ratio;
    }
    Hardening& h = membrane.hardening;
    const std::string applied = ", " + setting("hardening.apply_to") + ",";
    h.shear = applied.find(", shear,") != std::string::npos;
    if (!h.shear) return membrane;
    h.D = setting_si(setting("hardening.D"));
    h.beta = setting_si(setting("hardening.beta"));
    const bool known = choose_word(setting("hardening.form"), h.form) &&
                       choose_word(setting("hardening.compression"), h.compression);
    if (!known || !std::isfinite(h.D) || !std::isfinite(h.beta)) return std::nullopt;
    return membrane;
}

namespace {

/// Of 256 stretches, for each kind of cells; null where the law of one is not known.
Json tensions_of_kinds(const Results& run, double low, double high) {
    const std::vector<std::string> kinds = kind_names(run.frames->header());
    Json tensions = Json::array();
    for (const std::string& kind : kinds) {
        const auto membrane = membrane_law(run, kind.empty() ? "membrane" : "kind." + kind);
        if (!membrane || std::holds_alternative<SurfaceTension>(membrane->law)) return nullptr;
        Json& tension = tensions.emplace_back(Json::array());
        for (int b = 0; b < 256; ++b)
            tension.push_back(membrane->tension(low + (high - low) * b / 255.0));
    }
    return tensions;
}

}  // namespace

Json stretch_data(const Results& run, const std::vector<std::vector<double>>& frames) {
    double low = 1e300, high = -1e300;
    for (const auto& frame : frames)
        for (const double stretch : frame) {
            if (!std::isfinite(stretch)) continue;
            low = std::min(low, stretch);
            high = std::max(high, stretch);
        }
    if (!(high >= low)) return nullptr;
    const double scale = high > low ? 255.0 / (high - low) : 0.0;
    std::string bytes;
    for (const auto& frame : frames)
        for (const double stretch : frame) {
            const double level = std::isfinite(stretch) ? scale * (stretch - low) : 0.0;
            bytes += static_cast<char>(static_cast<unsigned char>(std::lround(level)));
        }
    return {{"low", low},
            {"high", high},
            {"bytes", base64(bytes)},
            {"tension", tensions_of_kinds(run, low, high)}};
}

}  // namespace tt
