#include <cstddef>
#include <cstdint>

#include "one_case.hpp"

/// libFuzzer: `cmake -DCMAKE_CXX_COMPILER=clang++ -DTT_FUZZ=ON …`, then
/// `fuzz_case tests/fuzz/corpus`. What it finds is kept there and replayed by every test run.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    tt::try_as_case({reinterpret_cast<const char*>(data), size});
    return 0;
}
