#include "game/app/commands.hpp"
#include "runtime/level/diagnostic.hpp"

#include <iostream>

namespace trembler {

int guarded(std::function<int()> const& work) {
    try {
        return work();
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            std::cerr << diagnostic.print() << "\n";
        }
    } catch (std::exception const& error) {
        std::cerr << "trembler: " << error.what() << "\n";
    }
    return exitBadInput;
}

} // namespace trembler
