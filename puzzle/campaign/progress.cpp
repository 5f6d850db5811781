#include "puzzle/campaign/progress.hpp"

#include "runtime/file/path_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

std::set<std::string> namesIn(Json const& object, char const* key) {
    std::set<std::string> names;
    if (auto const list = object.find(key); list != object.end() && list->is_array()) {
        for (Json const& name : *list) {
            if (name.is_string()) {
                names.insert(name.get<std::string>());
            }
        }
    }
    return names;
}

} // namespace

int LevelProgress::stars() const {
    return solved ? std::clamp(static_cast<int>(kinds.size()), 1, mostStars) : 0;
}

LevelProgress const& CampaignProgress::of(std::string const& levelId) const {
    static LevelProgress const none;
    auto const found = levels_.find(levelId);
    return found == levels_.end() ? none : found->second;
}

bool CampaignProgress::markSolved(std::string const& levelId) {
    LevelProgress& level = levels_[levelId];
    bool const fresh = !level.solved;
    level.solved = true;
    return fresh;
}

bool CampaignProgress::addKind(std::string const& levelId, SolutionKind kind) {
    constexpr std::size_t most = 1000; // each is compared with all others
    std::vector<SolutionKind>& kinds = levels_[levelId].kinds;
    bool const other = kinds.size() < most &&
                       std::all_of(kinds.begin(), kinds.end(),
                                   [&](SolutionKind const& known) { return differInKind(known, kind); });
    if (other) {
        kinds.push_back(std::move(kind));
    }
    return other;
}

void CampaignProgress::add(CampaignProgress const& other) {
    for (auto const& [id, theirs] : other.levels_) {
        LevelProgress& mine = levels_[id];
        mine.solved = mine.solved || theirs.solved;
        // One kind may be like each of two that differ: so the longer list stays as it is.
        std::vector<SolutionKind> fewer = theirs.kinds;
        if (fewer.size() > mine.kinds.size()) {
            std::swap(fewer, mine.kinds);
        }
        for (SolutionKind& kind : fewer) {
            addKind(id, std::move(kind));
        }
    }
}

Json CampaignProgress::written() const {
    Json all = Json::object();
    for (auto const& [id, level] : levels_) {
        if (!level.solved) {
            continue;
        }
        Json kinds = Json::array();
        for (SolutionKind const& kind : level.kinds) {
            kinds.push_back(Json{{"parts", kind.parts}, {"actions", kind.actions}, {"causes", kind.causes}});
        }
        all[pathAsText(id)] = Json{{"kinds", std::move(kinds)}};
    }
    return all;
}

void CampaignProgress::read(Json const& stated) {
    if (!stated.is_object()) {
        return;
    }
    for (auto const& [text, level] : stated.items()) {
        if (!level.is_object()) {
            continue;
        }
        std::string const id = pathFromText(text);
        markSolved(id);
        auto const kinds = level.find("kinds");
        if (kinds == level.end() || !kinds->is_array()) {
            continue;
        }
        for (Json const& kind : *kinds) {
            if (kind.is_object()) {
                addKind(id, {namesIn(kind, "parts"), namesIn(kind, "actions"), namesIn(kind, "causes")});
            }
        }
    }
}

} // namespace trembler
