// The texts of the language in use, for sentences that are put together elsewhere.
#pragma once

#include "puzzle/language/catalogue.hpp"

namespace trembler::ui {

/// Valid until useLanguage(); nullptr: English. Window thread only.
[[nodiscard]] Catalogue const* catalogueInUse();

} // namespace trembler::ui
