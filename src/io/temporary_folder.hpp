#pragma once

#include <filesystem>

namespace tt {

/// A folder of its own that is there as long as the object. Throws IoError if none can be made.
class TemporaryFolder {
public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    std::filesystem::path path;
};

}  // namespace tt
