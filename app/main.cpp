// etalon: renders scene files and analyses them.
#include "app/common/provenance.h"
#include "app/subcommands.h"

namespace {

// To add a subcommand: its file, a line of CMakeLists.txt, its declaration in subcommands.h, and a
// line here.
constexpr etalon::Command commands[] = {
    {"render",
     "Render a scene to EXR and PNG",
     etalon::declare_render,
     {{{"scene.p3f -o scene.png", "Render as the scene asks, to a PNG"},
       {"scene.p3f --spp 64 --resolution 320x240 -o scene.exr --stats scene.json",
        "Render 64 samples per pixel, and write times and numbers of rays beside the image"}}}},
    {"serve",
     "Render a scene, and show it meanwhile on a page for this machine alone",
     etalon::declare_serve,
     {{{"scene.p3f", "Render as the scene asks, and print the address of the page"},
       {"scene.p3f --target-error 0.01 -o scene.exr",
        "Render until the error is small, or the button on the page is pressed"}}}},
    {"info",
     "Show the contents of a scene and what it needs; renders nothing",
     etalon::declare_info,
     {{{"scene.p3f", "Show the numbers of primitives, the size of the image, the memory"},
       {"- --json <scene.p3f", "Show all of it as JSON, of a scene on standard input"}}}},
    {"trace",
     "Trace given rays and write their nearest hits",
     etalon::declare_trace,
     {{{"scene.p3f --rays rays.txt", "Show the nearest hit of each ray"},
       {"scene.p3f --rays rays.txt -b embree -o hits.txt",
        "Find the hits with another backend, and write them to a file"}}}},
    {"crosscheck",
     "Compare the answers of several backends with those of the oracle",
     etalon::declare_crosscheck,
     {{{"scene.p3f --rays 100", "Check all backends with 100 rays of each kind"},
       {"scene.p3f -b bvh,embree-builtin --rays 100 --json crosscheck.json",
        "Check two backends, and write the counts of wrong answers to a file"}}}},
    {"compare",
     "Compare an image with a reference",
     etalon::declare_compare,
     {{{"a.exr b.exr", "Show the metrics of A against the reference B"},
       {"a.exr b.exr --heatmap flip.png --fail-above relmse=0.5",
        "Show where a viewer sees a difference; end with status 1 if relMSE is above 0.5"}}}},
    {"convert",
     "Write a scene in another format",
     etalon::declare_convert,
     {{{"scene.p3f -o scene.pbrt", "Write PBRT; warn of what it cannot express"},
       {"scene.p3f -o again.p3f --strict", "Write P3F, or fail if anything would be lost"}}}},
    {"merge",
     "Merge parts of an image: shares of its samples, crops, other seeds",
     etalon::declare_merge,
     {{{"part1.exr part2.exr -o whole.exr", "Merge two renderings with --part 1/2 and --part 2/2"},
       {"left.exr right.exr -o whole.exr", "Merge two crops of one image"}}}},
};

}  // namespace

int main(int argc, char** argv) {
    return etalon::run_program(
        {"etalon", "A renderer and accelerator laboratory", etalon::library_lines}, commands, argc,
        argv);
}
