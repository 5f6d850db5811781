#include "insight/probe/watch_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace trembler::watch {
namespace {

std::string quoted(std::string const& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string all = "\"";
    for (char const c : text) {
        all += c;
        if (c == '"') {
            all += c;
        }
    }
    return all + "\"";
}

struct Written {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(std::string const& text) const { return quoted(text); }
};

} // namespace

std::string csvHeader(std::span<Watch const> watches) {
    std::string line = "frame,time [s]";
    for (Watch const& watch : watches) {
        for (std::string const& header : watch.headers()) {
            line += "," + quoted(header);
        }
    }
    return line;
}

std::string csvRow(std::uint64_t frame, std::span<Cell const> cells) {
    double const time = frameDuration * static_cast<double>(frame);
    std::string line = fmt::format("{},{}", frame, time);
    for (Cell const& cell : cells) {
        line += "," + std::visit(Written{}, cell);
    }
    return line;
}

WatchTable::WatchTable(Registry const& registry, World const& world, std::vector<std::string> const& what,
                       std::uint64_t every, std::ostream& out)
    : registry_(registry), every_(every), out_(out) {
    std::vector<WatchedField> const fields = watchedFields(registry);
    for (std::string const& one : what) {
        Watch const& watch = watches_.emplace_back(find(world, fields, one));
        if (watch.field().property->kind != PropertyKind::object) {
            subscriptions_.push_back(world.want(*watch.field().property));
        }
    }
    filled_.resize(watches_.size());
    out_ << csvHeader(watches_) << "\n";
}

void WatchTable::look(World const& world) {
    if (world.frame() % every_ != 0) {
        return;
    }
    std::vector<Cell> row;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        for (Cell& cell : watches_[i].read(world)) {
            filled_[i] = filled_[i] || !std::holds_alternative<std::monostate>(cell);
            row.push_back(std::move(cell));
        }
    }
    out_ << csvRow(world.frame(), row) << "\n";
}

std::vector<std::string> WatchTable::withoutValue(World const& world) const {
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        if (!filled_[i]) {
            sentences.push_back(fmt::format("'{}' had no value in any row{}", watches_[i].asked(),
                                            whyEmpty(world, *watches_[i].field().property)));
        }
    }
    return sentences;
}

std::string WatchTable::whyEmpty(World const& world, PropertyInfo const& property) const {
    ComponentText const* present = nullptr; // of the component that leaves it empty
    std::vector<std::string> levels;        // of the components that compute it
    std::vector<ComponentStatus> const all = world.status();
    for (Registration const& registration : registry_.components()) {
        auto const& offers = registration.info->offers;
        if (std::find(offers.begin(), offers.end(), &property) == offers.end()) {
            continue;
        }
        if (registration.leftEmpty != &property) {
            if (registration.missing.empty()) {
                levels.emplace_back(registration.info->text.level);
            }
        } else if (std::any_of(all.begin(), all.end(), [&](ComponentStatus const& status) {
                       return status.info == registration.info && status.activity != Activity::absent;
                   })) {
            present = &registration.info->text;
        }
    }
    if (present == nullptr || levels.empty()) {
        return "";
    }
    return fmt::format(": the detail level {} of {} leaves it empty; --detail {}={} computes it",
                       present->level, present->effect, present->effect, fmt::join(levels, " or "));
}

} // namespace trembler::watch
