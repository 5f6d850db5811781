#include "game/ui/shared/shown_faults.hpp"

#include "game/ui/shared/texts.hpp"

namespace trembler::ui {

std::string shownMessage(Diagnostic const& fault) {
    std::string const message = translated(fault.message);
    return fault.expected.empty() ? message
                                  : textWith("{}; expected {}", message, translated(fault.expected));
}

std::string shownFault(Diagnostic const& fault) {
    Diagnostic shown = fault;
    shown.message = shownMessage(fault);
    shown.expected.clear();
    return shown.print();
}

std::string shownError(std::exception const& error) {
    auto const* const input = dynamic_cast<InputError const*>(&error);
    if (input == nullptr || input->diagnostics().empty()) {
        return translated(error.what());
    }
    std::string lines;
    for (Diagnostic const& fault : input->diagnostics()) {
        lines += (lines.empty() ? "" : "\n") + shownFault(fault);
    }
    return lines;
}

} // namespace trembler::ui
