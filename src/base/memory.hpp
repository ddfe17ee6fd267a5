#pragma once

#include <filesystem>
#include <vector>

namespace tt {

/// How much memory this process may use [bytes]: that of the machine, and no more than the limits
/// of the process (ulimit) and of its control groups allow.
double usable_memory();

/// How much memory nobody uses now, as the system judges [bytes]; infinite where it does not say.
double free_memory();

/// The smallest limit [bytes] among control groups of `memory`. Version 2 keeps it in memory.max,
/// version 1 in memory.limit_in_bytes. Infinite: none has one.
double memory_by_limit(const std::vector<std::filesystem::path>& groups);

}  // namespace tt
