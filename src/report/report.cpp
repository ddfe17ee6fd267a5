#include "report/report.hpp"

#include "base/error.hpp"
#include "base/tell.hpp"
#include "io/file.hpp"
#include "report/figures.hpp"
#include "report/page.hpp"

namespace tt {

std::filesystem::path write_report(std::span<const std::filesystem::path> directories,
                                   const std::filesystem::path& out) {
    if (directories.empty()) throw IoError("a report needs at least one results directory");
    std::vector<Results> runs;
    for (const std::filesystem::path& directory : directories)
        runs.push_back(read_results(directory));
    for (const Results& run : runs)
        for (const std::string& fault : run.faults) tell_user("tanktread: {}\n", fault);
    std::filesystem::path place = out;
    if (place.empty())
        place = directories.size() == 1 ? directories.front() : std::filesystem::path("comparison");
    std::vector<Figure> figures;
    if (can_draw())
        figures = draw_figures(runs, place / "figures");
    else
        make_directory(place);
    const std::filesystem::path page = place / "report.html";
    replace_file(page, report_page(runs, figures, place / "figures", PageLimits{}),
                 Durability::process);
    return page;
}

}  // namespace tt
