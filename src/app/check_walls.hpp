#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/words.hpp"
#include "case/case.hpp"
#include "case/choose.hpp"

namespace tt {

/// Lines of "label  text", the text wrapped within 79 columns.
inline void print_line(std::string_view label, const std::string& text) {
    fmt::print("  {:<17} {}\n", label, wrapped(text, 79, 20));
}

/// What `check` says of walls of any shape, and of their ports.
void print_walls(const Case& c, const Choice& choice);

}  // namespace tt
