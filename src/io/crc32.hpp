#pragma once

#include <cstdint>
#include <string_view>

namespace tt {

/// CRC-32 (zlib), for files that other programs read too: Python can check it without a package.
/// `before` is that of the bytes in front, if they come in pieces.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace tt
