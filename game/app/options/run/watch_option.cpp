#include "game/app/options/run/watch_option.hpp"

#include "game/app/options/rule/rule.hpp"
#include "insight/probe/watch.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trembler {

CLI::Option* addWatch(CLI::App& command, std::vector<std::string>& target, std::string const& meaning) {
    auto* const added = command.add_option("--watch", target, meaning);
    return accepts(added->type_name("OBJECT.FIELD")->allow_extra_args(false),
                   "OBJECT.FIELD, for example lamp.current or world.gravity", [](std::string const& text) {
                       std::size_t const dot = text.find('.');
                       return dot == std::string::npos || dot == 0 || text.ends_with('.') ? Fault("")
                                                                                          : Fault();
                   });
}

void checkWatched(Registry const& registry, World const& world, std::vector<std::string> const& options) {
    std::vector<watch::WatchedField> const fields = watch::watchedFields(registry);
    for (std::string const& what : options) {
        try {
            (void)watch::find(world, fields, what);
        } catch (std::invalid_argument const& error) {
            throw std::invalid_argument(fmt::format("--watch {}: {}", shown(what), error.what()));
        }
    }
}

} // namespace trembler
