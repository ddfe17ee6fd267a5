#include "io/chip_file.hpp"

#include <algorithm>
#include <cctype>
#include <mutex>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/checksum.hpp"
#include "io/chip_converter.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "io/program.hpp"
#include "io/temporary_folder.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

constexpr int refused = 2, no_library = 3;  // exit codes of the converter

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string package_of(const std::string& module) {
    return "python3-" + lower(module);  // PIL is in python3-pil
}

[[noreturn]] void tell_missing(const ChipDrawing& drawing,
                               const std::vector<std::string>& modules) {
    std::vector<std::string> packages;
    for (const std::string& module : modules) packages.push_back(package_of(module));
    throw IoError(fmt::format(
        "reading {} takes python3 with {}; on Debian or Ubuntu: sudo apt install python3 {}",
        drawing.file.filename().string(), fmt::join(modules, ", "), fmt::join(packages, " ")));
}

std::vector<std::string> texts(const Json& told, const char* key) {
    return told.value(key, std::vector<std::string>{});
}

std::vector<std::string> arguments(const ChipDrawing& drawing, const std::string& python,
                                   const std::string& name) {
    std::vector<std::string> words{python, "-B", "-W", "ignore", "-m", "chips", name, "."};
    const auto add = [&](const char* key, const std::string& value) {
        words.push_back(fmt::format("--{}={}", key, value));
    };
    if (drawing.layer) add("layer", *drawing.layer);
    if (drawing.unit) add("unit", fmt::format("{:.17g}", *drawing.unit));
    if (drawing.pixel) add("pixel", fmt::format("{:.17g}", *drawing.pixel));
    if (drawing.chord) add("chord", fmt::format("{:.17g}", *drawing.chord));
    add("fluid", std::string(drawing.fluid));
    return words;
}

/// Python as the user has it, and as Debian has it: that is where Debian's libraries are.
std::vector<std::string> pythons() {
    std::vector<std::string> found;
    if (has_program("python3")) found.emplace_back("python3");
    constexpr const char* debian = "/usr/bin/python3";
    if (fs::exists(debian)) found.emplace_back(debian);
    return found;
}

std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.find_last_of('\n') + 1);
}

/// One go with one Python: what it tells, and its exit code.
std::pair<int, Json> converted(const ChipDrawing& drawing, const std::string& python,
                               const fs::path& folder) {
    const std::string name = "drawing" + lower(drawing.file.extension().string());
    replace_file(folder / name, drawing.bytes, Durability::process);
    const int code = run_program(arguments(drawing, python, name), folder, "log.txt");
    if (code != 0 && code != refused && code != no_library)
        throw CaseError({{drawing.file.string(), 0, 0,
                          fmt::format("reading it failed: {} ended with code {}: {}", python, code,
                                      last_line(read_file(folder / "log.txt")))}});
    return {code, read_object(folder / "told.json")};
}

ChipLoops convert(const ChipDrawing& drawing) {
    const TemporaryFolder folder;
    make_directory(folder.path / "chips");
    for (const CarriedFile& file : chip_converter)
        replace_file(folder.path / "chips" / file.name, file.text, Durability::process);
    std::vector<std::string> missing{"numpy", "shapely"};
    for (const std::string& python : pythons()) {
        const auto [code, told] = converted(drawing, python, folder.path);
        if (code == no_library) {
            missing = texts(told, "missing");
            continue;
        }
        std::vector<Fault> faults;
        for (const std::string& fault : texts(told, "faults"))
            faults.push_back({drawing.file.string(), 0, 0, fault});
        if (!faults.empty()) throw CaseError(std::move(faults));
        return {chip_heading(drawing) + read_file(folder.path / "loops.csv"),
                told.value("found", std::vector<std::pair<std::string, std::string>>{}),
                texts(told, "remarks")};
    }
    tell_missing(drawing, missing);
}

}  // namespace

DrawingKind drawing_kind(const fs::path& file) {
    const std::string ending = lower(file.extension().string());
    if (ending.empty() || ending == ".csv" || ending == ".txt" || ending == ".dat")
        return DrawingKind::points;
    if (ending == ".dxf") return DrawingKind::dxf;
    if (ending == ".svg") return DrawingKind::svg;
    if (ending == ".gds" || ending == ".gdsii" || ending == ".gds2") return DrawingKind::gds;
    if (ending == ".png") return DrawingKind::png;
    return DrawingKind::unknown;
}

std::string chip_heading(const ChipDrawing& drawing) {
    const auto text = [](const std::optional<double>& value) {
        return value ? fmt::format("{:.12g} um", *value) : std::string("auto");
    };
    return fmt::format("# drawing {}; layer {}, unit {}, pixel {}, chord {}, fluid {}\n",
                       hexadecimal(checksum(drawing.bytes)),
                       drawing.layer ? Json(*drawing.layer).dump() : "auto", text(drawing.unit),
                       text(drawing.pixel), text(drawing.chord), drawing.fluid);
}

ChipLoops read_chip(const ChipDrawing& drawing) {
    // A sweep reads its case again and again: the last drawing is kept.
    static std::mutex mutex;
    static std::string last_heading;
    static ChipLoops last;
    const std::lock_guard lock(mutex);
    const std::string heading = chip_heading(drawing);
    if (heading != last_heading) {
        last = convert(drawing);
        last_heading = heading;
    }
    return last;
}

}  // namespace tt
