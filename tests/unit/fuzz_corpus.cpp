#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "../fuzz/one_case.hpp"
#include "source_dir.hpp"

namespace {

namespace fs = std::filesystem;

TEST(FuzzCorpus, no_text_of_it_crashes_the_reader) {
    const fs::path root = TT_SOURCE_DIR;
    int count = 0;
    for (const char* folder : {"tests/fuzz/corpus", "tests/unit/cases_bad"})
        for (const auto& entry : fs::directory_iterator(root / folder)) {
            std::ifstream file(entry.path(), std::ios::binary);
            tt::try_as_case(std::string(std::istreambuf_iterator<char>(file), {}));
            ++count;
        }
    EXPECT_GT(count, 60);
}

}  // namespace
