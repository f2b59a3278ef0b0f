#include "app/render/checkpoint.h"

#include "core/render/image_film.h"
#include "tests/fuzz/target.h"
#include "tests/temporary_folder.h"

namespace etalon::fuzz {
namespace {

const nlohmann::ordered_json identity = {{"scene", "any"}};

/// Returns a checkpoint file with this state and a valid hash.
std::string checkpoint_of(std::string_view state) {
    std::string file = "etalon-checkpoint 1\n" + identity.dump() + "\n";
    file += state;
    const std::uint64_t hash = hash64(file);
    return file.append(reinterpret_cast<const char*>(&hash), sizeof hash);
}

void resume() {
    CheckpointReader reader;
    const std::string error = reader.open("checkpoint", identity);
    require(error.empty() || error.starts_with("checkpoint"),
            "an error that does not name the file");
    if (!error.empty()) return;
    for (const bool is_filtered : {false, true}) {
        RenderSettings settings;
        if (is_filtered) settings.filter = {FilterKind::gaussian, {2, 2}};
        ImageFilm film({{0, 0}, {3, 2}}, settings);
        CheckpointReader again;
        again.open("checkpoint", identity);
        StateReader state = again.state();
        film.transfer(state);
        if (!state.failed()) film.samples().pixels();
    }
}

void run(std::string_view bytes) {
    test::put("checkpoint", bytes);
    resume();
    test::put("checkpoint", checkpoint_of(bytes));
    resume();
}

}  // namespace

const Target target = {run, false, false};

}  // namespace etalon::fuzz
