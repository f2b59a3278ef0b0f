// What a part of an image has behind the end of its EXR file, where other programs do not look: the
// film, whose sums tell more than the pixels do. It is a line that says so, a line of JSON, films
// as bytes, a hash of these, the number of all these bytes, and eight letters by which it is found.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/rendered_image.h"
#include "core/render/state.h"

namespace etalon {

/// Samples of each pixel, by their numbers: those of a pixel with a rate are that times as many.
struct SampleShare {
    std::uint64_t seed;
    std::uint32_t first, end;

    auto operator<=>(const SampleShare&) const = default;
};

/// A film among others.
struct StoredFilm {
    Imath::Box2i window;  ///< of the image, inclusive on both ends
    std::vector<SampleShare> shares;
    std::uint64_t bytes;
};

struct FilmAppendix {
    nlohmann::ordered_json identity;  ///< see image_identity()
    nlohmann::ordered_json metadata;  ///< of the image
    std::vector<StoredFilm> films;
};

/// Returns the one film of an image of this identity.
StoredFilm one_film(const nlohmann::ordered_json& identity, std::size_t bytes);

/// The image's metadata as JSON, and back.
nlohmann::ordered_json metadata_json(const RenderedImage& image);
std::map<std::string, RenderedImage::Attribute> metadata_of(const nlohmann::ordered_json& json);

/// The line of text with which the appendix begins. The JSON that it is made of asks for memory
/// when it is destroyed, and ends the program where there is none.
std::string appendix_line(const FilmAppendix& appendix);

/// Calls put(bytes) with all of an appendix that begins with that line; `write_films` writes the
/// films in their order.
void write_appendix(const std::string& line, const StateWriter::Sink& put,
                    const std::function<void(const StateWriter::Sink&)>& write_films);

/// The same in memory, for films as bytes.
std::string film_appendix(const FilmAppendix& appendix, const std::string& films);

/// A file that ends with such an appendix.
class AppendixReader {
  public:
    /// Returns the appendix without the films. An error begins with the path.
    Result<FilmAppendix> open(const std::string& path);

    /// Returns a reader of the film of that number.
    StateReader film(const FilmAppendix& appendix, std::size_t number);

  private:
    std::ifstream file_;
    std::uint64_t films_ = 0;  ///< where they begin
};

}  // namespace etalon
