#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "base/undefined.hpp"
#include "case/reader.hpp"
#include "case/targets.hpp"

namespace tt {

/// [search]
struct SearchTable {
    std::vector<double> D, beta;
    std::vector<std::int64_t> seeds;
    std::int64_t first_pairs = SearchLimits{}.first;
    std::int64_t most_pairs = SearchLimits{}.most;
    double tolerance = SearchLimits{}.tolerance;
};

/// [[target]]
struct TargetTable {
    std::string quantity;
    Measure value{undefined, {}};
    Measure uncertainty;
    std::vector<std::string> set;
};

/// The file as it stands.
struct TargetsText {
    std::int64_t format = 1;
    std::string name;
    std::string case_file;
    std::vector<std::string> set;
    SearchTable search;
    std::vector<TargetTable> target;
};

template <>
struct FieldList<SearchTable> {
    using T = SearchTable;
    static constexpr auto entries = std::tuple{
        FieldEntry{"D", &T::D, "from, to", Range{1e-6, 1e3}, {}, "[0.1, 2]"},
        FieldEntry{"beta", &T::beta, "from, to", Range{1e-3, 200.0}, {}, "[5, 30]"},
        FieldEntry{"seeds", &T::seeds, "averaged over", Range{0.0, 9e15}, {}, "[1, 2, 3]"},
        FieldEntry{"first_pairs", &T::first_pairs, "tried evenly", Range{4.0, 1e4}, {}, "12"},
        FieldEntry{"most_pairs", &T::most_pairs, "tried in all", Range{4.0, 1e4}, {}, "40"},
        FieldEntry{"tolerance",
                   &T::tolerance,
                   "of the minimum, in standard uncertainties",
                   Range{0.0, 3.0, true, false},
                   {},
                   "0.2"},
    };
};

template <>
struct FieldList<TargetTable> {
    using T = TargetTable;
    static constexpr auto entries = std::tuple{
        FieldEntry{"quantity", &T::quantity, "of summary.json", any_value, "", "lambda_C"},
        FieldEntry{"value", &T::value, "its mean", any_value, "", "1.083"},
        FieldEntry{"uncertainty", &T::uncertainty, "one standard deviation", positive, "", "0.01"},
        FieldEntry{"set", &T::set, "in place of the case's", any_value, "",
                   "[\"flow.pseudo_shear_rate=150 /s\"]"},
    };
};

template <>
struct FieldList<TargetsText> {
    using T = TargetsText;
    static constexpr auto entries = std::tuple{
        FieldEntry{"format", &T::format, "of this file", Range{1.0, 1.0}, {}, "1"},
        FieldEntry{"name", &T::name, "of the results", any_value, "", "hardening"},
        FieldEntry{"case", &T::case_file, "the case file", any_value, "", "channel.toml"},
        FieldEntry{"set", &T::set, "for all targets", any_value, "", "[\"numerics.dx=0.4 um\"]"},
        FieldEntry{"search", &T::search, "where and how long"},
        FieldEntry{"target", &T::target, "a number to be met"},
    };
};

}  // namespace tt
