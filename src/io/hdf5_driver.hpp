#pragma once

#include <exception>
#include <filesystem>

#include "io/file.hpp"
#include "io/hdf5.hpp"
#include "io/sealed_file.hpp"

namespace tt::hdf5 {

/// Opens `file` for reading. HDF5 gets sound bytes or a failed read, never damaged bytes, on which
/// it may loop or crash. Precondition: `file` outlives the result. IoError if it is not HDF5 or is
/// damaged where HDF5 begins to read.
Id open_sealed(const SealedFile& file);

/// A file that HDF5 fills. HDF5 1.10 crashes when a write fails; here it never learns of that: the
/// first error is kept, and nothing is written after it.
class GuardedFile {
public:
    explicit GuardedFile(const std::filesystem::path& path);

    hid_t id() const { return id_; }
    /// Throws the error kept, if any.
    void expect_sound() const;
    /// Hands over the rest; the file is whole, though not yet on the disk, unless this throws.
    void close();

private:
    friend struct Access;

    OutputFile file_;
    std::exception_ptr error_;
    Id id_;
};

}  // namespace tt::hdf5
