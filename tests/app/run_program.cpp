#include "tests/app/run_program.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

namespace etalon::test {

const std::string small_scene = R"(accel bvh
spp 0
bclr 0.2 0.3 0.4
camera
eye 0 1 5
at 0 0 0
up 0 1 0
angle 45
hither 0.01
resolution 32 24
aperture 0
focal 1
light punctual 3 5 4 1 1 1
mat 0.8 0.6 0.4 1 1 1 1 0 10 0 1
pl 1 -1 0 0 -1 1 -1 -1 0
mat 1 0.2 0.1 0.7 1 1 1 0.3 30 0 1
s 0 0 0 1
)";

std::string Folder::write(const std::string& name, const std::string& text) const {
    put(path(name), text);
    return path(name);
}

bool Folder::has(const std::string& name) const {
    return std::filesystem::exists(path(name));
}

std::string Folder::read(const std::string& name) const {
    return content_of(path(name));
}

ProgramResult Folder::etalon(const std::string& arguments, const std::string& input) const {
    return shell(fmt::format("exec {}/bin/etalon {}", ETALON_BINARY_DIR, arguments), input);
}

ProgramResult Folder::shell(const std::string& command, const std::string& input) const {
    const Folder io;
    io.write("in", input);
    const std::string line = fmt::format("cd '{}' && {{ {}; }} <'{}' >'{}' 2>'{}'", path(""),
                                         command, io.path("in"), io.path("out"), io.path("err"));
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    rusage usage = {};
    wait4(child, &status, 0, &usage);
    return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), io.read("out"),
            io.read("err"), static_cast<std::size_t>(usage.ru_maxrss) * 1024};
}

ProgramResult interrupted(const Folder& f, const std::string& command, const std::string& until,
                          const std::string& signal) {
    // Removes the output of an earlier program, which must not be mistaken for that of this one.
    // The temporary files of a program that is killed are removed with the folder.
    const auto r = f.shell("export TMPDIR=$PWD; rm -f out err; '" ETALON_BINARY_DIR "/bin/'" +
                           command + " >out 2>err & pid=$!; while kill -0 $pid && ! { " + until +
                           "; }; do sleep 0.02; done 2>loop; kill -" + signal + " $pid; wait $pid");
    return {r.status, f.read("out"), f.read("err"), r.peak_bytes};
}

std::string has_worked(int hundredths) {
    return "test $(cut -d ' ' -f 14 /proc/$pid/stat) -ge " + std::to_string(hundredths);
}

}  // namespace etalon::test
