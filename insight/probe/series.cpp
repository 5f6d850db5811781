#include "insight/probe/series.hpp"

#include <algorithm>

namespace trembler::insight {

std::optional<double> Series::at(std::uint64_t frame) const {
    auto const next =
        std::upper_bound(samples.begin(), samples.end(), frame,
                         [](std::uint64_t f, Sample const& sample) { return f < sample.frame; });
    return next == samples.begin() ? std::nullopt : std::optional((next - 1)->value);
}

void Probes::add(World const& world, std::vector<watch::WatchedField> const& fields,
                 std::string const& what) {
    watch::Watch watch = watch::find(world, fields, what);
    bool const two = watch.headers().size() > 1;
    for (char const* const component : {".x", ".y"}) {
        series_.push_back({two ? what + component : what, watch.field().unit, {}});
        if (!two) {
            break;
        }
    }
    watches_.push_back(std::move(watch));
}

bool Probes::has(std::string_view what) const {
    return std::any_of(watches_.begin(), watches_.end(),
                       [what](watch::Watch const& watch) { return watch.asked() == what; });
}

void Probes::remove(std::string_view what) {
    auto series = series_.begin();
    for (auto watch = watches_.begin(); watch != watches_.end();) {
        auto const count = static_cast<std::ptrdiff_t>(watch->headers().size());
        if (watch->asked() == what) {
            series = series_.erase(series, series + count);
            watch = watches_.erase(watch);
        } else {
            series += count;
            ++watch;
        }
    }
}

void Probes::look(World const& world, std::uint64_t frame) {
    last_ = frame;
    if (!frames_.empty() && frame - frames_.back() < gap_) {
        return;
    }
    std::size_t next = 0;
    for (watch::Watch const& watch : watches_) {
        for (watch::Cell const& cell : watch.read(world)) {
            if (double const* const value = std::get_if<double>(&cell)) {
                series_[next].samples.push_back({frame, *value});
            }
            ++next;
        }
    }
    frames_.push_back(frame);
    if (frames_.size() > 2 && frames_.size() * std::max<std::size_t>(series_.size(), 1) > most_) {
        thinOut();
    }
}

void Probes::thinOut() {
    gap_ = 2 * std::max(gap_, (frames_.back() - frames_.front()) / (frames_.size() - 1));
    std::vector<std::uint64_t> kept;
    for (std::uint64_t const frame : frames_) {
        if (kept.empty() || frame - kept.back() >= gap_) {
            kept.push_back(frame);
        }
    }
    frames_ = std::move(kept);
    for (Series& series : series_) {
        std::erase_if(series.samples, [&](Sample const& sample) {
            return !std::binary_search(frames_.begin(), frames_.end(), sample.frame);
        });
    }
}

void Probes::forgetAfter(std::uint64_t frame) {
    for (Series& series : series_) {
        std::erase_if(series.samples, [frame](Sample const& sample) { return sample.frame > frame; });
    }
    std::erase_if(frames_, [frame](std::uint64_t each) { return each > frame; });
    if (frames_.empty()) {
        last_.reset();
    } else if (*last_ > frame) {
        last_ = frame;
    }
}

void Probes::clearSamples() {
    for (Series& series : series_) {
        series.samples.clear();
    }
    frames_.clear();
    last_.reset();
    gap_ = 1;
}

} // namespace trembler::insight
