// etalon: renders scene files, and shows what it does with them.
#include "app/subcommands.h"

namespace {

// To add a subcommand: one file that declares and runs it, one line here.
constexpr etalon::Command commands[] = {
    {"render", "Render a scene to EXR and PNG", etalon::declare_render},
    {"info", "Show the contents of a scene and what it needs; renders nothing",
     etalon::declare_info},
    {"trace", "Trace given rays and write their nearest hits", etalon::declare_trace},
    {"crosscheck", "Compare the answers of several backends with those of the oracle",
     etalon::declare_crosscheck},
    {"compare", "Compare an image with a reference", etalon::declare_compare},
    {"convert", "Write a scene in another format", etalon::declare_convert},
};

}  // namespace

int main(int argc, char** argv) {
    return etalon::run_program("etalon", "Etalon: a renderer and accelerator laboratory", commands,
                               argc, argv);
}
