#pragma once

#include "case/choose.hpp"

namespace tt {

/// Sites and their spacing. Of a box such that its length is a whole number of sites too, at or
/// just finer than `dx`. Of a network as `dx` says, else the largest spacing near to what resolves
/// the ports that divides the drawing; else that. Throws CaseError where `dx` does not divide a
/// box.
void choose_grid(const Case& c, Choice& choice);

}  // namespace tt
