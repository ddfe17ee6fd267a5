#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "../fuzz/one_case.hpp"
#include "../fuzz/one_checkpoint.hpp"
#include "../fuzz/one_outline.hpp"
#include "source_dir.hpp"

namespace {

namespace fs = std::filesystem;

/// Calls `attempt` with the bytes of each file of a folder; tells how many there were.
int replay(const char* folder, const std::function<void(const std::string&)>& attempt) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(TT_SOURCE_DIR) / "tests" / folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        attempt(std::string(std::istreambuf_iterator<char>(file), {}));
        ++count;
    }
    return count;
}

TEST(FuzzCorpus, no_text_of_it_crashes_the_reader_of_cases) {
    EXPECT_GT(replay("fuzz/corpus/case", tt::try_as_case), 20);
    EXPECT_GT(replay("unit/cases_bad", tt::try_as_case), 40);
}

TEST(FuzzCorpus, no_file_of_it_crashes_the_reader_of_outlines) {
    EXPECT_GT(replay("fuzz/corpus/outline", tt::try_as_outline), 15);
}

TEST(FuzzCorpus, no_file_of_it_crashes_a_resume) {
    EXPECT_GT(replay("fuzz/corpus/checkpoint", tt::try_as_checkpoint), 2);
}

/// The fuzzer begins with it: were it refused, everything would be.
TEST(FuzzCorpus, a_sound_checkpoint_is_taken_and_no_damage_of_it_crashes_a_resume) {
    const std::string sound = tt::sound_checkpoint();
    ASSERT_TRUE(tt::try_as_checkpoint(sound));
    for (std::size_t at = 0; at < sound.size(); at += 7) {
        tt::try_as_checkpoint(sound.substr(0, at));
        std::string damaged = sound;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        tt::try_as_checkpoint(damaged);
    }
}

}  // namespace
