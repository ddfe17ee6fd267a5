#include "observe/frame_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "base/error.hpp"
#include "fluid/moments.hpp"
#include "observe/all_cells.hpp"

namespace tt {
namespace {

template <class Real>
void add_flow(const Model& model, const Sites<Real>& sites, Frame& frame) {
    const Lattice& lattice = model.lattice;
    const Scales& scales = model.scales;
    const double speed = scales.unit(Velocity::dimension);
    const double pressure =
        scales.unit(Pressure::dimension) * d2q9::sound_speed_squared;  // p = c_s² δρ
    const std::size_t count = static_cast<std::size_t>(lattice.nx) * lattice.ny;
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    const Walls* const walls = model.boundaries.walls.get();
    frame.velocity.resize(2 * count, nothing);
    frame.pressure.resize(count, nothing);
    for (int j = 0; j < lattice.ny; ++j) {
        const std::vector<double> density_deviation = density_deviations(sites.populations, j);
        const Real *const ux = sites.velocity.x.row(j), *const uy = sites.velocity.y.row(j);
        const std::size_t row = static_cast<std::size_t>(j) * lattice.nx;
        for (int i = 0; i < lattice.nx; ++i) {
            if (walls && !walls->is_open(i, j)) continue;  // not a number
            frame.velocity[2 * (row + i)] = static_cast<float>(ux[i] * speed);
            frame.velocity[2 * (row + i) + 1] = static_cast<float>(uy[i] * speed);
            frame.pressure[row + i] = static_cast<float>(density_deviation[i] * pressure);
        }
    }
}

void add_cytoplasm(const Field<>& fraction, Frame& frame) {
    const Lattice& lattice = fraction.lattice();
    for (int j = 0; j < lattice.ny; ++j) {
        const std::size_t row = static_cast<std::size_t>(j) * lattice.nx;
        for (int i = 0; i < lattice.nx; ++i)
            frame.cytoplasm[row + i] = static_cast<float>(fraction(i, j));
    }
}

}  // namespace

Frame membranes_of(const Snapshot& snapshot) {
    const State& state = snapshot.state();
    const Scales& scales = snapshot.model().scales;
    const double speed = scales.unit(Velocity::dimension);
    Frame frame;
    frame.time = snapshot.time().si;
    frame.step = snapshot.step();
    const AllCells all = all_cells(state);
    const auto per_node = [&](const std::vector<double>& x, const std::vector<double>& y,
                              double unit) {
        return per_node_of_all(all, state.cells, x, y, unit);
    };
    frame.nodes = per_node(state.cells.x, state.cells.y, scales.length);
    frame.node_force = per_node(state.cells.fx, state.cells.fy, scales.unit(Tension::dimension));
    frame.node_velocity = per_node(state.cells.ux, state.cells.uy, speed);
    return frame;
}

Frame frame_of(const Snapshot& snapshot) {
    Frame frame = membranes_of(snapshot);
    const State& state = snapshot.state();
    std::visit([&](const auto& sites) { add_flow(snapshot.model(), sites, frame); }, state.sites);
    frame.cytoplasm.resize(frame.pressure.size());
    // A run without cells has no field of cytoplasm.
    if (state.interior.cytoplasm.size() > 0) add_cytoplasm(fraction_inside(state.interior), frame);
    return frame;
}

FramesHeader frames_header(const Model& model, const State& state, const std::string& name) {
    FramesHeader header;
    header.name = name;
    header.dx = model.scales.length;
    header.dt = model.scales.time;
    header.length = model.lattice.nx * model.scales.length;
    header.width = model.lattice.ny * model.scales.length;
    header.nx = model.lattice.nx;
    header.ny = model.lattice.ny;
    if (model.origin != Vec2{})
        for (const double coordinate : {model.origin.x, model.origin.y})
            header.origin.push_back(coordinate * model.scales.length);
    const AllCells all = all_cells(state);
    header.first = all.first;
    header.kind = all.kind;
    for (const CellKind& kind : model.kinds)
        header.kinds += (header.kinds.empty() ? "" : ",") + kind.name;
    if (const Walls* walls = model.boundaries.walls.get()) {
        header.wall_first = {0};
        for (const Loop& loop : solid_loops(walls->solid, header.nx, header.ny)) {
            for (const Vec2 p : loop)
                for (const double coordinate : {p.x, p.y})
                    header.walls.push_back(coordinate * model.scales.length);
            header.wall_first.push_back(header.wall_first.back() +
                                        static_cast<std::int32_t>(loop.size()));
        }
    }
    for (const double length : all.rest_length)
        header.rest_length.push_back(length * model.scales.length);
    return header;
}

FrameRecorder::FrameRecorder(const Schedule& schedule, std::optional<Schedule> fields,
                             const std::filesystem::path& directory, FramesHeader header,
                             std::function<void(const std::string&)> say)
    : Observer(schedule),
      fields_(fields),
      directory_(directory),
      header_(std::move(header)),
      say_(std::move(say)) {}

bool FrameRecorder::fields_due(std::int64_t step) const {
    if (!fields_) return false;
    const auto& before = writer_->times();
    return before.empty() || fields_->next_after(before.back().step) <= step;
}

void FrameRecorder::start() { writer_.emplace(directory_, header_, std::vector<FrameTime>{}); }

void FrameRecorder::resume(const ArchiveReader& archive) {
    const auto time = archive.take<double>("frames.time");
    const auto step = archive.take<std::int64_t>("frames.step");
    std::vector<FrameTime> kept;
    for (std::size_t k = 0; k < time.size(); ++k) kept.push_back({time[k], step[k]});
    writer_.emplace(directory_, header_, kept);
}

void FrameRecorder::observe(const Snapshot& snapshot) {
    const State& state = snapshot.state();
    if (state.cells.id.size() + state.departed.size() >= header_.first.size()) {  // more have come
        const FramesHeader now = frames_header(snapshot.model(), state, header_.name);
        header_.first = now.first;
        writer_->add_cells(now);
    }
    writer_->write(fields_due(snapshot.step()) ? frame_of(snapshot) : membranes_of(snapshot));
}

void FrameRecorder::sync() { writer_->sync(); }

void FrameRecorder::save(ArchiveOutput& archive) const {
    archive.put_value("frames.interval", schedule().interval());
    std::vector<double> time;
    std::vector<std::int64_t> step;
    for (const FrameTime& when : writer_->times()) {
        time.push_back(when.time);
        step.push_back(when.step);
    }
    archive.put("frames.time", time);
    archive.put("frames.step", step);
}

void FrameRecorder::examine(const ArchiveReader& archive) {
    interval_in(archive, "frames.interval");
    const auto time = archive.take<double>("frames.time");
    const auto step = archive.take<std::int64_t>("frames.step");
    const bool in_time = std::all_of(time.begin(), time.end(),
                                     [](double t) { return t >= 0.0 && std::isfinite(t); });
    const bool in_steps =
        std::all_of(step.begin(), step.end(), [](std::int64_t n) { return n >= 0; });
    if (time.size() != step.size() || !in_time || !in_steps)
        throw DamagedArchive("the checkpoint cannot be loaded: its list of frames is wrong");
}

void FrameRecorder::finish() {
    try {
        for (const std::string& fault : writer_->merge()) say_(fault);
    } catch (const IoError& error) {
        // Nothing is lost: frames.h5 reads the same as an index of the folder frames/.
        say_(fmt::format("frames.h5 stays an index of the folder frames/: {}", error.what()));
    }
}

}  // namespace tt
