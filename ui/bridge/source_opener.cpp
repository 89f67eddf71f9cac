#include "ui/bridge/source_opener.hpp"

#include <exception>

namespace echotrail {

void SourceOpener::start(Opener opener) {
    cancel();
    std::erase_if(jobs_, [](const auto& job) { return job->done.load(); });
    auto job = std::make_unique<Job>();
    current_ = job.get();
    job->thread = std::jthread([job = job.get(), opener = std::move(opener)] {
        try {
            job->outcome = opener();
        } catch (const std::exception& failure) {
            job->outcome = Outcome(Error{failure.what()});
        }
        job->done = true;
    });
    jobs_.push_back(std::move(job));
}

void SourceOpener::cancel() { current_ = nullptr; }

std::optional<SourceOpener::Outcome> SourceOpener::take() {
    if (!current_ || !current_->done) return std::nullopt;
    auto outcome = std::move(current_->outcome);
    current_ = nullptr;
    return outcome;
}

}  // namespace echotrail
