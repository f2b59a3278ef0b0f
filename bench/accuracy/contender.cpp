#include "bench/accuracy/contender.h"

namespace etalon::accuracy {
namespace {

class BackendContender final : public Contender {
  public:
    BackendContender(const Backend& backend, const Scene& scene)
        : Contender(std::string(backend.name)), intersector_(backend.build(scene.geometry)) {}

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

void Contender::occluded(const RayBlock& block, std::span<char> answers) const {
    std::vector<Answer> nearest(block.rays.size(), missed);
    closest(block, nearest);
    for (std::size_t i = 0; i < nearest.size(); ++i) answers[i] = nearest[i].primitive != no_index;
}

std::unique_ptr<Contender> backend_contender(const Backend& backend, const Scene& scene) {
    return std::make_unique<BackendContender>(backend, scene);
}

}  // namespace etalon::accuracy
