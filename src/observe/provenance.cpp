#include "observe/provenance.hpp"

#include <fstream>
#include <thread>

#include "base/processors.hpp"
#include "base/version.hpp"
#include "io/checksum.hpp"
#include "io/json.hpp"

namespace tt {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

void write_provenance(const std::filesystem::path& results, const Provenance& p, Session& session,
                      const std::string& state_hash) {
    const std::filesystem::path path = results / "PROVENANCE.json";
    Json sessions = Json::array();
    if (std::filesystem::exists(path)) {
        const Json before = read_json(path);
        if (before.contains("sessions")) sessions = before["sessions"];
    }
    const Json entry{{"started", session.started}, {"command_line", p.command_line},
                     {"threads", p.threads},       {"from_step", session.from_step},
                     {"to_step", session.to_step}, {"wall_seconds", session.wall_seconds},
                     {"ending", session.ending}};
    if (session.number < 0) {
        session.number = static_cast<int>(sessions.size());
        sessions.push_back(entry);
    }
    sessions[static_cast<std::size_t>(session.number)] = entry;
    const Json commit = revision.commit.empty() ? Json() : Json(revision.commit);
    Json inputs = Json::array();
    for (const InputFile& input : p.inputs)
        inputs.push_back({{"file", input.name}, {"hash", hexadecimal(checksum(input.bytes))}});
    const Json all{{"name", p.name},
                   {"case_hash", p.case_hash},
                   {"program", "tanktread"},
                   {"version", version},
                   {"commit", commit},
                   {"commit_changed", revision.changed},
                   {"compiler", compiler},
                   {"compiler_flags", compiler_flags},
                   {"build_type", build_type},
                   {"processor", processor_name()},
                   {"hardware_threads", std::thread::hardware_concurrency()},
                   {"usable_processors", usable_processors()},
                   {"threads", p.threads},
                   {"ranks", 1},
                   {"case_toml_hash", hexadecimal(checksum(p.case_toml))},
                   {"resolved_toml_hash", hexadecimal(checksum(p.resolved_toml))},
                   {"inputs", inputs},
                   {"state_hash", state_hash},
                   {"sessions", sessions}};
    write_json(path, all, Durability::power);
}

}  // namespace tt
