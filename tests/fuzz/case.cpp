#include <cstddef>
#include <cstdint>

#include "one_case.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    tt::try_as_case({reinterpret_cast<const char*>(data), size});
    return 0;
}
