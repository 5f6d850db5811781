// Keeps the parts and wires that a player has placed in each level: one KeptFile per level.
#pragma once

#include "puzzle/session/session.hpp"
#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

/// The present build, as the text of a file: a solution without inputs and changes. "" if nothing is
/// placed.
[[nodiscard]] std::string buildOf(Session const& session);

/// What a build has of parts that do not exist at present, such as those of a mod that cannot be loaded.
struct AbsentPieces {
    std::vector<Placement> placements;
    std::vector<LevelConnection> wires; ///< with an end at one of them

    [[nodiscard]] bool empty() const { return placements.empty() && wires.empty(); }
};

/// Not thread-safe.
class KeptBuilds {
public:
    /// `folder` empty: nothing is kept (tests). It is made when the first build is kept.
    explicit KeptBuilds(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

    /// What could not be written is tried again after this time, s.
    static constexpr double patience = 5;

    /// The file of a level. Names of different levels give different files.
    [[nodiscard]] std::filesystem::path fileOf(std::string const& levelId) const;
    /// Writes a build, as buildOf() states it; if nothing is built the file is removed. What cannot be
    /// written is kept in memory, and tried again by pass(): see unwritten().
    void keep(std::string const& levelId, std::string const& build);
    /// Places the kept parts and wires, while building and with nothing placed. If the level has changed so
    /// that it does not fit as a whole, parts are placed one by one; returns how many were left out. Without
    /// a file nothing is placed: 0. A damaged file is moved aside, see takeDamaged(), and the last good one
    /// taken. Parts that do not exist at all are left out with their wires, and nothing else because of them;
    /// they are added to `absent`, if it is not nullptr.
    int restore(std::string const& levelId, Session& session, AbsentPieces* absent = nullptr);

    /// Why a build could not be written; nothing if all are.
    [[nodiscard]] std::optional<OutputError> const& unwritten() const { return unwritten_; }
    /// To be called once per picture: tries again what could not be written.
    void pass(double seconds);
    /// Tries again at once.
    void finish();
    /// The damaged files that restore() has found since the last call.
    [[nodiscard]] std::vector<DamagedFile> takeDamaged() { return std::exchange(damaged_, {}); }
    /// The same of files that could not be read.
    [[nodiscard]] std::vector<InputError> takeNotRead() { return std::exchange(notRead_, {}); }

private:
    void write(std::string const& levelId, std::string const& build) const;

    std::filesystem::path folder_;
    std::map<std::string, std::string> waiting_; // builds by level, which could not be written
    std::optional<OutputError> unwritten_;
    std::vector<DamagedFile> damaged_;
    std::vector<InputError> notRead_;
    double sinceTry_ = 0; // s
};

/// Hands on the builds of one level while it is played: soon after each change, at most `delay` seconds
/// later. What restore() could not place, as its part does not exist at present, stays in the build as long
/// as the player has anything placed.
class BuildKeeper {
public:
    /// How long a change may wait, s: several soon after one another, as when a part is turned, are one.
    static constexpr double delay = 1;

    /// The builds must outlive it.
    BuildKeeper(KeptBuilds& builds, std::string levelId) : builds_(builds), id_(std::move(levelId)) {}

    /// Places the kept parts and wires, which then count as kept. See KeptBuilds::restore().
    int restore(Session& session);
    /// Compares the placed parts and wires with those that were kept last, after `seconds` more, and keeps
    /// them when that is due.
    void pass(Session const& session, double seconds);
    /// Keeps them at once: the level is being left.
    void finish(Session const& session) { pass(session, delay); }

private:
    KeptBuilds& builds_;
    std::string id_;
    std::string kept_; ///< without what is absent
    AbsentPieces absent_;
    double sinceLook_ = 0; // s; the session is looked at once per `delay`
};

} // namespace trembler
