#include "observe/look_average.hpp"

#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "io/checksum.hpp"

namespace tt {

LookAverage::LookAverage(const std::filesystem::path& directory, const std::string& name,
                         std::string table, Time from, std::size_t numbers,
                         std::function<void(const std::string&)> say)
    : file_(directory / "checkpoint" / name),
      name_(name),
      table_(std::move(table)),
      from_(from),
      say_(std::move(say)),
      sums_(numbers, 0.0) {}

void LookAverage::start() {
    make_directory(file_.parent_path());
    looks_.emplace(file_, OutputFile::Mode::append);
    looks_->cut(0);
}

void LookAverage::resume(const ArchiveReader& archive) {
    looks_.emplace(file_, OutputFile::Mode::append);
    looks_->cut(archive.value<std::int64_t>(name_ + ".size"));
    const std::string bytes = read_file(file_);
    const std::size_t numbers = 1 + sums_.size(), size = numbers * sizeof(double);
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
        say_(fmt::format("{} leaves out {} look{} damaged in '{}'", table_, damaged,
                         damaged == 1 ? " that is" : "s that are", looks_->path().string()));
}

void LookAverage::look(Time time, const std::vector<double>& numbers) {
    std::vector<double> look{time.si};
    look.insert(look.end(), numbers.begin(), numbers.end());
    std::string record(reinterpret_cast<const char*>(look.data()), look.size() * sizeof(double));
    const std::uint64_t sum = checksum(record);
    record.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    looks_->append(record);
    add(look.data());
}

/// Time and numbers of one look.
void LookAverage::add(const double* look) {
    if (*look++ < from_.si) return;
    for (double& sum : sums_) sum += *look++;
    ++samples_;
}

void LookAverage::save(ArchiveOutput& archive) const {
    archive.put_value(name_ + ".size", looks_->size());
}

void LookAverage::write(const std::function<std::string()>& table) const {
    const std::filesystem::path path = file_.parent_path().parent_path() / table_;
    std::error_code ignored;
    if (samples_ == 0)
        std::filesystem::remove(path, ignored);
    else
        replace_file(path, table(), Durability::power);
}

}  // namespace tt
