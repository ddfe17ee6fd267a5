#pragma once

#include <filesystem>
#include <iterator>
#include <string>

#include <stdlib.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace tt {

/// A fixture with a directory of its own, removed at the end.
class TemporaryDirectory : public testing::Test {
protected:
    TemporaryDirectory() {
        // In memory where there is such a place: the tests wait for many syncs, and lose no power.
        const std::filesystem::path memory = "/dev/shm";
        const bool usable = access(memory.c_str(), W_OK) == 0;
        const std::filesystem::path base = usable ? memory : std::filesystem::temp_directory_path();
        std::string name = (base / "tanktread-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw std::filesystem::filesystem_error(name, std::error_code());
        directory_ = name;
    }
    ~TemporaryDirectory() override {
        std::error_code ignored;
        std::filesystem::remove_all(directory_, ignored);
    }
    std::filesystem::path path(const std::string& name) const { return directory_ / name; }
    const std::filesystem::path& directory() const { return directory_; }
    int files() const {
        return static_cast<int>(std::distance(std::filesystem::directory_iterator(directory_), {}));
    }

private:
    std::filesystem::path directory_;
};

}  // namespace tt
