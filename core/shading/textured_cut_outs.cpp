#include "core/shading/textured_cut_outs.h"

#include <algorithm>

#include "core/intersect/parametrization.h"
#include "core/shading/physical_surface.h"
#include "core/texture/mapping.h"

namespace etalon {
namespace {

/// Collects those float textures that are referenced, directly or by another texture. A texture
/// refers to earlier ones only.
class ReferencedTextures {
  public:
    explicit ReferencedTextures(const Textures& from)
        : from_(from), is_marked_(from.numbers.size()) {}

    void mark(const NumberSlot& slot) {
        if (slot.texture != no_index) is_marked_[slot.texture] = true;
    }

    /// Returns the marked textures and those that they refer to, with their indices unchanged.
    Textures find() {
        Textures found{std::vector<Texture<float>>(from_.numbers.size()), {}, from_.images};
        for (std::size_t i = from_.numbers.size(); i-- > 0;) {
            if (!is_marked_[i]) continue;
            found.numbers[i] = from_.numbers[i];
            std::visit([&](const auto& texture) { mark_parts(texture); }, from_.numbers[i]);
        }
        return found;
    }

  private:
    template <class Kind>
    void mark_parts(const Kind& texture) {
        if constexpr (requires { texture.a; }) mark(texture.a), mark(texture.b);
        if constexpr (requires { texture.amount; }) mark(texture.amount);
        if constexpr (requires { texture.even; }) mark(texture.even), mark(texture.odd);
        if constexpr (requires { texture.dot; }) mark(texture.dot), mark(texture.ground);
    }

    const Textures& from_;
    std::vector<bool> is_marked_;
};

/// Calls visit(slot) for the alphas of all surfaces.
template <class Visit>
void for_each_alpha(const PhysicalLook& look, const Visit& visit) {
    for (const SurfaceBinding& binding : look.bindings) {
        visit(binding.alpha);
        visit(binding.shadow_alpha);
    }
}

/// Returns the alpha textures that are images, with their indices unchanged.
Textures image_alphas(const PhysicalLook& look) {
    const Textures& all = look.textures;
    Textures found{std::vector<Texture<float>>(all.numbers.size()), {}, all.images};
    for_each_alpha(look, [&](const NumberSlot& alpha) {
        if (alpha.texture == no_index) return;
        const Texture<float>& texture = all.numbers[alpha.texture];
        if (std::holds_alternative<ImageTexture<float>>(texture)) {
            found.numbers[alpha.texture] = texture;
        }
    });
    return found;
}

/// Returns the alpha textures without a mask and those that they refer to, with their indices
/// unchanged.
template <class Masks>
Textures other_alphas(const PhysicalLook& look, const Masks& masks) {
    ReferencedTextures referenced(look.textures);
    for_each_alpha(look, [&](const NumberSlot& alpha) {
        if (alpha.texture != no_index && !masks[alpha.texture]) referenced.mark(alpha);
    });
    return referenced.find();
}

}  // namespace

std::vector<std::optional<TexturedCutOuts::Mask>> TexturedCutOuts::masks(
    const PhysicalLook& look, std::vector<std::string>& problems) {
    const Textures textures = image_alphas(look);
    const TextureImages images = read_texture_images(textures, problems);
    std::vector<std::optional<Mask>> all(textures.numbers.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto* texture = std::get_if<ImageTexture<float>>(&textures.numbers[i]);
        if (texture == nullptr) continue;
        if (auto zeros = images.numbers[texture->image].zeros()) {
            all[i] = Mask{texture->mapping, std::move(*zeros)};
        }
    }
    return all;
}

TexturedCutOuts::TexturedCutOuts(const PhysicalLook& look, std::vector<std::string>& problems)
    : masks_(masks(look, problems)),
      textures_(other_alphas(look, masks_)),
      values_(textures_, problems) {
    for (const SurfaceBinding& b : look.bindings) {
        surfaces_.push_back({b.alpha, b.shadow_alpha, b.uv_offset});
    }
}

bool TexturedCutOuts::is_hole(const Geometry& geometry, const SurfacePoint& point,
                              bool for_shadow) const {
    const auto& [alpha, shadow_alpha, uv_offset] = surfaces_[point.material];
    const Parametrization at = with_coordinates_of_mesh(geometry, point.primitive, uv_offset,
                                                        parametrization_at(geometry, point));
    const TexturePoint place{at.uv, point.position};
    return is_zero(alpha, place) || (for_shadow && is_zero(shadow_alpha, place));
}

bool TexturedCutOuts::is_zero(const NumberSlot& alpha, const TexturePoint& place) const {
    if (alpha.texture != no_index && masks_[alpha.texture]) {
        const auto& [mapping, zeros] = *masks_[alpha.texture];
        return zeros.is_zero(texture_coordinates(mapping, place));
    }
    return values_.number(alpha, place) == 0;
}

void make_cut_outs(Scene& scene, std::vector<std::string>& problems) {
    if (!scene.is_physical()) return;
    const PhysicalLook& look = scene.physical();
    const auto is_cut_out = [](const SurfaceBinding& b) { return b.is_cut_out(); };
    if (std::ranges::none_of(look.bindings, is_cut_out)) return;
    scene.geometry.cut_outs = std::make_shared<const TexturedCutOuts>(look, problems);
    for (Geometry& object : scene.geometry.objects) object.cut_outs = scene.geometry.cut_outs;
}

}  // namespace etalon
