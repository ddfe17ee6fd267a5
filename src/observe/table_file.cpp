#include "observe/table_file.hpp"

#include <utility>

#include "base/tell.hpp"
#include "io/crc32.hpp"

namespace tt {

TableFile::TableFile(const std::filesystem::path& directory, std::string stem)
    : directory_(directory), stem_(std::move(stem)) {}

void TableFile::start(std::string_view header) {
    forget_table(directory_, stem_ + ".csv");
    file_.emplace(directory_ / (stem_ + ".csv"), OutputFile::Mode::append);
    file_->cut(0);
    append(header);
}

void TableFile::resume(const ArchiveReader& archive) {
    sum_.bytes = archive.value<std::int64_t>(stem_ + ".size");
    sum_.crc32 = static_cast<std::uint32_t>(archive.value<std::int64_t>(stem_ + ".crc32"));
    file_.emplace(directory_ / (stem_ + ".csv"), OutputFile::Mode::append);
    file_->cut(sum_.bytes);
    note_table(directory_, stem_ + ".csv", sum_);
    const std::string fault = table_fault(directory_, stem_ + ".csv");
    if (!fault.empty()) tell_user("tanktread: {}\n", fault);
}

void TableFile::append(std::string_view rows) {
    file_->append(rows);
    sum_.crc32 = crc32(rows, sum_.crc32);
    sum_.bytes += static_cast<std::int64_t>(rows.size());
}

void TableFile::sync() {
    file_->sync();
    note_table(directory_, stem_ + ".csv", sum_);
}

void TableFile::save(ArchiveOutput& archive) const {
    archive.put_value(stem_ + ".size", sum_.bytes);
    archive.put_value(stem_ + ".crc32", static_cast<std::int64_t>(sum_.crc32));
}

}  // namespace tt
