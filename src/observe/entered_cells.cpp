#include "observe/entered_cells.hpp"

#include <algorithm>
#include <string>
#include <tuple>

#include "io/csv.hpp"

namespace tt {
namespace {

struct EnteredRow {
    Time time;
    std::int64_t cell = 0, port = 0;
    Length place;
    Area area;
};

}  // namespace

template <>
struct FieldList<EnteredRow> {
    using R = EnteredRow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"time", &R::time, "when its foremost node came to the port"},
        FieldEntry{"cell", &R::cell, "its number"},
        FieldEntry{"port", &R::port, "number of the port, in the order of the case, from 0"},
        FieldEntry{"place", &R::place, "of its middle along the port, from the lower or left end"},
        FieldEntry{"area", &R::area, "area"},
    };
};

EnteredCells::EnteredCells(const Schedule& schedule, const std::filesystem::path& directory)
    : Observer(schedule), table_(directory, "entered") {}

void EnteredCells::start() { table_.start(csv_header<EnteredRow>()); }

void EnteredCells::resume(const ArchiveReader& archive) {
    table_.resume(archive);
    written_ = archive.value<std::int64_t>("entered.written");
}

void EnteredCells::observe(const Snapshot& snapshot) {
    const Model& model = snapshot.model();
    const Scales& scales = model.scales;
    // Numbers are given as cells come, whichever way.
    std::vector<EnteredRow> rows;
    for (std::size_t n = 0; n < model.feeds.size(); ++n) {
        const Feed& feed = model.feeds[n];
        const Exit& port = model.exits[static_cast<std::size_t>(feed.port)];
        const double low =
            feed.in.x != 0.0 ? std::min(port.from.y, port.to.y) : std::min(port.from.x, port.to.x);
        for (const Entered& e : snapshot.state().feeds[n].entered)
            rows.push_back({Time{e.time * scales.time}, e.id, feed.port,
                            scales.to_si<Length>(e.place - low), scales.to_si<Area>(e.area)});
    }
    std::sort(rows.begin(), rows.end(),
              [](const EnteredRow& a, const EnteredRow& b) { return a.cell < b.cell; });
    std::string text;
    for (; written_ < static_cast<std::int64_t>(rows.size()); ++written_)
        text += csv_row(rows[static_cast<std::size_t>(written_)]);
    if (!text.empty()) table_.append(text);
}

void EnteredCells::save(ArchiveOutput& archive) const {
    table_.save(archive);
    archive.put_value("entered.written", written_);
}

}  // namespace tt
