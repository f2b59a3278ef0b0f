// etalon: renders scene files, and shows what it does with them.
#include "app/subcommands.h"

namespace {

// To add a subcommand: one file that declares and runs it, one line here.
constexpr etalon::Command commands[] = {
    {"render", "Render a scene to EXR and PNG", etalon::declare_render},
    {"info", "Say what a scene holds and needs, without building anything", etalon::declare_info},
    {"trace", "Rays in, hits out", etalon::declare_trace},
    {"crosscheck", "The same rays through several backends and the oracle",
     etalon::declare_crosscheck},
    {"compare", "How far a picture is from another", etalon::declare_compare},
    {"convert", "Write a scene in another format", etalon::declare_convert},
};

}  // namespace

int main(int argc, char** argv) {
    return etalon::run_program("etalon", "Etalon: a renderer and accelerator laboratory", commands,
                               argc, argv);
}
