#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "case/case.hpp"
#include "case/channel_flow.hpp"

namespace tt {

/// Where each key that the user gave was written: "flow.drive" → file, line and column, with an
/// empty message. Keys set to "auto" are not among them.
using Places = std::map<std::string, Fault, std::less<>>;

/// Keys of one table of which at most one may be given; an override of one takes the place of the
/// others.
struct Exclusive {
    std::string_view table;
    std::span<const std::string_view> keys;
};
inline constexpr std::array<std::string_view, 2> shear_keys{"shear_rate", "shear_number"};
inline constexpr std::array<std::string_view, 2> number_keys{"count", "hematocrit"};
inline constexpr std::array exclusive_keys{
    Exclusive{"flow", channel_flow_keys},
    Exclusive{"flow", shear_keys},
    Exclusive{"cells", number_keys},
};

/// Keys that contradict each other, lack each other, or mean nothing together. Looks only at which
/// keys are given and at the words chosen, so it may run on a case some of whose numbers could not
/// be read.
std::vector<Fault> find_conflicts(const Case& given, const Places& places, const std::string& file);

/// Values that cannot be together: cells that do not fit, a file that is not there, an end before
/// the beginning.
std::vector<Fault> find_impossibilities(const Case& given, const Places& places,
                                        const std::string& file);

}  // namespace tt
