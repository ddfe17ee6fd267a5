#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tt {

/// XXH64 (Collet) of bytes that come in pieces. Finds damage, not forgery.
class Checksum {
public:
    Checksum();
    ~Checksum();
    Checksum(const Checksum&) = delete;
    Checksum& operator=(const Checksum&) = delete;

    void add(const void* bytes, std::size_t count);
    std::uint64_t value() const;

private:
    void* state_;
};

std::uint64_t checksum(std::string_view bytes);

/// Sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t value);

}  // namespace tt
