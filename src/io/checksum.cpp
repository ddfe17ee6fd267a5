#include "io/checksum.hpp"

#include <new>

#include <fmt/format.h>
#include <xxhash.h>

namespace tt {

Checksum::Checksum() : state_(XXH64_createState()) {
    if (state_ == nullptr) throw std::bad_alloc();
    XXH64_reset(static_cast<XXH64_state_t*>(state_), 0);
}

Checksum::~Checksum() { XXH64_freeState(static_cast<XXH64_state_t*>(state_)); }

void Checksum::add(const void* bytes, std::size_t count) {
    if (count > 0) XXH64_update(static_cast<XXH64_state_t*>(state_), bytes, count);
}

std::uint64_t Checksum::value() const {
    return XXH64_digest(static_cast<const XXH64_state_t*>(state_));
}

std::uint64_t checksum(std::string_view bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

std::string hexadecimal(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace tt
