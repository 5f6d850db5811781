#include "audio/device/sound_file.hpp"

#include "audio/device/openal_output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <sndfile.h>
#include <stdexcept>
#include <utility>

namespace trembler {

struct SoundFile::Handle {
    explicit Handle(SNDFILE* opened) : file(opened) {}
    ~Handle() { close(); }
    /// 0, or the error: the header is written last.
    int close() { return file == nullptr ? SF_ERR_NO_ERROR : sf_close(std::exchange(file, nullptr)); }
    Handle(Handle const&) = delete;
    Handle& operator=(Handle const&) = delete;
    SNDFILE* file;
};

SoundFile::SoundFile(std::filesystem::path file, LoudspeakerOptions const& options,
                     Loudspeaker::Report report)
    : name_(std::move(file)) {
    if (name_.extension() != ".wav") {
        throw std::invalid_argument(
            fmt::format("{}: expected a file whose name ends in .wav", name_.string()));
    }
    file_ = std::make_unique<OutputFile>(name_, OutputFile::Content::binary);
    std::string why;
    auto output = OpenAlOutput::loopback(options.synthesiser, why);
    if (output == nullptr) {
        throw std::runtime_error(fmt::format("{}: {}", name_.string(), why));
    }
    output_ = output.get();
    loudspeaker_ = std::make_unique<Loudspeaker>(options, std::move(output), std::move(report));
    SF_INFO info{};
    info.samplerate = options.synthesiser.rate;
    info.channels = 2;
    // Integer samples: a file of floating-point samples would contain the time of its creation.
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* const opened = sf_open_fd(file_->descriptor(), SFM_WRITE, &info, SF_FALSE);
    if (opened == nullptr) { // a pipe, for example: the length in the header is written last
        throw OutputError(fmt::format("{}: cannot be written: {}", name_.string(), sf_strerror(nullptr)));
    }
    handle_ = std::make_unique<Handle>(opened);
    sf_command(opened, SFC_SET_CLIPPING, nullptr, SF_TRUE);
}

SoundFile::~SoundFile() = default;

std::uint64_t SoundFile::mostFrames(int rate) {
    constexpr std::uint64_t framesPerSecond = 60;
    return mostPairs * framesPerSecond / static_cast<std::uint64_t>(rate);
}

void SoundFile::frame(World const& world, Listener const& listener) {
    loudspeaker_->frame(world, listener);
    std::span<float const> const block = output_->rendered();
    auto const pairs = static_cast<sf_count_t>(block.size() / 2);
    pairs_ += block.size() / 2;
    if (pairs_ > mostPairs) {
        file_->failed(EFBIG);
        file_->check();
    }
    errno = 0;
    if (handle_ != nullptr && sf_writef_float(handle_->file, block.data(), pairs) != pairs) {
        file_->failed(errno != 0 ? errno : EIO);
    }
    file_->check();
}

void SoundFile::finish() {
    if (handle_ == nullptr) {
        return;
    }
    errno = 0;
    bool const well = sf_error(handle_->file) == SF_ERR_NO_ERROR && handle_->close() == SF_ERR_NO_ERROR;
    if (!well) {
        file_->failed(errno != 0 ? errno : EIO);
    }
    handle_.reset();
    file_->commit();
}

} // namespace trembler
