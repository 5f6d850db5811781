#include "audio/effect/hearing/heard_sum.hpp"

#include "audio/effect/hearing/group_path.hpp"

#include <algorithm>

namespace trembler {
namespace {

constexpr double nearestSquared = 0.01; // m²
constexpr double upwards = 1 + 1e-9;    // more than all rounding in a limit
constexpr std::size_t mostAtOnce = 512;

// Groups are no longer tested when walls hide hardly any of them.
constexpr int firstHope = 80;
constexpr int eachHope = 8; // more for each group that is hidden

double squaredDistance(Bounds const& bounds, Vec2 point) {
    Vec2 const nearest{std::clamp(point.x, bounds.lower.x, bounds.upper.x),
                       std::clamp(point.y, bounds.lower.y, bounds.upper.y)};
    return lengthSquared(nearest - point);
}

} // namespace

bool reaches(SoundSource const& source, SoundListener const& listener) {
    return listener.placed &&
           source.loudness / std::max(nearestSquared, lengthSquared(listener.at - source.at)) >=
               listener.faintest;
}

bool HeardSum::begin(SoundListener const& listener, SourceTree const& tree, double silence,
                     double neglected) {
    listener_ = listener;
    silence_ = silence;
    share_ = neglected;
    restart(tree);
    return !open_.empty();
}

void HeardSum::restart(SourceTree const& tree) {
    threshold_ = 0;
    gathered_ = 0;
    neglected_ = 0;
    atOnce_ = 1;
    hope_ = firstHope;
    open_.clear();
    asked_.clear();
    known_.clear();
    if (listener_.placed && !tree.groups().empty()) {
        open(tree, 0);
    }
}

void HeardSum::open(SourceTree const& tree, std::uint32_t number) {
    SourceTree::Group const& group = tree.groups()[number];
    double const most =
        upwards * group.loudest / std::max(nearestSquared, squaredDistance(group.bounds, listener_.at));
    if (most >= listener_.faintest) { // else none of them reaches the listener
        open_.push_back({most, number});
        std::push_heap(open_.begin(), open_.end());
    }
}

bool HeardSum::next(SourceTree const& tree, ObstacleField const& field) {
    take();
    for (;;) {
        ask(tree, field);
        if (!asked_.empty()) {
            return true;
        }
        if (addUp(tree.sources().size())) {
            return false;
        }
        share_ = share_ > 0x1p-100 ? 0x1p-60 * share_ : 0;
        restart(tree);
    }
}

void HeardSum::take() {
    for (Way const& way : asked_) {
        if (way.heard > 0) {
            known_.push_back(way);
            gathered_ += way.heard;
        } else if (threshold_ > silence_) {
            neglected_ += threshold_;
        }
    }
    asked_.clear();
}

void HeardSum::ask(SourceTree const& tree, ObstacleField const& field) {
    threshold_ = share_ * gathered_;
    least_ = std::max(silence_, threshold_);
    while (!open_.empty() && asked_.size() < atOnce_) {
        if (open_.front().most < threshold_) { // so are all others
            for (Open const& other : open_) {
                neglected_ += tree.groups()[other.group].size() * other.most;
            }
            open_.clear();
            break;
        }
        std::pop_heap(open_.begin(), open_.end());
        Open const loudest = open_.back();
        open_.pop_back();
        SourceTree::Group const& group = tree.groups()[loudest.group];
        if (threshold_ > 0 && hope_ > 0) {
            --hope_;
            double const enough = threshold_ / (group.size() * loudest.most);
            if (shareAtMost(field, listener_.object, group.bounds, listener_.at, group.lowestFrequency,
                            enough) < enough) {
                neglected_ += threshold_;
                hope_ += eachHope;
                continue;
            }
        }
        if (group.second != 0) {
            open(tree, loudest.group + 1);
            open(tree, group.second);
            continue;
        }
        for (std::uint32_t const source : tree.membersOf(group)) {
            if (reaches(tree.sources()[source], listener_)) {
                asked_.push_back({source, 0});
            }
        }
    }
    atOnce_ = std::min(mostAtOnce, 8 * atOnce_);
}

// In the order of the sources.
void HeardSum::sortKnown(std::size_t sources) {
    constexpr std::size_t sparse = 16;
    if (sparse * known_.size() < sources) {
        std::sort(known_.begin(), known_.end(),
                  [](Way const& a, Way const& b) { return a.source < b.source; });
        return;
    }
    thread_local std::vector<double> heard; // static to reuse its memory
    heard.assign(sources, 0);
    for (Way const& way : known_) {
        heard[way.source] = way.heard;
    }
    known_.clear();
    for (std::size_t source = 0; source < sources; ++source) {
        if (heard[source] > 0) {
            known_.push_back({static_cast<std::uint32_t>(source), heard[source]});
        }
    }
}

// Whether the sum is certain.
bool HeardSum::addUp(std::size_t sources) {
    sortKnown(sources);
    double const each = upwards * share_ * gathered_; // at most, of the sources that are not known
    double const all = upwards * neglected_;
    double low = 0;  // if they contribute nothing
    double high = 0; // if they contribute as much as they may
    auto const addUnknown = [&](std::size_t count) {
        // Rounding makes a sum of n numbers at most (1 + 2^-53)^n times as great.
        if (count > 0 && neglected_ > 0 && each >= 0x1p-54 * low) {
            auto const n = static_cast<double>(count);
            high = (high + std::min(all, n * each)) * (1 + (n + 4) * 0x1p-52);
        }
    };
    std::size_t begin = 0;
    double most = 0;
    loudest_.reset();
    for (Way const& way : known_) {
        addUnknown(way.source - begin);
        low += way.heard;
        high += way.heard;
        begin = way.source + std::size_t{1};
        if (way.heard > most) {
            most = way.heard;
            loudest_ = way.source;
        }
    }
    addUnknown(sources - begin);
    sum_ = low;
    return low == high;
}

} // namespace trembler
