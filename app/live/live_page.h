#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "app/live/live_image.h"
#include "app/live/page_server.h"
#include "app/live/view_state.h"

namespace etalon {

/// A page on this machine that shows an image while it is rendered.
class LivePage {
  public:
    /// `title` names the scene; `stop`, from another thread, ends the rendering.
    LivePage(const RenderSettings& settings, std::string title, double exposure,
             std::function<void()> stop);

    /// Begins to serve. Returns why that failed, or nothing.
    std::string start() { return server_.start(); }
    std::string address() const { return server_.address(); }

    /// Returns what keeps the page up to date.
    std::vector<RenderObserver> observers() { return {image_.observer(), state_.observer()}; }
    void set_stage(ViewState::Stage stage) { state_.set_stage(stage); }

    /// Waits until all pages that are open have shown what there is now; a few seconds at most.
    void wait_for_pages() const;

  private:
    /// A PNG that is made anew when the image has changed.
    struct Picture {
        std::mutex mutex;
        std::uint64_t version = 0;
        std::string png;
    };

    std::map<std::string, Resource> resources();
    Resource picture(Picture& picture, std::function<std::string()> make) const;
    std::string image_png() const;
    std::string samples_png() const;
    std::string seconds_png() const;
    std::string state() const;

    LiveImage image_;
    ViewState state_;
    std::string title_;
    double exposure_;
    std::function<void()> stop_;
    Picture shown_, samples_, seconds_;
    PageServer server_;  ///< the last, which ends first
};

}  // namespace etalon
