#include "app/check_json.hpp"

#include "case/cell_outline.hpp"
#include "case/port_figures.hpp"

namespace tt {
namespace {

Json to_json(const CellOutline& outline) {
    const OutlineMeasures m = measures_of(outline);
    return {{"file", outline.file},           {"points", outline.given},
            {"closed", outline.closed},       {"clockwise", outline.clockwise},
            {"staircase", outline.staircase}, {"width_m", m.width},
            {"height_m", m.height},           {"area_m2", m.area},
            {"perimeter_m", m.perimeter},     {"reduced_area", m.reduced_area}};
}

}  // namespace

Json to_json(const Case& c, const Choice& choice, const Appraisal& a, const Probe& p) {
    Json j;
    j["name"] = c.name;
    j["nx"] = choice.nx;
    j["ny"] = choice.ny;
    j["dx_m"] = choice.dx.si;
    j["dt_s"] = choice.dt.si;
    j["steps"] = a.steps;
    j["cells"] = a.cells;
    j["nodes"] = a.nodes;
    j["node_spacing_sites"] = a.node_distance;
    j["radius_sites"] = a.radius_sites;
    j["bending_length_sites"] = a.bending_length;
    j["contact_distance_sites"] = a.contact_distance;
    j["start_turn_deg"] = a.start_turn_deg;
    j["start_radius_sites"] = a.cells > 0 ? Json(a.start_radius) : Json(nullptr);
    j["hematocrit"] = a.hematocrit;
    j["viscosity_ratio"] = a.viscosity_ratio;
    if (a.cells > 0)
        j["start"] = {{"smallest_gap_sites", a.smallest_gap},
                      {"smallest_gap_is_at_least", !(a.smallest_gap < gap_reach)},
                      {"wall_distance_sites", a.wall_distance},
                      {"largest_stretch", a.start_stretch}};
    for (const KindFigures& kind : a.kinds) {
        if (a.kinds.size() < 2) break;
        j["kinds"].push_back({{"name", kind.name},
                              {"cells", kind.cells},
                              {"radius_sites", kind.radius_sites},
                              {"viscosity_ratio", kind.viscosity_ratio},
                              {"shear_number", kind.shear_number},
                              {"bending_length_sites", kind.bending_length}});
    }
    if (!a.kinds.empty()) {
        j["boussinesq_stretching"] = a.kinds.front().stretching_viscosity;
        j["boussinesq_bending"] = a.kinds.front().bending_viscosity;
    }
    if (c.cells.outline()) j["outline"] = to_json(*c.cells.outline());
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        const PortFigures port = figures_of(c, choice, n);
        j["ports"].push_back({{"name", c.ports[n].name},
                              {"width_m", port.width.si},
                              {"pressure_Pa", port.pressure.si},
                              {"flow_rate_m2_per_s", port.flow_rate.si},
                              {"mean_velocity_m_per_s", port.mean_velocity.si}});
    }
    if (!a.feed_cells.empty()) j["feed_cells"] = a.feed_cells;
    if (c.network()) j["late_answer_s"] = late_answer(choice).si;
    j["relaxation_time_plasma"] = a.tau_plasma;
    j["relaxation_time_largest"] = a.tau_cytoplasm;
    j["density_scale"] = choice.density_scale;
    j["area_stiffness_Pa"] = choice.kinds[0].area_stiffness.si;
    j["shear_rate_per_s"] = choice.shear_rate.si;
    j["shear_number"] = a.shear_number;
    j["reynolds_cell"] = a.cell_reynolds;
    j["reynolds_cell_as_run"] = a.cell_reynolds_run;
    j["reynolds_channel"] = a.channel_reynolds;
    j["mach"] = a.mach;
    j["transits"] = a.transits;
    j["precision"] = word_of(choice.precision);
    j["step_tolerance"] = c.numerics.step_tolerance;
    j["expected_change"] = choice.expected_change();
    j["expected_stretch"] = choice.kinds[0].expected_stretch;
    for (const StepLimit& l : choice.limits)
        j["step_limits"].push_back({{"name", l.name},
                                    {"dt_s", l.step.si},
                                    {"reason", l.reason},
                                    {"kind", l.change > 0.0 ? "accuracy" : "stability"}});
    for (const Bound& b : a.bounds)
        j["stability"].push_back({{"name", b.name},
                                  {"value", b.value},
                                  {"limit", b.limit},
                                  {"margin", b.margin()},
                                  {"definition", b.definition}});
    j["disk_bytes"] = a.disk_bytes;
    if (p.steps_per_second > 0.0) {
        j["memory_bytes"] = p.memory_bytes;
        j["steps_per_second"] = p.steps_per_second;
        j["threads"] = p.threads;
        j["seconds_to_finish"] = static_cast<double>(a.steps) / p.steps_per_second;
    }
    j["advice"] = Json::array();
    for (const Advice& x : a.advice)
        j["advice"].push_back({{"refused", x.weight == Advice::Weight::refuse}, {"text", x.text}});
    j["ready"] = !a.refused();
    return j;
}

}  // namespace tt
