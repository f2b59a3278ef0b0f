// etalon crosscheck and etalon-bench accuracy with backends that are wrong: "blind" and "modest"
// find nothing, and "far-sighted" finds everything too far away. All but "modest" claim to be
// exact.
#include "app/common/backends.h"
#include "app/common/provenance.h"
#include "app/subcommands.h"
#include "bench/bench_subcommands.h"
#include "core/intersect/kernels.h"

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

/// Finds the right primitives, but gives every t half as large again.
class FarSighted final : public Intersector {
  public:
    explicit FarSighted(const Geometry& geometry) : Intersector(geometry) {
        build_objects<FarSighted>();
    }

  protected:
    std::size_t own_bytes() const override { return 0; }

    void closest_bounded(const RayQuery& query, const NormalizedRay&,
                         NearestHit& nearest) const override {
        for (std::uint32_t id = 0; id < geometry().primitives.size(); ++id) {
            nearest.offer(1.5 * primitive_first_hit(geometry(), id, query), id);
        }
    }

    bool occluded_bounded(const RayQuery& query, const NormalizedRay&) const override {
        for (std::uint32_t id = 0; id < geometry().primitives.size(); ++id) {
            if (primitive_first_hit(geometry(), id, query) <= query.ray.tmax) return true;
        }
        return false;
    }
};

template <class Backend>
std::unique_ptr<Intersector> build(const Geometry& geometry) {
    return std::make_unique<Backend>(geometry);
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
    etalon::add_backend({"blind", "finds nothing", true, etalon::build<etalon::Blind>});
    etalon::add_backend({"modest", "finds nothing", false, etalon::build<etalon::Blind>});
    etalon::add_backend(
        {"far-sighted", "finds it too far away", true, etalon::build<etalon::FarSighted>});
    return etalon::run_program({"blind_backends", "Backends that are wrong", etalon::library_lines},
                               etalon::commands, argc, argv);
}
