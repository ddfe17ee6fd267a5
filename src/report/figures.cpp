#include "report/figures.hpp"

#include <algorithm>

#include "io/file.hpp"

namespace tt {

std::vector<std::string> run_labels(std::span<const Results> runs) {
    std::vector<std::string> labels;
    for (const Results& run : runs) {
        const auto same = std::count_if(runs.begin(), runs.end(),
                                        [&](const Results& r) { return r.name == run.name; });
        const auto folder =
            std::filesystem::absolute(run.directory / "").parent_path().filename().string();
        labels.push_back(same > 1 && folder != run.name ? run.name + " (" + folder + ")"
                                                        : run.name);
    }
    return labels;
}

Column scaled(Column values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}

void key_below(LineFigure& figure, std::size_t runs) {
    figure.key_rows = static_cast<int>(runs + 1) / 2;
    figure.commands.push_back("set key outside bottom center horizontal maxcols 2 samplen 1.8");
}

TimeUnit time_unit(double longest) {
    if (longest >= 1.0) return {1.0, "s"};
    if (longest >= 1e-3) return {1e3, "ms"};
    return {1e6, "μs"};
}

std::vector<Figure> draw_figures(std::span<const Results> runs, const std::filesystem::path& out) {
    make_directory(out);
    write_style(out);
    std::vector<Figure> drawn;
    if (runs.size() == 1) draw_flow(runs.front(), out, drawn);
    if (runs.size() == 1) draw_paths(runs.front(), out, drawn);
    if (runs.size() == 1) draw_forks(runs.front(), out, drawn);
    draw_series(runs, out, drawn);
    draw_profiles(runs, out, drawn);
    return drawn;
}

}  // namespace tt
