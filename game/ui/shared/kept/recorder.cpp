#include "game/ui/shared/kept/recorder.hpp"

#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

namespace trembler::ui {

void Recorder::prepare() const {
    makeFolder(folder_);
    OutputFile const probe = OutputFile::newIn(folder_); // without a name, nothing of it stays
}

std::filesystem::path Recorder::write(std::string const& name, std::string const& ending,
                                      std::string const& bytes) const {
    return writeNewFile(
        folder_, [&](int number) { return fmt::format("{}-{}{}", name, number, ending); }, bytes,
        OutputFile::Content::binary);
}

} // namespace trembler::ui
