#include "bench/accuracy/tracer.h"

namespace etalon::accuracy {
namespace {

class BackendTracer final : public Tracer {
  public:
    BackendTracer(const Backend& backend, const Scene& scene)
        : Tracer(std::string(backend.name)), intersector_(backend.build(scene.geometry)) {}

    void closest(const RayBlock& block, std::span<Answer> answers) const override {
        for (std::size_t i = 0; i < block.rays.size(); ++i) {
            answers[i] = intersector_->closest(block.rays[i]).value_or(missed);
        }
    }

    void occluded(const RayBlock& block, std::span<char> answers) const override {
        for (std::size_t i = 0; i < block.rays.size(); ++i) {
            answers[i] = intersector_->occluded(block.rays[i]);
        }
    }

  private:
    std::unique_ptr<Intersector> intersector_;
};

}  // namespace

RayBlock::RayBlock(std::vector<Ray> list)
    : rays(std::move(list)),
      queries(rays.begin(), rays.end()),
      floats(rays.begin(), rays.end()),
      prepared(rays.begin(), rays.end()) {}

void Tracer::occluded(const RayBlock& block, std::span<char> answers) const {
    std::vector<Answer> nearest(block.rays.size(), missed);
    closest(block, nearest);
    for (std::size_t i = 0; i < nearest.size(); ++i) answers[i] = nearest[i].primitive != no_index;
}

std::unique_ptr<Tracer> backend_tracer(const Backend& backend, const Scene& scene) {
    return std::make_unique<BackendTracer>(backend, scene);
}

}  // namespace etalon::accuracy
