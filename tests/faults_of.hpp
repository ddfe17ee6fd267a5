#pragma once

#include <string>

#include "base/error.hpp"

namespace tt {

/// All faults that `act` throws as a CaseError, a line each; empty if none.
template <class Act>
std::string faults_of(Act&& act) {
    std::string all;
    try {
        act();
    } catch (const CaseError& error) {
        for (const Fault& fault : error.faults()) all += to_string(fault) + '\n';
    }
    return all;
}

}  // namespace tt
