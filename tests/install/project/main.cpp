// Etalon's render and crosscheck with one more backend, and a converter of one more format.
#include <fstream>
#include <memory>
#include <sstream>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/program.h"
#include "app/common/provenance.h"
#include "app/subcommands.h"
#include "balls.h"
#include "core/formats/write/write.h"
#include "median.h"

namespace laboratory {
namespace {

std::unique_ptr<etalon::Intersector> build_median(const etalon::Geometry& geometry) {
    return std::make_unique<Median>(geometry);
}

struct Arguments {
    std::string input, output;
};

int convert(const Arguments& a) {
    std::ostringstream text;
    text << std::ifstream(a.input).rdbuf();
    const etalon::LoadResult loaded = load_balls(text.str(), a.input);
    etalon::write_message(etalon::report(loaded.diagnostics));
    if (!loaded.scene) return etalon::exit_unusable;
    const auto written = etalon::write_p3f(*loaded.scene, loaded.settings, ".");
    return etalon::write_text(a.output, written.text) ? etalon::exit_done
                                                      : etalon::exit_not_written;
}

etalon::Action declare_convert(etalon::Options& options) {
    auto a = std::make_shared<Arguments>();
    options.add("BALLS", a->input, "File of balls, x y z radius on each line").required();
    options.add("-o,--output", a->output, "Output file").value("FILE.p3f").required();
    return [a] { return convert(*a); };
}

constexpr etalon::Command commands[] = {
    {"convert",
     "Write a file of balls as P3F",
     declare_convert,
     {{{"balls.txt -o balls.p3f", "Convert a file"}, {"b.txt -o b.p3f", "Convert another"}}}},
    {"render",
     "Render a scene to EXR and PNG",
     etalon::declare_render,
     {{{"scene.p3f -b median", "Render"}, {"scene.p3f -b bvh", "Render by another backend"}}}},
    {"crosscheck",
     "Compare the answers of several backends with those of the oracle",
     etalon::declare_crosscheck,
     {{{"scene.p3f", "Check all"}, {"scene.p3f -b median", "Check one"}}}},
};

}  // namespace
}  // namespace laboratory

int main(int argc, char** argv) {
    etalon::add_backend({"median", "binary tree split at medians", true, laboratory::build_median});
    return etalon::run_program(
        {"laboratory", "A backend and a loader of our own", etalon::library_lines},
        laboratory::commands, argc, argv);
}
