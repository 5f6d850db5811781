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

SolutionKind kindIn(Json const& entry) {
    return {namesIn(entry, "parts"), namesIn(entry, "actions"), namesIn(entry, "causes")};
}

Json written(SolutionKind const& kind) {
    return Json{{"parts", kind.parts}, {"actions", kind.actions}, {"causes", kind.causes}};
}

/// Whether there is more in an entry than a kind, which would be lost if it were written again.
bool hasMore(Json const& entry) {
    return !entry.is_object() || std::any_of(entry.items().begin(), entry.items().end(), [](auto const& one) {
        return one.key() != "parts" && one.key() != "actions" && one.key() != "causes";
    });
}

/// The kinds with what the entries that are there have besides.
Json kindsWith(Json const& there, std::vector<SolutionKind> const& kinds) {
    Json all = Json::array();
    std::vector<bool> used(there.size(), false);
    for (SolutionKind const& kind : kinds) {
        Json const plain = written(kind);
        std::size_t at = 0;
        while (at < there.size() &&
               (used[at] || !there[at].is_object() || written(kindIn(there[at])) != plain)) {
            ++at;
        }
        if (at < there.size()) {
            used[at] = true;
        }
        all.push_back(at < there.size() ? there[at] : plain);
    }
    for (std::size_t at = 0; at < there.size(); ++at) {
        if (!used[at] && hasMore(there[at])) {
            all.push_back(there[at]);
        }
    }
    return all;
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
    return writtenInto(Json::object());
}

Json CampaignProgress::writtenInto(Json present) const {
    if (!present.is_object()) {
        present = Json::object();
    }
    for (auto const& [id, level] : levels_) {
        if (!level.solved) {
            continue;
        }
        Json& there = present[pathAsText(id)];
        if (!there.is_object()) {
            there = Json::object();
        }
        Json& kinds = there["kinds"];
        bool const understood = kinds.is_null() || kinds.is_array();
        if (understood || !level.kinds.empty()) {
            kinds = kindsWith(kinds.is_array() ? kinds : Json::array(), level.kinds);
        }
    }
    return present;
}

std::vector<std::string> CampaignProgress::read(Json const& stated) {
    std::vector<std::string> damaged;
    if (!stated.is_object()) {
        return damaged;
    }
    for (auto const& [text, level] : stated.items()) {
        if (!level.is_object()) {
            damaged.push_back(text);
            continue;
        }
        std::string const id = pathFromText(text);
        markSolved(id);
        auto const kinds = level.find("kinds");
        bool whole = kinds == level.end() || kinds->is_array();
        for (Json const& kind : kinds != level.end() && whole ? *kinds : Json::array()) {
            if (kind.is_object()) {
                addKind(id, kindIn(kind));
            } else {
                whole = false;
            }
        }
        if (!whole) {
            damaged.push_back(text);
        }
    }
    return damaged;
}

} // namespace trembler
