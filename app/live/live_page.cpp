#include "app/live/live_page.h"

#include <chrono>
#include <thread>

#include "app/live/cost_map.h"
#include "app/live/page_text.h"
#include "core/image/io.h"

namespace etalon {
namespace {

using namespace std::chrono_literals;

/// Longest interval between requests of an open page; in the background it asks once a second.
constexpr double silence = 1.5;

/// Longest time that open pages are given for the last image. The server takes up to a second more.
constexpr auto patience = 4s;

template <class T>
std::vector<double> doubles(const std::vector<T>& values) {
    return {values.begin(), values.end()};
}

}  // namespace

LivePage::LivePage(const RenderSettings& settings, std::string title, double exposure,
                   std::function<void()> stop)
    : image_(settings),
      title_(std::move(title)),
      exposure_(exposure),
      stop_(std::move(stop)),
      server_(resources()) {}

std::map<std::string, Resource> LivePage::resources() {
    const auto stop = [this] {
        stop_();
        return std::string();
    };
    return {{"", {"text/html; charset=utf-8", [] { return std::string(page_text()); }}},
            {"state.json", {"application/json", [this] { return state(); }}},
            {"image.png", png_resource(shown_, [this] { return image_png(); })},
            {"samples.png", png_resource(samples_, [this] { return samples_png(); })},
            {"seconds.png", png_resource(seconds_, [this] { return seconds_png(); })},
            {"stop", {"text/plain", stop, "POST"}}};
}

Resource LivePage::png_resource(CachedPng& cached, std::function<std::string()> make) const {
    return {"image/png", [this, &cached, make = std::move(make)] {
                const std::uint64_t version = image_.version();
                if (cached.png.empty() || cached.version != version) cached.png = make();
                cached.version = version;
                return cached.png;
            }};
}

std::string LivePage::image_png() const {
    const RenderSettings& s = image_.settings();
    return encode_image("image.png",
                        {s.resolution.x,
                         s.resolution.y,
                         image_.window(),
                         image_.pixels().colors,
                         s.display_colors,
                         {}},
                        exposure_)
        .value;
}

std::string LivePage::samples_png() const {
    return cost_map(image_.window(), doubles(image_.pixels().samples));
}

std::string LivePage::seconds_png() const {
    return cost_map(image_.window(), doubles(image_.pixels().seconds));
}

std::string LivePage::state() const {
    nlohmann::ordered_json json = state_.json();
    const LiveImage::Summary summary = image_.summary();
    json["scene"] = title_;
    json["version"] = image_.version();
    json["samples"] = summary.samples;
    json["most_samples"] = summary.most_samples;
    json["most_seconds"] = summary.most_seconds;
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void LivePage::wait_for_pages() const {
    const auto start = std::chrono::steady_clock::now();
    while (server_.idle_seconds() < silence &&
           std::chrono::steady_clock::now() - start < patience) {
        std::this_thread::sleep_for(20ms);
    }
}

}  // namespace etalon
