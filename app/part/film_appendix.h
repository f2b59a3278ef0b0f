// Data behind the end of the EXR file of a part of an image, where other programs do not look: the
// film, whose sums have more information than the pixels. It consists of a line of text, a line of
// JSON, films as bytes, a hash of these, the number of all these bytes, and eight letters that
// identify it.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/image/rendered_image.h"
#include "core/render/state.h"

namespace etalon {

/// Range of samples of each pixel. For a pixel with a rate, numbers are multiplied by the rate.
struct SampleShare {
    std::uint64_t seed;
    std::uint32_t first, end;
    bool may_have_rates = false;  ///< the image has so many samples that pixels may have rates

    auto operator<=>(const SampleShare&) const = default;
};

/// Description of a stored film.
struct StoredFilm {
    Imath::Box2i window;  ///< window of the image, inclusive on both ends
    std::vector<SampleShare> shares;
    std::uint64_t bytes;
};

struct FilmAppendix {
    nlohmann::ordered_json identity;  ///< see image_identity()
    nlohmann::ordered_json metadata;  ///< metadata of the image
    std::vector<StoredFilm> films;
};

/// Sorts shares, and joins those that continue each other.
void join_shares(std::vector<SampleShare>& shares);

/// Returns the description of the only film of an image with this identity.
StoredFilm one_film(const nlohmann::ordered_json& identity, std::size_t bytes);

/// Convert the image's metadata to JSON and back.
nlohmann::ordered_json metadata_json(const RenderedImage& image);
std::map<std::string, RenderedImage::Attribute> metadata_of(const nlohmann::ordered_json& json);

/// Returns the first line of the appendix. (The JSON library allocates memory when values are
/// destroyed, and ends the program if there is none.)
std::string appendix_line(const FilmAppendix& appendix);

/// Calls put(bytes) with all of an appendix that begins with `line`; `write_films` writes the films
/// in their order.
void write_appendix(const std::string& line, const StateWriter::Sink& put,
                    const std::function<void(const StateWriter::Sink&)>& write_films);

/// Reads a file that ends with such an appendix. The file is open only while it is read, as there
/// may be more files than a process can have open.
class AppendixReader {
  public:
    /// Checks all of the appendix and returns it without the films. An error begins with the path.
    Result<FilmAppendix> open(const std::string& path);

    /// Returns a reader of the film with that number.
    StateReader film(const FilmAppendix& appendix, std::size_t number);

    /// Ends the reading of a film.
    void close() { file_.close(); }

  private:
    std::string path_;
    std::ifstream file_;
    std::uint64_t films_ = 0;  ///< offset of the films
};

}  // namespace etalon
