#include "game/ui/shared/kept/recorder.hpp"

#include "game/ui/shared/words.hpp"
#include "render/gl/error.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

/// The first of name-1, name-2 ... that does not exist.
fs::path fresh(fs::path const& folder, std::string const& name, char const* ending) {
    std::error_code ignored;
    for (int n = 1;; ++n) {
        fs::path path = folder / fmt::format("{}-{}{}", name, n, ending);
        if (!fs::exists(path, ignored)) {
            return path;
        }
    }
}

} // namespace

void Recorder::prepare() const {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    if (failed) {
        throw render::RenderError(words::cannotWrite(folder_.string(), failed.message()));
    }
}

fs::path Recorder::clip(render::AnimatedWebp& clip, std::int64_t milliseconds) const {
    prepare();
    fs::path path = fresh(folder_, "clip", ".webp");
    OutputFile file(path, OutputFile::Content::binary);
    clip.write(file, milliseconds);
    file.commit();
    return path;
}

fs::path Recorder::writeText(std::string const& name, char const* ending, std::string const& content) const {
    prepare();
    fs::path path = fresh(folder_, name, ending);
    OutputFile file(path);
    file.stream() << content;
    file.commit();
    return path;
}

fs::path Recorder::picture(render::Image const& image) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    fs::path path = fresh(folder_, "picture", ".png");
    render::writePng(image, path);
    return path;
}

} // namespace trembler::ui
