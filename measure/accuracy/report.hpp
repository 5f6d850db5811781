// Ladders as tables: text, JSON, and Markdown for the documentation.
#pragma once

#include "measure/accuracy/ladder.hpp"

#include <nlohmann/json_fwd.hpp>

namespace trembler::accuracy {

/// A table for a terminal.
[[nodiscard]] std::string asText(std::vector<Ladder> const& ladders);
/// {"ladders": [{"effect", "scene", "unit", "error", "reference", "rivals", "remark", "levels": [{"level",
/// "us_per_frame", "error", "front", "beaten_by", "cannot_tell"}]}]}. An error without bound is null.
[[nodiscard]] nlohmann::ordered_json asJson(std::vector<Ladder> const& ladders);
/// The whole of docs/measurements/accuracy.md; `pictures` is the folder of the plots relative to it, "" for
/// none.
[[nodiscard]] std::string asMarkdown(std::vector<Ladder> const& ladders, std::string const& pictures);

/// A file name for the ladder, without extension: "accuracy-gravity-a-disc-of-stars". Numbers in the scene's
/// name, such as its size, stay; every other character than letters and digits becomes a hyphen.
[[nodiscard]] std::string slugOf(Ladder const& ladder);

/// "1.2e-05", "0.031"; "0" if exact, "no bound" if not finite.
[[nodiscard]] std::string errorText(double error);
/// A time in µs with three digits.
[[nodiscard]] std::string timeText(double microseconds);

} // namespace trembler::accuracy
