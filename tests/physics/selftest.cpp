#include "verify/selftest.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace tt {

static void PrintTo(const SelftestPart& part, std::ostream* out) { *out << part.name; }

namespace {

class EveryPart : public testing::TestWithParam<SelftestPart> {};

TEST_P(EveryPart, holds) {
    for (const Check& c : GetParam().run())
        EXPECT_TRUE(c.passed()) << c.what << ": expected " << c.expected << ", got " << c.got
                                << ", error " << c.error() << ", allowed " << c.tolerance;
}

INSTANTIATE_TEST_SUITE_P(Selftest, EveryPart,
                         testing::ValuesIn(selftest_parts().begin(), selftest_parts().end()),
                         [](const auto& part) { return std::string(part.param.name); });

}  // namespace
}  // namespace tt
