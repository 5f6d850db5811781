#include "game/app/commands.hpp"
#include "game/app/options/rule/rule.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <filesystem>
#include <ios>
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
    } catch (std::filesystem::filesystem_error const& error) { // in words of ours, should a call of it throw
        std::cerr << "trembler: " << shown(error.path1().string())
                  << ": cannot be read or written: " << error.code().message() << "\n";
    } catch (std::ios_base::failure const& error) {
        std::cerr << "trembler: a file cannot be read or written: " << error.code().message() << "\n";
    } catch (std::bad_alloc const&) {
        std::cerr << "trembler: there is not enough memory\n";
    } catch (std::exception const& error) {
        std::cerr << "trembler: " << visibleLines(error.what()) << "\n";
    }
    return exitBadInput;
}

} // namespace trembler
