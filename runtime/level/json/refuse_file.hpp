// A file that cannot be used as a whole.
#pragma once

#include <string>

namespace trembler {

/// Throws an InputError with one problem, which is about the file. `expected` may be empty.
[[noreturn]] void refuseFile(std::string file, std::string message, std::string expected);

} // namespace trembler
