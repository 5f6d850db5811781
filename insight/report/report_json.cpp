#include "insight/report/report_text.hpp"
#include "insight/why/words/words.hpp"
#include "runtime/level/write/write_level.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace trembler::insight {
namespace {

using Json = nlohmann::ordered_json;

Json mapJson(PlaceMap const& map) {
    Json made;
    made["part"] = map.part;
    made["placement"] = map.placement;
    made["step_m"] = map.step;
    made["recorded"] = {map.row, map.column};
    made["runs"] = map.runs;
    made["rows"] = map.rows;
    return made;
}

Json sideJson(GraphSide const& side) {
    Json made;
    made["parts"] = side.parts;
    made["deeds"] = side.deeds;
    made["links"] = side.links;
    return made;
}

Json comparisonJson(KindComparison const& one) {
    Json made;
    made["kind"] = one.kind;
    made["with"] = one.with;
    made["only_here"] = sideJson(one.difference.here);
    made["only_there"] = sideJson(one.difference.there);
    return made;
}

Json solutionJson(LevelReport const& report, SolutionReport const& solution) {
    Json made;
    made["name"] = solution.name;
    made["expected_to_solve"] = solution.expected;
    made["solves"] = solution.needs.solves;
    if (!solution.needs.solves) {
        return made;
    }
    made["frame"] = solution.needs.frame;
    made["kind"] = inWords(solution.graph);
    made["kind_number"] = solution.kind;
    made["needs_parts"] = solution.needs.parts;
    made["needs_deeds"] = solution.needs.deeds;
    made["needs_effects"] = solution.needs.effects;
    made["superfluous"] = solution.needs.superfluous;
    made["reduced_frame"] = solution.needs.leastFrame;
    made["superfluous_effects"] = solution.needs.idleEffects;
    bool const displaced = solution.robustness.runs > 0;
    made["robustness"] = displaced ? Json(solution.robustness.share()) : Json();
    made["robustness_runs"] = solution.robustness.runs;
    made["robustness_redrawn"] = solution.robustness.redrawn;
    made["chains"] = Json::array();
    for (Answer const& answer : solution.chains) {
        made["chains"].push_back(
            toJson(answer, "goal " + answer.goal, goalText(report, answer.goal), AnswerLanguage()));
    }
    if (!solution.maps.empty()) {
        made["places"] = Json::array();
        for (PlaceMap const& map : solution.maps) {
            made["places"].push_back(mapJson(map));
        }
    }
    return made;
}

} // namespace

nlohmann::ordered_json toJson(FoundSolution const& found) {
    Json made;
    made["kind"] = inWords(found.graph);
    made["needs_parts"] = found.needs.parts;
    made["needs_deeds"] = found.needs.deeds;
    made["needs_effects"] = found.needs.effects;
    made["frame"] = found.needs.leastFrame;
    made["run"] = found.run;
    made["times"] = found.times;
    made["solution"] = writeSolution(found.needs.least);
    return made;
}

nlohmann::ordered_json toJson(LevelReport const& report) {
    Json made;
    made["level"] = report.level;
    made["complete"] = report.complete;
    made["demonstration"] = report.demonstration;
    made["task"] = report.task;
    made["empty_toolbox_solves"] = report.emptyToolboxSolves;
    made["seed"] = report.seed;
    made["jitter"] = {{"cm", 100 * report.jitter.distance},
                      {"degrees", report.jitter.angle},
                      {"seconds", report.jitter.seconds}};
    made["kinds"] = report.kinds;
    made["solutions"] = Json::array();
    for (SolutionReport const& solution : report.solutions) {
        made["solutions"].push_back(solutionJson(report, solution));
    }
    made["differences"] = Json::array();
    for (KindComparison const& one : report.comparisons) {
        made["differences"].push_back(comparisonJson(one));
    }
    made["drops"] = Json::array();
    for (Drop const& drop : report.drops) {
        made["drops"].push_back(
            {{"part", drop.part}, {"runs", drop.runs}, {"solved", drop.solved}, {"share", drop.share()}});
    }
    made["effects"] = Json::array();
    for (EffectCost const& cost : report.costs) {
        made["effects"].push_back({{"effect", cost.effect}, {"us_per_frame", cost.microseconds}});
    }
    made["ways_to_compute"] = Json::array();
    for (WayToCompute const& way : report.ways) {
        made["ways_to_compute"].push_back({{"effect", way.effect},
                                           {"level", way.level},
                                           {"present", way.present},
                                           {"keeps_all_verdicts", way.keepsAll},
                                           {"differs_in", way.differs},
                                           {"us_per_frame", way.microseconds}});
    }
    made["found"] = Json::array();
    if (report.search) {
        for (std::size_t i = 0; i < report.search->found.size(); ++i) {
            Json one = toJson(report.search->found[i]);
            one["recorded_as"] = report.foundAs[i].empty() ? Json() : Json(report.foundAs[i]);
            made["found"].push_back(std::move(one));
        }
        made["search"] = {{"runs", report.search->runs}, {"solved", report.search->solved}};
    }
    made["shortcomings"] = shortcomings(report);
    return made;
}

} // namespace trembler::insight
