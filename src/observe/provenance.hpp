#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/json.hpp"
#include "observe/same_case.hpp"

namespace tt {

/// A file that a case was read from.
struct InputFile {
    std::string name;  ///< of its copy, from the results directory: "inputs/cell.csv"
    std::string bytes;
};

/// `{file, hash}` of each.
Json to_json(const std::vector<InputFile>& inputs);

/// Writes them into a directory that is to stand alone, by their names.
void keep_inputs(const std::filesystem::path& directory, const std::vector<InputFile>& inputs);

/// Where a result came from; what is not asked of the machine.
struct Provenance {
    std::string name;
    std::string settings;  ///< a line `table.key = value` each: tells what case it is
    std::string case_toml, resolved_toml;
    std::string command_line;
    int threads = 1;
    std::vector<InputFile> inputs;
};

/// One go at a run, from start or resume to its end, or to its last checkpoint if it was killed.
struct Session {
    std::string started;  ///< UTC
    std::int64_t from_step = 0;
    std::int64_t to_step = 0;
    double wall_seconds = 0.0;
    std::string ending;  ///< running, done, stopped, failed; `running` of an old session: killed
    int number = -1;     ///< place in the list; −1 before the first write
    double from_time = 0.0;              ///< [s]
    std::vector<SettingChange> changes;  ///< of the numerics, with which it went on
};

/// What PROVENANCE.json says; an empty object if there is none or it is damaged.
Json read_provenance(const std::filesystem::path& results);

/// The settings in it; nothing where they cannot be told.
std::optional<std::string> recorded_settings(const std::filesystem::path& results);

/// The sessions in it that went on with other numerics: [{time, step, changes: {key: [before,
/// after]}}]. Empty for a run that is the same all through.
Json recorded_changes(const std::filesystem::path& results);

/// PROVENANCE.json: settings, hashes of all that was read, the machine, and one entry per session
/// with the build that ran it: the first write of a session adds its entry and sets its number,
/// later ones replace it.
void write_provenance(const std::filesystem::path& results, const Provenance& provenance,
                      Session& session, const std::string& state_hash);

/// "AMD EPYC …" as the system calls it.
std::string processor_name();

}  // namespace tt
