#include "puzzle/campaign/kept_builds.hpp"

#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestName = 100; // bytes, of the readable part of a file's name

/// FNV-1a, so that long ids, and ids that differ in unusual letters only, have files of their own.
std::uint64_t sumOf(std::string const& text) {
    std::uint64_t sum = 14695981039346656037ULL;
    for (char const letter : text) {
        sum = (sum ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
    }
    return sum;
}

/// The build in a text; nothing if it is none. Its document is left out, so that problems with it are not
/// reported: the placements that fit are placed.
std::optional<Solution> buildIn(std::string_view text) {
    try {
        auto const document = JsonDocument::parse(std::string(text), "build");
        Problems problems;
        auto build = readSolution(JsonNode(*document, document->root(), "", problems));
        if (build) {
            build->document = nullptr;
        }
        return build;
    } catch (InputError const&) {
        return std::nullopt;
    }
}

/// Whether it has the form of a build, whatever its entries say: those that do not fit are left out later.
bool isBuild(std::string_view text) {
    try {
        auto const document = JsonDocument::parse(std::string(text), "build");
        nlohmann::json const& root = document->root();
        auto const isListOrMissing = [&](char const* key) {
            auto const found = root.find(key);
            return found == root.end() || found->is_array();
        };
        return root.is_object() && isListOrMissing("placements") && isListOrMissing("wires") && buildIn(text);
    } catch (InputError const&) {
        return false;
    }
}

/// Whether an object is a placed part of that name, or a piece of one: "lamp 2", "battery 1 plus".
bool isOf(std::string_view object, std::string_view part) {
    return object.size() > part.size() + 1 && object.starts_with(part) && object[part.size()] == ' ' &&
           std::isdigit(static_cast<unsigned char>(object[part.size() + 1])) != 0;
}

/// Takes out of the build what has to do with parts that do not exist.
AbsentPieces takeAbsent(Solution& build, PartLibrary const& parts) {
    AbsentPieces absent;
    std::erase_if(build.placements, [&](Placement const& placement) {
        bool const missing = parts.find(placement.part) == nullptr;
        if (missing) {
            absent.placements.push_back(placement);
        }
        return missing;
    });
    std::erase_if(build.wires, [&](LevelConnection const& wire) {
        bool const missing =
            std::any_of(absent.placements.begin(), absent.placements.end(), [&](Placement const& one) {
                return isOf(wire.a, one.part) || isOf(wire.b, one.part);
            });
        if (missing) {
            absent.wires.push_back(wire);
        }
        return missing;
    });
    return absent;
}

std::string textOf(Solution build) {
    build.inputs.clear();
    build.changes.clear();
    build.frames.reset();
    bool const nothing = build.placements.empty() && build.wires.empty();
    return nothing ? std::string() : writeSolution(build).dump(2) + "\n";
}

} // namespace

fs::path KeptBuilds::fileOf(std::string const& levelId) const {
    std::string name = levelId.substr(0, longestName);
    for (char& letter : name) {
        bool const plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-';
        letter = plain ? letter : '_';
    }
    return folder_ / fmt::format("{}-{:016x}.json", name, sumOf(levelId));
}

std::string buildOf(Session const& session) {
    return textOf(session.record("my build"));
}

void KeptBuilds::write(std::string const& levelId, std::string const& build) const {
    KeptFile const file(fileOf(levelId), isBuild);
    if (build.empty()) {
        file.remove();
    } else {
        file.write(build);
    }
}

void KeptBuilds::keep(std::string const& levelId, std::string const& build) {
    if (folder_.empty()) {
        return;
    }
    waiting_[levelId] = build;
    finish();
}

void KeptBuilds::finish() {
    sinceTry_ = 0;
    unwritten_.reset();
    for (auto at = waiting_.begin(); at != waiting_.end();) {
        try {
            write(at->first, at->second);
            at = waiting_.erase(at);
        } catch (OutputError const& error) {
            unwritten_ = error;
            ++at;
        }
    }
}

void KeptBuilds::pass(double seconds) {
    sinceTry_ += seconds;
    if (sinceTry_ >= patience && !waiting_.empty()) {
        finish();
    }
}

int KeptBuilds::restore(std::string const& levelId, Session& session, AbsentPieces* absent) {
    if (folder_.empty()) {
        return 0;
    }
    std::optional<Solution> build;
    if (auto const waiting = waiting_.find(levelId); waiting != waiting_.end()) {
        build = buildIn(waiting->second);
    } else {
        try {
            KeptText found = KeptFile(fileOf(levelId), isBuild).read();
            if (found.damaged) {
                damaged_.push_back(std::move(*found.damaged));
            }
            build = found.text ? buildIn(*found.text) : std::nullopt;
        } catch (InputError const& error) { // it cannot be read, and so it will not be replaced
            notRead_.push_back(error);
        }
    }
    if (!build) {
        return 0;
    }
    AbsentPieces missing = takeAbsent(*build, session.parts());
    auto leftOut = static_cast<int>(missing.placements.size());
    if (absent != nullptr) {
        *absent = std::move(missing);
    }
    try {
        session.load(*build);
        return leftOut;
    } catch (InputError const&) { // the level or a part has changed since
    }
    int refused = 0;
    for (Placement const& placement : build->placements) {
        refused += session.place(placement) ? 0 : 1;
    }
    if (refused == 0) { // else the numbers in the names of the others are not the same
        for (LevelConnection const& wire : build->wires) {
            ObjectId const a = session.world().store().find(wire.a);
            ObjectId const b = session.world().store().find(wire.b);
            if (a.valid() && b.valid()) {
                (void)session.layWire(a, b);
            }
        }
    }
    return leftOut + refused;
}

int BuildKeeper::restore(Session& session) {
    int const leftOut = builds_.restore(id_, session, &absent_);
    kept_ = buildOf(session);
    return leftOut;
}

void BuildKeeper::pass(Session const& session, double seconds) {
    sinceLook_ += seconds;
    if (sinceLook_ < delay) {
        return;
    }
    sinceLook_ = 0;
    if (std::string build = buildOf(session); build != kept_) {
        kept_ = std::move(build);
        if (kept_.empty() || absent_.empty()) {
            builds_.keep(id_, kept_);
            return;
        }
        Solution all = session.record("my build");
        all.placements.insert(all.placements.end(), absent_.placements.begin(), absent_.placements.end());
        all.wires.insert(all.wires.end(), absent_.wires.begin(), absent_.wires.end());
        builds_.keep(id_, textOf(std::move(all)));
    }
}

} // namespace trembler
