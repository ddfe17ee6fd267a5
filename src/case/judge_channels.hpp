#pragma once

#include <string>

#include "case/judge.hpp"

namespace tt {

/// What changes in time, at `path`; `why` it cannot, or empty.
void judge_wave(Judge& judge, const WaveCase& wave, const std::string& path,
                const std::string& why);

/// Channels between ports: what drives the flow are they, and the box is that of the drawing.
void judge_ports(Judge& judge, const Case& c);

/// Channels that feed ports, of cells that have a size.
void judge_feeds(Judge& judge, const Case& c);

/// Shapes of walls that leave no way between them.
void judge_walls(Judge& judge, const Case& c);

}  // namespace tt
