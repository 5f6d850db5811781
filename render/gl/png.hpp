// Pictures into files that the caller completes.
#pragma once

#include "render/gl/image.hpp"
#include "runtime/file/output_file.hpp"

#include <string>

namespace trembler::render {

/// Writes the picture as a PNG. Throws RenderError if the picture is empty. Errors of writing are reported by
/// the file when it is committed.
void writePng(Image const& image, OutputFile& file);
/// The content of a PNG file. Throws RenderError if the picture is empty.
[[nodiscard]] std::string pngOf(Image const& image);

} // namespace trembler::render
