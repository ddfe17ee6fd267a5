#include "observe/pace.hpp"

#include <cmath>

#include "membrane/outline.hpp"

namespace tt {

double mean_extension(const Suspension& cells) {
    if (cells.cell_count() == 0) return 1.0;
    double sum = 0.0;
    for (int c = 0; c < cells.cell_count(); ++c) {
        sum +=
            perimeter(outline(cells, c)) / cells.reference_perimeter[static_cast<std::size_t>(c)];
    }
    return sum / cells.cell_count();
}

void Pace::update(std::int64_t step) {
    const Clock::time_point now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - last_).count();
    if (elapsed < 0.05) return;
    const double fresh = static_cast<double>(step - step_) / elapsed;
    constexpr double memory = 5.0;  // seconds
    const double keep = rate_ > 0.0 ? std::exp(-elapsed / memory) : 0.0;
    rate_ = keep * rate_ + (1.0 - keep) * fresh;
    step_ = step;
    last_ = now;
}

double Pace::mean_rate(std::int64_t step) const {
    const double elapsed = seconds();
    return elapsed > 0.0 ? static_cast<double>(step - first_step_) / elapsed : 0.0;
}

}  // namespace tt
