#include "case/judge_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/feeds.hpp"
#include "case/table_names.hpp"

namespace tt {
namespace {

/// Of all cells, or of those of one kind.
void judge_positions_given(Judge& judge, const Case& c,
                           const std::vector<std::vector<Length>>& positions) {
    if (positions.empty())
        judge.tell(
            {"cells.layout"},
            fmt::format("layout = \"explicit\" needs the centre of each cell; write positions "
                        "= [[\"{}\", \"{}\"]]",
                        to_text(Length{0.5 * c.domain.length.si}),
                        to_text(Length{0.5 * c.domain.width.si})));
    for (const auto& position : positions)
        if (position.size() != 2) {
            judge.tell({"cells.positions"},
                       "each of positions is a pair, as in [[\"20 um\", \"10 um\"]]");
            break;
        }
}

/// Cells that are laid at random lie at any angle, and fit as they are at rest.
void judge_random(Judge& judge, const CellsCase& cells) {
    if (cells.angle.si != 0.0)
        judge.tell(
            {"cells.angle"},
            "angle means nothing with layout = \"random\", which turns each cell by an angle of "
            "its own; leave it out");
    if (cells.initial_stretch)
        judge.tell(
            {"cells.initial_stretch"},
            fmt::format("initial_stretch = {} is not possible with layout = \"random\", which "
                        "lays cells as they are at rest; leave it out, or write layout = "
                        "\"explicit\"",
                        to_text(*cells.initial_stretch)));
}

/// What a layout needs, whatever the kinds.
void judge_layout(Judge& judge, const Case& c) {
    const CellsCase& cells = c.cells;
    const bool single = std::holds_alternative<SingleCell>(cells.layout);
    if (single || std::holds_alternative<AtPositions>(cells.layout))
        judge.forbid("cells.hematocrit",
                     fmt::format("with layout = \"{}\"", word_of(cells.layout)));
    if (single && (cells.count.value_or(1) > 1 || c.kinds.size() > 1))
        judge.tell({"cells.count", "cells.layout"},
                   "layout = \"single\" is one cell; write layout = \"paper\" or \"random\"");
    if (std::holds_alternative<PaperRows>(cells.layout) && cells.count.value_or(2) % 2 != 0)
        judge.tell({"cells.count"},
                   fmt::format("layout = \"paper\" is two equal rows; write count = {}",
                               *cells.count + 1));
}

/// How many there are, where they are all alike.
void judge_number(Judge& judge, const Case& c) {
    const CellsCase& cells = c.cells;
    if (const auto* layout = std::get_if<AtPositions>(&cells.layout)) {
        judge_positions_given(judge, c, layout->positions);
        if (cells.count && !layout->positions.empty() &&
            *cells.count != static_cast<std::int64_t>(layout->positions.size()))
            judge.tell({"cells.count"},
                       fmt::format("count = {}, but there are {} positions; leave count out",
                                   *cells.count, layout->positions.size()));
    } else if (!std::holds_alternative<SingleCell>(cells.layout) && !judge.given("cells.count") &&
               !judge.given("cells.hematocrit")) {
        judge.tell({"cells.layout"},
                   fmt::format("layout = \"{}\" needs count = 12 or hematocrit = \"38 %\"",
                               word_of(cells.layout)));
    }
    if (std::holds_alternative<AtRandom>(cells.layout)) judge_random(judge, cells);
}

/// Where a kind is told about: its table has its name, or which it is.
std::string path_of(const Case& c, std::size_t n) {
    return fmt::format("kind.{}",
                       c.kinds[n].name.empty() ? fmt::format("{}", n + 1) : c.kinds[n].name);
}

void judge_names(Judge& judge, const Case& c) {
    for (std::size_t n = 0; n < c.kinds.size(); ++n) {
        const std::string& name = c.kinds[n].name;
        const auto same = [&](const KindCase& other) { return other.name == name; };
        if (name.empty())
            judge.tell({path_of(c, n)}, "a [[kind]] needs a name; write name = \"stiff\"");
        else if (!is_table_name(name))
            judge.tell({path_of(c, n) + ".name"},
                       fmt::format("the name of a kind has letters, digits, _ and -, at most {}; "
                                   "write name = \"stiff\"",
                                   longest_table_name));
        else if (std::count_if(c.kinds.begin(), c.kinds.begin() + static_cast<int>(n), same) > 0)
            judge.tell({path_of(c, n)},
                       fmt::format("there are two kinds '{}'; give them different names", name));
    }
}

/// Kinds that say where each of their cells is.
void judge_placed_kind(Judge& judge, const Case& c, std::size_t n) {
    const std::string path = path_of(c, n);
    judge.forbid(path + ".share", "with layout = \"explicit\"");
    judge_positions_given(judge, c, c.kinds[n].positions);
    const auto places = static_cast<std::int64_t>(c.kinds[n].positions.size());
    if (c.kinds[n].count && places > 0 && *c.kinds[n].count != places)
        judge.tell({path + ".count"},
                   fmt::format("count = {}, but there are {} positions; leave count out",
                               *c.kinds[n].count, places));
}

/// Kinds that say how many, or which share.
void judge_counted_kind(Judge& judge, const Case& c, std::size_t n) {
    const std::string path = path_of(c, n);
    if (!c.kinds[n].positions.empty())
        judge.forbid(path + ".positions", "without layout = \"explicit\" in [cells]");
    if (c.kinds[n].share && c.kinds[n].count)
        judge.tell({path + ".share"}, "count and share exclude each other; leave one out");
    if (!c.kinds[n].share && !c.kinds[n].count)
        judge.tell({path}, fmt::format("how many cells of kind '{}' are there? Write share = "
                                       "\"10 %\" of all, or count = 3",
                                       c.kinds[n].name));
    if (!std::holds_alternative<AtRandom>(c.cells.layout)) return;
    judge.look_at_kind(c.kinds[n].name);
    CellsCase cells = c.cells;
    static_cast<CellTypeCase&>(cells) = c.kinds[n];
    judge_random(judge, cells);
    judge.look_at_kind({});
}

/// Whether shares add up, and to what.
void judge_shares(Judge& judge, const Case& c) {
    double sum = 0.0;
    std::int64_t counted = 0;
    bool any = false;
    for (const KindCase& kind : c.kinds) {
        sum += kind.share.value_or(0.0);
        counted += kind.count.value_or(0);
        any = any || kind.share;
    }
    const std::string first = path_of(c, 0);
    const bool total = judge.given("cells.count") || judge.given("cells.hematocrit");
    if (any && std::abs(sum - 1.0) > 1e-9) {
        const KindCase& last = *std::find_if(c.kinds.rbegin(), c.kinds.rend(),
                                             [](const KindCase& kind) { return bool(kind.share); });
        const double rest = 1.0 - (sum - *last.share);
        judge.tell({"kind." + last.name + ".share"},
                   fmt::format("the shares of the kinds add up to {:.6g} %, not to 100 %; write {}",
                               100.0 * sum,
                               rest > 0.0 ? fmt::format("share = \"{:.6g} %\"", 100.0 * rest)
                                          : std::string("smaller ones")));
    }
    if (any && !total)
        judge.tell({first},
                   "share is of the cells that [cells] asks for; write hematocrit = \"38 "
                   "%\" or count = 12 there");
    if (!any && c.cells.hematocrit)
        judge.tell({"cells.hematocrit"},
                   "hematocrit means nothing where every kind has its count; leave it out, or "
                   "write share instead of count");
    if (!any && c.cells.count && *c.cells.count != counted)
        judge.tell({"cells.count"}, fmt::format("count = {}, but the kinds have {} cells; leave "
                                                "count out",
                                                *c.cells.count, counted));
    if (std::holds_alternative<PaperRows>(c.cells.layout) && !any && counted % 2 != 0)
        judge.tell({first}, "layout = \"paper\" is two equal rows; write an even number of cells");
}

void judge_pairs(Judge& judge, const Case& c) {
    for (std::size_t n = 0; n < c.contact.pairs.size(); ++n) {
        const std::string path = fmt::format("contact.pair.{}", n + 1);
        const std::vector<std::string>& kinds = c.contact.pairs[n].kinds;
        if (c.contact.morse() == nullptr)
            judge.tell({path}, "[[contact.pair]] means nothing with model = \"none\"");
        if (kinds.size() != 2)
            judge.tell({path + ".kinds", path},
                       "a pair has two kinds; write kinds = [\"white\", \"red\"]");
        for (const std::string& name : kinds)
            if (std::none_of(c.kinds.begin(), c.kinds.end(),
                             [&](const KindCase& kind) { return kind.name == name; }))
                judge.tell({path + ".kinds"},
                           c.kinds.empty()
                               ? fmt::format("there is no [[kind]], and so none named '{}'", name)
                               : fmt::format("there is no [[kind]] named '{}'; there are {}", name,
                                             listed_names(c.kinds)));
    }
}

void judge_all_kinds(Judge& judge, const Case& c) {
    judge_names(judge, c);
    const bool placed = std::holds_alternative<AtPositions>(c.cells.layout);
    if (placed)
        judge.forbid("cells.positions", "where there are kinds (each has positions of its own)");
    for (std::size_t n = 0; n < c.kinds.size(); ++n)
        placed ? judge_placed_kind(judge, c, n) : judge_counted_kind(judge, c, n);
    if (!placed) judge_shares(judge, c);
    for (const PortCase& port : c.ports)
        for (std::size_t n = 0; n < c.kinds.size(); ++n)
            if (lets_cells_in(c, port) && c.kinds[n].count)
                judge.tell({path_of(c, n) + ".count"},
                           fmt::format("port '{}' feeds cells of each kind by their share; write "
                                       "share instead of count",
                                       port.name));
}

}  // namespace

void judge_cells(Judge& judge, const Case& c) {
    judge_pairs(judge, c);
    if (c.numerics.fluid_only) return;
    if (!judge.given_any("cells.") && c.kinds.empty())
        return judge.tell({},
                          "there is no [cells]; write one, or fluid_only = true in [numerics] for "
                          "a plain channel");
    judge_layout(judge, c);
    if (c.kinds.empty())
        judge_number(judge, c);
    else
        judge_all_kinds(judge, c);
}

}  // namespace tt
