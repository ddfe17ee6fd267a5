#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include "source_dir.hpp"

namespace tt {

/// A folder that goes away with the test.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "tanktread-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no scratch folder");
        path_ = name;
    }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

/// Makes an invented results directory with tests/fixtures/invented_results.py.
inline void invent_results(const std::filesystem::path& directory,
                           const std::string& options = "") {
    const std::string line = std::string("/usr/bin/python3 ") + TT_SOURCE_DIR +
                             "/tests/fixtures/invented_results.py " + directory.string() + " " +
                             options;
    if (std::system(line.c_str()) != 0)
        throw std::runtime_error("failed: " + line + " (needs python3-h5py)");
}

inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace tt
