#include "core/formats/pbrt/write_frames.h"

#include <optional>

#include "core/formats/pbrt/plugin_text.h"
#include "core/formats/write/text.h"

namespace etalon::pbrt {
namespace {

std::string medium_name(std::uint32_t number) {
    return number == none ? std::string() : fmt::format("medium-{}", number);
}

std::string object_name(std::uint32_t number) {
    return fmt::format("object-{}", number);
}

/// The graphics state that the text so far has set.
struct WrittenState {
    TransformPair to_world{};
    std::uint32_t material = none;
    MediumInterface media{};
    bool reverse_orientation = false;
};

class FrameWriter {
  public:
    FrameWriter(const Frame& frame, const std::filesystem::path& directory, LineWriter& out)
        : frame_(frame), directory_(directory), out_(out) {}

    void write() {
        write_options();
        out_.line("\nWorldBegin");
        write_media();
        write_textures();
        write_materials();
        write_lights();
        write_objects();
        write_shapes(frame_.shapes);
        for (const Instance& instance : frame_.instances) {
            set_transform(instance.to_world);
            out_.line("ObjectInstance {}", quote(object_name(instance.object)));
        }
        // The camera is in the medium that is outside at the end.
        if (frame_.has_media) write_interface({none, frame_.camera_medium});
        out_.line("WorldEnd");
    }

  private:
    void write_plugin(std::string_view directive, const Plugin& plugin) {
        out_.line("{} {}{}", directive, quote(plugin.type->name),
                  parameters_text(plugin, directory_));
    }

    /// Writes a plugin whose type is one of its parameters.
    void write_named(std::string_view directive, const std::string& name, const Plugin& plugin,
                     const std::string& more = {}) {
        out_.line("{} {} \"string type\" {}{}{}", directive, quote(name), quote(plugin.type->name),
                  parameters_text(plugin, directory_), more);
    }

    void write_options() {
        write_camera_transform();
        write_plugin("Camera", frame_.camera);
        write_plugin("Sampler", frame_.sampler);
        write_plugin("PixelFilter", frame_.filter);
        write_plugin("Film", frame_.film);
        write_plugin("Integrator", frame_.integrator);
        write_plugin("Accelerator", frame_.accelerator);
        const auto& [start, end] = frame_.transform_times;
        if (start != 0 || end != 1) out_.line("TransformTimes {} {}", start, end);
    }

    void write_camera_transform() {
        const auto& [start, end] = frame_.camera_transforms;
        write_transform(start.from_world, end.from_world);
    }

    void write_transform(const Matrix4& start, const Matrix4& end) {
        if (start == end) {
            out_.line("Transform {}", matrix_text(start));
            return;
        }
        out_.line("ActiveTransform StartTime Transform {}", matrix_text(start));
        out_.line("ActiveTransform EndTime Transform {}", matrix_text(end));
        out_.line("ActiveTransform All");
    }

    void set_transform(TransformPair pair) {
        if (pair == now_.to_world) return;
        now_.to_world = pair;
        write_transform(frame_.transforms[pair.start], frame_.transforms[pair.end]);
    }

    void set_transform(std::uint32_t still) { set_transform({still, still}); }

    void write_interface(MediumInterface media) {
        out_.line("MediumInterface {} {}", quote(medium_name(media.inside)),
                  quote(medium_name(media.outside)));
    }

    void set_media(MediumInterface media) {
        if (media == now_.media) return;
        now_.media = media;
        write_interface(media);
    }

    void write_media() {
        for (std::uint32_t i = 0; i < frame_.media.size(); ++i) {
            set_transform(frame_.media[i].to_world);
            write_named("MakeNamedMedium", medium_name(i), frame_.media[i].plugin);
        }
    }

    void write_textures() {
        for (std::uint32_t i = 0; i < frame_.textures.size(); ++i) {
            const auto& [plugin, to_world] = frame_.textures[i];
            set_transform(to_world);
            const bool is_float = plugin.type->category == Category::float_texture;
            out_.line("Texture {} \"{}\" {}{}", quote(texture_name(i)),
                      is_float ? "float" : "spectrum", quote(plugin.type->name),
                      parameters_text(plugin, directory_));
        }
    }

    void write_materials() {
        for (std::uint32_t i = 0; i < frame_.materials.size(); ++i) {
            const auto& [plugin, mixed] = frame_.materials[i];
            std::string names;
            std::size_t count = 0;
            for (const ParameterSpec& spec : plugin.type->parameters) {
                if (spec.type != ValueType::material) continue;
                names += fmt::format(" \"string {}\" {}", spec.name,
                                     quote(material_name(mixed[count++])));
            }
            write_named("MakeNamedMaterial", material_name(i), plugin, names);
        }
    }

    void write_lights() {
        for (const Light& light : frame_.lights) {
            set_transform(light.to_world);
            set_media({none, light.medium});
            write_plugin("LightSource", light.plugin);
        }
    }

    void write_objects() {
        for (std::uint32_t i = 0; i < frame_.objects.size(); ++i) {
            out_.line("ObjectBegin {}", quote(object_name(i)));
            const WrittenState outside = now_;
            write_shapes(frame_.objects[i].shapes);
            now_ = outside;
            out_.line("ObjectEnd");
        }
    }

    void write_shapes(const std::vector<Shape>& shapes) {
        for (std::size_t i = 0; i < shapes.size();) {
            if (shapes[i].area_light == none) {
                write_shape(shapes[i++]);
            } else {
                i = write_lit_shapes(shapes, i);
            }
        }
    }

    /// Writes consecutive shapes with the same area light, in a block.
    std::size_t write_lit_shapes(const std::vector<Shape>& shapes, std::size_t first) {
        const std::uint32_t light = shapes[first].area_light;
        const WrittenState outside = now_;
        out_.line("AttributeBegin");
        write_plugin("AreaLightSource", frame_.area_lights[light]);
        std::size_t i = first;
        for (; i < shapes.size() && shapes[i].area_light == light; ++i) write_shape(shapes[i]);
        out_.line("AttributeEnd");
        now_ = outside;
        return i;
    }

    void write_shape(const Shape& shape) {
        set_transform(shape.to_world);
        set_media(shape.media);
        if (shape.material != now_.material) {
            out_.line("NamedMaterial {}", quote(material_name(shape.material)));
            now_.material = shape.material;
        }
        if (shape.reverse_orientation != now_.reverse_orientation) {
            out_.line("ReverseOrientation");
            now_.reverse_orientation = shape.reverse_orientation;
        }
        write_plugin("Shape", shape.plugin);
    }

    const Frame& frame_;
    const std::filesystem::path& directory_;
    LineWriter& out_;
    WrittenState now_{};
};

}  // namespace

void write_frames(std::span<const Frame> frames, const std::filesystem::path& directory,
                  const std::function<void(std::string_view)>& sink) {
    LineWriter out(sink);
    for (const Frame& frame : frames) FrameWriter(frame, directory, out).write();
    out.flush();
}

}  // namespace etalon::pbrt
