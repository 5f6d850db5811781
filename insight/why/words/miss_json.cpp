// A miss as `trembler why --json` writes it.
#include "insight/why/words/miss_words.hpp"

#include <nlohmann/json.hpp>

namespace trembler::insight {
namespace miss_json {
namespace {

/// The key of what a further run showed.
char const* ifKey(Lack lack) {
    switch (lack) {
    case Lack::blocked:
    case Lack::grab:
    case Lack::cut:
    case Lack::removal:
        return "if_gone";
    case Lack::unpushed:
    case Lack::push:
        return "if_pushed";
    default:
        return "if_closed";
    }
}

} // namespace
} // namespace miss_json

nlohmann::ordered_json toJson(Miss const& miss) {
    nlohmann::ordered_json made{{"frame", miss.frame},     {"what", nameOf(miss.lack)},
                                {"by", miss.by},           {"unit", unitOf(miss.lack)},
                                {"measure", miss.measure}, {"objects", miss.names}};
    nlohmann::ordered_json gaps = nlohmann::ordered_json::array();
    for (CircuitGap const& gap : miss.gaps) {
        gaps.push_back({{"between", {gap.nameA, gap.nameB}},
                        {"width", gap.width},
                        {"from", {gap.from.x, gap.from.y}},
                        {"to", {gap.to.x, gap.to.y}},
                        {"reason", nameOf(gap.reason)}});
        if (!gap.nameBy.empty()) {
            gaps.back()["by"] = gap.nameBy;
        }
        if (gap.reason == GapReason::slow || gap.reason == GapReason::quiet) {
            if (gap.reason == GapReason::slow || gap.is > 0) { // too faint a sound is not computed
                gaps.back()["is"] = gap.is;
            }
            gaps.back()["needed"] = gap.needed;
        }
    }
    if (!gaps.empty()) {
        made["gaps"] = gaps;
    }
    nlohmann::ordered_json ways = nlohmann::ordered_json::array();
    for (CurrentWay const& way : miss.ways) {
        ways.push_back({way.nameA, way.nameB});
    }
    if (!ways.empty()) {
        made["ways"] = ways;
    }
    if (miss.ifClosed != IfClosed::unknown) {
        made[miss_json::ifKey(miss.lack)] = miss.ifClosed == IfClosed::met ? "met" : "nearer";
    }
    if (miss.lack == Lack::count) {
        made["too_many"] = miss.tooMany;
    }
    nlohmann::ordered_json besides = nlohmann::ordered_json::array();
    for (Miss const& other : miss.besides) {
        nlohmann::ordered_json one = toJson(other);
        if (other.frame == 0) {
            one.erase("frame"); // that of the whole
        }
        besides.push_back(std::move(one));
    }
    if (!besides.empty()) {
        made["besides"] = besides;
    }
    return made;
}

} // namespace trembler::insight
