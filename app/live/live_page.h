#pragma once

#include <functional>
#include <string>

#include "app/live/live_image.h"
#include "app/live/page_server.h"
#include "app/live/view_state.h"

namespace etalon {

/// A web page on this machine that shows an image during its rendering.
class LivePage {
  public:
    /// `title` names the scene; `stop`, called from another thread, ends the rendering.
    LivePage(const RenderSettings& settings, std::string title, double exposure,
             std::function<void()> stop);

    /// Starts to serve. Returns why that failed, or an empty string.
    std::string start() { return server_.start(); }
    std::string address() const { return server_.address(); }

    /// Returns observers that update the page.
    std::vector<RenderObserver> observers() { return {image_.observer(), state_.observer()}; }
    void set_stage(ViewState::Stage stage) { state_.set_stage(stage); }

    /// Waits until all open pages have shown the current image; four seconds at most.
    void wait_for_pages() const;

  private:
    /// A PNG that is encoded again when the image has changed.
    struct CachedPng {
        std::uint64_t version = 0;
        std::string png;
    };

    std::map<std::string, Resource> resources();
    Resource png_resource(CachedPng& cached, std::function<std::string()> make) const;
    std::string image_png() const;
    std::string samples_png() const;
    std::string seconds_png() const;
    std::string state() const;

    LiveImage image_;
    ViewState state_;
    std::string title_;
    double exposure_;
    std::function<void()> stop_;
    CachedPng shown_, samples_, seconds_;
    PageServer server_;  ///< declared last, so that it ends first
};

}  // namespace etalon
