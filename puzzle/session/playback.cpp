#include "puzzle/session/playback.hpp"

#include <algorithm>
#include <optional>

namespace trembler {
namespace {

template <class Recorded>
void sortByFrame(std::vector<Recorded>& all) {
    std::stable_sort(all.begin(), all.end(),
                     [](Recorded const& a, Recorded const& b) { return a.frame < b.frame; });
}

/// The entries of one frame; `all` is ascending by frame.
template <class Recorded>
std::span<Recorded const> ofFrame(std::vector<Recorded> const& all, std::uint64_t frame) {
    auto const first =
        std::partition_point(all.begin(), all.end(), [&](Recorded const& r) { return r.frame < frame; });
    auto const last = std::find_if(first, all.end(), [&](Recorded const& r) { return r.frame != frame; });
    return {first, last};
}

/// The input with object ids in place of names; nothing if one of the objects does not exist.
std::optional<PlayerInput> resolved(RecordedInput const& input, Store const& store) {
    PlayerInput const found{input.kind, store.find(input.object), store.find(input.other), input.at,
                            static_cast<std::uint8_t>(input.hand)};
    bool const known =
        (input.object.empty() || found.object.valid()) && (input.other.empty() || found.other.valid());
    return known ? std::optional(found) : std::nullopt;
}

} // namespace

Playback::Playback(std::vector<RecordedInput> inputs, std::vector<RecordedChange> changes)
    : inputs_(std::move(inputs)), changes_(std::move(changes)) {
    sortByFrame(inputs_);
    sortByFrame(changes_);
}

std::span<RecordedInput const> Playback::inputsOf(std::uint64_t frame) const {
    return ofFrame(inputs_, frame);
}

std::span<RecordedChange const> Playback::changesOf(std::uint64_t frame) const {
    return ofFrame(changes_, frame);
}

void Playback::feed(LevelRun& run) const {
    std::uint64_t const next = run.world().frame() + 1;
    for (RecordedChange const& change : changesOf(next)) {
        run.change(change);
    }
    for (RecordedInput const& input : inputsOf(next)) {
        if (auto const known = resolved(input, run.world().store())) {
            run.feed(*known);
        }
    }
}

} // namespace trembler
