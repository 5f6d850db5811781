#include "game/ui/play/why/inquiry.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace trembler::ui {

Inquiry::Inquiry(Registry const& registry, PartLibrary const& parts, std::shared_ptr<GameData const> data)
    : registry_(registry), parts_(parts), data_(std::move(data)) {}

Inquiry::~Inquiry() {
    forget();
    clearForgotten(true);
}

std::unique_ptr<insight::LevelRuns> Inquiry::runsOf(LevelFile level) const {
    return data_ != nullptr ? std::make_unique<insight::LevelRuns>(*data_, std::move(level))
                            : std::make_unique<insight::LevelRuns>(registry_, parts_, std::move(level));
}

void Inquiry::ask(RunAsked run, insight::Question question) {
    forget();
    clearForgotten(false);
    job_ = std::make_unique<Job>();
    Job& job = *job_;
    job.future = std::async(std::launch::async,
                            [this, &job, run = std::move(run), question = std::move(question)]() mutable {
                                Found found;
                                insight::AskOptions options;
                                options.frames = run.frames;
                                options.stop = [&job] { return job.stop.load(); };
                                options.progress = [&job](std::size_t done, std::size_t of) {
                                    job.of = of;
                                    job.done = done;
                                    return !job.stop.load();
                                };
                                try {
                                    auto const runs = runsOf(std::move(run.level));
                                    found.answer = insight::why(*runs, run.solution, question, options);
                                } catch (insight::NothingHappened const&) {
                                    found.nothing = true;
                                } catch (std::exception const& error) { // the run cannot be repeated
                                    found.fault = error.what();
                                }
                                return found;
                            });
}

void Inquiry::stop() {
    if (job_ != nullptr) {
        job_->stop = true;
    }
}

void Inquiry::forget() {
    stop();
    if (job_ != nullptr) {
        forgotten_.push_back(std::move(job_));
    }
}

void Inquiry::clearForgotten(bool all) {
    std::erase_if(forgotten_, [all](std::unique_ptr<Job> const& job) {
        if (all) {
            job->future.wait();
        }
        return job->future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
}

std::optional<Inquiry::Found> Inquiry::take() {
    clearForgotten(false);
    if (job_ == nullptr || job_->future.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return std::nullopt;
    }
    Found found = job_->future.get();
    job_.reset();
    return found;
}

Inquiry::Progress Inquiry::progress() const {
    return job_ == nullptr ? Progress{} : Progress{job_->done, job_->of};
}

void Inquiry::wait() const {
    if (job_ != nullptr) {
        job_->future.wait();
    }
}

} // namespace trembler::ui
