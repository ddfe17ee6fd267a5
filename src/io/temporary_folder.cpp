#include "io/temporary_folder.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "tanktread-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw IoError(
            fmt::format("cannot make a folder in '{}'", fs::temp_directory_path().string()));
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

}  // namespace tt
