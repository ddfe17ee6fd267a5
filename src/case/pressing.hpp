#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "case/layout.hpp"
#include "case/outline_contact.hpp"
#include "grid/lattice.hpp"
#include "interaction/neighbours.hpp"

namespace tt {

/// Cells that grow and give way: copies of outlines grow together from a small size, and each in
/// turn steps back and turns away from what presses on it. Where rigid outlines get stuck they
/// begin to bend, softer and softer: a point that is pressed in moves in, the outline springs back
/// in part, segments keep their length as far as they can, and the area of the cell stays. The gap
/// asked for falls at the same time.
///
/// Work is linear in the number of cells: each sweep looks at each cell once, and how many sweeps
/// it takes depends on how dense it becomes. One thread, and only arithmetic that rounds in one way
/// on every machine: the same bits everywhere.
class Pressing {
public:
    /// `shapes`: as of a Crowd. `gap`: to be left between two membranes and to the walls, of which
    /// at least half is reached.
    Pressing(const std::vector<std::vector<Vec2>>& shapes, const Room& room, double gap);

    /// One more cell.
    void add(int shape, Vec2 centre, double angle);

    /// Told after each sweep the share of their area that the cells have.
    using Watch = std::function<void(double filled)>;

    /// Grows all cells from `scale` to full size. Where they do not fit they end at the largest
    /// size at which they do, to within 1 %; returns the size reached, 1: full.
    double press(double scale, const Watch& watch);

    std::vector<Placement> cells() const;
    /// Cells looked at, over all sweeps.
    std::int64_t visits() const { return visits_; }

private:
    /// Share of the gap by which neighbours may come nearer at the end.
    static constexpr double tolerance = 0.5;

    /// An outline at rest.
    struct Form {
        std::vector<Vec2> shape;  ///< of a few points
        double area = 0.0, gyration2 = 0.0, reach = 0.0, thickness = 0.0;
        double bulge = 0.0;  ///< by how much the outline sticks out of that polygon
    };

    struct Cell {
        int form = 0;
        Vec2 centre;
        Vec2 axis;                               ///< cosine and sine of its angle
        std::vector<Vec2> bend;                  ///< as in Placement; empty: rigid
        double size = 1.0;                       ///< of the others; less where it grows anew
        double pressed = 0.0;                    ///< how deep it was when it was last looked at
        Vec2 low, high;                          ///< of its outline, in its own frame
        std::int64_t stirred = 0, visited = -1;  ///< sweeps when it last moved, was looked at
    };

    int cell_count() const { return static_cast<int>(cells_.size()); }
    Edges edges_of(int cell) const;
    void draw(int cell);
    void scale_by(double factor);
    double sweep();
    double visit(int cell);
    bool undisturbed(int cell) const;
    bool near_outline(int cell, Vec2 point, double reach) const;
    void find_pushes(int cell, int other, Vec2 shift);
    void find_wall_pushes(int cell);
    void yield(int cell, double share);
    void dent(int cell, const Push& push);
    void bend(int cell);
    void spring_back(std::vector<Vec2>& bend) const;
    void hold_lengths(Cell& cell) const;
    void hand_over_motion(Cell& cell) const;
    void hold_area(Cell& cell) const;
    double scale_of(const Cell& cell) const { return scale_ * cell.size; }
    const Form& form_of(const Cell& cell) const { return forms_[cell.form]; }
    Vec2 at(const Cell& cell, int point) const;
    bool shrink_stuck();
    bool grow_anew();
    bool soften();
    double growth_step() const;
    bool grow_from(double scale, const Watch& watch);

    Lattice box_;
    const Walls* walls_;
    int points_;
    std::vector<Form> forms_;
    double reach_ = 0.0, bulge_ = 0.0;  ///< of them the largest
    double thickness_;                  ///< of them the least
    double gap_;
    double scale_ = 1.0;
    double spring_ = 1.0;  ///< share by which a bent outline springs back a sweep; 1: rigid
    std::int64_t sweeps_ = 0, visits_ = 0;
    int shrunk_ = 0;  ///< how often stuck cells were made to grow anew

    std::vector<Cell> cells_;
    std::vector<double> x_, y_, edge_x_, edge_y_, inverse_;  ///< of all outlines, as in Edges
    std::vector<Bounds> bounds_;
    CellBins bins_;

    // Of the cell that is looked at.
    std::vector<Neighbour> near_;
    std::vector<Push> pushes_;  ///< of one neighbour
    double deepest_ = 0.0;
    Vec2 step_;
    double turn_ = 0.0;
    std::vector<Vec2> dents_;
    std::vector<double> weights_;
};

}  // namespace tt
