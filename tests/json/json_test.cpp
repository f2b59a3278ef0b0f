// Compares docs/json.md with the JSON of the programs: every value is described, and every
// described value occurs.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "bench/report/data_files.h"
#include "bench/report/sections/sections.h"
#include "bench/speed/timed_tracer.h"
#include "core/scene/shapes.h"
#include "core/test_rays/ray_sets.h"
#include "tests/app/mpirun.h"
#include "tests/bench/report_results.h"
#include "tests/catch.h"
#include "tests/json/documented_keys.h"

using namespace etalon;
using namespace etalon::test;

using nlohmann::json;

namespace {

/// Returns the keys that "<name>" of the document stands for.
std::set<std::string> keys_named(const std::string& name) {
    std::set<std::string> keys;
    if (name == "<backend>") std::ranges::copy(backend_names(), std::inserter(keys, keys.end()));
    if (name == "<ray kind>") keys.insert(ray_kinds.begin(), ray_kinds.end());
    if (name == "<threads>") keys = {"1", "2"};
    if (name == "<tracer>") {
        std::ranges::copy(speed::tracer_names(), std::inserter(keys, keys.end()));
    }
    for (std::size_t kind = 0; name == "<shape>" && kind < shape_kinds; ++kind) {
        keys.emplace(kind_name(static_cast<ShapeKind>(kind)));
    }
    return keys;
}

bool matches(const std::string& documented, const std::string& key) {
    return documented == key ||
           (documented.starts_with('<') && keys_named(documented).contains(key));
}

bool begins_with(const Path& documented, const Path& path) {
    return documented.size() >= path.size() &&
           std::equal(path.begin(), path.end(), documented.begin(),
                      [](const auto& key, const auto& name) { return matches(name, key); });
}

std::string type_of(const json& value) {
    if (value.is_number_float()) return "number";
    return value.is_number() ? "integer" : std::string(value.type_name());
}

/// Checks JSON against the document, and records which documented values have occurred.
class Comparison {
  public:
    Comparison() {
        for (const auto& [name, section] : sections_) {
            for (const Pattern& p : patterns_of(sections_, name)) documented_.insert(p.line);
        }
    }

    void check(const std::string& section, const json& value) {
        patterns_ = patterns_of(sections_, section);
        INFO(section);
        check_at({}, value);
    }

    /// Returns values that are documented but have not occurred, and the reverse.
    std::vector<std::string> missing() const {
        std::vector<std::string> lines;
        std::ranges::set_difference(documented_, seen_, std::back_inserter(lines));
        return lines;
    }

  private:
    void check_at(const Path& path, const json& value) {
        bool is_documented = value.is_structured() && !value.empty();
        for (const Pattern& p : patterns_) is_documented |= describes(p, path, value);
        INFO(fmt::format("{} is {}", fmt::join(path, "."), value.dump()));
        CHECK(is_documented);
        if (!value.is_structured()) return;
        for (const auto& [key, item] : value.items()) {
            Path place = path;
            place.push_back(value.is_array() ? "[]" : key);
            check_at(place, item);
        }
    }

    bool describes(const Pattern& p, const Path& path, const json& value) {
        if (!begins_with(p.path, path)) return false;
        if (p.path.size() > path.size()) return value.is_structured();
        const std::string type = type_of(value);
        if (p.type != type && !(p.type == "number" && type == "integer")) return false;
        seen_.insert(p.line);
        return true;
    }

    const DocumentedSections sections_ =
        read_sections(content_of(ETALON_SOURCE_DIR "/docs/json.md"));
    std::vector<Pattern> patterns_;
    std::set<std::string> documented_, seen_;
};

/// A scene with every light plugin of PBRT.
constexpr const char* pbrt_lights = R"(Film "image" "integer xresolution" 8 "integer yresolution" 8
LookAt 0 1 5 0 0 0 0 1 0
Camera "perspective"
WorldBegin
LightSource "point"
LightSource "spot"
LightSource "distant"
LightSource "infinite"
LightSource "goniometric"
LightSource "projection"
AttributeBegin
AreaLightSource "diffuse"
Shape "sphere" "float radius" 0.1
AttributeEnd
Shape "sphere"
WorldEnd
)";

/// Runs programs in a folder that has scenes.
class Programs {
  public:
    Programs() {
        f_.write("G", small_scene);
        f_.write("lights.pbrt", pbrt_lights);
        f_.write("wrong.p3f", wrong_scene());
        f_.write("black.pfm", pixel(std::string(4, '\0')));
        f_.write("infinite.pfm", pixel(std::string("\x7f\x80\0\0", 4)));
    }

    /// Returns the JSON in a file that the command writes, or in its output for "-".
    json operator()(const std::string& command, const std::string& file, int status = 0) const {
        const auto r = f_.shell("exec '" ETALON_BINARY_DIR "/bin/'" + command);
        INFO(command << "\n" << r.err);
        CHECK(r.status == status);
        return json::parse(file == "-" ? r.out : f_.read(file));
    }

    const Folder& folder() const { return f_; }

  private:
    /// A PFM image of one pixel, whose red value is given by the bytes of a big-endian float.
    static std::string pixel(const std::string& red) {
        return "PF\n1 1\n1.0\n" + red + std::string(8, '\0');
    }

    /// A scene with more diagnostics of one kind than are kept.
    static std::string wrong_scene() {
        std::string text = small_scene;
        for (int i = 0; i < 30; ++i) text += "s 0 0 zero 1\n";
        return text;
    }

    Folder f_;
};

void check_renders(Comparison& c, const Programs& run) {
    const std::string to = "etalon-render---stats", stats = " -q --stats s.json";
    run("etalon render G --spp 2 --seed 1 -q -o a.exr --stats s.json", "s.json");
    c.check(to, run("etalon render G -o b.exr --spp 16 --target-error 1 --reference a.exr" + stats,
                    "s.json"));
    c.check(to, run("etalon render G -o b.exr --spp 4096 --time-limit 1e-300" + stats, "s.json"));
    c.check(to, run("etalon render G -o b.exr --target-error 1 --spp 1" + stats, "s.json"));
    const std::string stopped =
        "etalon render G -o b.exr --spp 4096 --time-limit 1e-300 --checkpoint c";
    run(stopped + stats, "s.json");
    c.check(to, run(stopped + " --resume" + stats, "s.json"));
    if (has_mpirun(run.folder())) {
        const auto r = run.folder().shell(
            mpirun(2) + "'" ETALON_BINARY_DIR "/bin/etalon' render G -o b.exr --spp 4096" + stats);
        CHECK(r.status == 0);
        c.check(to, json::parse(run.folder().read("s.json")));
    }
    const std::string compare = "etalon-compare---json";
    c.check(compare, run("etalon compare a.exr a.exr --json -", "-"));
    REQUIRE(run.folder().etalon("render G --spp 1 --crop 0,0,8,8 -q -o crop.exr").status == 0);
    c.check(compare, run("etalon compare crop.exr a.exr --json -", "-"));
    c.check(compare, run("etalon compare infinite.pfm black.pfm --json -", "-"));
    c.check(compare, run("etalon compare black.pfm infinite.pfm --json -", "-"));
}

void check_info(Comparison& c, const Programs& run) {
    const std::string to = "etalon-info---json", scenes = ETALON_SOURCE_DIR "/scenes/features/";
    c.check(to, run("etalon info G --json", "-"));
    c.check(to, run("etalon info lights.pbrt --json", "-"));
    c.check(to, run("etalon info wrong.p3f --json", "-"));
    c.check(to, run("etalon info black.pfm --json", "-", 3));
    c.check(to, run("etalon info '" + scenes + "skybox.p3f' --json", "-"));
    c.check(to, run("etalon info '" + scenes + "soft_shadows.p3f' --json", "-"));
}

void check_crosschecks(Comparison& c, const Programs& run) {
    const std::string to = "etalon-crosscheck---json";
    c.check(to, run("etalon crosscheck G --rays 20 --json -", "-"));
    const auto r = interrupted(
        run.folder(), "etalon crosscheck G -b bvh --rays 8000000 --json c.json", has_worked(20));
    CHECK(r.status == 130);
    c.check(to, json::parse(run.folder().read("c.json")));
}

void check_measurements(Comparison& c, const Programs& run) {
    c.check("etalon-bench-speed---json",
            run("etalon-bench speed --scene spheres:20 --backends bvh --rays camera,shadow "
                "--max-rays 50 --oracle 0.01 --repeat 1 --json -",
                "-"));
    c.check("etalon-bench-accuracy---json",
            run("etalon-bench accuracy --case SPH-1 --rays 10 --json -", "-"));
    c.check("etalon-bench-frames---json",
            run("etalon-bench frames G --width 16 --repeat 1 --json -", "-"));
    c.check("etalon-bench-convergence---json",
            run("etalon-bench convergence G --width 16 --spp 4 --seeds 1 --json -", "-"));
    run.folder().write("t.tsv", "image\tspp\tcpu_s\trelmse\na.exr\t2\t1\t-\n-\t-\t2\t0.1\n");
    c.check("etalon-bench-convergence---json",
            run("etalon-bench convergence G --reference b.exr --foreign t.tsv --spp 4 --seeds 2 "
                "--json -",
                "-"));
    c.check("etalon-bench-convergence---json",
            run("etalon-bench convergence G --width 1 --reference black.pfm --spp 4 --seeds 1 "
                "--json -",
                "-"));
    const auto r =
        interrupted(run.folder(), "etalon-bench accuracy --backends bvh --rays 1e5 --json a.json",
                    "grep -q bvh out");
    CHECK(r.status == 130);
    c.check("etalon-bench-accuracy---json", json::parse(run.folder().read("a.json")));
}

/// Uses made-up figures, since the report itself takes minutes.
void check_report(Comparison& c, const Programs& run) {
    const bench_report::Results results = sample_results();
    REQUIRE(write_data(run.folder().path(""), results, page_of(results)));
    c.check("datajson-of-etalon-bench-report", json::parse(run.folder().read("data.json")));
}

}  // namespace

TEST_CASE("Every value that the programs write as JSON is documented, and all documented occur") {
    Comparison c;
    const Programs run;
    check_renders(c, run);
    check_info(c, run);
    check_crosschecks(c, run);
    check_measurements(c, run);
    check_report(c, run);
    std::vector<std::string> missing = c.missing();
    if (!has_mpirun(run.folder())) {  // by which ranks are started
        std::erase_if(missing,
                      [](const std::string& line) { return line.find("ranks.") != line.npos; });
    }
    CHECK(missing == std::vector<std::string>());
}
