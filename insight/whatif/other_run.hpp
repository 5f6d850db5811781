// The run with something changed at a moment, computed beside the real run.
#pragma once

#include "insight/timeline/recording.hpp"
#include "insight/whatif/apply.hpp"
#include "puzzle/session/session.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace trembler::insight {

/// Where an object of the other run was while it was elsewhere than in the real run.
struct OtherPath {
    struct At {
        std::uint64_t frame = 0;
        Vec2 at; ///< m
    };
    std::vector<At> points; ///< ascending by frame, at least OtherRun::pathStep apart
};

/// Computes two runs side by side from the recorded placements and inputs: the session's once more, and
/// another one that is the same to the bit up to a moment and is changed there. After the moment both get the
/// session's inputs, so without a change they never differ. The same change at the same moment gives the same
/// bits. It reads the session and never changes it. Not thread-safe.
class OtherRun {
public:
    static constexpr std::size_t mostBytes = std::size_t{16} << 20U; ///< for its recording
    static constexpr double pathStep = 0.02;                         ///< m
    static constexpr std::size_t mostPoints = 4000;                  ///< of one path

    /// All but the what-if must outlive it; the session's run must not end before, and must not have been
    /// altered.
    OtherRun(Registry const& registry, Session const& session, WhatIf whatIf);

    /// Builds the next one of its worlds, so that drawing in between never waits for both. True if
    /// there is another to be built. Throws InputError if the world cannot be built any more.
    bool build();
    [[nodiscard]] bool built() const { return other_ != nullptr; }
    /// How many worlds it builds.
    static constexpr int worlds = 2;

    /// Builds what is still to be built, as build() does, and computes at most `most` frames of both runs, up
    /// to the frame `last`, which the session has computed. True if there is more to compute.
    bool advance(std::uint64_t most, std::uint64_t last);

    [[nodiscard]] WhatIf const& whatIf() const { return whatIf_; }
    /// The last frame that it has computed.
    [[nodiscard]] std::uint64_t frame() const { return built() ? other_->world().frame() : 0; }
    /// Whether it has come to the moment, so that there is something to be seen.
    [[nodiscard]] bool begun() const { return recording_.begun(); }
    /// From the moment on: its frame is as it is after the changes.
    [[nodiscard]] Recording const& recording() const { return recording_; }
    /// As it is after the last computed frame. This and the functions below: only if it is built.
    [[nodiscard]] LevelRun const& run() const { return *other_; }

    /// The first frame whose state has another hash than in the real run; nothing if there is none so far. An
    /// interaction that is left out is no difference by itself: then only the objects are compared.
    [[nodiscard]] std::optional<std::uint64_t> firstDifference() const { return differs_; }
    /// The goals as they are after the last computed frame, with the frames in which they were first met.
    [[nodiscard]] std::vector<GoalStatus> const& goals() const { return other_->judge().status(); }
    [[nodiscard]] std::optional<std::uint64_t> solvedFrame() const { return other_->judge().solvedFrame(); }
    /// The paths of the objects that have been elsewhere than in the real run, by their ids, which are those
    /// of the real run.
    [[nodiscard]] std::map<ObjectId, OtherPath> const& paths() const { return paths_; }

private:
    void change();
    void step();
    void notePaths();
    [[nodiscard]] std::uint64_t hashOf(World const& world) const;

    Registry const& registry_;
    Session const& session_;
    WhatIf whatIf_;
    std::unique_ptr<LevelRun> real_;
    std::unique_ptr<LevelRun> other_;
    Playback realInputs_;
    Playback otherInputs_;
    std::size_t inputsKnown_ = 0;
    std::size_t changesKnown_ = 0;
    bool objectsOnly_ = false; // an interaction is left out
    int hand_ = 1;             // of a grab
    Recording recording_{mostBytes};
    std::optional<std::uint64_t> differs_;
    std::map<ObjectId, OtherPath> paths_;
};

/// Whether the object is elsewhere in the other world, or exists in one of them only: by more than can be
/// seen.
[[nodiscard]] bool isElsewhere(Store const& real, Store const& other, ObjectId object);

} // namespace trembler::insight
