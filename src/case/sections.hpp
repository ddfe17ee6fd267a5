#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/choose.hpp"
#include "case/judge.hpp"

namespace tt {

/// Keys of sections, forks and stretches that lack or contradict each other: names that are not
/// there, twice the same.
void judge_section_keys(Judge& judge, const Case& c);

/// Sections that lie on no channel, or on several: with what to write.
void judge_section_places(Judge& judge, const Case& c);

/// The sections of a case on its lattice. `walls` may be none. CaseError where one meets too little
/// of it.
std::vector<Section> lattice_sections(const Case& c, const Choice& choice, const Walls* walls);

/// Forks and stretches of the sections of a model. CaseError where plasma does not flow so.
std::vector<Fork> forks_of(const Case& c, const std::vector<Section>& sections);
std::vector<Stretch> stretches_of(const Case& c, const Choice& choice);

}  // namespace tt
