#pragma once

#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/read.hpp"
#include "case/write.hpp"

namespace tt {

/// What any text at all must survive as a case file, as a quantity and as a --set. Whatever can be
/// read must be written back to the same Case.
inline void try_as_case(std::string_view text) {
    try {
        const Case c = parse_case(text, "fuzz.toml");
        if (parse_case(to_toml(c), "fuzz.toml") != c) __builtin_trap();
    } catch (const CaseError&) {
    }
    try {
        const Measure m = parse_measure(text.substr(0, 64));
        if (parse_measure(to_text(m.si, m.dimension)).si != m.si) __builtin_trap();
    } catch (const UnitError&) {
    }
    try {
        parse_case("", "fuzz.toml", {std::string(text.substr(0, 256))});
    } catch (const CaseError&) {
    }
}

}  // namespace tt
