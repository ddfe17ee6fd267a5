#pragma once

#include <filesystem>
#include <iterator>
#include <string>

#include <stdlib.h>

#include <gtest/gtest.h>

namespace tt {

/// A fixture with a directory of its own, removed at the end.
class TemporaryDirectory : public testing::Test {
protected:
    TemporaryDirectory() {
        std::string name = (std::filesystem::temp_directory_path() / "tanktread-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::filesystem::filesystem_error(name, std::error_code());
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
