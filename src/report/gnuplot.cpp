#include "report/gnuplot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tell.hpp"
#include "io/file.hpp"
#include "io/program.hpp"
#include "report/assets.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view script = R"(load "style.gp"
do for [type in "png svg"] {{
if (type eq "png") {{
  set terminal pngcairo size {0},{1} font "DejaVu Sans,25.5" linewidth 3 pointscale 3
}} else {{
  set terminal svg size {2},{3} dynamic background "white" font "DejaVu Sans,Verdana,sans-serif,11"
}}
set output "{4}." . type
{5}
}}
unset output
)";

bool has_points(const Curve& curve) {
    const std::size_t rows = curve.columns.empty() ? 0 : curve.columns.front().size();
    for (std::size_t row = 0; row < rows; ++row)
        if (std::all_of(curve.columns.begin(), curve.columns.end(),
                        [&](const auto& c) { return row < c.size() && std::isfinite(c[row]); }))
            return true;
    return false;
}

/// Names come from files: whatever could end a line is a space.
std::string one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return line;
}

/// Runs gnuplot inside `out`; its messages go to name.log, which stays only if it fails.
void execute(const fs::path& out, const std::string& name) {
    const std::string log = name + ".log";
    if (run_program({"gnuplot", name + ".gp"}, out, log) != 0) {
        const std::string said = one_line(read_file(out / log));
        throw IoError(fmt::format("gnuplot could not draw {}{}", (out / (name + ".gp")).string(),
                                  said.empty() ? "" : ": " + said));
    }
    fs::remove(out / log);
}

std::string data_text(const LineFigure& figure) {
    std::string text = "# columns: " + fmt::format("{}\n", fmt::join(figure.column_names, ", "));
    for (const Curve& curve : figure.curves) {
        if (!has_points(curve)) continue;
        text += fmt::format("# {}\n", curve.title.empty() ? "untitled" : one_line(curve.title));
        for (std::size_t row = 0; row < curve.columns.front().size(); ++row) {
            for (std::size_t c = 0; c < curve.columns.size(); ++c)
                text += fmt::format("{}{:.7g}", c ? " " : "", curve.columns[c][row]);
            text += '\n';
        }
        text += "\n\n";
    }
    return text;
}

}  // namespace

bool can_draw() { return has_program("gnuplot"); }

bool has_points(const LineFigure& figure) {
    return std::any_of(figure.curves.begin(), figure.curves.end(),
                       [](const Curve& curve) { return has_points(curve); });
}

std::string gnuplot_string(std::string_view text) {
    std::string result = "'";
    for (const char c : one_line(text)) {
        if (c == '\'') result += '\'';
        result += c;
    }
    return result + "'";
}

void write_text(const fs::path& path, std::string_view text) {
    replace_file(path, text, Durability::process);
}

void write_style(const fs::path& out) { write_text(out / "style.gp", assets::figure_style); }

void add_figure(Figure figure, const std::function<void()>& draw, std::vector<Figure>& drawn) {
    try {
        draw();
    } catch (const IoError& error) {
        figure.fault = error.what();
        tell_user("tanktread: {}\n", figure.fault);
    }
    drawn.push_back(std::move(figure));
}

void add_figure(const LineFigure& figure, const fs::path& out, std::vector<Figure>& drawn) {
    if (has_points(figure))
        add_figure(
            Figure{figure.name, figure.caption, ""}, [&] { draw(figure, out); }, drawn);
}

void run_gnuplot(const fs::path& out, const std::string& name, const std::string& body, int width,
                 int height) {
    write_text(out / (name + ".gp"),
               fmt::format(script, 3 * width, 3 * height, width, height, name, body));
    execute(out, name);
}

void draw(const LineFigure& figure, const fs::path& out) {
    write_text(out / (figure.name + ".dat"), data_text(figure));
    std::string body;
    for (const std::string& command : figure.commands) body += command + '\n';
    int index = 0;
    for (const Curve& curve : figure.curves) {
        if (!has_points(curve)) continue;
        const std::string title = curve.title.empty()
                                      ? "notitle"
                                      : "title " + gnuplot_string(curve.title) + " noenhanced";
        body += fmt::format("{}\"{}.dat\" index {} {} {}", index == 0 ? "plot " : ", \\\n     ",
                            figure.name, index, curve.style, title);
        ++index;
    }
    constexpr int row = 14;
    run_gnuplot(out, figure.name, body, 340, 240 + row * figure.key_rows);
}

}  // namespace tt
