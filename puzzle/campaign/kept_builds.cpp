#include "puzzle/campaign/kept_builds.hpp"

#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

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

bool isBuild(std::string_view text) {
    return buildIn(text).has_value();
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
    Solution build = session.record("my build");
    build.inputs.clear();
    build.changes.clear();
    build.frames.reset();
    bool const nothing = build.placements.empty() && build.wires.empty();
    return nothing ? std::string() : writeSolution(build).dump(2) + "\n";
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

int KeptBuilds::restore(std::string const& levelId, Session& session) {
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
        } catch (InputError const&) { // it cannot be read, and so it will not be replaced
        }
    }
    if (!build) {
        return 0;
    }
    try {
        session.load(*build);
        return 0;
    } catch (InputError const&) { // the level or a part has changed since
    }
    int leftOut = 0;
    for (Placement const& placement : build->placements) {
        leftOut += session.place(placement) ? 0 : 1;
    }
    return leftOut;
}

int BuildKeeper::restore(Session& session) {
    int const leftOut = builds_.restore(id_, session);
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
        builds_.keep(id_, kept_);
    }
}

} // namespace trembler
