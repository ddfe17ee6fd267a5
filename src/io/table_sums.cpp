#include "io/table_sums.hpp"

#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/crc32.hpp"
#include "io/json.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

fs::path sums_of(const fs::path& directory) { return directory / "checksums.json"; }

/// A file that is damaged itself says nothing, and is written anew.
Json read_sums(const fs::path& directory) { return read_object(sums_of(directory)); }

}  // namespace

void note_table(const fs::path& directory, const std::string& name, TableSum sum) {
    Json sums = read_sums(directory);
    sums[name] = {{"bytes", sum.bytes}, {"crc32", sum.crc32}};
    write_json(sums_of(directory), sums, Durability::power);
}

void forget_table(const fs::path& directory, const std::string& name) {
    Json sums = read_sums(directory);
    if (sums.erase(name) > 0) write_json(sums_of(directory), sums, Durability::power);
}

std::string table_fault(const fs::path& directory, const std::string& name) {
    const std::string path = (directory / name).string();
    if (!fs::exists(sums_of(directory))) return {};
    const Json sums = read_sums(directory);
    if (sums.empty()) return sums_of(directory).string() + " is damaged";
    const auto sum = sums.find(name);
    if (sum == sums.end()) return {};
    if (!sum->is_object() || !sum->contains("bytes") || !(*sum)["bytes"].is_number_unsigned() ||
        !sum->contains("crc32") || !(*sum)["crc32"].is_number_unsigned())
        return sums_of(directory).string() + " is damaged";
    if (!fs::exists(path)) return path + " is gone";
    const std::string text = read_file(path);
    const auto bytes = (*sum)["bytes"].get<std::uint64_t>();
    if (text.size() < bytes)
        return fmt::format("{} is cut short: {} bytes of {}", path, text.size(), bytes);
    const std::uint32_t crc = crc32(std::string_view(text).substr(0, bytes));
    if (crc != (*sum)["crc32"].get<std::uint64_t>())
        return path + " is damaged: its checksum does not match";
    return {};
}

}  // namespace tt
