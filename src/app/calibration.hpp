#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/targets.hpp"
#include "fit/search.hpp"
#include "io/json.hpp"

namespace tt {

/// A pair that was tried and what it gave.
struct TriedPair {
    double D = 0.0, beta = 0.0;
    std::vector<double> found;    ///< mean over seeds, for each target; empty: it failed
    std::vector<double> scatter;  ///< standard deviation over seeds; NaN with one seed
    std::string failure;          ///< why, if it failed
};

/// A search for D and beta that has ended, or as far as it came.
struct Calibration {
    Targets targets;
    Search search;
    std::vector<TriedPair> pairs;  ///< as the trials of the search

    std::vector<Goal> goals() const;
    const TriedPair& best() const { return pairs[search.standpoint().best]; }
    Vec2 place(double D, double beta) const {
        return {targets.D.place(D), targets.beta.place(beta)};
    }
};

/// The best beta for a D.
struct ValleyPoint {
    double D = 0.0, beta = 0.0, chi_squared = 0.0;
    bool at_end = false;  ///< of beta's range
};
std::vector<ValleyPoint> valley_of(const Calibration& calibration, int points);

/// What the calibration found, for people, in 80 columns.
std::string describe(const Calibration& calibration);

/// The same and every run, for programs: calibration.json.
Json to_json(const Calibration& calibration);

/// Draws valley.svg and valley.png, with data and script beside them.
void draw_valley(const Calibration& calibration, const std::filesystem::path& out);

}  // namespace tt
