#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tt {

/// What is wrong with `name` as that of a run and of its directory, and what to write; nothing if
/// it will do. A name stays within results/ and can be written on every file system.
std::optional<std::string> fault_of_name(std::string_view name);

/// A name for a run made of `text`, the name of a file: what may not stand in a name becomes '_'.
std::string name_from(std::string_view text);

}  // namespace tt
