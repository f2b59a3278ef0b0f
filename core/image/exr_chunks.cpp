#include "core/image/exr_chunks.h"

#include <new>
#include <stdexcept>
#include <utility>

namespace etalon {
namespace {

constexpr int part = 0;

void require(bool condition, const char* what) {
    if (!condition) throw std::runtime_error(what);
}

void check(exr_result_t result) {
    if (result == EXR_ERR_OUT_OF_MEMORY) throw std::bad_alloc();
    require(result == EXR_ERR_SUCCESS, exr_get_default_error_message(result));
}

/// Keeps the library from printing messages; check() has its results.
void ignore_message(exr_const_context_t, exr_result_t, const char*) {}

_priv_exr_context_t* open(const std::string& path) {
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = ignore_message;
    exr_context_t file = nullptr;
    check(exr_start_read(&file, path.c_str(), &settings));
    return file;
}

Imath::V2i tile_size(exr_const_context_t file) {
    std::uint32_t x = 0, y = 0;
    exr_tile_level_mode_t levels{};
    exr_tile_round_mode_t round{};
    check(exr_get_tile_descriptor(file, part, &x, &y, &levels, &round));
    require(x > 0 && y > 0, "tiles without pixels");
    return {static_cast<int>(x), static_cast<int>(y)};
}

/// The library's buffers for a chunk.
class Pipeline {
  public:
    Pipeline(exr_const_context_t file, const exr_chunk_info_t& chunk) : file_(file) {
        check(exr_decoding_initialize(file, part, &chunk, &buffers_));
    }
    ~Pipeline() { exr_decoding_destroy(file_, &buffers_); }
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    /// Reads and decompresses. Values are not converted: memory for them is only worth taking once
    /// they are known to exist.
    ExrBytes run() {
        check(exr_decoding_choose_default_routines(file_, part, &buffers_));
        buffers_.unpack_and_convert_fn = nullptr;
        check(exr_decoding_run(file_, part, &buffers_));
        void* const bytes = std::exchange(buffers_.unpacked_buffer, nullptr);
        if (bytes == buffers_.packed_buffer)
            buffers_.packed_buffer = nullptr;  // was stored as it is
        return ExrBytes(static_cast<std::uint8_t*>(bytes));
    }

  private:
    exr_const_context_t file_;
    exr_decode_pipeline_t buffers_ = EXR_DECODE_PIPELINE_INITIALIZER;
};

}  // namespace

ExrChunks::ExrChunks(const std::string& path, bool is_tiled) : file_(open(path)) {
    exr_storage_t storage{};
    exr_attr_box2i_t window{};
    check(exr_get_storage(file_.get(), part, &storage));
    require(storage == (is_tiled ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE), "another type");
    check(exr_get_data_window(file_.get(), part, &window));
    check(exr_get_compression(file_.get(), part, &compression_));
    if (is_tiled) tile_size_ = tile_size(file_.get());
    origin_ = {window.min.x, window.min.y};
    size_ = {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
}

std::span<const exr_attr_chlist_entry_t> ExrChunks::channels() const {
    const exr_attr_chlist_t* list = nullptr;
    check(exr_get_channels(file_.get(), part, &list));
    return {list->entries, static_cast<std::size_t>(list->num_channels)};
}

bool ExrChunks::can_decode() const {
    return compression_ == EXR_COMPRESSION_NONE || compression_ == EXR_COMPRESSION_RLE ||
           compression_ == EXR_COMPRESSION_ZIPS || compression_ == EXR_COMPRESSION_ZIP;
}

ExrChunk ExrChunks::chunk_at(const Imath::V2i& corner) const {
    ExrChunk chunk{{}, corner};
    exr_chunk_info_t& info = chunk.info;
    if (tile_size_.x > 0) {
        check(exr_read_tile_chunk_info(file_.get(), part, corner.x / tile_size_.x,
                                       corner.y / tile_size_.y, 0, 0, &info));
    } else {
        check(exr_read_scanline_chunk_info(file_.get(), part, origin_.y + corner.y, &info));
    }
    require(info.width > 0 && info.width <= size_.x - corner.x, "columns outside the image");
    require(info.height > 0 && info.height <= size_.y - corner.y, "rows outside the image");
    if (compression_ == EXR_COMPRESSION_NONE) {  // the library refuses empty chunks only
        require(info.packed_size == info.unpacked_size, "a chunk of another size");
    }
    return chunk;
}

ExrBytes ExrChunks::decode(const ExrChunk& chunk) const {
    return Pipeline(file_.get(), chunk.info).run();
}

}  // namespace etalon
