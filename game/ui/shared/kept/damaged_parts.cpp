#include "game/ui/shared/kept/damaged_parts.hpp"

#include "game/ui/shared/kept/kept_words.hpp"

namespace trembler::ui {

std::vector<std::string> moveDamagedAside(std::span<DamagedFile const> damaged) {
    std::vector<std::string> sentences;
    for (DamagedFile const& one : damaged) {
        try {
            if (KeptText const found = KeptFile(one.file).read(); found.damaged) {
                sentences.push_back(inWords(*found.damaged));
            }
        } catch (InputError const&) { // it cannot be read now, which is reported as a fault of the part
        }
    }
    return sentences;
}

} // namespace trembler::ui
