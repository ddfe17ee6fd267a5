#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "base/field_list.hpp"
#include "base/quantity.hpp"

namespace tt {

/// Where something is measured: [section.NAME]. Flow to the right of the way from one end to the
/// other is positive.
struct SectionCase {
    std::string name;              ///< of the table; no key
    std::vector<Length> from, to;  ///< [x, y], its ends
    friend bool operator==(const SectionCase&, const SectionCase&) = default;
};
/// Sections around a place where a channel parts in two: [fork.NAME].
struct ForkCase {
    std::string name;
    std::string parent;
    std::vector<std::string> daughters;
    friend bool operator==(const ForkCase&, const ForkCase&) = default;
};
/// A channel between two sections, of which the resistance is told: [stretch.NAME].
struct StretchCase {
    std::string name;
    std::string from, to;
    friend bool operator==(const StretchCase&, const StretchCase&) = default;
};

template <>
struct FieldList<SectionCase> {
    using T = SectionCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"from", &T::from,
                   "one end of a line along x or y across a channel, from wall to wall; flow to "
                   "the right of the way to the other end is positive",
                   any_value, "", "[\"40 um\", \"0 um\"]"},
        FieldEntry{"to", &T::to, "the other end", any_value, "", "[\"40 um\", \"20 um\"]"},
    };
};

template <>
struct FieldList<ForkCase> {
    using T = ForkCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{
            "parent", &T::parent, "name of the section before the fork", any_value, {}, "parent"},
        FieldEntry{"daughters", &T::daughters, "names of the two sections behind it", any_value, "",
                   "[\"upper\", \"lower\"]"},
    };
};

template <>
struct FieldList<StretchCase> {
    using T = StretchCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"from", &T::from, "name of a section", any_value, {}, "near"},
        FieldEntry{
            "to", &T::to, "name of another section of the same channel", any_value, {}, "far"},
    };
};

}  // namespace tt
