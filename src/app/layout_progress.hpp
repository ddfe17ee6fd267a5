#pragma once

#include "case/random_layout.hpp"
#include "observe/progress.hpp"

namespace tt {

/// Shows on stderr how far a random layout has come, where that takes more than two seconds.
LayoutWatch layout_progress(ProgressMode mode);

}  // namespace tt
