#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "base/error.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "io/program.hpp"
#include "observe/results_directory.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& path, Author author) {
    try {
        read_file(path, author);
    } catch (const IoError& error) {
        return error.what();
    }
    return "none";
}

class Files : public TemporaryDirectory {
protected:
    void write(const std::string& name, const std::string& text) {
        std::ofstream(path(name)) << text;
    }
    /// A file of this size that holds nothing and takes no room.
    fs::path hollow(const std::string& name, std::uintmax_t size) {
        write(name, "");
        fs::resize_file(path(name), size);
        return path(name);
    }
};

TEST_F(Files, what_is_read_is_a_file_of_bounded_size) {
    write("text", "12\n");
    EXPECT_EQ(read_file(path("text"), Author::user), "12\n");
    EXPECT_NE(refusal("/dev/zero", Author::user).find("device"), std::string::npos);
    EXPECT_NE(refusal("/dev/null", Author::program).find("device"), std::string::npos);
    EXPECT_NE(refusal(directory(), Author::user).find("directory"), std::string::npos);
    EXPECT_NE(refusal(path("nothing"), Author::user).find("No such file"), std::string::npos);
    const fs::path large = hollow("large", (16u << 20) + 1);
    EXPECT_NE(refusal(large, Author::user).find("more than 16 MB"), std::string::npos);
    EXPECT_EQ(read_file(large, Author::program).size(), (16u << 20) + 1);
    const fs::path huge = hollow("huge", std::uintmax_t{1} << 42);
    EXPECT_NE(refusal(huge, Author::program).find("more than"), std::string::npos);
}

TEST_F(Files, a_pipe_is_read_up_to_the_same_bound) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    const auto feed = [&](std::size_t size) {
        return std::thread([this, size] {
            const int descriptor = ::open(path("pipe").c_str(), O_WRONLY);
            const std::string block(size, 'x');
            for (std::size_t done = 0; done < size;) {
                const ssize_t count = ::write(descriptor, block.data() + done, size - done);
                if (count < 0) break;  // the reader has had enough
                done += static_cast<std::size_t>(count);
            }
            ::close(descriptor);
        });
    };
    const auto former = std::signal(SIGPIPE, SIG_IGN);
    std::thread little = feed(100'000);
    EXPECT_EQ(read_file(path("pipe"), Author::user).size(), 100'000u);
    little.join();
    std::thread much = feed(17 << 20);
    EXPECT_NE(refusal(path("pipe"), Author::user).find("more than"), std::string::npos);
    much.join();
    std::signal(SIGPIPE, former);
    EXPECT_NE(refusal(path("pipe"), Author::program).find("pipe"), std::string::npos);
}

/// Into which nobody writes: told at once. One that is written to is waited for.
TEST_F(Files, a_pipe_without_a_writer_is_told_at_once) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_NE(refusal(path("pipe"), Author::user).find("it is a pipe, not a file"),
              std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    std::thread slow([this] {
        const int descriptor = ::open(path("pipe").c_str(), O_WRONLY);
        std::this_thread::sleep_for(std::chrono::milliseconds(600));
        EXPECT_EQ(::write(descriptor, "late", 4), 4);
        ::close(descriptor);
    });
    EXPECT_EQ(read_file(path("pipe"), Author::user), "late");
    slow.join();
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_EQ(::write(ends[1], "given", 5), 5);
    ::close(ends[1]);
    EXPECT_EQ(read_file("/dev/fd/" + std::to_string(ends[0]), Author::user), "given");
    ::close(ends[0]);
}

/// As on a disk that fills up in the middle of it.
TEST_F(Files, an_append_that_fails_leaves_nothing_of_itself) {
    write("table", "12345\n");
    OutputFile file(path("table"), OutputFile::Mode::append);
    const auto former = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit small{10, limit.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    std::string told;
    try {
        file.append("6789 and more\n");
    } catch (const IoError& error) {
        told = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, former);
    EXPECT_NE(told.find("table"), std::string::npos) << told;
    EXPECT_EQ(read_file(path("table")), "12345\n");
    file.append("6789\n");
    EXPECT_EQ(read_file(path("table")), "12345\n6789\n");
}

TEST_F(Files, json_nested_without_end_is_refused) {
    write("deep.json", std::string(100'000, '[') + std::string(100'000, ']'));
    EXPECT_THROW(read_json(path("deep.json")), IoError);
    write("shallow.json", std::string(20, '[') + std::string(20, ']'));
    EXPECT_NO_THROW(read_json(path("shallow.json")));
}

TEST_F(Files, a_program_runs_in_its_directory_without_a_shell) {
    const std::string hostile = "-rf '; touch here; $(touch here)\n";
    make_directory(path(hostile));
    EXPECT_EQ(run_program({"pwd"}, path(hostile), "log"), 0);
    EXPECT_EQ(read_file(path(hostile) / "log"), path(hostile).string() + "\n");
    EXPECT_EQ(run_program({"printf", "%s", "$HOME `id` *"}, path(hostile), "log"), 0);
    EXPECT_EQ(read_file(path(hostile) / "log"), "$HOME `id` *");
    EXPECT_EQ(run_program({"false"}, directory(), "log"), 1);
    EXPECT_THROW(run_program({"tanktread-no-such-program"}, directory(), "log"), IoError);
    EXPECT_THROW(run_program({"true"}, path("nowhere"), "log"), IoError);
    EXPECT_TRUE(has_program("true"));
    EXPECT_FALSE(has_program("tanktread-no-such-program"));
}

/// Scratch disks are used by a link from results/.
TEST_F(Files, former_results_behind_a_link_are_moved_aside_on_their_own_disk) {
    make_directory(path("scratch/run"));
    write("scratch/run/PROVENANCE.json", "{}");
    fs::create_directory_symlink(path("scratch/run"), path("run"));
    for (const char* name : {"run", "run/"}) {
        const ResultsDirectory results(path(name), Start::fresh);
        EXPECT_TRUE(fs::is_symlink(path("run")));
        EXPECT_TRUE(fs::is_directory(path("scratch/run")));
        EXPECT_TRUE(fs::exists(results.moved_to() / "PROVENANCE.json"));
        EXPECT_EQ(results.moved_to().parent_path(), fs::canonical(path("scratch")));
        write("scratch/run/PROVENANCE.json", "{}");
    }
}

}  // namespace
}  // namespace tt
