#include "report/figure_case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/file.hpp"
#include "io/temporary_folder.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

constexpr const char* fluid_colour = "#e3effa";
constexpr const char* wall_colour = "#8a8a8a";

double twice_area(const Loop& loop) {
    double sum = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k)
        sum += cross(loop[k], loop[(k + 1) % loop.size()]);
    return std::fabs(sum);
}

/// A loop and what is asked of it again and again.
struct DrawnLoop {
    const Loop* points;
    Corners corners;
    double area;
};

bool goes_round(const DrawnLoop& drawn, Vec2 p) {
    const auto& [low, high] = drawn.corners;
    if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
    const Loop& loop = *drawn.points;
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 a = loop[k], b = loop[(k + 1) % loop.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

/// A place just within a loop, beside the middle of its longest side.
Vec2 just_within(const DrawnLoop& drawn) {
    const Loop& loop = *drawn.points;
    std::size_t longest = 0;
    const auto side = [&](std::size_t k) { return loop[(k + 1) % loop.size()] - loop[k]; };
    for (std::size_t k = 1; k < loop.size(); ++k)
        if (norm(side(k)) > norm(side(longest))) longest = k;
    const Vec2 along = side(longest), middle = loop[longest] + 0.5 * along;
    const Vec2 across = 1e-6 * Vec2{-along.y, along.x};
    return goes_round(drawn, middle + across) ? middle + across : middle - across;
}

std::string block_of(const Loop& loop) {
    std::string text;
    for (std::size_t k = 0; k <= loop.size(); ++k)
        text += fmt::format("{:.7g} {:.7g}\n", 1e6 * loop[k % loop.size()].x,
                            1e6 * loop[k % loop.size()].y);
    return text + "\n\n";
}

/// Figures of gnuplot's plot command, one after the other.
class PicturePlot {
public:
    explicit PicturePlot(const fs::path& folder) : folder_(folder) {}
    /// `blocks` of lines, drawn in a style; empty ones are left out.
    void add(const std::string& name, const std::string& blocks, const std::string& style) {
        if (blocks.empty()) return;
        write_text(folder_ / (name + ".dat"), blocks);
        text_ += fmt::format("{}\"{}.dat\" using 1:2 {}", text_.empty() ? "plot " : ", \\\n     ",
                             name, style);
    }
    /// Something must be plotted, or there are no axes.
    std::string command() const { return text_.empty() ? "plot NaN notitle" : text_; }

private:
    fs::path folder_;
    std::string text_;
};

/// Loops from the largest to the smallest, each with the colour of what it goes round.
void add_walls(const CasePicture& picture, PicturePlot& plot) {
    std::vector<DrawnLoop> loops;
    for (const Loop& loop : picture.solid)
        if (loop.size() > 2) loops.push_back({&loop, corners_of({loop}), twice_area(loop)});
    std::stable_sort(loops.begin(), loops.end(),
                     [](const DrawnLoop& a, const DrawnLoop& b) { return a.area > b.area; });
    // Neighbours in this order that have the same colour make one file.
    std::string blocks;
    bool solid = true;
    int number = 0;
    const auto finish = [&] {
        plot.add(fmt::format("walls_{}", number++), blocks,
                 fmt::format("with filledcurves closed fc rgb \"{}\" fs solid border lc rgb "
                             "\"#4a4a4a\" notitle",
                             solid ? wall_colour : fluid_colour));
        blocks.clear();
    };
    for (const DrawnLoop& loop : loops) {
        const Vec2 place = just_within(loop);
        const auto depth = std::count_if(loops.begin(), loops.end(), [&](const DrawnLoop& other) {
            return goes_round(other, place);
        });
        if ((depth % 2 == 1) != solid) finish();
        solid = depth % 2 == 1;
        blocks += block_of(*loop.points);
    }
    finish();
}

void add_ports(const CasePicture& picture, PicturePlot& plot, std::string& body) {
    const double length = 0.06 * norm(picture.high - picture.low) * 1e6;
    for (std::size_t n = 0; n < picture.ports.size(); ++n) {
        const CasePicture::Port& port = picture.ports[n];
        const std::size_t colour = n % 6 + 1;
        plot.add(fmt::format("port_{}", n), block_of({port.place.from, port.place.to}),
                 fmt::format("with lines lt {} lw 4 title {} noenhanced", colour,
                             gnuplot_string(port.words)));
        if (port.along == Vec2{}) continue;
        const Vec2 middle = 0.5e6 * (port.place.from + port.place.to);
        const Vec2 half = 0.5 * length * port.along;
        body += fmt::format(
            "set arrow from {:.7g},{:.7g} to {:.7g},{:.7g} front lt {} lw 2.5 size graph "
            "0.012,25 filled\n",
            middle.x - half.x, middle.y - half.y, middle.x + half.x, middle.y + half.y, colour);
    }
}

/// 1, 2 or 5 times a power of ten, about `share` of the extent.
double round_length(double extent, double share) {
    const double raw = share * extent, decade = std::pow(10.0, std::floor(std::log10(raw)));
    const double lead = raw / decade;
    return decade * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

/// Sizes in pixels: the box in scale, with room for labels and a row of the key for each port.
struct PictureFrame {
    double left = 62, right = 16, top = 40, bottom = 44;
    double across, up;
    explicit PictureFrame(const CasePicture& picture) {
        const Vec2 size = picture.high - picture.low;
        constexpr double widest = 560, highest = 560;
        const double scale = std::min(widest / size.x, highest / size.y);
        across = scale * size.x;
        up = std::max(24.0, scale * size.y);
        right = std::max(right, 240.0 - left - across);  // for the title and the scale bar
        bottom += 16.0 * static_cast<double>(picture.ports.size());
    }
    int width() const { return static_cast<int>(left + across + right); }
    int height() const { return static_cast<int>(top + up + bottom); }
};

std::string axes_text(const CasePicture& picture, const PictureFrame& frame) {
    const Vec2 low = 1e6 * picture.low, high = 1e6 * picture.high, size = high - low;
    const double w = frame.width(), h = frame.height();
    std::string text = fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen "
        "{:.5f}\nset tmargin at screen {:.5f}\n",
        frame.left / w, (frame.left + frame.across) / w, frame.bottom / h,
        (frame.bottom + frame.up) / h);
    text += fmt::format("set xrange [{:.7g}:{:.7g}]\nset yrange [{:.7g}:{:.7g}]\n", low.x, high.x,
                        low.y, high.y);
    text += fmt::format("set xtics {:.7g}\nset ytics {:.7g}\n", round_length(size.x, 0.2),
                        round_length(size.y, frame.up < 90.0 ? 0.5 : 0.25));
    text +=
        "set border 15 lw 0.6\nset tics out scale 0.4\nset xlabel \"{/:Italic x} [μm]\" offset "
        "0,0.4\nset ylabel \"{/:Italic y} [μm]\"\n";
    const double bar = round_length(size.x, 0.15), above = 10.0 / frame.up;
    text += fmt::format(
        "set arrow from {0:.7g},graph {2:.5f} to {1:.7g},graph {2:.5f} nohead lw 3 lc rgb "
        "\"#222222\"\nset label \"{3:g} μm\" at {4:.7g},graph {2:.5f} right offset "
        "-0.6,0\n",
        high.x - bar, high.x, 1.0 + above, bar, high.x - bar);
    text += fmt::format("set label {} noenhanced at screen {:.5f},screen {:.5f} left\n",
                        gnuplot_string(picture.title), frame.left / w, 1.0 - 16.0 / h);
    text += picture.ports.empty()
                ? "unset key\n"
                : fmt::format(
                      "set key at screen {:.5f},screen {:.5f} left bottom Left reverse "
                      "samplen 1.5 spacing 1.0 maxcols 1\n",
                      frame.left / w, 4.0 / h);
    return text;
}

}  // namespace

bool is_picture_name(const fs::path& file) {
    return file.extension() == ".png" || file.extension() == ".svg";
}

void draw_case(const CasePicture& picture, const fs::path& file) {
    const TemporaryFolder folder;
    write_style(folder.path);
    const PictureFrame frame(picture);
    std::string body = axes_text(picture, frame);
    body += fmt::format(
        "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb \"{}\" fs solid "
        "noborder\n",
        fluid_colour);
    PicturePlot plot(folder.path);
    add_walls(picture, plot);
    if (picture.side_walls) {
        const Vec2 low = picture.low, high = picture.high;
        plot.add("sides", block_of({low, {high.x, low.y}}) + block_of({{low.x, high.y}, high}),
                 "with lines lc rgb \"#4a4a4a\" lw 4 notitle");
    }
    std::string cells;
    for (const Loop& cell : picture.cells) cells += block_of(cell);
    plot.add("cells", cells,
             "with filledcurves closed fc rgb \"#c8372d\" fs transparent solid 0.8 border lc rgb "
             "\"#5c0d08\" notitle");
    add_ports(picture, plot, body);
    run_gnuplot(folder.path, "case", body + plot.command(), frame.width(), frame.height());
    replace_file(file, read_file(folder.path / ("case" + file.extension().string())),
                 Durability::process);
}

}  // namespace tt
