#include "audio/effect/properties/sounds.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace trembler {

void Sounds::gather(Sounds& frame, Sounds const& part, PartSpan span) {
    std::vector<Impact> impacts = std::move(frame.impacts);
    std::vector<Scrape> scrapes = std::move(frame.scrapes);
    std::vector<double> amplitudes = std::move(frame.amplitudes);
    frame = part;
    auto const shift = static_cast<std::uint32_t>(amplitudes.size());
    for (Impact impact : part.impacts) {
        impact.since += span.begin;
        impact.first += shift;
        impacts.push_back(impact);
    }
    amplitudes.insert(amplitudes.end(), part.amplitudes.begin(), part.amplitudes.end());
    // The noises of different parts are independent, so their powers add up. A noise during a share of the
    // frame counts as one throughout the frame with that share of the power.
    double const weaker = std::sqrt(span.share);
    std::map<std::pair<ObjectId, ObjectId>, Scrape> known; // of earlier parts
    for (Scrape const& scrape : scrapes) {
        known.emplace(std::pair(scrape.object, scrape.other), scrape);
    }
    for (Scrape scrape : part.scrapes) {
        scrape.first += shift;
        auto const same = known.find({scrape.object, scrape.other});
        bool const goesOn = same != known.end() && same->second.count == scrape.count;
        for (std::uint32_t i = 0; i < scrape.count; ++i) {
            double& amplitude = amplitudes[scrape.first + i];
            amplitude *= weaker;
            if (goesOn) {
                double& sum = amplitudes[same->second.first + i];
                sum = std::hypot(sum, amplitude);
            }
        }
        if (!goesOn) {
            scrapes.push_back(scrape);
        }
    }
    frame.impacts = std::move(impacts);
    frame.scrapes = std::move(scrapes);
    frame.amplitudes = std::move(amplitudes);
}

} // namespace trembler
