#include "bench/convergence/foreign_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/base/parse_number.h"
#include "core/formats/byte_order_mark.h"

namespace etalon::convergence {
namespace {

namespace fs = std::filesystem;

/// Text between two tabs, and the column in which it begins.
struct Field {
    std::string text;
    std::size_t column;
};

std::vector<Field> fields_of(const std::string& line) {
    std::vector<Field> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find('\t', begin), line.size());
        fields.push_back({line.substr(begin, end - begin), begin + 1});
        begin = end + 1;
    }
    return fields;
}

bool is_given(const std::string& text) {
    return !text.empty() && text != "-";
}

/// Reads one field into an image; returns what was expected, or nothing.
using ReadField = std::function<std::string(const std::string& text, ForeignImage& image)>;

template <class Set>
ReadField number(double least, const char* expected, const Set& set) {
    return [=](const std::string& text, ForeignImage& image) -> std::string {
        const std::optional<double> value = parse_number<double>(text);
        if (!value || !std::isfinite(*value) || *value < least) return expected;
        set(image, *value);
        return {};
    };
}

ReadField number(double ForeignImage::*member) {
    return number(std::numeric_limits<double>::min(), "a number above 0",
                  [=](ForeignImage& image, double value) { image.*member = value; });
}

ReadField pixels(int Imath::V2i::*side) {
    return [=](const std::string& text, ForeignImage& image) -> std::string {
        int& count = image.size.*side;
        count = parse_number<int>(text).value_or(0);
        return count >= 1 ? "" : "a number of pixels";
    };
}

ReadField text(std::string ForeignImage::*member) {
    return [=](const std::string& word, ForeignImage& image) {
        image.*member = word;
        return std::string();
    };
}

struct TableColumn {
    const char* name;
    ReadField read;
};

const std::array<TableColumn, 10>& table_columns() {
    static const std::array<TableColumn, 10> columns{{{"program", text(&ForeignImage::program)},
                                                      {"scene", text(&ForeignImage::scene)},
                                                      {"reference", text(&ForeignImage::reference)},
                                                      {"image", text(&ForeignImage::image)},
                                                      {"width", pixels(&Imath::V2i::x)},
                                                      {"height", pixels(&Imath::V2i::y)},
                                                      {"spp", number(&ForeignImage::samples)},
                                                      {"cpu_s", number(&ForeignImage::cpu_seconds)},
                                                      {"mse", number(&ForeignImage::mse)},
                                                      {"relmse", number(&ForeignImage::relmse)}}};
    return columns;
}

/// A table being read, line by line.
class Reader {
  public:
    explicit Reader(std::string path) : path_(std::move(path)) {}

    /// Returns the first error, or nothing.
    std::string add(const std::string& line) {
        ++line_;
        if (line.empty() || line.front() == '#') return {};
        return columns_.empty() ? add_heading(fields_of(line)) : add_image(fields_of(line));
    }

    std::string error_at(std::size_t column, const std::string& what) const {
        return fmt::format("{}:{}:{}: error: {}", path_, line_, column, what);
    }

    std::vector<ForeignImage> images;

  private:
    std::string add_heading(const std::vector<Field>& fields) {
        for (const Field& field : fields) {
            const auto& all = table_columns();
            const auto* found = std::ranges::find(all, field.text, &TableColumn::name);
            if (found == all.end()) {
                std::string names;
                for (const TableColumn& column : all) names += std::string(" ") + column.name;
                return error_at(field.column,
                                fmt::format("column \"{}\"; expected tabs between some of:{}",
                                            field.text, names));
            }
            if (std::ranges::find(columns_, found) != columns_.end()) {
                return error_at(field.column, fmt::format("column \"{}\" is there twice; expected "
                                                          "it once",
                                                          field.text));
            }
            columns_.push_back(found);
        }
        return {};
    }

    std::string add_image(const std::vector<Field>& fields) {
        if (fields.size() != columns_.size()) {
            return error_at(fields.back().column, fmt::format("{} fields; expected {}, as above",
                                                              fields.size(), columns_.size()));
        }
        ForeignImage image;
        image.where = fmt::format("{}:{}", path_, line_);
        image.program = fs::path(path_).stem().string();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (!is_given(fields[i].text)) continue;
            const std::string expected = columns_[i]->read(fields[i].text, image);
            if (!expected.empty()) {
                return error_at(fields[i].column,
                                fmt::format("\"{}\"; expected {}", fields[i].text, expected));
            }
        }
        if (image.cpu_seconds == 0) return error_at(1, "no cpu_s: expected the CPU seconds");
        if (image.image.empty() == std::isnan(image.relmse)) {
            return error_at(1, "expected either an image or its relmse");
        }
        images.push_back(opened(image));
        return {};
    }

    /// Paths are relative to the table.
    ForeignImage opened(ForeignImage image) const {
        for (std::string* file : {&image.scene, &image.reference, &image.image}) {
            if (!file->empty()) *file = (fs::path(path_).parent_path() / *file).string();
        }
        return image;
    }

    const std::string path_;
    std::size_t line_ = 0;
    std::vector<const TableColumn*> columns_;
};

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code none;
    return a == b || fs::equivalent(a, b, none);
}

/// A file such as "scene-1024.exr", in the order of the numbers, which may have any length.
struct NumberedImage {
    std::size_t length = 0;  ///< of the number without leading zeros; 0 if it is no such file
    std::string number, path;

    auto operator<=>(const NumberedImage&) const = default;
};

/// Returns the image if the file's name is `stem`, a number and ".exr".
NumberedImage numbered_image(const fs::path& file, const std::string& stem) {
    const std::string name = file.stem().string();
    if (file.extension() != ".exr" || !name.starts_with(stem + "-")) return {};
    std::string number = name.substr(stem.size() + 1);
    if (number.find_first_not_of("0123456789") != std::string::npos) return {};
    number.erase(0, number.find_first_not_of('0'));
    return number.empty() ? NumberedImage() : NumberedImage{number.size(), number, file.string()};
}

}  // namespace

Result<std::vector<ForeignImage>> read_foreign_table(const std::string& path) {
    std::ifstream file(path);
    std::error_code none;
    if (!file || fs::is_directory(path, none)) return {{}, path + ": error: cannot be read"};
    Reader reader(path);
    bool is_first = true;
    for (std::string line; std::getline(file, line); is_first = false) {
        if (is_first) line.erase(0, byte_order_mark_size(line));
        if (line.ends_with('\r')) line.pop_back();
        if (std::string error = reader.add(line); !error.empty()) return {{}, std::move(error)};
    }
    if (file.bad() || reader.images.empty()) return {{}, reader.error_at(1, "no images in it")};
    return {std::move(reader.images), {}};
}

std::vector<ForeignImage> images_of(const std::vector<ForeignImage>& all,
                                    const std::string& scene) {
    std::vector<ForeignImage> images;
    std::ranges::copy_if(all, std::back_inserter(images), [&](const ForeignImage& image) {
        return image.scene.empty() || is_same_file(image.scene, scene);
    });
    return images;
}

std::vector<std::string> scenes_of(const std::vector<ForeignImage>& all) {
    std::vector<std::string> scenes;
    for (const ForeignImage& image : all) {
        const bool is_new = std::ranges::find(scenes, image.scene) == scenes.end();
        if (is_new && !image.scene.empty()) scenes.push_back(image.scene);
    }
    return scenes;
}

std::string reference_for(const std::vector<ForeignImage>& images, const std::string& scene) {
    for (const ForeignImage& image : images) {
        if (!image.reference.empty()) return image.reference;
    }
    const fs::path path(scene);
    const std::string stem = path.stem().string();
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    NumberedImage best;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        best = std::max(best, numbered_image(entry.path(), stem));
    }
    return best.path;
}

}  // namespace etalon::convergence
