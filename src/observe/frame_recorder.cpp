#include "observe/frame_recorder.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "fluid/moments.hpp"

namespace tt {
namespace {

std::vector<double> interleaved(const std::vector<double>& x, const std::vector<double>& y,
                                double unit) {
    std::vector<double> pairs;
    pairs.reserve(2 * x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
        pairs.push_back(x[n] * unit);
        pairs.push_back(y[n] * unit);
    }
    return pairs;
}

}  // namespace

Frame frame_of(const Snapshot& snapshot) {
    const State& state = snapshot.state();
    const Lattice& lattice = snapshot.model().lattice;
    const Scales& scales = snapshot.model().scales;
    const double speed = scales.unit(Velocity::dimension);
    const double pressure =
        scales.unit(Pressure::dimension) * d2q9::sound_speed_squared;  // p = c_s² δρ
    Frame frame;
    frame.time = snapshot.time().si;
    frame.step = snapshot.step();
    frame.nodes = interleaved(state.cells.x, state.cells.y, scales.length);
    frame.node_force = interleaved(state.cells.fx, state.cells.fy, scales.unit(Tension::dimension));
    frame.node_velocity = interleaved(state.cells.ux, state.cells.uy, speed);
    const std::size_t sites = static_cast<std::size_t>(lattice.nx) * lattice.ny;
    frame.velocity.resize(2 * sites);
    frame.pressure.resize(sites);
    frame.cytoplasm.resize(sites);
    // A run without cells has no field of cytoplasm.
    const bool cells = state.interior.fraction.size() > 0;
    for (int j = 0; j < lattice.ny; ++j) {
        const std::vector<double> density_deviation = density_deviations(state.populations, j);
        const double *const ux = state.velocity.x.row(j), *const uy = state.velocity.y.row(j);
        const std::size_t row = static_cast<std::size_t>(j) * lattice.nx;
        for (int i = 0; i < lattice.nx; ++i) {
            frame.velocity[2 * (row + i)] = static_cast<float>(ux[i] * speed);
            frame.velocity[2 * (row + i) + 1] = static_cast<float>(uy[i] * speed);
            frame.pressure[row + i] = static_cast<float>(density_deviation[i] * pressure);
        }
        if (!cells) continue;
        const double* const fraction = state.interior.fraction.row(j);
        for (int i = 0; i < lattice.nx; ++i)
            frame.cytoplasm[row + i] = static_cast<float>(fraction[i]);
    }
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
    header.first = state.cells.first;
    return header;
}

FrameRecorder::FrameRecorder(const Schedule& schedule, const std::filesystem::path& directory,
                             FramesHeader header, std::function<void(const std::string&)> say)
    : Observer(schedule), directory_(directory), header_(std::move(header)), say_(std::move(say)) {}

void FrameRecorder::start() { writer_.emplace(directory_, header_, 0); }

void FrameRecorder::resume(const ArchiveReader& archive) {
    writer_.emplace(directory_, header_, archive.value<std::int64_t>("frames.count"));
}

void FrameRecorder::observe(const Snapshot& snapshot) { writer_->write(frame_of(snapshot)); }

void FrameRecorder::save(ArchiveOutput& archive) const {
    archive.put_value("frames.interval", schedule().interval());
    archive.put_value("frames.count", writer_->count());
}

void FrameRecorder::finish() {
    try {
        writer_->merge();
    } catch (const IoError& error) {
        // Nothing is lost: frames.h5 reads the same as an index of the folder frames/.
        say_(fmt::format("frames.h5 stays an index of the folder frames/: {}", error.what()));
    }
}

}  // namespace tt
