#include "observe/left_cells.hpp"

#include <string>
#include <tuple>

#include "io/csv.hpp"

namespace tt {
namespace {

struct LeftRow {
    Time time;
    std::int64_t cell = 0, port = 0;
    Length place;
    Velocity speed;
    Area area;
    double lambda_C = 1.0;
};

}  // namespace

template <>
struct FieldList<LeftRow> {
    using R = LeftRow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"time", &R::time, "when it left"},
        FieldEntry{"cell", &R::cell, "its number"},
        FieldEntry{"port", &R::port, "number of the port, in the order of the case, from 0"},
        FieldEntry{"place", &R::place, "of its middle along the port, from the lower or left end"},
        FieldEntry{"speed", &R::speed, "through the port"},
        FieldEntry{"area", &R::area, "area"},
        FieldEntry{"lambda_C", &R::lambda_C, "perimeter extension ratio, its forces faded"},
    };
};

LeftCells::LeftCells(const Schedule& schedule, const std::filesystem::path& directory)
    : Observer(schedule), table_(directory, "left") {}

void LeftCells::start() { table_.start(csv_header<LeftRow>()); }

void LeftCells::resume(const ArchiveReader& archive) {
    table_.resume(archive);
    written_ = archive.value<std::int64_t>("left.written");
}

void LeftCells::observe(const Snapshot& snapshot) {
    const Scales& scales = snapshot.model().scales;
    const auto& departed = snapshot.state().departed;
    std::string rows;
    for (; written_ < static_cast<std::int64_t>(departed.size()); ++written_) {
        const Departed& d = departed[static_cast<std::size_t>(written_)];
        const Exit& exit = snapshot.model().exits[static_cast<std::size_t>(d.exit)];
        const Vec2 along = exit.to - exit.from;
        // From the lower or left end, whichever way round the outline was drawn.
        const double place = along.x + along.y > 0.0 ? d.place : norm(along) - d.place;
        rows += csv_row(LeftRow{Time{d.time * scales.time}, d.id, d.exit,
                                scales.to_si<Length>(place), scales.to_si<Velocity>(d.speed),
                                scales.to_si<Area>(d.area), d.lambda_C});
    }
    if (!rows.empty()) table_.append(rows);
}

void LeftCells::save(ArchiveOutput& archive) const {
    table_.save(archive);
    archive.put_value("left.written", written_);
}

}  // namespace tt
