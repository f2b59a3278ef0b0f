#include "core/formats/pbrt/build/bsdf_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "core/formats/diagnostic_log.h"
#include "core/formats/file_text.h"

namespace etalon::pbrt {
namespace {

constexpr std::string_view magic = "SCATFUN\x01";
constexpr std::uint32_t is_bsdf = 1;

/// Header after the magic number, in the byte order of x86.
struct Header {
    std::uint32_t flags;
    std::int32_t cosines, coefficients, longest, channels, bases;
    std::int32_t metadata_bytes, parameters, parameter_values;
    float eta;
    float alpha[2], unused[2];
};
static_assert(sizeof(Header) == 56);

/// Reads the bytes of a file from its beginning.
class Bytes {
  public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

    std::size_t size() const { return bytes_.size(); }

    /// There must be that many bytes left.
    template <class T>
    std::vector<T> take(std::size_t count) {
        std::vector<T> values(count);
        if (count > 0) std::memcpy(values.data(), bytes_.data(), count * sizeof(T));
        bytes_.remove_prefix(count * sizeof(T));
        return values;
    }

  private:
    std::string_view bytes_;
};

/// Returns why a file with this header cannot be used; empty if it can.
std::string check_header(const Header& h, std::size_t bytes_after) {
    if (h.flags != is_bsdf)
        return fmt::format("has the flags {}: expected 1, a plain BSDF", h.flags);
    if (h.channels != 1 && h.channels != 3) {
        return fmt::format("has {} channels: expected 1 or 3", h.channels);
    }
    if (h.bases != 1) return fmt::format("has {} bases: expected 1, without textures", h.bases);
    if (h.cosines < 2 || h.cosines > 1 << 14 || h.coefficients < 0) {
        return fmt::format("announces {} cosines and {} coefficients", h.cosines, h.coefficients);
    }
    if (!(h.eta > 0) || !std::isfinite(h.eta))
        return "has an index of refraction that is not positive";
    const auto n = static_cast<std::size_t>(h.cosines);
    const std::size_t needed = 4 * (n + 3 * n * n + static_cast<std::size_t>(h.coefficients));
    if (bytes_after < needed) {
        return fmt::format("ends early: {} bytes after the header, expected {}", bytes_after,
                           needed);
    }
    return {};
}

/// The same for the contents of the file.
std::string check_table(const FourierTable& table) {
    const auto is_finite = [](float x) { return std::isfinite(x); };
    for (const auto* numbers : {&table.cosines, &table.sums, &table.coefficients}) {
        if (!std::ranges::all_of(*numbers, is_finite)) return "has a number that is not finite";
    }
    const auto& c = table.cosines;
    if (std::ranges::adjacent_find(c, std::greater_equal()) != c.end() || c.front() < -1 ||
        c.back() > 1) {
        return "has cosines that do not increase from -1 to 1";
    }
    const std::uint64_t count = table.coefficients.size();
    const auto is_outside = [&](const FourierTable::Series& s) {
        return s.first + std::uint64_t{s.length} * table.channels > count;
    };
    if (std::ranges::any_of(table.series, is_outside)) {
        return "has a series beyond the end of its coefficients";
    }
    return {};
}

}  // namespace

Result<FourierTable> parse_bsdf_file(std::string_view text) {
    if (!text.starts_with(magic))
        return {{}, "does not begin as a table of a BSDF, with SCATFUN and 1"};
    Bytes bytes(text.substr(magic.size()));
    if (bytes.size() < sizeof(Header)) return {{}, "ends within its header"};
    const Header header = bytes.take<Header>(1)[0];
    if (std::string why = check_header(header, bytes.size()); !why.empty()) return {{}, why};
    const auto n = static_cast<std::size_t>(header.cosines);
    FourierTable table;
    table.eta = header.eta;
    table.channels = header.channels;
    table.cosines = bytes.take<float>(n);
    table.sums = bytes.take<float>(n * n);
    table.series = bytes.take<FourierTable::Series>(n * n);
    table.coefficients = bytes.take<float>(static_cast<std::size_t>(header.coefficients));
    return {table, check_table(table)};
}

const BsdfFiles::Table& BsdfFiles::read(const std::string& path) {
    const auto [place, is_new] = tables_.try_emplace(path);
    Table& table = place->second;
    if (!is_new) return table;
    if (path.empty()) {
        table.error = "no bsdffile is given";
        return table;
    }
    const FileText file = read_file(path, FileKind::regular);
    Result<FourierTable> parsed{{}, file.error};
    if (file.error.empty()) parsed = parse_bsdf_file(file.text());
    if (parsed) {
        table.value = std::make_shared<const FourierTable>(std::move(parsed.value));
    } else {
        table.error = fmt::format("{} {}", path_in_quotes(path), parsed.error);
    }
    return table;
}

}  // namespace etalon::pbrt
