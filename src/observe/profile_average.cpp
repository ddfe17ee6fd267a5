#include "observe/profile_average.hpp"

#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "io/checksum.hpp"
#include "io/csv.hpp"

namespace tt {
namespace {

/// The state's folder: of no use to people, and none once the run is done for good.
constexpr const char* looks_name = "checkpoint/profiles";

}  // namespace

ProfileAverage::ProfileAverage(const Schedule& schedule, const std::filesystem::path& directory,
                               Time from, const Model& model,
                               std::function<void(const std::string&)> say)
    : Observer(schedule),
      directory_(directory),
      from_(from),
      spacing_(model.scales.length),
      say_(std::move(say)),
      velocity_(static_cast<std::size_t>(model.lattice.ny), 0.0),
      hematocrit_(velocity_) {}

void ProfileAverage::start() {
    make_directory(directory_ / "checkpoint");
    looks_.emplace(directory_ / looks_name, OutputFile::Mode::append);
    looks_->cut(0);
}

void ProfileAverage::resume(const ArchiveReader& archive) {
    looks_.emplace(directory_ / looks_name, OutputFile::Mode::append);
    looks_->cut(archive.value<std::int64_t>("profiles.size"));
    const std::string bytes = read_file(directory_ / looks_name);
    const std::size_t numbers = 1 + 2 * velocity_.size(), size = numbers * sizeof(double);
    std::vector<double> look(numbers);
    int damaged = 0;
    for (std::size_t at = 0; at + size + sizeof(std::uint64_t) <= bytes.size();
         at += size + sizeof(std::uint64_t)) {
        std::uint64_t sum = 0;
        std::memcpy(look.data(), bytes.data() + at, size);
        std::memcpy(&sum, bytes.data() + at + size, sizeof sum);
        if (sum == checksum({bytes.data() + at, size}))
            add(look.data());
        else
            ++damaged;
    }
    if (damaged > 0)
        say_(fmt::format("profiles.csv leaves out {} looks that are damaged in '{}'", damaged,
                         looks_->path().string()));
}

void ProfileAverage::observe(const Snapshot& snapshot) {
    const Profiles& now = snapshot.profiles();
    std::vector<double> look{snapshot.time().si};
    look.insert(look.end(), now.velocity.begin(), now.velocity.end());
    look.insert(look.end(), now.hematocrit.begin(), now.hematocrit.end());
    std::string record(reinterpret_cast<const char*>(look.data()), look.size() * sizeof(double));
    const std::uint64_t sum = checksum(record);
    record.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    looks_->append(record);
    add(look.data());
}

/// Time, velocities and hematocrits of one look.
void ProfileAverage::add(const double* look) {
    if (*look++ < from_.si) return;
    for (double& sum : velocity_) sum += *look++;
    for (double& sum : hematocrit_) sum += *look++;
    ++samples_;
}

void ProfileAverage::sync() {
    looks_->sync();
    write();
}

void ProfileAverage::save(ArchiveOutput& archive) const {
    archive.put_value("profiles.size", looks_->size());
}

void ProfileAverage::write() const {
    if (samples_ == 0) {  // nor is there any of another window
        std::error_code ignored;
        std::filesystem::remove(directory_ / "profiles.csv", ignored);
        return;
    }
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
