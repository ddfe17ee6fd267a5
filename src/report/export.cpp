#include "report/export.hpp"

#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/file.hpp"
#include "report/frames.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
std::string nodes_table(const FramesHeader& header, const Frame& frame) {
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "cell,node,x [m],y [m],force_x [N/m],force_y [N/m],"
                   "velocity_x [m/s],velocity_y [m/s]\n");
    for (int c = 0; c < cell_count(header); ++c) {
        const auto begin = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c)]);
        const auto end = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c) + 1]);
        for (std::size_t k = begin; k < end; ++k) {
            fmt::format_to(out, "{},{},{:.10g},{:.10g},{:.9g},{:.9g},{:.9g},{:.9g}\n", c, k - begin,
                           frame.nodes[2 * k], frame.nodes[2 * k + 1], frame.node_force[2 * k],
                           frame.node_force[2 * k + 1], frame.node_velocity[2 * k],
                           frame.node_velocity[2 * k + 1]);
        }
    }
    return fmt::to_string(text);
}

std::string fields_table(const FramesHeader& header, const Frame& frame) {
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "x [m],y [m],velocity_x [m/s],velocity_y [m/s],pressure [Pa],cytoplasm\n");
    for (int j = 0; j < header.ny; ++j)
        for (int i = 0; i < header.nx; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * header.nx + i;
            fmt::format_to(out, "{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n",
                           (i + 0.5) * header.dx, (j + 0.5) * header.dx, frame.velocity[2 * site],
                           frame.velocity[2 * site + 1], frame.pressure[site],
                           frame.cytoplasm[site]);
        }
    return fmt::to_string(text);
}

/// How every README.txt of an export begins.
constexpr std::string_view our_readme = "Frames of a tanktread run";

constexpr const char* csv_readme = R"(Frames of a tanktread run as plain tables, SI units.

frames.csv         frame   number that the other files carry
                   time    [s]
                   step    time step
nodes_NNNNNN.csv   membrane nodes, counter-clockwise around each cell
                   cell, node              numbers from 0
                   x, y                    position [m]; x counts on when a cell leaves through an end
                   force_x, force_y        force of the node on the fluid, per unit depth [N/m]
                   velocity_x, velocity_y  [m/s]
fields_NNNNNN.csv  of the frames that hold fields: sites of the lattice, row after row from the bottom wall
                   x, y                    position [m]; walls stand half a spacing beyond the end rows
                   velocity_x, velocity_y  [m/s]
                   pressure                above its value at rest [Pa]
                   cytoplasm               share of cytoplasm at the site, 0 to 1
)";

/// Removes `before`NNNNNN`behind`, six digits or more, from a folder.
void remove_numbered(const fs::path& folder, std::string_view before, std::string_view behind) {
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(before) || !name.ends_with(behind)) continue;
        const std::string_view number = std::string_view(name).substr(
            before.size(), name.size() - before.size() - behind.size());
        if (number.size() >= 6 && number.find_first_not_of("0123456789") == std::string_view::npos)
            old.push_back(entry.path());
    }
    for (const fs::path& path : old) fs::remove(path);
}

}  // namespace

void begin_export(const fs::path& out, std::string_view readme,
                  std::span<const NumberedFiles> earlier) {
    const fs::path note = out / "README.txt";
    if (fs::exists(out) && !fs::is_directory(out))
        throw IoError(fmt::format("'{}' is a file; name a folder with -o, which the export makes",
                                  out.string()));
    const bool empty = !fs::exists(out) || fs::is_empty(out);
    const bool ours = fs::exists(note) && read_file(note).starts_with(our_readme);
    if (!empty && !ours)
        throw IoError(
            fmt::format("'{}' holds files of others; name another folder with -o, which "
                        "the export makes",
                        out.string()));
    make_directory(out);
    write_text(note, readme);
    for (const NumberedFiles& files : earlier) {
        const fs::path folder = out / files.folder;
        if (!fs::exists(folder)) continue;
        remove_numbered(folder, files.before, files.behind);
        if (*files.folder != '\0' && fs::is_empty(folder)) fs::remove(folder);
    }
}

void export_csv(const fs::path& directory, const fs::path& out) {
    const auto opened = open_frames(directory);
    const FramesReader& frames = *opened;
    constexpr NumberedFiles earlier[] = {{"", "nodes_", ".csv"}, {"", "fields_", ".csv"}};
    begin_export(out, csv_readme, earlier);
    std::string index = "frame,time [s],step\n";
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.frame(k);
        const std::int64_t number = frames.number(k);
        index += fmt::format("{},{:.10g},{}\n", number, frame.time, frame.step);
        write_text(out / fmt::format("nodes_{:06d}.csv", number),
                   nodes_table(frames.header(), frame));
        if (!frame.velocity.empty())
            write_text(out / fmt::format("fields_{:06d}.csv", number),
                       fields_table(frames.header(), frame));
    }
    write_text(out / "frames.csv", index);
}

}  // namespace tt
