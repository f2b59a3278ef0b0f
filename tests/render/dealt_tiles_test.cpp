// Tiles that another process renders: here the same one, by way of the same bytes.
#include "core/integrators/integrators.h"
#include "core/render/tile_renderer.h"
#include "tests/render/state_bytes.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Gives every other tile to a task. Of each result only so many bytes arrive.
class OneProcess : public TileDealer {
  public:
    OneProcess(const TileTask& task, std::size_t arriving) : task_(task), arriving_(arriving) {}

    void deal(const DealtPass& pass) override {
        for (const std::size_t tile : pass.tiles) {
            if (pass.interrupted()) return;
            ++dealt_ % 2 == 0 ? pass.render(tile) : send(pass, tile);
        }
    }
    bool has_failed() const override { return has_failed_; }

  private:
    void send(const DealtPass& pass, std::size_t tile) {
        std::string task, result;
        StateWriter task_writer([&](std::string_view bytes) { task += bytes; }),
            result_writer([&](std::string_view bytes) { result += bytes; });
        pass.write_task(tile, task_writer);
        std::string_view task_bytes = task;
        StateReader task_reader = reader_of(task_bytes);
        task_(tile, task_reader, result_writer, [] { return false; });
        CHECK((!task_reader.failed() && task_bytes.empty()));
        std::string_view result_bytes = std::string_view(result).substr(0, arriving_);
        StateReader result_reader = reader_of(result_bytes);
        pass.read_result(tile, result_reader);
        CHECK(result_bytes.empty());
        has_failed_ = result_reader.failed();
    }

    const TileTask& task_;
    std::size_t arriving_, dealt_ = 0;
    bool has_failed_ = false;
};

Rendering rendered_by_two(const TestScene& scene, std::size_t arriving = std::string::npos) {
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    const auto integrator = find_integrator(scene.settings.integrator)
                                ->make(scene, *intersector, scene.settings, problems);
    std::optional<Rendering> result;
    render_dealt_tiles(scene.camera, *integrator, scene.settings, [&](const TileTask& task) {
        OneProcess dealer(task, arriving);
        RunControl control;
        control.dealer = &dealer;
        result = render(scene.camera, *integrator, scene.settings, control);
    });
    return std::move(*result);
}

}  // namespace

TEST_CASE("Dealt tiles: given results of another process, then the image has the same bits",
          "[dealt]") {
    for (const double error : {0.0, 3e-2}) {
        for (const FilterKind filter : {FilterKind::box, FilterKind::gaussian}) {
            TestScene scene = mixed_scene(70, 50);
            scene.settings.samples_per_pixel = error > 0 ? 64 : 5;
            scene.settings.target_error = error;
            scene.settings.variance = true;
            if (filter == FilterKind::gaussian) scene.settings.filter = {filter, Vec2(1.5)};
            const Rendering alone = rendered(scene), dealt = rendered_by_two(scene);
            CAPTURE(error, static_cast<int>(filter));
            check_same(dealt, alone);
            CHECK(dealt.complete == alone.complete);
        }
    }
}

TEST_CASE("Dealt tiles: given a part of a result, then no samples of it are counted", "[dealt]") {
    const TestScene scene = mixed_scene(70, 50);
    for (const std::size_t arriving : {std::size_t{0}, sizeof(TileResult)}) {
        const Rendering r = rendered_by_two(scene, arriving);
        CHECK_FALSE(r.complete);
        CHECK(r.samples == 0);
        CHECK(r.counts.camera == 0);
    }
}
