#include "puzzle/session/renaming.hpp"

#include "runtime/level/build/placing.hpp"

namespace trembler {
namespace {

/// Whether `name` is that of an object or of one of its pieces.
bool belongsTo(std::string const& name, std::string const& object) {
    return name.starts_with(object) && (name.size() == object.size() || name[object.size()] == ' ');
}

} // namespace

void Renaming::add(std::string const& before, std::string const& now) {
    if (before != now) {
        names_[before] = now;
    }
}

std::optional<std::string> Renaming::newName(std::string const& before) const {
    if (own_.contains(before)) {
        return std::nullopt;
    }
    for (auto const& [old, now] : names_) {
        if (belongsTo(before, old)) {
            return now.empty() ? now : now + before.substr(old.size());
        }
    }
    return std::nullopt;
}

std::optional<std::string> Renaming::oldName(std::string const& now) const {
    if (own_.contains(now)) {
        return std::nullopt;
    }
    for (auto const& [old, fresh] : names_) {
        if (!fresh.empty() && belongsTo(now, fresh)) {
            return old + now.substr(fresh.size());
        }
    }
    return std::nullopt;
}

std::vector<std::string> namesAsStated(std::span<Placement const> placements,
                                       std::vector<std::string> const& sorted) {
    std::vector<std::size_t> const order = canonicalOrder(placements);
    std::vector<std::string> names(placements.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        names[order[i]] = sorted[i];
    }
    return names;
}

} // namespace trembler
