#include "case/kept_inputs.hpp"

#include <algorithm>

#include "case/drawn_file.hpp"
#include "case/kinds.hpp"

namespace tt {

namespace fs = std::filesystem;

std::vector<InputFile> kept_inputs(const fs::path& case_file, const std::string& text,
                                   const std::vector<const Case*>& cases) {
    std::vector<InputFile> files{{"inputs/" + case_file.filename().string(), text}};
    const fs::path folder = fs::absolute(case_file).parent_path();
    const auto keep = [&](const fs::path& file, const std::string& bytes) {
        const fs::path beside = file.lexically_relative(folder);
        const bool inside = !beside.empty() && *beside.begin() != "..";
        const std::string name = "inputs/" + (inside ? beside : file.filename()).string();
        const auto same = [&](const InputFile& other) { return other.name == name; };
        if (std::none_of(files.begin(), files.end(), same)) files.push_back({name, bytes});
    };
    for (const Case* c : cases) {
        for (const Case& one : cases_by_kind(*c))
            if (const CellOutline* outline = one.cells.outline())
                keep(std::get<OutlineShape>(one.cells.shape).file, outline->bytes);
        const auto* drawn = std::get_if<DrawnShape>(&c->geometry.shape);
        if (!drawn || drawn->file.empty()) continue;
        if (is_converted(*drawn)) keep(drawn->file, drawn->original);
        keep(as_points(*drawn).file, drawn->bytes);
    }
    return files;
}

fs::path find_case(const fs::path& folder, const std::string& named) {
    const fs::path given = (folder / named).lexically_normal();
    const fs::path copy = folder / "inputs" / given.filename();
    return !fs::exists(given) && fs::exists(copy) ? copy : given;
}

}  // namespace tt
