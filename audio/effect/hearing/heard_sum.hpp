// The sum of all sounds at one listener, without computing the sounds that cannot change it.
#pragma once

#include "audio/effect/hearing/obstacle_field.hpp"
#include "audio/effect/hearing/source_tree.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trembler {

/// An object at which the loudness is computed.
struct SoundListener {
    ObjectId object;
    bool placed = false;
    Vec2 at;             ///< m
    double faintest = 0; ///< Pa²; sources that would be fainter without obstacles do not count
};

/// Whether the source would be heard without obstacles.
[[nodiscard]] bool reaches(SoundSource const& source, SoundListener const& listener);

/// The sum of the mean square pressures along straight lines from all sources, in their order, bit for bit as
/// if all of them were added. A sound that is fainter than 2^-54 of what is added up already leaves a double
/// as it is. So the nearest sources are computed first, then groups of sources that cannot be that much
/// fainter; for all others a limit of their loudness is enough. At the end everything neglected is added as
/// nothing and as much as the limits allow: if both sums have the same bits, so has the sum between them.
/// Otherwise less is neglected, at last nothing.
class HeardSum {
public:
    /// A source whose way to the listener is to be computed.
    struct Way {
        std::uint32_t source = 0;
        double heard = 0; ///< Pa²; to be set, 0 if it is less than least()
    };
    /// The share of the sum below which a source is neglected at first, if nothing else is stated.
    static constexpr double usuallyNeglected = 0x1p-68;

    /// `silence` in Pa²: fainter sounds count as nothing. False if no source can reach the listener.
    bool begin(SoundListener const& listener, SourceTree const& tree, double silence,
               double neglected = usuallyNeglected);
    /// Takes the results of the ways that it asked for, and asks for others; false if it needs no more. The
    /// tree is that of begin().
    bool next(SourceTree const& tree, ObstacleField const& field);
    /// The ways that it asks for.
    [[nodiscard]] std::span<Way> ways() { return asked_; }
    /// Pa², for the present ways.
    [[nodiscard]] double least() const { return least_; }

    [[nodiscard]] SoundListener const& listener() const { return listener_; }
    /// Pa², after next() returned false.
    [[nodiscard]] double sum() const { return sum_; }
    /// The first of the sources that contribute most, after next() returned false; none in silence.
    [[nodiscard]] std::optional<std::uint32_t> loudest() const { return loudest_; }

private:
    /// A group of sources, each of which contributes at most so much.
    struct Open {
        double most = 0; // Pa²
        std::uint32_t group = 0;
        friend bool operator<(Open const& a, Open const& b) {
            return a.most != b.most ? a.most < b.most : a.group > b.group;
        }
    };
    void restart(SourceTree const& tree);
    void open(SourceTree const& tree, std::uint32_t group);
    void take();
    void ask(SourceTree const& tree, ObstacleField const& field);
    void sortKnown(std::size_t sources);
    bool addUp(std::size_t sources);

    SoundListener listener_;
    double silence_ = 0;     // Pa²
    double share_ = 0;       // of the sum, below which a source is neglected
    double threshold_ = 0;   // Pa², that is
    double least_ = 0;       // Pa²
    double gathered_ = 0;    // Pa², of the known ways, in any order
    double neglected_ = 0;   // Pa², at most
    std::size_t atOnce_ = 1; // ways
    int hope_ = 0;           // tests of groups that are still worth their time
    std::vector<Open> open_; // a heap
    std::vector<Way> asked_;
    std::vector<Way> known_;
    double sum_ = 0; // Pa²
    std::optional<std::uint32_t> loudest_;
};

} // namespace trembler
