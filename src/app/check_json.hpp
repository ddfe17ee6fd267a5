#pragma once

#include "app/probe.hpp"
#include "case/appraise.hpp"
#include "case/case.hpp"
#include "case/choose.hpp"
#include "io/json.hpp"

namespace tt {

/// What `check --json` prints.
Json to_json(const Case& c, const Choice& choice, const Appraisal& a, const Probe& p);

}  // namespace tt
