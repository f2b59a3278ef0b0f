// Data behind the end of the EXR file of a part of an image, where other programs do not look: the
// film, whose sums have more information than the pixels. It consists of a line of text, a line of
// JSON, films as bytes, a hash of these, the number of all these bytes, and eight letters that
// identify it.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/part/sample_share.h"
#include "core/base/result.h"
#include "core/numerics/vec.h"
#include "core/render/state.h"

namespace etalon {

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

/// Returns the description of the only film of an image with this identity.
StoredFilm one_film(const nlohmann::ordered_json& identity, std::size_t bytes);

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
