#pragma once

#include <optional>
#include <string>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tt {

/// --picture [FILE].
struct PictureOption {
    const CLI::Option* option = nullptr;
    std::string file;  ///< empty: NAME.png
    bool wanted() const;
};
void add_picture_option(CLI::App& verb, PictureOption& option);

/// Draws a case as it is known: its walls and ports; with `choice` which way plasma goes; with
/// `model` and `initial` the cells. Returns the file.
std::string draw_picture(const PictureOption& option, const Case& c, const Choice* choice = nullptr,
                         const Model* model = nullptr, const State* initial = nullptr);

/// The same of loops alone [m].
std::string draw_picture(const PictureOption& option, const DrawnShape& drawn,
                         const std::string& name);

/// CommandError or IoError if no picture can be drawn, before anything is computed.
void expect_drawable(const PictureOption& option);

}  // namespace tt
