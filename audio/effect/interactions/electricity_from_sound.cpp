#include "audio/effect/interactions/electricity_from_sound.hpp"

#include <algorithm>
#include <map>

namespace trembler {

// The connections that each sensor makes when it hears enough: between the two objects that it names, or from
// the first conductor that touches it to each other one.
std::vector<ElectricityFromSound::Link> ElectricityFromSound::possible(Access& access) {
    auto const& sensors = access.read<SoundSensor>();
    auto const& conductors = access.read<Conductor>();
    std::vector<Link> links;
    std::map<ObjectId, std::vector<ObjectId>> touching;
    for (TouchingPair const& pair : access.read<Contacts>().current) {
        if (sensors.has(pair.a) && conductors.has(pair.b)) {
            touching[pair.a].push_back(pair.b);
        }
        if (sensors.has(pair.b) && conductors.has(pair.a)) {
            touching[pair.b].push_back(pair.a);
        }
    }
    for (std::size_t row = 0; row < sensors.size(); ++row) {
        ObjectId const id = sensors.owners()[row];
        SoundSensor const& sensor = sensors.values()[row];
        if (sensor.a.valid() || sensor.b.valid()) {
            if (conductors.has(sensor.a) && conductors.has(sensor.b) && sensor.a != sensor.b) {
                links.push_back({id, std::min(sensor.a, sensor.b), std::max(sensor.a, sensor.b)});
            }
            continue;
        }
        std::vector<ObjectId>& neighbours = touching[id];
        std::sort(neighbours.begin(), neighbours.end());
        for (std::size_t i = 1; i < neighbours.size(); ++i) {
            links.push_back({id, neighbours[0], neighbours[i]});
        }
    }
    std::sort(links.begin(), links.end());
    return links;
}

// A newly constructed interaction reads from the graph which of the possible connections exist.
void ElectricityFromSound::recall(Access& access, std::vector<Link> const& possible,
                                  std::vector<Link>& connected) {
    std::map<std::pair<ObjectId, ObjectId>, std::int32_t> left;
    for (Link const& link : possible) {
        std::pair const ends{link.a, link.b};
        auto const at =
            left.emplace(
                    ends,
                    connectionBetween(access.read<ElectricityGraph>(), link.a, link.b).of(access.caller()))
                .first;
        if (at->second > 0) {
            --at->second;
            connected.push_back(link);
        }
    }
}

void ElectricityFromSound::apply(Access& access) {
    std::vector<Link> links = possible(access);
    if (access.firstTime()) {
        recall(access, links, connected_);
    }
    Loudness const& loudness = access.read<Loudness>();
    auto const& sensors = access.read<SoundSensor>();
    auto const& conductors = access.read<Conductor>();
    std::erase_if(links, [&](Link const& link) {
        return !(loudness.at(link.sensor) >= sensors[link.sensor].threshold);
    });
    auto const causeOf = [&](ObjectId sensor) {
        for (Loudness::Entry const& entry : loudness.entries) {
            if (entry.ear == sensor) {
                return entry.event;
            }
        }
        return EventId{};
    };
    std::vector<Link> ended;
    std::vector<Link> begun;
    std::set_difference(connected_.begin(), connected_.end(), links.begin(), links.end(),
                        std::back_inserter(ended));
    std::set_difference(links.begin(), links.end(), connected_.begin(), connected_.end(),
                        std::back_inserter(begun));
    for (Link const& link : ended) {
        if (conductors.has(link.a) && conductors.has(link.b)) { // else the graph has already removed it
            access.call(RemoveConnection{{link.a, link.b}}, causeOf(link.sensor));
        }
    }
    for (Link const& link : begun) {
        access.call(AddConnection{{link.a, link.b}}, causeOf(link.sensor));
    }
    connected_ = std::move(links);
}

} // namespace trembler
