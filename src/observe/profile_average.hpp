#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "observe/look_average.hpp"
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

/// profiles.csv: velocity and hematocrit across the channel, averaged over the looks from `from` on
/// (observe/look_average.hpp).
class ProfileAverage : public Observer {
public:
    /// `say` takes a message for the log.
    ProfileAverage(const Schedule& schedule, const std::filesystem::path& directory, Time from,
                   const Model& model, std::function<void(const std::string&)> say);

    void start() override { average_.start(); }
    void resume(const ArchiveReader& archive) override { average_.resume(archive); }
    void observe(const Snapshot& snapshot) override;
    void sync() override {
        average_.sync();
        write();
    }
    void save(ArchiveOutput& archive) const override { average_.save(archive); }
    void finish() override { write(); }

private:
    void write() const {
        average_.write([this] { return table(); });
    }
    std::string table() const;

    double spacing_;  ///< of the rows [m]
    std::size_t rows_;
    LookAverage average_;  ///< velocity [m/s], then hematocrit, of each row
};

}  // namespace tt
