#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "io/archive.hpp"
#include "io/file.hpp"

namespace tt {

/// The mean of a list of numbers over the looks from a time on. A file in checkpoint/ keeps every
/// look, so that a run that goes on with another window has its average too: a record is the time,
/// the numbers, and XXH64 of these. It is of no use to people, and of none once the run is done.
class LookAverage {
public:
    /// `name` of the file. `say` takes a message for the log; `table` is what damage is told of.
    LookAverage(const std::filesystem::path& directory, const std::string& name, std::string table,
                Time from, std::size_t numbers, std::function<void(const std::string&)> say);

    void start();
    void resume(const ArchiveReader& archive);
    /// Precondition: as many numbers as it was made for.
    void look(Time time, const std::vector<double>& numbers);
    void sync() { looks_->sync(); }
    void save(ArchiveOutput& archive) const;
    /// Replaces the table in the results; without looks in the window there is none, nor is there
    /// one of another window.
    void write(const std::function<std::string()>& table) const;

    std::int64_t samples() const { return samples_; }
    double mean(std::size_t k) const { return sums_[k] / static_cast<double>(samples_); }

private:
    void add(const double* look);

    std::filesystem::path file_;
    std::string name_, table_;
    Time from_;
    std::function<void(const std::string&)> say_;
    std::optional<OutputFile> looks_;
    std::int64_t samples_ = 0;
    std::vector<double> sums_;
};

}  // namespace tt
