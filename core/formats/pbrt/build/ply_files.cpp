#include "core/formats/pbrt/build/ply_files.h"

#include <filesystem>
#include <utility>

#include "core/formats/mapped_file.h"
#include "core/parallel/parallel.h"

namespace etalon::pbrt {
namespace {

/// Limit of the bytes of files in memory at a time, if there is more than one.
constexpr std::uintmax_t most_bytes = 64 << 20;

PlyFile read(const Shape& shape, bool strict) {
    PlyFile result{std::string(shape.plugin.parameters.string("filename")), {}, {}, {}};
    const MappedFile file(result.path, FileKind::regular);
    result.error = file.error();
    if (!result.error.empty()) return result;
    DiagnosticLog log(result.path, file.text(), strict);
    result.mesh = read_ply(file.text(), log);
    result.said = std::move(log.list());
    return result;
}

std::uintmax_t size_of_file(const Shape& shape) {
    std::error_code unknown;
    const std::uintmax_t size =
        std::filesystem::file_size(shape.plugin.parameters.string("filename"), unknown);
    return unknown ? 0 : size;
}

/// Returns how many of the files to read together: enough to keep all threads busy.
std::size_t size_of_batch(std::span<const Shape* const> shapes) {
    const auto threads = static_cast<std::size_t>(max_threads());
    const std::size_t most = std::min(shapes.size(), threads > 1 ? 4 * threads : 1);
    std::uintmax_t bytes = size_of_file(*shapes.front());
    std::size_t count = 1;
    while (count < most && bytes <= most_bytes) bytes += size_of_file(*shapes[count++]);
    return count;
}

}  // namespace

PlyFiles::PlyFiles(const Frame& frame, bool strict) : strict_(strict) {
    add(frame.shapes);
    std::vector<bool> is_added(frame.objects.size(), false);
    for (const Instance& instance : frame.instances) {
        if (is_added[instance.object]) continue;
        is_added[instance.object] = true;
        add(frame.objects[instance.object].shapes);
    }
}

void PlyFiles::add(std::span<const Shape> shapes) {
    for (const Shape& shape : shapes) {
        if (shape.plugin.type->name != "plymesh") continue;
        numbers_.emplace(&shape, shapes_.size());
        shapes_.push_back(&shape);
    }
}

PlyFile PlyFiles::take(const Shape& shape) {
    const std::size_t number = numbers_.at(&shape);
    if (number < first_read_ || number >= first_read_ + read_.size()) read_ahead(number);
    return std::move(read_[number - first_read_]);
}

void PlyFiles::read_ahead(std::size_t number) {
    const std::span<const Shape* const> ahead = std::span(shapes_).subspan(number);
    read_.clear();
    read_.resize(size_of_batch(ahead));
    first_read_ = number;
    parallel_for(read_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) read_[i] = read(*ahead[i], strict_);
    });
}

}  // namespace etalon::pbrt
