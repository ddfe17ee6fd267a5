#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/archive.hpp"
#include "io/file.hpp"
#include "io/table_sums.hpp"

namespace tt {

/// A table that grows row by row, and its checksum in checksums.json as of the last checkpoint.
class TableFile {
public:
    /// `stem`.csv in `directory`.
    TableFile(const std::filesystem::path& directory, std::string stem);

    /// Empties it and writes its first line.
    void start(std::string_view header);
    /// Cuts it to what the checkpoint knows; tells if that is not what it was.
    void resume(const ArchiveReader& archive);
    void append(std::string_view rows);
    /// It is on the disk when this returns, and so is its checksum.
    void sync();
    void save(ArchiveOutput& archive) const;

private:
    std::filesystem::path directory_;
    std::string stem_;
    std::optional<OutputFile> file_;
    TableSum sum_;  ///< of all that was written, whatever the disk holds
};

}  // namespace tt
