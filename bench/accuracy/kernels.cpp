#include "bench/accuracy/textbook/textbooks.h"
#include "bench/accuracy/tracer.h"
#include "core/intersect/shapes/all_shapes.h"

namespace etalon::accuracy {
namespace {

/// Adapts the project's kernel to the interface of textbook kernels.
template <class Shape>
struct ProjectKernel {
    using RayForm = RayQuery;

    double first_hit(const RayQuery& query) const {
        const double t = etalon::first_hit(scene.geometry, shape, sides, query);
        return t <= query.ray.tmax ? t : no_hit;
    }

    const Scene& scene;
    Shape shape;
    Sides sides;
};

template <class RayForm>
const std::vector<RayForm>& rays_as(const RayBlock& block) {
    if constexpr (std::is_same_v<RayForm, RayQuery>) {
        return block.queries;
    } else if constexpr (std::is_same_v<RayForm, FloatRay>) {
        return block.floats;
    } else if constexpr (std::is_same_v<RayForm, PreparedRay>) {
        return block.prepared;
    } else {
        return block.rays;
    }
}

/// A kernel alone, inlined into the loop over the rays.
template <class Kernel>
class KernelTracer final : public Tracer {
  public:
    KernelTracer(std::string_view name, Kernel kernel)
        : Tracer(std::string(name)), kernel_(std::move(kernel)) {}

    void closest(const RayBlock& block, std::span<Answer> answers) const override {
        const auto& rays = rays_as<typename Kernel::RayForm>(block);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double t = kernel_.first_hit(rays[i]);
            answers[i] = t < infinity ? Answer{t, 0} : missed;
        }
    }

  private:
    Kernel kernel_;
};

template <class Kernel>
std::unique_ptr<Tracer> tracer(std::string_view name, Kernel kernel) {
    return std::make_unique<KernelTracer<Kernel>>(name, std::move(kernel));
}

template <class Shape>
std::vector<std::unique_ptr<Tracer>> textbooks_of(const Scene& scene, const Shape& shape) {
    std::vector<std::unique_ptr<Tracer>> list;
    std::apply([&](auto... k) { (list.push_back(tracer(k.name, std::move(k.kernel))), ...); },
               textbook_kernels(scene, shape));
    return list;
}

}  // namespace

std::unique_ptr<Tracer> kernel_tracer(const Scene& scene) {
    if (scene.geometry.primitives.size() != 1) return nullptr;
    const Primitive& p = scene.geometry.primitives.front();
    return with_shape(p.kind, [&]<class Shape>() {
        const auto shape = scene.geometry.get<Shape>(p);
        return tracer("kernel", ProjectKernel<decltype(shape)>{scene, shape, p.sides});
    });
}

std::vector<std::unique_ptr<Tracer>> textbook_tracers(const Scene& scene) {
    if (scene.geometry.primitives.size() != 1) return {};
    const Primitive& p = scene.geometry.primitives.front();
    return with_shape(
        p.kind, [&]<class Shape>() { return textbooks_of(scene, scene.geometry.get<Shape>(p)); });
}

}  // namespace etalon::accuracy
