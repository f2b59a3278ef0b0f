#include "app/live/view_state.h"

namespace etalon {
namespace {

constexpr const char* stage_names[] = {"preparing", "rendering", "writing", "over", "unwritten"};

}  // namespace

RenderObserver ViewState::observer() {
    const auto note_part = [this](double part) {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (lock) part_ = std::max(part_, part);
    };
    const auto note_error = [this](const RenderedPass& pass) {
        const std::lock_guard lock(mutex_);
        if (!pass.expected_error) return;
        errors_.push_back({{"seconds", seconds()}, {"relmse", *pass.expected_error}});
    };
    return {.progress = note_part, .after_pass = note_error};
}

void ViewState::set_stage(Stage stage) {
    const std::lock_guard lock(mutex_);
    if (stage == Stage::rendering) start_ = Clock::now();
    if (stage == Stage::writing) end_ = Clock::now();
    stage_ = stage;
}

ViewState::Stage ViewState::stage() const {
    const std::lock_guard lock(mutex_);
    return stage_;
}

/// The mutex must be held.
double ViewState::seconds() const {
    if (stage_ == Stage::preparing) return 0;
    const Clock::time_point until = stage_ == Stage::rendering ? Clock::now() : end_;
    return std::chrono::duration<double>(until - start_).count();
}

nlohmann::ordered_json ViewState::json() const {
    const std::lock_guard lock(mutex_);
    return {{"stage", stage_names[static_cast<int>(stage_)]},
            {"seconds", seconds()},
            {"part", part_},
            {"errors", errors_}};
}

}  // namespace etalon
