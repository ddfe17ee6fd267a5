#include "app/calibration_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "io/file.hpp"
#include "observe/provenance.hpp"

namespace tt {

namespace fs = std::filesystem;

CalibrationDirectory::CalibrationDirectory(const fs::path& path, const Targets& targets)
    : path_(path) {
    if (fs::exists(path_ / "PROVENANCE.json"))
        throw DirectoryInUse(fmt::format(
            "'{}' holds the results of a run; choose another directory with -o", path_.string()));
    make_directory(path_);
    lock_.acquire(path_);
    std::vector<InputFile> files = targets.inputs;
    files.push_back({"targets.toml", targets.text});
    const auto differs = [&](const InputFile& file) {
        return fs::exists(path_ / file.name) && read_file(path_ / file.name) != file.bytes;
    };
    if (std::any_of(files.begin(), files.end(), differs)) move_answer_aside();
    keep_inputs(path_, files);
}

void CalibrationDirectory::move_answer_aside() {
    int number = 1;
    do moved_to_ = path_ / fmt::format("former-{}", number++);
    while (fs::exists(moved_to_));
    make_directory(moved_to_);
    for (const char* name : {"targets.toml", "inputs", "calibration.json", "figures"})
        if (fs::exists(path_ / name))
            move_into_place(path_ / name, moved_to_ / name, Durability::power);
}

}  // namespace tt
