#include "base/version.hpp"

#include <fmt/format.h>

namespace tt {

std::string version_text() {
    std::string commit;
    if (!revision.commit.empty())
        commit = fmt::format("commit {}{}, ", revision.commit.substr(0, 12),
                             revision.changed ? " with changes" : "");
    return fmt::format("{} ({}{}, {})", version, commit, compiler, build_type);
}

}  // namespace tt
