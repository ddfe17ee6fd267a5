#include "observe/provenance.hpp"

#include <fstream>
#include <sstream>
#include <thread>

#include "base/error.hpp"
#include "base/processors.hpp"
#include "base/version.hpp"
#include "io/checksum.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

Json build_of_this_program() {
    const Json commit = revision.commit.empty() ? Json() : Json(revision.commit);
    return Json{{"program", "tanktread"},  {"version", version},
                {"commit", commit},        {"commit_changed", revision.changed},
                {"compiler", compiler},    {"compiler_flags", compiler_flags},
                {"build_type", build_type}};
}

Json lines_of(const std::string& text) {
    Json lines = Json::array();
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

Json to_json(const std::vector<InputFile>& inputs) {
    Json list = Json::array();
    for (const InputFile& input : inputs)
        list.push_back({{"file", input.name}, {"hash", hexadecimal(checksum(input.bytes))}});
    return list;
}

void keep_inputs(const std::filesystem::path& directory, const std::vector<InputFile>& inputs) {
    for (const InputFile& input : inputs) {
        make_directory((directory / input.name).parent_path());
        replace_file(directory / input.name, input.bytes, Durability::power);
    }
}

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

Json read_provenance(const std::filesystem::path& results) {
    Json known = read_object(results / "PROVENANCE.json");
    return known.value("sessions", Json::array()).is_array() ? known : Json::object();
}

std::optional<std::string> recorded_settings(const std::filesystem::path& results) {
    const Json lines = read_provenance(results).value("settings", Json());
    if (!lines.is_array()) return std::nullopt;
    std::string settings;
    for (const Json& line : lines) {
        if (!line.is_string()) return std::nullopt;
        settings += line.get<std::string>() + '\n';
    }
    return settings;
}

Json recorded_changes(const std::filesystem::path& results) {
    Json changes = Json::array();
    for (const Json& session : read_provenance(results).value("sessions", Json::array())) {
        if (!session.is_object() || !session.contains("changes")) continue;
        changes.push_back({{"time", session.value("from_time", Json())},
                           {"step", session.value("from_step", Json())},
                           {"changes", session["changes"]}});
    }
    return changes;
}

void write_provenance(const std::filesystem::path& results, const Provenance& p, Session& session,
                      const std::string& state_hash) {
    const Json build = build_of_this_program();
    Json sessions = read_provenance(results).value("sessions", Json::array());
    const int count = static_cast<int>(sessions.size());
    if (session.number < 0 || session.number > count) session.number = count;
    Json entry{{"started", session.started}, {"command_line", p.command_line},
               {"threads", p.threads},       {"from_step", session.from_step},
               {"to_step", session.to_step}, {"wall_seconds", session.wall_seconds},
               {"ending", session.ending},   {"build", build}};
    if (!session.changes.empty()) entry["from_time"] = session.from_time;
    for (const SettingChange& change : session.changes)
        entry["changes"][change.key] = Json::array({change.before, change.after});
    sessions[static_cast<std::size_t>(session.number)] = entry;
    Json all{{"name", p.name}, {"settings", lines_of(p.settings)}};
    all.update(build);
    all.update(Json{{"processor", processor_name()},
                    {"hardware_threads", std::thread::hardware_concurrency()},
                    {"usable_processors", usable_processors()},
                    {"threads", p.threads},
                    {"ranks", 1},
                    {"case_toml_hash", hexadecimal(checksum(p.case_toml))},
                    {"resolved_toml_hash", hexadecimal(checksum(p.resolved_toml))},
                    {"inputs", to_json(p.inputs)},
                    {"state_hash", state_hash},
                    {"sessions", sessions}});
    write_json(results / "PROVENANCE.json", all, Durability::power);
}

}  // namespace tt
