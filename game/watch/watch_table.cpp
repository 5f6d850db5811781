#include "game/watch/watch_table.hpp"

#include <fmt/format.h>

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

WatchTable::WatchTable(Registry const& registry, World const& world, std::vector<std::string> const& what,
                       std::uint64_t every, std::ostream& out)
    : every_(every), out_(out) {
    std::vector<WatchedField> const fields = watchedFields(registry);
    std::string line = "frame,time [s]";
    for (std::string const& one : what) {
        Watch const& watch = watches_.emplace_back(find(world, fields, one));
        for (std::string const& header : watch.headers()) {
            line += "," + quoted(header);
        }
        if (watch.field().property->kind != PropertyKind::object) {
            subscriptions_.push_back(world.want(*watch.field().property));
        }
    }
    out_ << line << "\n";
}

void WatchTable::look(World const& world) {
    if (world.frame() % every_ != 0) {
        return;
    }
    std::string line = fmt::format("{},{}", world.frame(), world.time());
    for (Watch const& watch : watches_) {
        for (Cell const& cell : watch.read(world)) {
            line += "," + std::visit(Written{}, cell);
        }
    }
    out_ << line << "\n";
}

} // namespace trembler::watch
