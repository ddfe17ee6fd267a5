#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "app/calibration.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

/// χ² − least on a grid, for the contours.
std::string map_text(const Calibration& c) {
    constexpr int steps = 100;
    std::string text = "# D, beta, chi2 - least, from the surfaces\n";
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            const Vec2 p{static_cast<double>(i) / steps, static_cast<double>(j) / steps};
            text += fmt::format(
                "{:.6g} {:.6g} {:.6g}\n", c.targets.D.value(p.x), c.targets.beta.value(p.y),
                c.search.landscape().misfit(p) - c.search.standpoint().estimate.misfit);
        }
        text += '\n';
    }
    return text;
}

std::string pair_text(const TriedPair& pair) { return fmt::format("{} {}\n", pair.D, pair.beta); }

/// Blocks of points: the valley, the pairs tried, the best of them, those that failed.
std::string points_text(const Calibration& c) {
    std::string text = "# the best beta for each D\n";
    for (const ValleyPoint& p : valley_of(c, 101))
        text += p.at_end ? "\n" : fmt::format("{:.6g} {:.6g}\n", p.D, p.beta);
    std::string tried, failed;
    for (const TriedPair& pair : c.pairs) (pair.found.empty() ? failed : tried) += pair_text(pair);
    text += "\n\n# pairs tried\n" + tried + "\n\n# the best of them\n" + pair_text(c.best());
    return failed.empty() ? text : text + "\n\n# pairs that failed\n" + failed;
}

/// Round numbers: on a logarithmic axis of a decade gnuplot names too few.
std::string tics_text(const LogRange& range) {
    std::string text;
    const int first = static_cast<int>(std::floor(std::log10(range.low)));
    const int last = static_cast<int>(std::floor(std::log10(range.high)));
    const bool narrow = range.high < 20.0 * range.low;
    for (int decade = first; decade <= last; ++decade)
        for (const double digit : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0}) {
            const double tic = digit * std::pow(10.0, decade);
            if (tic < range.low || tic > range.high) continue;
            if (!narrow && (digit == 1.5 || digit == 3.0 || digit == 7.0)) continue;
            text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", tic);
        }
    return "(" + text + ")";
}

// What draws both formats is run twice: scales and ranges are set back first.
constexpr std::string_view commands = R"(unset logscale
set xrange [*:*]
set yrange [*:*]
set table "valley-contours.dat"
set contour base
unset surface
set cntrparam levels discrete 1, 4, 25
splot "valley-map.dat" using (log10($1)):(log10($2)):3
unset table
set surface
unset contour
set logscale xy
set xrange [{}:{}]
set yrange [{}:{}]
set xlabel "{{/:Italic D}}"
set ylabel "{{/:Italic β}}"
set xtics {}
set ytics {}
set key outside right
level(z, wanted, value) = abs(z - wanted) < 0.1 ? 10**value : NaN
plot "valley-contours.dat" using (10**$1):(level($3, 1, $2)) with lines lt 1 lw 2 title "χ^2 = least + 1", \
     "" using (10**$1):(level($3, 4, $2)) with lines lt 6 title "least + 4", \
     "" using (10**$1):(level($3, 25, $2)) with lines lc rgb "#bbbbbb" title "least + 25", \
     "valley.dat" index 0 with lines lt 2 title "best {{/:Italic β}} for each {{/:Italic D}}", \
     "" index 1 with points lc rgb "#555555" pt 7 ps 0.4 title "tried", \
     "" index 2 with points lt 2 pt 3 ps 1.2 title "best")";

}  // namespace

void draw_valley(const Calibration& c, const std::filesystem::path& out) {
    write_style(out);
    write_text(out / "valley-map.dat", map_text(c));
    write_text(out / "valley.dat", points_text(c));
    std::string body =
        fmt::format(commands, c.targets.D.low, c.targets.D.high, c.targets.beta.low,
                    c.targets.beta.high, tics_text(c.targets.D), tics_text(c.targets.beta));
    if (std::any_of(c.pairs.begin(), c.pairs.end(),
                    [](const TriedPair& pair) { return pair.found.empty(); }))
        body += R"(, \
     "" index 3 with points lc rgb "#555555" pt 2 ps 0.8 title "failed")";
    run_gnuplot(out, "valley", body, 520, 280);
}

}  // namespace tt
