#include "observe/profile_average.hpp"

#include "io/csv.hpp"
#include "io/file.hpp"

namespace tt {

ProfileAverage::ProfileAverage(const Schedule& schedule, const std::filesystem::path& directory,
                               Time from, const Model& model)
    : Observer(schedule),
      directory_(directory),
      from_(from),
      spacing_(model.scales.length),
      velocity_(static_cast<std::size_t>(model.lattice.ny), 0.0),
      hematocrit_(velocity_) {}

void ProfileAverage::resume(const ArchiveReader& archive) {
    samples_ = archive.value<std::int64_t>("profiles.samples");
    velocity_ = archive.take<double>("profiles.velocity");
    hematocrit_ = archive.take<double>("profiles.hematocrit");
}

void ProfileAverage::observe(const Snapshot& snapshot) {
    if (snapshot.time() < from_) return;
    const Profiles& now = snapshot.profiles();
    for (std::size_t j = 0; j < velocity_.size(); ++j) {
        velocity_[j] += now.velocity[j];
        hematocrit_[j] += now.hematocrit[j];
    }
    ++samples_;
}

void ProfileAverage::save(ArchiveOutput& archive) const {
    archive.put_value("profiles.samples", samples_);
    archive.put("profiles.velocity", velocity_);
    archive.put("profiles.hematocrit", hematocrit_);
}

void ProfileAverage::write() const {
    if (samples_ == 0) return;
    std::string text = csv_header<ProfileRow>();
    const auto count = static_cast<double>(samples_);
    for (std::size_t j = 0; j < velocity_.size(); ++j) {
        text +=
            csv_row(ProfileRow{Length{(static_cast<double>(j) + 0.5) * spacing_},
                               Velocity{velocity_[j] / count}, hematocrit_[j] / count, samples_});
    }
    replace_file(directory_ / "profiles.csv", text, Durability::power);
}

}  // namespace tt
