#include "io/archive.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "temporary_directory.hpp"

namespace tt {
namespace {

using Archive = TemporaryDirectory;

std::vector<double> numbers{0.1, -2.5, 3e300, 1e-310};

void write_archive(const std::filesystem::path& path, const std::filesystem::path& previous = {}) {
    ArchiveWriter archive(path);
    archive.put("numbers", numbers);
    archive.put_value<std::int64_t>("step", 12345678901);
    archive.put_text("name", "shear, 75 /s");
    archive.commit(previous);
}

TEST_F(Archive, gives_back_the_same_bits) {
    write_archive(path("a"));
    const ArchiveReader archive(path("a"));
    EXPECT_EQ(archive.take<double>("numbers"), numbers);
    EXPECT_EQ(archive.value<std::int64_t>("step"), 12345678901);
    EXPECT_EQ(archive.text("name"), "shear, 75 /s");
}

TEST_F(Archive, leaves_nothing_behind_where_a_kill_came_between_its_two_renamings) {
    write_archive(path("a"));
    std::filesystem::create_hard_link(path("a"), path("before"));
    write_archive(path("a"), path("before"));
    for (const auto& entry : std::filesystem::directory_iterator(path("")))
        EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(Archive, no_flipped_bit_goes_unnoticed) {
    write_archive(path("a"));
    const std::string whole = read_file(path("a"));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            replace_file(path("b"), damaged, Durability::process);
            ASSERT_THROW(ArchiveReader{path("b")}, DamagedArchive)
                << "byte " << at << " bit " << bit;
        }
    }
}

TEST_F(Archive, no_truncation_or_extension_goes_unnoticed) {
    write_archive(path("a"));
    const std::string whole = read_file(path("a"));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        replace_file(path("b"), std::string_view(whole).substr(0, size), Durability::process);
        ASSERT_THROW(ArchiveReader{path("b")}, DamagedArchive) << size << " bytes";
    }
    replace_file(path("b"), whole + '\0', Durability::process);
    EXPECT_THROW(ArchiveReader{path("b")}, DamagedArchive);
}

TEST_F(Archive, a_section_of_another_type_or_name_is_refused) {
    write_archive(path("a"));
    const ArchiveReader archive(path("a"));
    EXPECT_THROW(archive.take<std::int64_t>("numbers"), DamagedArchive);
    EXPECT_THROW(archive.take<double>("absent"), DamagedArchive);
    EXPECT_THROW(archive.value<double>("numbers"), DamagedArchive);
}

TEST_F(Archive, the_previous_one_is_kept) {
    write_archive(path("a"), path("b"));
    EXPECT_FALSE(std::filesystem::exists(path("b")));
    const std::string first = read_file(path("a"));
    numbers[0] = 0.2;
    write_archive(path("a"), path("b"));
    numbers[0] = 0.1;
    EXPECT_EQ(read_file(path("b")), first);
    EXPECT_EQ(ArchiveReader(path("a")).take<double>("numbers")[0], 0.2);
}

TEST_F(Archive, one_that_is_not_committed_leaves_nothing) {
    write_archive(path("a"));
    const std::string before = read_file(path("a"));
    {
        ArchiveWriter archive(path("a"));
        archive.put("numbers", numbers);
    }
    EXPECT_EQ(read_file(path("a")), before);
    EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace tt
