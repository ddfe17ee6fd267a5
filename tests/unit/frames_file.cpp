#include "io/frames.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/error.hpp"
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
    FramesWriter writer(directory(), header(), 0);
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
        FramesWriter writer(directory(), header(), 0);
        for (int number = 0; number < 4; ++number) writer.write(frame(number));
    }
    FramesWriter resumed(directory(), header(), 2);
    expect_frames(path("frames.h5"), 2);
    resumed.write(frame(2));
    expect_frames(path("frames.h5"), 3);
}

TEST_F(Frames, a_merged_file_can_be_continued) {
    {
        FramesWriter writer(directory(), header(), 0);
        for (int number = 0; number < 3; ++number) writer.write(frame(number));
        writer.merge();
    }
    FramesWriter resumed(directory(), header(), 2);
    expect_frames(path("frames.h5"), 2);
    resumed.write(frame(2));
    resumed.write(frame(3));
    resumed.merge();
    expect_frames(path("frames.h5"), 4);
}

TEST_F(Frames, a_damaged_file_is_an_error_and_no_crash) {
    replace_file(path("frames.h5"), "not HDF5", Durability::process);
    EXPECT_THROW(FramesReader{path("frames.h5")}, IoError);
}

TEST_F(Frames, are_what_h5py_expects) {
    const std::string python = "/usr/bin/python3";
    ASSERT_EQ(std::system((python + " -c 'import h5py' 2>/dev/null").c_str()), 0)
        << "python3-h5py is missing; ./check installs it";
    FramesWriter writer(directory(), header(), 0);
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
