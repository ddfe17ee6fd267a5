#include "case/resolve.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/drawn_file.hpp"
#include "case/kinds.hpp"
#include "case/write.hpp"
#include "io/checksum.hpp"

namespace tt {
namespace {

/// A line for a quantity: its key, SI value, lattice value.
template <Dimension D>
std::string line(std::string_view key, Quantity<D> value, const Scales& scales) {
    return fmt::format("# {:<24} {:<22} {:.17g}\n", key, rounded_text(value, 10),
                       scales.to_lattice(value));
}

std::string line(std::string_view key, double value) {
    return fmt::format("# {:<24} {}\n", key, to_text(value));
}

}  // namespace

Case named_by_content(Case c) {
    const auto name = [](const std::string& bytes) {
        return "content " + hexadecimal(checksum(bytes));
    };
    for (CellTypeCase* type : cell_types(c))
        if (const CellOutline* outline = type->outline())
            std::get<OutlineShape>(type->shape).file = name(outline->bytes);
    if (auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape)) {
        *drawn = as_points(*drawn);
        drawn->file = name(drawn->bytes);
    }
    return c;
}

namespace {

/// Keeps what the files of a case hold, and names them in it as they are kept. Two files of one
/// name are told apart.
std::vector<InputFile> keep_inputs(Case& c) {
    std::vector<InputFile> inputs;
    const auto add = [&](const std::string& file, const std::string& bytes) {
        std::string name = std::filesystem::path(file).filename().string();
        const auto taken = [&](const InputFile& other) {
            return other.name == "inputs/" + name && other.bytes != bytes;
        };
        while (std::any_of(inputs.begin(), inputs.end(), taken)) name = "other-" + name;
        name = "inputs/" + name;
        const auto same = [&](const InputFile& other) { return other.name == name; };
        if (std::none_of(inputs.begin(), inputs.end(), same)) inputs.push_back({name, bytes});
        return name;
    };
    for (CellTypeCase* type : cell_types(c))
        if (const CellOutline* outline = type->outline())
            std::get<OutlineShape>(type->shape).file = add(outline->file, outline->bytes);
    if (auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape)) {
        if (is_converted(*drawn)) add(drawn->file, drawn->original);
        *drawn = as_points(*drawn);
        drawn->file = add(drawn->file, drawn->bytes);
    }
    return inputs;
}

/// Of the cells of one kind.
std::string lines_of_cells(const Case& c, const KindChoice& choice, const Scales& s) {
    return line("cytoplasm_viscosity", c.cells.cytoplasm_viscosity, s) +
           line("radius", equivalent_radius(c), s) +
           line("shear_modulus", c.membrane.shear_modulus, s) +
           line("bending_modulus", c.membrane.bending_modulus, s) +
           line("area_stiffness", choice.area_stiffness, s);
}

}  // namespace

std::vector<InputFile> inputs_of(const Case& c) {
    Case copy = c;
    return keep_inputs(copy);
}

std::string resolved_toml(const Case& c, const Choice& choice, const Model& model) {
    const Scales& s = model.scales;
    Case standing_alone = c;
    keep_inputs(standing_alone);
    std::string text = to_toml(standing_alone);
    text += fmt::format("\n# What follows from these.{:<28}{}\n", "", "in lattice units");
    text += fmt::format("# {:<24} {} x {} sites\n", "lattice", choice.nx, choice.ny);
    text += line("dx", choice.dx, s);
    text += line("dt", choice.dt, s);
    text += line("relaxation_time", choice.relaxation_time);
    text += line("density_scale", choice.density_scale);
    text += fmt::format("# {:<24} {}\n", "equilibrium", word_of(choice.equilibrium));
    text += fmt::format("# {:<24} {}\n", "precision", word_of(choice.precision));
    text += line("cell_reynolds_as_run", choice.cell_reynolds(c));
    text += line("shear_rate", choice.shear_rate, s);
    text += line("largest_speed", choice.largest_speed, s);
    text += line("pressure_gradient", choice.pressure_gradient, s);
    text += line("plasma.viscosity", c.plasma.viscosity, s);
    if (c.numerics.fluid_only) return text;
    text += fmt::format("# {:<24} {}\n", "delta", word_of(choice.delta));
    text += fmt::format("# {:<24} {}\n", "jump_correction", choice.jump_correction);
    const std::vector<Case> kinds = cases_by_kind(c);
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        if (!c.kinds.empty()) text += fmt::format("# kind \"{}\"\n", c.kinds[n].name);
        text += lines_of_cells(kinds[n], choice.kinds[n], s);
    }
    text +=
        fmt::format("# {:<24} {:<22} {:.17g}\n", "contact range",
                    rounded_text(s.to_si<Length>(model.contact.range), 10), model.contact.range);
    return text;
}

std::string settings_of(const Case& c, const Choice& choice) {
    const auto chosen = [](std::string_view key, std::string_view value) {
        return fmt::format("chosen.{} = {}\n", key, value);
    };
    std::string of_kinds;
    for (std::size_t n = 0; n < choice.kinds.size(); ++n) {
        const std::string of = c.kinds.empty() ? "" : fmt::format("kind.{}.", c.kinds[n].name);
        of_kinds += chosen(of + "node_spacing", to_text(choice.kinds[n].node_spacing));
        of_kinds += chosen(of + "area_stiffness", to_text(choice.kinds[n].area_stiffness));
    }
    return key_lines(named_by_content(c)) + chosen("dx", to_text(choice.dx)) +
           chosen("dt", to_text(choice.dt)) +
           chosen("relaxation_time", to_text(choice.relaxation_time)) +
           chosen("density_scale", to_text(choice.density_scale)) +
           chosen("equilibrium", word_of(choice.equilibrium)) +
           chosen("precision", word_of(choice.precision)) + chosen("delta", word_of(choice.delta)) +
           of_kinds;
}

}  // namespace tt
