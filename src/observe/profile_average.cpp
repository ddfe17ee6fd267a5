#include "observe/profile_average.hpp"

#include <utility>

#include "io/csv.hpp"

namespace tt {

ProfileAverage::ProfileAverage(const Schedule& schedule, const std::filesystem::path& directory,
                               Time from, const Model& model,
                               std::function<void(const std::string&)> say)
    : Observer(schedule),
      spacing_(model.scales.length),
      rows_(static_cast<std::size_t>(model.lattice.ny)),
      average_(directory, "profiles", "profiles.csv", from, 2 * rows_, std::move(say)) {}

void ProfileAverage::observe(const Snapshot& snapshot) {
    const Profiles& now = snapshot.profiles();
    std::vector<double> look = now.velocity;
    look.insert(look.end(), now.hematocrit.begin(), now.hematocrit.end());
    average_.look(snapshot.time(), look);
}

std::string ProfileAverage::table() const {
    std::string text = csv_header<ProfileRow>();
    for (std::size_t j = 0; j < rows_; ++j)
        text += csv_row(ProfileRow{Length{(static_cast<double>(j) + 0.5) * spacing_},
                                   Velocity{average_.mean(j)}, average_.mean(rows_ + j),
                                   average_.samples()});
    return text;
}

}  // namespace tt
