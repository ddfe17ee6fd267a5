#include "io/csv.hpp"

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/file.hpp"
#include "observe/measures.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

using Tables = TemporaryDirectory;

TEST_F(Tables, every_column_names_its_unit) {
    const std::string header = csv_header<RunMeasures>();
    EXPECT_EQ(header.rfind("time [s],step,mean_velocity [m/s],pseudo_shear_rate [/s],", 0), 0u)
        << header;
    EXPECT_NE(header.find(",mu_app [Pa s],mu_rel,"), std::string::npos) << header;
}

TEST_F(Tables, numbers_read_back_to_the_same_bits) {
    CellMeasures row;
    row.time = Time{0.1 + 0.2};
    row.cell = 11;
    row.phase = -std::numeric_limits<double>::denorm_min();
    row.area = Area{std::nextafter(5e-11, 1.0)};
    row.stretch_min = std::nan("");
    OutputFile(path("cells.csv"), OutputFile::Mode::create)
        .append(csv_header<CellMeasures>() + csv_row(row));
    const Table table = read_csv(path("cells.csv"));
    ASSERT_EQ(table.rows(), 1u);
    EXPECT_EQ(table.column("time")[0], row.time.si);
    EXPECT_EQ(table.column("cell")[0], 11.0);
    EXPECT_EQ(table.column("phase")[0], row.phase);
    EXPECT_EQ(table.column("area")[0], row.area.si);
    EXPECT_TRUE(std::isnan(table.column("stretch_min")[0]));
    EXPECT_EQ(table.unit("area"), "m^2");
}

TEST_F(Tables, a_ragged_line_is_named) {
    OutputFile(path("t.csv"), OutputFile::Mode::create).append("a,b\n1,2\n1\n");
    try {
        read_csv(path("t.csv"));
        FAIL() << "no error";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("t.csv:3:"), std::string::npos) << error.what();
    }
}

TEST_F(Tables, a_file_cut_to_what_a_checkpoint_remembers_goes_on_from_there) {
    OutputFile file(path("t.csv"), OutputFile::Mode::append);
    file.append("a\n1\n");
    const std::int64_t size = file.size();
    file.append("2\n3");
    file.cut(size);
    file.append("7\n");
    EXPECT_EQ(read_file(path("t.csv")), "a\n1\n7\n");
    EXPECT_THROW(file.cut(1000), IoError);
}

TEST_F(Tables, an_append_that_does_not_fit_leaves_the_file_as_it_was) {
    OutputFile file(path("t.csv"), OutputFile::Mode::append);
    file.append("a\n1\n");
    rlimit former{};
    getrlimit(RLIMIT_FSIZE, &former);
    const rlimit full{8, former.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    EXPECT_THROW(file.append("2\n3\n4\n5\n"), IoError);
    setrlimit(RLIMIT_FSIZE, &former);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(read_file(path("t.csv")), "a\n1\n");
}

}  // namespace
}  // namespace tt
