#include "io/program.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/words.hpp"

namespace tt {
namespace {

/// What is done between fork and exec: all of it may fail there, and none of it here.
class SpawnActions {
public:
    SpawnActions(const std::filesystem::path& directory, const std::string& log) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0644);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

}  // namespace

bool has_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    for (const std::string_view folder : split(path == nullptr ? "/usr/bin:/bin" : path, ':')) {
        const std::string file = std::string(folder) + "/" + name;
        if (!folder.empty() && ::access(file.c_str(), X_OK) == 0) return true;
    }
    return false;
}

int run_program(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
                const std::string& log) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const SpawnActions actions(directory, log);
    pid_t child = 0;
    const int code = ::posix_spawnp(&child, argv[0], actions.get(), nullptr, argv.data(), environ);
    if (code != 0)
        throw IoError(fmt::format("cannot start {} in '{}': {}", arguments.front(),
                                  directory.string(), std::strerror(code)));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            throw IoError(
                fmt::format("lost sight of {}: {}", arguments.front(), std::strerror(errno)));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace tt
