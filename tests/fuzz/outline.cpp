#include <cstddef>
#include <cstdint>

#include "one_outline.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    tt::try_as_outline({reinterpret_cast<const char*>(data), size});
    return 0;
}
