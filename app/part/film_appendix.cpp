#include "app/part/film_appendix.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/common/shallow_json.h"
#include "app/part/image_identity.h"
#include "app/part/image_metadata.h"
#include "core/base/hash64.h"
#include "core/image/exr.h"
#include "core/render/image_film.h"
#include "core/render/sample_rates.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view first_line = "etalon-film 2\n";

/// Letters at the end of the file.
struct Ending {
    std::uint64_t hash = 0, bytes = 0;
    std::array<char, 8> mark{};
};
constexpr std::array<char, 8> mark = {'E', 't', 'a', 'l', 'F', 'i', 'l', 'm'};

Json shares_json(const std::vector<SampleShare>& shares) {
    Json list = Json::array();
    for (const SampleShare& s : shares) {
        list.push_back(Json{s.seed, s.first, s.end, s.may_have_rates});
    }
    return list;
}

Json to_json(const FilmAppendix& appendix) {
    Json films = Json::array();
    for (const StoredFilm& film : appendix.films) {
        const Imath::Box2i& w = film.window;
        films.push_back({{"window", Json{w.min.x, w.min.y, w.max.x, w.max.y}},
                         {"shares", shares_json(film.shares)},
                         {"bytes", film.bytes}});
    }
    return {{"identity", appendix.identity}, {"metadata", appendix.metadata}, {"films", films}};
}

FilmAppendix from_json(const Json& json) {
    FilmAppendix result{json.at("identity"), json.at("metadata"), {}};
    for (const Json& film : json.at("films")) {
        const auto w = [&](int i) { return whole_number<int>(film.at("window").at(i)); };
        StoredFilm stored{
            {{w(0), w(1)}, {w(2), w(3)}}, {}, whole_number<std::uint64_t>(film.at("bytes"))};
        for (const Json& s : film.at("shares")) {
            stored.shares.push_back({whole_number<std::uint64_t>(s.at(0)),
                                     whole_number<std::uint32_t>(s.at(1)),
                                     whole_number<std::uint32_t>(s.at(2)), s.at(3)});
        }
        join_shares(stored.shares);
        result.films.push_back(std::move(stored));
    }
    return result;
}

constexpr int most_pixels_of_side = 65536;

/// Most bytes of the two lines of text.
constexpr std::size_t longest_lines = 1 << 26;

/// Returns whether a film of so many bytes may be that of an image: whether there are as many as
/// it takes to store one.
bool is_possible(const StoredFilm& film, const RenderSettings& settings) {
    const Imath::V2i &min = film.window.min, &max = film.window.max, &size = settings.resolution;
    const bool is_inside = 0 <= min.x && min.x <= max.x && max.x < size.x && 0 <= min.y &&
                           min.y <= max.y && max.y < size.y;
    return is_inside && ImageFilm::least_bytes(film.window, settings) <= film.bytes;
}

/// Returns whether an image may have these metadata: whether a pixel that has them can be encoded.
bool is_possible_metadata(const Json& metadata) {
    if (!metadata.is_object()) return false;
    RenderedImage pixel{1, 1, {{0, 0}, {0, 0}}, {Color(0.0F)}, false, {}};
    pixel.metadata = metadata_of(metadata);
    return static_cast<bool>(encode_exr(pixel));
}

/// Returns whether an appendix can be that of an image: a hash shows damage, but not who wrote the
/// file. Throws as film_settings() does.
bool is_possible(const FilmAppendix& appendix, std::uint64_t bytes) {
    const RenderSettings settings = film_settings(appendix.identity);
    const Imath::V2i& size = settings.resolution;
    const auto is_radius = [](double r) { return r > 0 && r <= max_filter_radius; };
    if (!is_radius(settings.filter.radius.x) || !is_radius(settings.filter.radius.y)) return false;
    if (std::max(size.x, size.y) > most_pixels_of_side || appendix.films.empty()) return false;
    if (!is_possible_metadata(appendix.metadata)) return false;
    std::uint64_t left = bytes;
    for (const StoredFilm& film : appendix.films) {
        if (!is_possible(film, settings) || film.bytes > left) return false;
        left -= film.bytes;
    }
    return true;
}

/// Reads the two lines of a file, from its current position; hashes everything up to the end.
Result<FilmAppendix> read_checked(std::ifstream& file, const Ending& ending) {
    Hash64 hash;
    std::string lines;
    std::size_t end = lines.npos;  // of the second line
    std::vector<char> bytes(std::min<std::uint64_t>(ending.bytes, 1 << 20));
    for (std::uint64_t left = ending.bytes; left > 0 && file;) {
        const auto count = std::min<std::uint64_t>(left, bytes.size());
        file.read(bytes.data(), static_cast<std::streamsize>(count));
        hash.add({bytes.data(), count});
        if (end == lines.npos && lines.size() < longest_lines) {
            const std::size_t next = std::max(lines.size(), first_line.size());
            lines.append(bytes.data(), count);
            end = lines.find('\n', next);
        }
        left -= count;
    }
    const std::string damaged = "the sums behind the image are damaged";
    if (!file || hash.value() != ending.hash || end == lines.npos) return {{}, damaged};
    if (!lines.starts_with(first_line)) return {{}, "its sums are of another version of Etalon"};
    try {
        const auto line = lines.substr(first_line.size(), end - first_line.size());
        FilmAppendix appendix = from_json(parse_shallow_json(line));
        if (!is_possible(appendix, ending.bytes)) return {{}, damaged};
        return {std::move(appendix), {}};
    } catch (const Json::exception&) {
        return {{}, damaged};
    }
}

}  // namespace

std::string appendix_line(const FilmAppendix& appendix) {
    return to_json(appendix).dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

StoredFilm one_film(const Json& identity, std::size_t bytes) {
    const Json& crop = identity["crop"];
    const std::uint64_t spp = identity["spp"], part = identity["part"][0],
                        parts = identity["part"][1];
    const SampleShare share{identity["seed"], static_cast<std::uint32_t>(spp * (part - 1) / parts),
                            static_cast<std::uint32_t>(spp * part / parts),
                            spp >= fewest_samples_with_rates};
    return {{{crop[0], crop[1]}, {crop[2].get<int>() - 1, crop[3].get<int>() - 1}}, {share}, bytes};
}

void write_appendix(const std::string& line, const StateWriter::Sink& put,
                    const std::function<void(const StateWriter::Sink&)>& write_films) {
    Ending ending{0, 0, mark};
    Hash64 hash;
    const StateWriter::Sink count = [&](std::string_view bytes) {
        hash.add(bytes);
        ending.bytes += bytes.size();
        put(bytes);
    };
    count(first_line);
    count(line);
    write_films(count);
    ending.hash = hash.value();
    put({reinterpret_cast<const char*>(&ending), sizeof ending});
}

Result<FilmAppendix> AppendixReader::open(const std::string& path) {
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
        return {{}, path + ": cannot be read: is no regular file"};
    }
    const std::uint64_t size = fs::file_size(path, error);
    file_.open(path, std::ios::binary);
    if (error || !file_) {
        return {{}, path + ": cannot be read" + (error ? ": " + error.message() : "")};
    }
    Ending ending;
    if (size > sizeof ending) file_.seekg(static_cast<std::streamoff>(size - sizeof ending));
    file_.read(reinterpret_cast<char*>(&ending), sizeof ending);
    if (!file_ || ending.mark != mark || ending.bytes > size - sizeof ending) {
        return {{}, path + ": holds no sums of samples; expected an EXR of `etalon render --part`"};
    }
    const std::uint64_t begin = size - sizeof ending - ending.bytes;
    file_.seekg(static_cast<std::streamoff>(begin));
    Result<FilmAppendix> result = read_checked(file_, ending);
    close();
    if (!result) return {{}, path + ": " + result.error};
    path_ = path;
    films_ = size - sizeof ending;
    for (const StoredFilm& film : result.value.films) films_ -= film.bytes;
    return result;
}

StateReader AppendixReader::film(const FilmAppendix& appendix, std::size_t number) {
    file_.open(path_, std::ios::binary);
    std::uint64_t begin = films_;
    for (std::size_t i = 0; i < number; ++i) begin += appendix.films[i].bytes;
    file_.seekg(static_cast<std::streamoff>(begin));
    return StateReader([this](char* to, std::size_t size) {
        return static_cast<bool>(file_.read(to, static_cast<std::streamsize>(size)));
    });
}

}  // namespace etalon
