#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "observe/look_average.hpp"
#include "observe/observer.hpp"

namespace tt {

/// One row of section_profiles.csv: time means over the averaging window at one place of a section.
struct SectionProfileRow {
    std::int64_t section = 0;
    Length place;
    Velocity velocity;
    double hematocrit = 0.0;
    std::int64_t samples = 0;
};

template <>
struct FieldList<SectionProfileRow> {
    using P = SectionProfileRow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"section", &P::section,
                   "number of the section, in the order of the case, from 0"},
        FieldEntry{"place", &P::place, "distance from the wall at the end `from`"},
        FieldEntry{"velocity", &P::velocity, "velocity through the section, forward, mean of time"},
        FieldEntry{"hematocrit", &P::hematocrit, "share of the time in cells"},
        FieldEntry{"samples", &P::samples, "looks in the mean"},
    };
};

/// section_profiles.csv: velocity, the mean of two steps, and hematocrit across each section,
/// averaged over the looks from `from` on (observe/look_average.hpp).
class SectionProfiles : public Observer {
public:
    /// `say` takes a message for the log.
    SectionProfiles(const Schedule& schedule, const std::filesystem::path& directory, Time from,
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

    const Model& model_;
    LookAverage average_;  ///< of each section its velocities [m/s], then its hematocrits
};

}  // namespace tt
