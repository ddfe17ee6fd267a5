#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/validate.hpp"

namespace tt {

/// Collects faults at the places of the keys they are about.
class Judge {
public:
    Judge(const Places& places, const std::string& file) : places_(places), file_(file) {}

    /// From here on it is about the cells of one kind: keys of [cells] and [membrane] are looked
    /// for in its table first, and faults name it. Empty: no longer.
    void look_at_kind(const std::string& name) { kind_ = name; }

    /// How the table of this name is called there.
    std::string table(const std::string& path) const {
        if (kind_.empty()) return path;
        return path == "membrane" ? "kind"
                                  : "kind" + path.substr(std::min(path.find('.'), path.size()));
    }

    bool given(std::string_view path) const { return place_of(path) != places_.end(); }

    /// Whether any key of a table was given.
    bool given_any(std::string_view table) const {
        const auto it = places_.lower_bound(table);
        return it != places_.end() && it->first.substr(0, table.size()) == table;
    }

    /// A fault at the first of `paths` that was given; else of the file as a whole.
    void tell(std::initializer_list<std::string_view> paths, std::string message) {
        Fault fault{file_, 0, 0, {}};
        for (const std::string_view path : paths) {
            const auto it = place_of(path);
            if (it == places_.end()) continue;
            fault = it->second;
            break;
        }
        fault.message =
            kind_.empty() ? std::move(message) : fmt::format("kind '{}': {}", kind_, message);
        faults.push_back(std::move(fault));
    }

    /// A key that means nothing here.
    void forbid(std::string_view path, const std::string& why) {
        if (given(path))
            tell({path}, fmt::format("{} means nothing {}; leave it out", key(path), why));
    }

    static std::string_view key(std::string_view path) { return path.substr(path.rfind('.') + 1); }

    std::vector<Fault> faults;

private:
    Places::const_iterator place_of(std::string_view path) const {
        const std::string_view table = path.substr(0, path.find('.'));
        if (!kind_.empty() && (table == "cells" || table == "membrane")) {
            const auto own = places_.find(fmt::format(
                "kind.{}.{}", kind_, path.substr(std::min(table.size() + 1, path.size()))));
            if (own != places_.end()) return own;
        }
        return places_.find(path);
    }

    const Places& places_;
    const std::string& file_;
    std::string kind_;
};

}  // namespace tt
