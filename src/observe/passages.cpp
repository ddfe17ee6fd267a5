#include "observe/passages.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "io/csv.hpp"

namespace tt {
namespace {

struct LeftRow {
    Time time;
    std::int64_t cell = 0, kind = 0, port = 0;
    Length place;
    Velocity speed;
    Area area;
    double lambda_C = 1.0;
};
struct EnteredRow {
    Time time;
    std::int64_t cell = 0, kind = 0, port = 0;
    Length place;
    Area area;
};

}  // namespace

template <>
struct FieldList<LeftRow> {
    using R = LeftRow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"time", &R::time, "when it left"},
        FieldEntry{"cell", &R::cell, "its number"},
        FieldEntry{"kind", &R::kind, "number of its kind, in the order of the case, from 0"},
        FieldEntry{"port", &R::port, "number of the port, in the order of the case, from 0"},
        FieldEntry{"place", &R::place, "of its middle along the port, from the lower or left end"},
        FieldEntry{"speed", &R::speed, "through the port"},
        FieldEntry{"area", &R::area, "area"},
        FieldEntry{"lambda_C", &R::lambda_C, "perimeter extension ratio, its forces faded"},
    };
};
template <>
struct FieldList<EnteredRow> {
    using R = EnteredRow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"time", &R::time, "when its foremost node came to the port"},
        FieldEntry{"cell", &R::cell, "its number"},
        FieldEntry{"kind", &R::kind, "number of its kind, in the order of the case, from 0"},
        FieldEntry{"port", &R::port, "number of the port, in the order of the case, from 0"},
        FieldEntry{"place", &R::place, "of its middle along the port, from the lower or left end"},
        FieldEntry{"area", &R::area, "area"},
    };
};

namespace {

EventTable::Lines left_from(const Snapshot& snapshot, std::int64_t written) {
    const Scales& scales = snapshot.model().scales;
    const auto& departed = snapshot.state().departed;
    EventTable::Lines lines;
    for (auto k = static_cast<std::size_t>(written); k < departed.size(); ++k, ++lines.count) {
        const Departed& d = departed[k];
        lines.text += csv_row(
            LeftRow{Time{d.time * scales.time}, d.id, d.kind, d.exit, scales.to_si<Length>(d.place),
                    scales.to_si<Velocity>(d.speed), scales.to_si<Area>(d.area), d.lambda_C});
    }
    return lines;
}

/// Numbers are given one after the other as cells come, whichever way.
EventTable::Lines entered_from(const Snapshot& snapshot, std::int64_t written) {
    const Model& model = snapshot.model();
    const Scales& scales = model.scales;
    const auto& feeds = snapshot.state().feeds;
    std::int64_t first = std::numeric_limits<std::int64_t>::max() - written;
    for (const FeedState& feed : feeds)
        if (!feed.entered.empty()) first = std::min(first, feed.entered.front().id);
    std::vector<EnteredRow> rows;
    for (std::size_t n = 0; n < feeds.size(); ++n)
        for (auto e = feeds[n].entered.rbegin();
             e != feeds[n].entered.rend() && e->id >= first + written; ++e)
            rows.push_back({Time{e->time * scales.time}, e->id, e->kind, model.feeds[n].port,
                            scales.to_si<Length>(e->place), scales.to_si<Area>(e->area)});
    std::sort(rows.begin(), rows.end(),
              [](const EnteredRow& a, const EnteredRow& b) { return a.cell < b.cell; });
    EventTable::Lines lines;
    for (const EnteredRow& row : rows) lines.text += csv_row(row);
    lines.count = static_cast<std::int64_t>(rows.size());
    return lines;
}

}  // namespace

std::unique_ptr<EventTable> left_cells(const Schedule& schedule,
                                       const std::filesystem::path& directory) {
    return std::make_unique<EventTable>(schedule, directory, "left", csv_header<LeftRow>(),
                                        left_from);
}

std::unique_ptr<EventTable> entered_cells(const Schedule& schedule,
                                          const std::filesystem::path& directory) {
    return std::make_unique<EventTable>(schedule, directory, "entered", csv_header<EnteredRow>(),
                                        entered_from);
}

}  // namespace tt
