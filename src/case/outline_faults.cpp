#include "case/outline_faults.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "membrane/outline_checks.hpp"

namespace tt {
namespace {

constexpr std::size_t fewest = 8;

/// Tells faults of one outline by their places in the file.
class OutlineJudge {
public:
    OutlineJudge(const GivenPoints& given, const std::string& file) : given_(given), file_(file) {}

    std::optional<Fault> too_few() const {
        if (given_.points.size() >= fewest) return std::nullopt;
        return fault(0, fmt::format("{} points are too few for an outline; at least {} are needed",
                                    given_.points.size(), fewest));
    }

    std::optional<Fault> on_one_line() const {
        const Vec2 first = given_.points.front();
        const auto apart = [&](Vec2 p) { return norm(p - first); };
        const Vec2 far = *std::max_element(given_.points.begin(), given_.points.end(),
                                           [&](Vec2 a, Vec2 b) { return apart(a) < apart(b); });
        const double rounding = 1e-9 * dot(far - first, far - first);
        for (const Vec2 p : given_.points)
            if (std::abs(cross(far - first, p - first)) > rounding) return std::nullopt;
        return fault(0, fmt::format("all {} points, from {} to {}, lie on one straight line: they "
                                    "enclose no area",
                                    count(), place(0), place(count() - 1)));
    }

    std::optional<Fault> run_twice() const {
        const int half = count() / 2;
        if (count() % 2 != 0 || !std::equal(given_.points.begin(), given_.points.begin() + half,
                                            given_.points.begin() + half))
            return std::nullopt;
        return fault(half, fmt::format("the outline is written twice over: {} begins again what "
                                       "{} began; leave one of the two out",
                                       place(half), place(0)));
    }

    std::optional<Fault> crossing() const {
        std::vector<double> x, y;
        for (const Vec2 p : given_.points) {
            x.push_back(p.x);
            y.push_back(p.y);
        }
        const auto found = self_crossing({x, y});
        if (!found) return std::nullopt;
        const auto [a, b] = *found;
        if (given_.points[a] != given_.points[b]) return crossing_of(a, b);
        if (next(next(a)) == b) return spur(a, next(a), b);
        if (next(next(b)) == a) return spur(b, next(b), a);
        return fault(a, fmt::format("the outline touches itself: {} and {} are the same point, "
                                    "{}; the outline of a cell is one simple loop",
                                    place(a), place(b), text(given_.points[a])));
    }

private:
    int count() const { return static_cast<int>(given_.points.size()); }
    int next(int k) const { return k + 1 < count() ? k + 1 : 0; }

    Fault spur(int before, int tip, int after) const {
        return fault(before, fmt::format("the outline runs out to {} and straight back: {} and {} "
                                         "are the same point, {}; leave the spur out",
                                         place(tip), place(before), place(after),
                                         text(given_.points[before])));
    }

    Fault crossing_of(int a, int b) const {
        return fault(a, fmt::format("the outline crosses or touches itself near {}: its way from "
                                    "{} to {} meets that from {} to {}; the outline of a cell is "
                                    "one simple loop",
                                    text(meeting(a, b)), place(a), place(next(a)), place(b),
                                    place(next(b))));
    }

    /// Where the two segments meet; of two that run along each other, an end of one.
    Vec2 meeting(int a, int b) const {
        const Vec2 p = given_.points[a], q = given_.points[b];
        const Vec2 along = given_.points[next(a)] - p, other = given_.points[next(b)] - q;
        const double area = cross(along, other);
        if (area == 0.0) return next(a) == b ? q : p;
        return p + std::clamp(cross(q - p, other) / area, 0.0, 1.0) * along;
    }

    std::string place(int k) const {
        return given_.lines.empty() ? fmt::format("point {}", given_.numbers[k])
                                    : fmt::format("line {}", given_.lines[k]);
    }
    static std::string text(Vec2 p) { return fmt::format("({:.6g}, {:.6g})", p.x, p.y); }

    Fault fault(int k, std::string message) const {
        const int line = given_.lines.empty() || given_.points.empty() ? 0 : given_.lines[k];
        return {file_, line, line > 0 ? 1 : 0, std::move(message)};
    }

    const GivenPoints& given_;
    const std::string& file_;
};

}  // namespace

std::optional<Fault> outline_fault(const GivenPoints& given, const std::string& file) {
    const OutlineJudge judge(given, file);
    if (auto fault = judge.too_few()) return fault;
    if (auto fault = judge.on_one_line()) return fault;
    if (auto fault = judge.run_twice()) return fault;
    return judge.crossing();
}

}  // namespace tt
