#include "puzzle/campaign/kept_builds.hpp"

#include "runtime/file/output_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <cctype>
#include <optional>
#include <system_error>
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

void KeptBuilds::keep(std::string const& levelId, std::string const& build) const {
    if (folder_.empty()) {
        return;
    }
    fs::path const file = fileOf(levelId);
    std::error_code error;
    if (build.empty()) {
        fs::remove(file, error);
        return;
    }
    fs::create_directories(folder_, error); // writing the file reports it if that failed
    writeFile(file, build);
}

int KeptBuilds::restore(std::string const& levelId, Session& session) const {
    std::error_code error;
    fs::path const file = folder_.empty() ? fs::path() : fileOf(levelId);
    if (folder_.empty() || !fs::exists(file, error)) {
        return 0;
    }
    std::optional<Solution> build;
    try {
        auto const document = JsonDocument::load(file);
        Problems problems;
        build = readSolution(JsonNode(*document, document->root(), "", problems));
    } catch (InputError const&) {
        return 0;
    }
    if (!build) {
        return 0;
    }
    build->document = nullptr; // problems with it are not reported: the placements that fit are placed
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
    written_ = buildOf(session);
    return leftOut;
}

bool BuildKeeper::pass(Session const& session, double seconds) {
    sinceLook_ += seconds;
    if (sinceLook_ < delay) {
        return true;
    }
    sinceLook_ = 0;
    std::string build = buildOf(session);
    if (build == written_) {
        return true;
    }
    written_ = std::move(build);
    try {
        builds_.keep(id_, written_);
        return true;
    } catch (OutputError const& error) {
        why_ = error.what();
        return false;
    }
}

} // namespace trembler
