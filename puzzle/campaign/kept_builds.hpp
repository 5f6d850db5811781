// Keeps the parts and wires that a player has placed in each level: one file per level, replaced as a whole.
#pragma once

#include "puzzle/session/session.hpp"

#include <filesystem>
#include <string>

namespace trembler {

/// The present build, as the text of a file: a solution without inputs and changes. "" if nothing is
/// placed.
[[nodiscard]] std::string buildOf(Session const& session);

/// Not thread-safe.
class KeptBuilds {
public:
    /// `folder` empty: nothing is kept (tests). It is made when the first build is kept.
    explicit KeptBuilds(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

    /// The file of a level. Names of different levels give different files.
    [[nodiscard]] std::filesystem::path fileOf(std::string const& levelId) const;
    /// Writes a build, as buildOf() states it; if nothing is built the file is removed. Even if the program
    /// is killed meanwhile, the file is afterwards either the former or the new one. Throws OutputError if it
    /// cannot be written.
    void keep(std::string const& levelId, std::string const& build) const;
    /// Places the kept parts and wires, while building and with nothing placed. If the level has changed so
    /// that it does not fit as a whole, parts are placed one by one; returns how many were left out. Without
    /// a file, or with a damaged one, nothing is placed: 0.
    int restore(std::string const& levelId, Session& session) const;

private:
    std::filesystem::path folder_;
};

/// Writes the builds of one level while it is played: soon after each change, at most `delay` seconds later.
class BuildKeeper {
public:
    /// How long a change may wait, s: several soon after one another, as when a part is turned, are one.
    static constexpr double delay = 1;

    /// The builds must outlive it.
    BuildKeeper(KeptBuilds const& builds, std::string levelId) : builds_(builds), id_(std::move(levelId)) {}

    /// Places the kept parts and wires, which then count as written. See KeptBuilds::restore().
    int restore(Session& session);
    /// Compares the placed parts and wires with the file, after `seconds` more, and writes them when that is
    /// due. Returns false if it cannot be written; `why()` then has the reason, and it is tried again after
    /// the next change.
    bool pass(Session const& session, double seconds);
    /// Writes at once if anything has not been written: the level is being left.
    bool finish(Session const& session) { return pass(session, delay); }
    [[nodiscard]] std::string const& why() const { return why_; }

private:
    KeptBuilds const& builds_;
    std::string id_;
    std::string written_;  // or given up on
    double sinceLook_ = 0; // s; the session is looked at once per `delay`
    std::string why_;
};

} // namespace trembler
