#include "app/sweep_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "io/file.hpp"
#include "observe/provenance.hpp"

namespace tt {

namespace fs = std::filesystem;

void SweepDirectory::expect_sweep(const fs::path& path) {
    if (!fs::exists(path) || fs::exists(path / "sweep.toml")) return;
    const auto refuse = [&](const char* what) {
        throw DirectoryInUse(
            fmt::format("'{}' {}; choose another directory with -o", path.string(), what));
    };
    if (!fs::is_directory(path)) refuse("is a file, not a directory");
    if (fs::exists(path / "PROVENANCE.json")) refuse("holds the results of a run");
    // All that a sweep leaves which was killed before it wrote sweep.toml, its first file.
    constexpr std::array leftovers{".lock", ".owner", "sweep.toml.tmp"};
    for (const auto& entry : fs::directory_iterator(path)) {
        const std::string name = entry.path().filename().string();
        if (std::find(leftovers.begin(), leftovers.end(), name) == leftovers.end())
            refuse("holds files but no sweep");
    }
}

SweepDirectory::SweepDirectory(const fs::path& path, const SweepPlan& plan, Start start)
    : path_(path) {
    expect_sweep(path_);
    make_directory(path_);
    lock_.acquire(path_);
    if (start == Start::fresh && fs::exists(path_ / "sweep.toml")) {
        const fs::path place = fs::is_symlink(path_) ? fs::canonical(path_) : path_;
        moved_to_ = move_aside(path_);
        lock_.release();
        make_directory(place);
        lock_.acquire(path_);
    }
    replace_file(path_ / "sweep.toml", plan.text, Durability::power);
    keep_inputs(path_, plan.inputs);
}

}  // namespace tt
