#include "io/frames.hpp"

#include <cmath>
#include <csignal>
#include <cstdlib>

#include <sys/resource.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/random.hpp"
#include "io/file.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

using Frames = TemporaryDirectory;

FramesHeader header() {
    FramesHeader h;
    h.name = "two cells";
    h.dx = 2e-7;
    h.dt = 1e-7;
    h.length = 8e-7;
    h.width = 6e-7;
    h.nx = 4;
    h.ny = 3;
    h.first = {0, 2, 5};
    return h;
}

Frame frame(int number) {
    Frame f;
    f.time = number * 1e-3;
    f.step = number * 1000;
    f.nodes = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10.0 + number};
    f.node_force.assign(10, 0.5);
    f.node_velocity.assign(10, -0.25);
    f.velocity.assign(24, 1.5f);
    f.pressure.assign(12, 2.5f);
    f.cytoplasm.assign(12, 1.0f);
    return f;
}

std::vector<FrameTime> times(int count) {
    std::vector<FrameTime> kept;
    for (int number = 0; number < count; ++number) kept.push_back({number * 1e-3, number * 1000});
    return kept;
}

void expect_frames(const std::filesystem::path& path, int count) {
    const FramesReader reader(path);
    EXPECT_EQ(reader.header().name, "two cells");
    EXPECT_EQ(reader.header().first, header().first);
    EXPECT_EQ(reader.header().width, 6e-7);
    ASSERT_EQ(reader.count(), count);
    for (int number = 0; number < count; ++number) {
        const Frame read = reader.frame(number);
        EXPECT_EQ(read.step, number * 1000);
        EXPECT_EQ(read.nodes, frame(number).nodes);
        EXPECT_EQ(read.velocity, frame(number).velocity);
        EXPECT_EQ(reader.time(number), number * 1e-3);
    }
}

TEST_F(Frames, can_be_read_after_each_one_and_after_the_merge) {
    FramesWriter writer(directory(), header(), {});
    for (int number = 0; number < 3; ++number) {
        writer.write(frame(number));
        expect_frames(path("frames.h5"), number + 1);
    }
    writer.merge();
    expect_frames(path("frames.h5"), 3);
    EXPECT_FALSE(std::filesystem::exists(path("frames")));
}

TEST_F(Frames, those_after_the_checkpoint_are_dropped_on_resume) {
    {
        FramesWriter writer(directory(), header(), {});
        for (int number = 0; number < 4; ++number) writer.write(frame(number));
    }
    FramesWriter resumed(directory(), header(), times(2));
    expect_frames(path("frames.h5"), 2);
    resumed.write(frame(2));
    expect_frames(path("frames.h5"), 3);
}

TEST_F(Frames, a_merged_file_can_be_continued) {
    {
        FramesWriter writer(directory(), header(), {});
        for (int number = 0; number < 3; ++number) writer.write(frame(number));
        writer.merge();
    }
    FramesWriter resumed(directory(), header(), times(2));
    expect_frames(path("frames.h5"), 2);
    resumed.write(frame(2));
    resumed.write(frame(3));
    resumed.merge();
    expect_frames(path("frames.h5"), 4);
}

/// Cells that come have places after those that were there; a frame from before has none of theirs.
TEST_F(Frames, grow_with_the_cells_that_come) {
    const auto expect_grown = [&] {
        const FramesReader reader(path("frames.h5"));
        EXPECT_EQ(reader.header().first, (std::vector<std::int32_t>{0, 2, 5, 9}));
        EXPECT_EQ(reader.header().kind, (std::vector<std::int32_t>{0, 0, 1}));
        ASSERT_EQ(reader.count(), 2);
        EXPECT_TRUE(reader.faults().empty());
        EXPECT_EQ(reader.stored(0).nodes, frame(0).nodes);
        const Frame before = reader.frame(0), after = reader.frame(1);
        ASSERT_EQ(before.nodes.size(), 18u);
        EXPECT_EQ(before.nodes[9], 10.0);
        EXPECT_TRUE(std::isnan(before.nodes[10]));
        EXPECT_TRUE(std::isnan(before.node_velocity[17]));
        EXPECT_EQ(after.nodes[17], 18.0);
    };
    FramesWriter writer(directory(), header(), {});
    writer.write(frame(0));
    FramesHeader grown = header();
    grown.first = {0, 2, 5, 9};
    grown.kind = {0, 0, 1};
    writer.add_cells(grown);
    Frame more = frame(1);
    for (double x = 11.0; x <= 18.0; ++x) more.nodes.push_back(x);
    more.node_force.resize(18, 0.5);
    more.node_velocity.resize(18, -0.25);
    writer.write(more);
    expect_grown();
    writer.merge();
    expect_grown();
}

TEST_F(Frames, a_damaged_file_is_an_error_and_no_crash) {
    replace_file(path("frames.h5"), "not HDF5", Durability::process);
    EXPECT_THROW(FramesReader{path("frames.h5")}, IoError);
}

/// The frames that can be read are true; whether anything was told.
bool expect_true_frames(const std::filesystem::path& path) {
    try {
        const FramesReader reader(path);
        for (int k = 0; k < reader.count(); ++k) {
            const Frame read = reader.frame(k), sound = frame(static_cast<int>(reader.number(k)));
            EXPECT_EQ(read.step, sound.step);
            EXPECT_EQ(read.time, sound.time);
            EXPECT_EQ(read.nodes, sound.nodes);
            EXPECT_EQ(read.node_force, sound.node_force);
            EXPECT_EQ(read.velocity, sound.velocity);
            EXPECT_EQ(read.pressure, sound.pressure);
        }
        return !reader.faults().empty();
    } catch (const IoError&) {
        return true;
    }
}

/// Flips a bit, cuts, or zeroes a piece; `number` picks kind and place.
std::string damaged(std::string bytes, int number) {
    Random random(static_cast<std::uint64_t>(number) + 1);
    const auto at =
        static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(bytes.size())));
    const std::size_t length = std::min<std::size_t>(number % 2 ? 64 : 4096, bytes.size() - at);
    if (number % 3 == 0) bytes[at] = static_cast<char>(bytes[at] ^ 1 << number % 8);
    if (number % 3 == 1) bytes.resize(at);
    if (number % 3 == 2) bytes.replace(at, length, length, '\0');
    return bytes;
}

/// 450 on demand: TANKTREAD_DAMAGES=450
int damages() {
    const char* const asked = std::getenv("TANKTREAD_DAMAGES");
    return asked ? std::atoi(asked) : 24;
}

TEST_F(Frames, every_damage_is_told_and_no_damaged_frame_is_read) {
    {
        FramesWriter writer(directory(), header(), {});
        for (int number = 0; number < 5; ++number) writer.write(frame(number));
        const auto part = path("frames/000003.h5");
        for (const auto& file : {part, path("frames.h5")}) {
            const std::string sound = read_file(file);
            for (int number = 0; number < damages(); ++number) {
                const std::string bytes = damaged(sound, number);
                if (bytes == sound) continue;
                replace_file(file, bytes, Durability::process);
                EXPECT_TRUE(expect_true_frames(path("frames.h5"))) << file << ' ' << number;
                if (file == part) {
                    EXPECT_EQ(FramesReader(path("frames.h5")).count(), 4);
                } else {  // only an index
                    EXPECT_EQ(FramesReader(path("frames.h5")).count(), 5);
                }
            }
            replace_file(file, sound, Durability::process);
        }
        writer.merge();
    }
    const std::string sound = read_file(path("frames.h5"));
    for (int number = 0; number < damages(); ++number) {
        const std::string bytes = damaged(sound, number);
        if (bytes == sound) continue;
        replace_file(path("frames.h5"), bytes, Durability::process);
        EXPECT_TRUE(expect_true_frames(path("frames.h5"))) << number;
    }
}

TEST_F(Frames, a_damaged_one_costs_only_itself_and_is_kept_beside) {
    FramesWriter writer(directory(), header(), {});
    for (int number = 0; number < 4; ++number) writer.write(frame(number));
    replace_file(path("frames/000002.h5"), "", Durability::process);
    const std::vector<std::string> faults = writer.merge();
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_NE(faults[0].find("000002.h5 is damaged and left out"), std::string::npos) << faults[0];
    EXPECT_NE(faults[1].find("lacks frame 2"), std::string::npos) << faults[1];
    const FramesReader reader(path("frames.h5"));
    ASSERT_EQ(reader.count(), 3);
    EXPECT_EQ(reader.number(2), 3);
    EXPECT_EQ(reader.frame(2).nodes, frame(3).nodes);
    EXPECT_TRUE(std::filesystem::exists(path("frames/000002.h5")));
    EXPECT_FALSE(std::filesystem::exists(path("frames/000003.h5")));
}

/// A size limit fails the writes beyond it, wherever in HDF5 they come from.
TEST_F(Frames, a_write_error_at_any_place_of_the_merge_leaves_all_as_it_was) {
    FramesWriter writer(directory(), header(), {});
    for (int number = 0; number < 6; ++number) writer.write(frame(number));
    const auto old_action = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    for (rlim_t limit = 0; limit < 12000; limit += 377) {
        const rlimit size{limit, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &size);
        EXPECT_THROW(writer.merge(), IoError) << limit;
        setrlimit(RLIMIT_FSIZE, &before);
        expect_frames(path("frames.h5"), 6);
        EXPECT_FALSE(std::filesystem::exists(path("frames.h5.tmp")));
    }
    std::signal(SIGXFSZ, old_action);
    writer.merge();
    expect_frames(path("frames.h5"), 6);
}

TEST_F(Frames, without_fields_and_compressed_read_as_they_were) {
    FramesHeader compressed = header();
    compressed.compressed = true;
    FramesWriter writer(directory(), compressed, {});
    Frame membranes = frame(1);
    membranes.velocity.clear();
    membranes.pressure.clear();
    membranes.cytoplasm.clear();
    writer.write(frame(0));
    writer.write(membranes);
    for (const bool merged : {false, true}) {
        if (merged) writer.merge();
        const FramesReader reader(path("frames.h5"));
        ASSERT_EQ(reader.count(), 2) << merged;
        EXPECT_TRUE(reader.faults().empty());
        EXPECT_TRUE(reader.has_fields(0));
        EXPECT_FALSE(reader.has_fields(1));
        EXPECT_EQ(reader.frame(0).pressure, frame(0).pressure);
        EXPECT_EQ(reader.frame(1).nodes, frame(1).nodes);
        EXPECT_TRUE(reader.frame(1).velocity.empty());
    }
}

TEST_F(Frames, are_the_same_bytes_when_written_in_pieces) {
    std::string whole;
    {
        FramesWriter writer(directory(), header(), {});
        for (int number = 0; number < 5; ++number) writer.write(frame(number));
        writer.merge();
        whole = read_file(path("frames.h5"));
    }
    FramesWriter(directory(), header(), times(4)).write(frame(4));
    FramesWriter resumed(directory(), header(), times(3));
    resumed.write(frame(3));
    resumed.write(frame(4));
    resumed.merge();
    EXPECT_TRUE(read_file(path("frames.h5")) == whole);
}

TEST_F(Frames, are_what_h5py_expects) {
    const std::string python = "/usr/bin/python3";
    ASSERT_EQ(std::system((python + " -c 'import h5py' 2>/dev/null").c_str()), 0)
        << "python3-h5py is missing; ./check installs it";
    FramesWriter writer(directory(), header(), {});
    writer.write(frame(0));
    writer.write(frame(1));
    const std::string script =
        "import h5py, sys\n"
        "with h5py.File(sys.argv[1], 'r') as f:\n"
        "    assert f.attrs['name'] == 'two cells' and f.attrs['nx'] == 4 and "
        "list(f.attrs['lengths']) == [8e-7, 6e-7]\n"
        "    assert list(f['first']) == [0, 2, 5] and sorted(f['frames']) == ['000000', '000001']\n"
        "    g = f['frames/000001']\n"
        "    assert g.attrs['time'] == 1e-3 and g.attrs['step'] == 1000 and "
        "g['nodes'].attrs['unit'] == 'm'\n"
        "    assert g['nodes'].shape == (5, 2) and g['nodes'][4, 1] == 11.0\n"
        "    assert list(f['time']) == [0, 1e-3] and list(f['step']) == [0, 1000]\n"
        "    assert g['velocity'].shape == (3, 4, 2) and g['velocity'].dtype == 'float32'\n";
    replace_file(path("read.py"), script, Durability::process);
    const std::string read =
        python + " " + path("read.py").string() + " " + path("frames.h5").string();
    EXPECT_EQ(std::system(read.c_str()), 0);
    writer.merge();
    EXPECT_EQ(std::system(read.c_str()), 0);
}

}  // namespace
}  // namespace tt
