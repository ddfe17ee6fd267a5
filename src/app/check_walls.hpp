#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"
#include "base/words.hpp"
#include "case/case.hpp"
#include "case/choose.hpp"
#include "case/appraise.hpp"
#include "simulation/model.hpp"

namespace tt {

/// Lines of "label  text", the text wrapped within 79 columns.
inline void print_line(std::string_view label, const std::string& text) {
    fmt::print("  {:<17} {}\n", label, wrapped(text, 79, 20));
}

/// "170", not "1.7e+02".
inline std::string plain(double number, int digits = 2) {
    return rounded_text(number, Dimension{}, digits);
}

inline std::string with_spaces(std::int64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ' ');
    return text;
}

/// What `check` says of walls of any shape, and of their ports.
void print_walls(const Case& c, const Choice& choice);

/// Of the channels that feed its ports: how many cells come in, and how often.
void print_feeds(const Case& c, const Model& model, const Appraisal& a);

}  // namespace tt
