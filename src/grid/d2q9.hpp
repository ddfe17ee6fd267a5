#pragma once

#include <array>

namespace tt::d2q9 {

/// The nine velocities: rest, the four axes, the four diagonals. Opposite pairs are (1,3) (2,4)
/// (5,7) (6,8).
inline constexpr int count = 9;
inline constexpr std::array<int, count> cx{0, 1, 0, -1, 0, 1, -1, -1, 1};
inline constexpr std::array<int, count> cy{0, 0, 1, 0, -1, 1, 1, -1, -1};
inline constexpr std::array<int, count> opposite{0, 3, 4, 1, 2, 7, 8, 5, 6};
/// Their mirror images in a line across x, (−c_x, c_y), and in one across y.
inline constexpr std::array<int, count> mirrored_x{0, 3, 2, 1, 4, 6, 5, 8, 7};
inline constexpr std::array<int, count> mirrored_y{0, 1, 4, 3, 2, 8, 7, 6, 5};
inline constexpr std::array<double, count> weight{4.0 / 9,  1.0 / 9,  1.0 / 9,  1.0 / 9, 1.0 / 9,
                                                  1.0 / 36, 1.0 / 36, 1.0 / 36, 1.0 / 36};
inline constexpr double sound_speed_squared = 1.0 / 3.0;

}  // namespace tt::d2q9
