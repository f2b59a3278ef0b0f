// etalon crosscheck and etalon-bench accuracy with two backends that find nothing: "blind", which
// claims to be exact, and "modest", which does not.
#include "app/common/backends.h"
#include "app/common/provenance.h"
#include "app/subcommands.h"
#include "bench/bench_subcommands.h"

namespace etalon {
namespace {

class Blind final : public Intersector {
  public:
    explicit Blind(const Geometry& geometry) : Intersector(geometry) { build_objects<Blind>(); }

  protected:
    std::size_t own_bytes() const override { return 0; }
    void closest_bounded(const RayQuery&, const NormalizedRay&, NearestHit&) const override {}
    bool occluded_bounded(const RayQuery&, const NormalizedRay&) const override { return false; }
};

std::unique_ptr<Intersector> build_blind(const Geometry& geometry) {
    return std::make_unique<Blind>(geometry);
}

constexpr Command commands[] = {
    {"crosscheck",
     "Compare backends with the oracle",
     declare_crosscheck,
     {{{"scene.p3f -b blind", "Check one"}, {"scene.p3f -b blind,bvh", "Check two"}}}},
    {"accuracy",
     "Measure errors on hard cases",
     declare_accuracy,
     {{{"--backends blind", "Measure one"}, {"--backends blind,bvh", "Measure two"}}}},
};

}  // namespace
}  // namespace etalon

int main(int argc, char** argv) {
    etalon::add_backend({"blind", "finds nothing", true, etalon::build_blind});
    etalon::add_backend({"modest", "finds nothing", false, etalon::build_blind});
    return etalon::run_program({"blind_backends", "Backends that are wrong", etalon::library_lines},
                               etalon::commands, argc, argv);
}
