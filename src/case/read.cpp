#include "case/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/letter.hpp"
#include "base/words.hpp"
#include "base/units.hpp"
#include "case/drawn_file.hpp"
#include "case/kinds.hpp"
#include "case/read_outline.hpp"
#include "case/reader.hpp"
#include "case/run_name.hpp"
#include "case/schema.hpp"
#include "case/validate.hpp"
#include "io/file.hpp"
#include "io/toml.hpp"

namespace tt {
namespace {

using Kind = TomlNode::Kind;

/// Takes the keys that exclude `path` out of the file's tree.
void remove_excluded(TomlNode& root, std::string_view path) {
    const std::string_view name = path.substr(0, path.find('.'));
    const std::string_view key = path.substr(std::min(name.size() + 1, path.size()));
    for (const Exclusive& exclusive : exclusive_keys) {
        const auto among = [&](std::string_view word) {
            return std::find(exclusive.keys.begin(), exclusive.keys.end(), word) !=
                   exclusive.keys.end();
        };
        if (name != exclusive.table || !among(key)) continue;
        std::erase_if(root.find(name)->value.entries, [&](const TomlEntry& e) {
            return e.key != key && among(e.key) && e.origin.empty();
        });
    }
}

/// The one of [[kind]] with this name, or of this number from 1 on.
TomlNode* table_in_list(TomlNode& list, std::string_view name) {
    for (std::size_t n = 0; n < list.items.size(); ++n) {
        const TomlEntry* own = list.items[n].find("name");
        if (own ? own->value.text == name : name == fmt::format("{}", n + 1)) return &list.items[n];
    }
    return nullptr;
}

/// Puts "table.key=value" into the tree as if the file had it.
void apply_override(TomlNode& root, const std::string& text, std::vector<Fault>& faults) {
    const std::string origin = origin_of(text);
    const std::size_t equals = text.find('=');
    const std::string path = text.substr(0, equals);
    const auto keys = split(path, '.');
    if (equals == std::string::npos || keys.empty() || keys.size() > 4 ||
        std::any_of(keys.begin(), keys.end(), [](std::string_view k) { return k.empty(); })) {
        faults.push_back(
            {origin, 0, 0,
             "write --set table.key=value, as in --set flow.pseudo_shear_rate=\"150 /s\""});
        return;
    }
    TomlNode* table = &root;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (table->kind == Kind::array) {
            TomlNode* item = table_in_list(*table, keys[i]);
            if (!item || i + 1 == keys.size()) {
                faults.push_back({origin, 0, 0,
                                  fmt::format("there is no [[{}]] '{}' of which a key could be set",
                                              fmt::join(keys.begin(), keys.begin() + i, "."),
                                              readable(keys[i]))});
                return;
            }
            table = item;
            continue;
        }
        TomlEntry* entry = table->find(keys[i]);
        if (entry == nullptr) {
            table->entries.push_back({std::string(keys[i]), 0, 0, {}, origin});
            entry = &table->entries.back();
        }
        const bool list = entry->value.kind == Kind::array;
        if (i + 1 < keys.size() && entry->value.kind != Kind::table && !list) {
            entry->origin = origin;
            entry->value = TomlNode{};  // the reader tells that it is no table
        }
        if (i + 1 == keys.size()) {
            entry->origin = origin;
            entry->value = parse_toml_value(text.substr(equals + 1));
        }
        table = &entry->value;
    }
    remove_excluded(root, path);
}

/// In the order of the file; options of the command line last.
void sort_faults(std::vector<Fault>& faults) {
    std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
        return std::tuple(a.line == 0, a.line, a.column) <
               std::tuple(b.line == 0, b.line, b.column);
    });
}

std::string default_name(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    const std::string folder = file.parent_path().filename().string();
    return name_from(stem == "case" && !folder.empty() && folder != "." ? folder : stem);
}

/// A name that was not given is made from that of the file; one that cannot be read has its fault
/// already.
void judge_name(const TomlNode& root, Reader<Case>& reader, Case& c, const std::string& file) {
    const TomlEntry* given = root.find("name");
    if (given == nullptr) {
        c.name = default_name(file);
    } else if (given->value.kind == Kind::string || !c.name.empty()) {
        const auto fault = fault_of_name(c.name);
        if (!fault) return;
        reader.faults.push_back(reader.places.at("name"));
        reader.faults.back().message = *fault;
    }
}

/// The box must be given, but for channels between ports: theirs is the extent of the drawing.
void judge_box(const TomlNode& root, Reader<Case>& reader, const Case& c, const std::string& file) {
    if (c.network() || !c.geometry.port_names().empty()) return;
    const TomlEntry* header = root.find("domain");
    const auto missing = [&](const char* key, Length value, const char* example) {
        const std::string path = fmt::format("domain.{}", key);
        if (value.si > 0.0 || reader.places.count(path) > 0) return;
        Fault fault{file, header ? header->line : 0, header ? header->column : 0, {}};
        if (header && !header->origin.empty()) fault = {header->origin, 0, 0, {}};
        fault.message =
            fmt::format("{} is missing from [domain]; write {} = \"{}\"", key, key, example);
        // Before those of the tables below it.
        reader.faults.insert(reader.faults.begin(), std::move(fault));
    };
    missing("width", c.domain.width, "20 um");
    missing("length", c.domain.length, "80 um");
}

/// Length and width of a network, into the case. Returns what contradicts them.
std::vector<Fault> fit_box(Case& c, const Places& places) {
    std::vector<Fault> faults;
    for (auto& [key, why] : c.geometry.faults()) {
        const auto place = places.find(fmt::format("geometry.{}", key));
        faults.push_back(place != places.end() ? place->second : places.at("geometry.shape"));
        faults.back().message = std::move(why);
    }
    const std::vector<Loop> channels = c.geometry.channels();
    if (!c.network() || channels.empty()) return faults;
    const Corners corners = corners_of(channels);
    const auto fit = [&](const char* key, double drawn_size, Length& size) {
        const auto place = places.find(fmt::format("domain.{}", key));
        if (place != places.end() && std::fabs(size.si - drawn_size) > 1e-6 * drawn_size) {
            faults.push_back(place->second);
            faults.back().message =
                fmt::format("{} = {}, but the drawing takes {}; leave {} out", key, to_text(size),
                            rounded_text(Length{drawn_size}, 6), key);
        }
        size.si = std::nearbyint(drawn_size * 1e15) / 1e15;  // of a sum of decimals
    };
    fit("length", corners.high.x - corners.low.x, c.domain.length);
    fit("width", corners.high.y - corners.low.y, c.domain.width);
    constexpr double smallest = 1e-6, largest = 0.1;
    const double size = std::max(c.domain.length.si, c.domain.width.si);
    if (size < smallest || size > largest) {
        const auto file = places.find("geometry.file");
        faults.push_back(file != places.end() ? file->second : places.at("geometry.shape"));
        faults.back().message = fmt::format(
            "what is drawn is {} long and {} wide; look at the unit of its numbers, and write unit "
            "= \"1 um\" or another in [geometry]",
            rounded_text(c.domain.length, 3), rounded_text(c.domain.width, 3));
    }
    return faults;
}

/// The sections and forks that a shape of channels brings, but for those of which the case has one
/// of the same name.
void add_sections_of_shape(Case& c) {
    const auto drawing = c.geometry.drawing();
    if (!drawing || !c.network()) return;
    const auto add = [](const auto& own, auto& given) {
        for (const auto& item : own)
            if (std::none_of(given.begin(), given.end(),
                             [&](const auto& other) { return other.name == item.name; }))
                given.push_back(item);
    };
    add(drawing->sections, c.sections);
    add(drawing->forks, c.forks);
}

/// The outline that `file` of the table `path` names, into it. Its own area is the size of the
/// cells. Returns what is wrong with it.
std::vector<Fault> read_shape_file(CellTypeCase& cells, const std::string& path,
                                   const Places& places) {
    auto* shape = std::get_if<OutlineShape>(&cells.shape);
    if (!shape || shape->file.empty()) return {};
    try {
        const std::filesystem::path file = shape->file;
        shape->outline = read_outline(read_file(file, Author::user), shown(file), *shape);
    } catch (const CaseError& error) {
        return error.faults();
    } catch (const IoError& error) {
        const auto place = places.find(path + ".file");  // else that of [cells]
        Fault fault = place != places.end() ? place->second : places.at("cells.file");
        fault.message = fmt::format("{}; file names the points of an outline", error.what());
        return {fault};
    }
    const Length radius{measures_of(*shape->outline).radius};
    if (places.count(path + ".radius") > 0 &&
        std::abs(cells.radius.si - radius.si) > 1e-6 * radius.si)
        shape->outline->remarks.push_back(fmt::format(
            "radius = {} in [{}] is not used: the outline of {} has the area of a circle of {}. "
            "Leave radius out.",
            to_text(cells.radius), path, shape->outline->file, rounded_text(radius)));
    cells.radius = radius;
    return {};
}

/// The same of [cells] and of every kind.
std::vector<Fault> read_shape_files(Case& c, const Places& places) {
    std::vector<Fault> faults = read_shape_file(c.cells, "cells", places);
    for (KindCase& kind : c.kinds)
        for (Fault& fault : read_shape_file(kind, "kind." + kind.name, places))
            faults.push_back(std::move(fault));
    return faults;
}

}  // namespace

std::string origin_of(const std::string& item) { return "--set " + readable(item); }

Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides, const std::filesystem::path& directory) {
    TomlText toml = parse_toml(text, name);
    std::vector<Fault> faults = toml.faults;
    for (const std::string& item : overrides) apply_override(toml.root, item, faults);
    Case result;
    const bool whole = toml.faults.empty();
    if (whole || !toml.root.entries.empty()) {
        Reader<Case> reader(name);
        reader.read_table(toml.root, nullptr, "", result);
        judge_name(toml.root, reader, result, name);
        judge_box(toml.root, reader, result, name);
        for (CellTypeCase* cells : cell_types(result))
            if (auto* shape = std::get_if<OutlineShape>(&cells->shape);
                shape && !shape->file.empty())
                shape->file = (directory / shape->file).lexically_normal().string();
        if (auto* drawn = std::get_if<DrawnShape>(&result.geometry.shape);
            drawn && !drawn->file.empty())
            drawn->file = (directory / drawn->file).lexically_normal().string();
        const bool read = reader.faults.empty();
        std::vector<Fault> outline_faults;
        if (read && !directory.empty()) {
            outline_faults = read_shape_files(result, reader.places);
            for (Fault& fault : read_drawn(result, reader.places))
                outline_faults.push_back(std::move(fault));
            for (Fault& fault : fit_box(result, reader.places))
                outline_faults.push_back(std::move(fault));
        }
        if (read) add_sections_of_shape(result);
        if (read && directory.empty() && !result.geometry.port_names().empty())
            outline_faults = fit_box(result, reader.places);
        // Where a line could not be read as TOML, a key may only seem to be missing.
        if (!whole)
            reader.faults.erase(std::remove_if(reader.faults.begin(), reader.faults.end(),
                                               [](const Fault& f) {
                                                   return f.message.find(" is missing from ") !=
                                                          std::string::npos;
                                               }),
                                reader.faults.end());
        const auto append = [&](std::vector<Fault> more) {
            faults.insert(faults.end(), std::make_move_iterator(more.begin()),
                          std::make_move_iterator(more.end()));
        };
        append(std::move(reader.faults));
        if (whole) append(find_conflicts(result, reader.places, name));
        const bool sized = result.domain.length.si > 0.0 && result.domain.width.si > 0.0;
        if (whole && read && sized) append(find_impossibilities(result, reader.places, name));
        sort_faults(faults);
        append(std::move(outline_faults));
    }
    if (!faults.empty()) throw CaseError(std::move(faults));
    return result;
}

Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    return parse_case(read_file(path, Author::user), path.string(), overrides,
                      std::filesystem::absolute(path).parent_path());
}

}  // namespace tt
