#pragma once

#include <filesystem>
#include <memory>

#include "observe/event_table.hpp"

namespace tt {

/// left.csv: a row for each cell that left through a port.
std::unique_ptr<EventTable> left_cells(const Schedule& schedule,
                                       const std::filesystem::path& directory);

/// entered.csv: a row for each cell that came in through a port.
std::unique_ptr<EventTable> entered_cells(const Schedule& schedule,
                                          const std::filesystem::path& directory);

}  // namespace tt
