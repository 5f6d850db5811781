// Words that stay on one line when text is wrapped.
#pragma once

#include <string>
#include <string_view>

namespace trembler::render {

/// The text with no-break spaces, at which ImGui does not wrap: behind every number ("4 seconds", "0.5 m"),
/// within "0 of 5" (a number, a word of up to three letters, a number) and within newton metres. Any thread.
[[nodiscard]] std::string unbroken(std::string_view text);

} // namespace trembler::render
