#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/file.hpp"
#include "observe/observer.hpp"

namespace tt {

/// One row of profiles.csv: time means over the averaging window at one height.
struct ProfileRow {
    Length y;
    Velocity velocity;
    double hematocrit = 0.0;
    std::int64_t samples = 0;
};

template <>
struct FieldList<ProfileRow> {
    using P = ProfileRow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"y", &P::y, "height above the bottom wall"},
        FieldEntry{"velocity", &P::velocity, "velocity along the channel, mean over x and time"},
        FieldEntry{"hematocrit", &P::hematocrit, "hematocrit, mean over x and time"},
        FieldEntry{"samples", &P::samples, "looks in the mean"},
    };
};

/// profiles.csv: velocity and hematocrit across the channel, averaged over the looks from `from`
/// on. checkpoint/profiles keeps every look, so that a run that goes on with another window has its
/// average too: a record is the time, both profiles, and XXH64 of these.
class ProfileAverage : public Observer {
public:
    /// `say` takes a message for the log.
    ProfileAverage(const Schedule& schedule, const std::filesystem::path& directory, Time from,
                   const Model& model, std::function<void(const std::string&)> say);

    void start() override;
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override;
    void save(ArchiveOutput& archive) const override;
    void finish() override { write(); }

private:
    void add(const double* look);
    void write() const;

    std::filesystem::path directory_;
    Time from_;
    double spacing_;  ///< of the rows [m]
    std::function<void(const std::string&)> say_;
    std::optional<OutputFile> looks_;
    std::int64_t samples_ = 0;
    std::vector<double> velocity_, hematocrit_;  ///< sums, per row
};

}  // namespace tt
