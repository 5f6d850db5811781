#include "puzzle/run/run_report.hpp"

#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(std::optional<std::uint64_t> const& value) {
    return value ? Json(*value) : Json(nullptr);
}

} // namespace

std::string hashText(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

Json toJson(RunReport const& report) {
    Json goals = Json::array();
    for (GoalReport const& goal : report.goals) {
        goals.push_back(
            {{"id", goal.id}, {"met", goal.met}, {"frame", orNull(goal.frame)}, {"text", goal.text}});
    }
    Json effects = Json::array();
    for (ComponentStatus const& status : report.effects) {
        effects.push_back({{"component", title(*status.info)},
                           {"kind", nameOf(status.info->kind)},
                           {"state", nameOf(status.activity)},
                           {"updates", status.updates},
                           {"time_us", status.totalMicroseconds},
                           {"effect", status.info->text.effect},
                           {"level", status.info->text.level},
                           {"period", status.period}});
    }
    Json all{{"level", report.level},
             {"frames", report.frames},
             {"simulated_s", report.simulatedSeconds()},
             {"wall_s", report.wallSeconds},
             {"realtime_factor", report.wallSeconds > 0 ? report.simulatedSeconds() / report.wallSeconds : 0},
             {"threads", report.threads},
             {"parts", report.parts},
             {"solved", report.solved},
             {"solved_frame", orNull(report.solvedFrame)},
             {"goals", goals},
             {"state_hash", hashText(report.stateHash)},
             {"warnings", report.warnings},
             {"effects", effects}};
    if (!report.hashes.empty()) {
        Json hashes = Json::array();
        for (HashAt const& at : report.hashes) {
            hashes.push_back({{"frame", at.frame}, {"hash", hashText(at.hash)}});
        }
        all["hashes"] = hashes;
    }
    return all;
}

std::string toWords(RunReport const& report) {
    std::string text = fmt::format("{}: {} after {} frames ({:.1f} s simulated in {:.2f} s)\n",
                                   visible(report.level), report.solved ? "solved" : "not solved",
                                   report.frames, report.simulatedSeconds(), report.wallSeconds);
    for (GoalReport const& goal : report.goals) {
        text += fmt::format("  [{}] {}", goal.met ? "x" : " ", visible(goal.text));
        if (goal.frame) {
            text += fmt::format("  (frame {}, {:.2f} s)", *goal.frame,
                                static_cast<double>(*goal.frame) * frameDuration);
        }
        text += "\n";
    }
    for (std::string const& warning : report.warnings) {
        text += fmt::format("  warning: {}\n", warning);
    }
    for (HashAt const& at : report.hashes) {
        text += fmt::format("  frame {:>6}  {}\n", at.frame, hashText(at.hash));
    }
    text += fmt::format("  state hash {}\n", hashText(report.stateHash));
    for (ComponentStatus const& status : report.effects) {
        text += fmt::format("  {:<48} {:<7} {:>8} updates {:>10.0f} us\n", title(*status.info),
                            nameOf(status.activity), status.updates, status.totalMicroseconds);
    }
    return text;
}

} // namespace trembler
