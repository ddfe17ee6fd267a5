// A program of someone else that computes with the layers: the first scene of the selftest, Poiseuille flow.
#include <cstdio>

#include "base/version.hpp"
#include "report/html.hpp"
#include "verify/selftest.hpp"

int main() {
    std::printf("tanktread %s\n", tt::version_text().c_str());
    int failed = 0;
    for (const tt::Check& check : tt::selftest_parts()[0].run()) {
        std::printf("%s: %g for %g\n", check.what.c_str(), check.got, check.expected);
        failed += check.passed() ? 0 : 1;
    }
    return failed;
}
