#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tt {

/// checksums.json of a results directory: of each table how many bytes it had when it was last on
/// the disk, and their CRC-32. A table that has grown since still begins with them.
struct TableSum {
    std::int64_t bytes = 0;
    std::uint32_t crc32 = 0;
};

void note_table(const std::filesystem::path& directory, const std::string& name, TableSum sum);
/// Before a table is written anew.
void forget_table(const std::filesystem::path& directory, const std::string& name);

/// What is wrong with a table, in words; empty if nothing is, or nothing is known of it.
std::string table_fault(const std::filesystem::path& directory, const std::string& name);

}  // namespace tt
