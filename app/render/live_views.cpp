#include "app/render/live_views.h"

#include <chrono>
#include <system_error>
#include <thread>

#include "app/common/console.h"
#include "app/common/signals.h"

namespace etalon {
namespace {

/// Time between two checks whether a page that stays is to end.
constexpr auto page_interval = std::chrono::milliseconds(50);

}  // namespace

std::string LiveViews::open_page(const RenderSettings& settings) {
    if (!a_.serve) return {};
    page_.emplace(settings, a_.scene.path, a_.exposure, SignalGuard::interrupt);
    const std::string error = page_->start();
    if (!error.empty()) return "the page cannot be shown: " + error;
    print_result("{}\n", page_->address());
    return {};
}

void LiveViews::start_tev() {
    try {
        tev_.emplace(a_.tev, a_.scene.path, *image_);
    } catch (const std::system_error& e) {  // the system starts no more threads
        print_message("etalon: warning: tev: {}; rendering goes on without it\n",
                      e.code().message());
    }
}

void LiveViews::attach(const RenderSettings& settings, RunControl& control) {
    if (!a_.tev.empty()) {
        image_.emplace(settings);
        start_tev();
        if (tev_) control.observers.push_back(image_->observer());
    }
    if (page_) {
        control.estimates_error = true;
        for (const RenderObserver& o : page_->observers()) control.observers.push_back(o);
    }
}

void LiveViews::show_end(bool is_written) {
    if (!page_) return;
    page_->set_stage(is_written ? ViewState::Stage::over : ViewState::Stage::unwritten);
    page_->wait_for_pages();
    const auto is_over = [] { return SignalGuard::raised() && !SignalGuard::is_requested(); };
    while (a_.stay && !is_over()) std::this_thread::sleep_for(page_interval);
}

}  // namespace etalon
