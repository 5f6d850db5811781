#include "game/app/commands.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <iostream>
#include <new>

namespace trembler {

int guarded(std::function<int()> const& work) {
    try {
        return work();
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            std::cerr << diagnostic.print() << "\n";
        }
    } catch (std::bad_alloc const&) {
        std::cerr << "trembler: there is not enough memory\n";
    } catch (std::exception const& error) {
        std::cerr << "trembler: " << visibleLines(error.what()) << "\n";
    }
    return exitBadInput;
}

} // namespace trembler
