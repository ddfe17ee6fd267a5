#pragma once

#include "grid/lattice.hpp"
#include "interaction/contact.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Lists pairs anew where nodes have moved too far since the last time; returns the common drift of
/// the cells since then. Allocates where there are more pairs than ever before. Team function.
Vec2 update_pairs(const ContactModel& model, const Lattice& lattice, const Suspension& cells,
                  ContactState& contact);

/// Finds the pairs of one cell that are within reach now, each with the nearest point of the
/// partner.
void find_hits(const ContactModel& model, const Suspension& cells, ContactState& contact, int cell,
               Vec2 drift);

}  // namespace tt
