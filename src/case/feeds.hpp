#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "simulation/model.hpp"

namespace tt {

/// Does this port let cells in? Without cells it holds its flow as others do.
inline bool lets_cells_in(const Case& c, const PortCase& port) {
    return port.feeds() && !c.numerics.fluid_only;
}

/// Room that a cell is given on either side of a port that feeds, where it is led: more than a cell
/// is long, however it is drawn out.
Length room_at_feed(const Case& c);

/// Length of the channel that feeds through a port of this width, where `auto`.
Length feed_length(const Case& c, const FeedCase& feed, Length port_width);

/// Why cells cannot come in, and what to write: something is in the way behind or before the port.
std::vector<std::string> faults_of_feeds(const Case& c, const Choice& choice, const Walls& walls);

/// The channels that feed a network whose model, but for them, is `network`.
std::vector<Feed> feeds_of(const Case& c, const Choice& choice, const Model& network);

/// The walls of a network with its ports closed: as far as no cell may lie at the start, and before
/// a port that feeds as far as cells are led that come in.
Walls with_closed_ports(const Model& network);

}  // namespace tt
