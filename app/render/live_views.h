#pragma once

#include <optional>
#include <string>

#include "app/live/live_page.h"
#include "app/live/tev_view.h"
#include "app/render/arguments.h"
#include "core/render/renderer.h"

namespace etalon {

/// Live views of an image during its rendering, if requested: a web page, and tev.
class LiveViews {
  public:
    /// The arguments must outlive this.
    explicit LiveViews(const RenderArguments& arguments) : a_(arguments) {}

    /// Starts to serve the page, and prints its address. Returns why that failed, or an empty
    /// string.
    std::string open_page(const RenderSettings& settings);

    /// Makes all views observe a rendering.
    void attach(const RenderSettings& settings, RunControl& control);

    void set_stage(ViewState::Stage stage) {
        if (page_) page_->set_stage(stage);
    }

    /// Lets pages show the finished image; a page that is to stay, until a signal.
    void show_end(bool is_written);

  private:
    void start_tev();

    const RenderArguments& a_;
    std::optional<LivePage> page_;
    std::optional<LiveImage> image_;
    std::optional<TevView> tev_;  ///< declared last: sends the rest of the image at the end
};

}  // namespace etalon
