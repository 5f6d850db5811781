#include "audio/device/sound_file.hpp"

#include "audio/device/openal_output.hpp"

#include <fmt/format.h>

#include <sndfile.h>
#include <stdexcept>

namespace trembler {

struct SoundFile::Handle {
    explicit Handle(SNDFILE* opened) : file(opened) {}
    ~Handle() { sf_close(file); }
    Handle(Handle const&) = delete;
    Handle& operator=(Handle const&) = delete;
    SNDFILE* file;
};

SoundFile::SoundFile(std::filesystem::path file, LoudspeakerOptions const& options, Loudspeaker::Tell tell)
    : file_(std::move(file)) {
    if (file_.extension() != ".wav") {
        throw std::invalid_argument(
            fmt::format("{}: expected a file whose name ends in .wav", file_.string()));
    }
    std::string why;
    auto output = OpenAlOutput::loopback(options.synthesiser, why);
    if (output == nullptr) {
        throw std::runtime_error(fmt::format("{}: {}", file_.string(), why));
    }
    output_ = output.get();
    loudspeaker_ = std::make_unique<Loudspeaker>(options, std::move(output), std::move(tell));
    SF_INFO info{};
    info.samplerate = options.synthesiser.rate;
    info.channels = 2;
    // Whole numbers: a file of floating-point samples would carry the time of its making.
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* const opened = sf_open(file_.c_str(), SFM_WRITE, &info);
    if (opened == nullptr) {
        throw std::invalid_argument(
            fmt::format("{}: the file cannot be written: {}", file_.string(), sf_strerror(nullptr)));
    }
    handle_ = std::make_unique<Handle>(opened);
    sf_command(opened, SFC_SET_CLIPPING, nullptr, SF_TRUE);
}

SoundFile::~SoundFile() = default;

void SoundFile::frame(World const& world, Listener const& listener) {
    loudspeaker_->frame(world, listener);
    std::span<float const> const block = output_->rendered();
    auto const pairs = static_cast<sf_count_t>(block.size() / 2);
    complete_ =
        handle_ != nullptr && sf_writef_float(handle_->file, block.data(), pairs) == pairs && complete_;
}

void SoundFile::finish() {
    if (handle_ == nullptr) {
        return;
    }
    sf_write_sync(handle_->file);
    bool const well = complete_ && sf_error(handle_->file) == SF_ERR_NO_ERROR;
    handle_.reset();
    if (!well) {
        throw std::runtime_error(
            fmt::format("{}: writing failed, the sound is not complete", file_.string()));
    }
}

} // namespace trembler
