// Conversion of the values of a parameter to its type.
#include <algorithm>
#include <cmath>

#include "core/formats/diagnostic_log.h"
#include "core/formats/pbrt/color_values.h"
#include "core/formats/pbrt/parameter_reader.h"

namespace etalon::pbrt {
namespace {

template <class T>
void drop_surplus(std::vector<T>& values, std::size_t multiple) {
    values.resize(values.size() - values.size() % multiple);
}

/// Releases the spare capacity of a long list.
template <class T>
void fit(std::vector<T>& values) {
    if (values.capacity() - values.size() > values.size() / 4) values.shrink_to_fit();
}

}  // namespace

bool ParameterReader::convert() {
    given_.type = declared_->type;
    given_.type_word = declared_->word;
    given_.is_texture = declared_->encoding == ValueEncoding::texture_name;
    const bool may_be_strings = declared_->takes_strings();
    const bool may_be_numbers = !may_be_strings;
    const bool may_be_files = declared_->encoding == ValueEncoding::spectrum;
    if (may_be_strings && strings_.empty()) {
        return refuse("'{}' has the type {} and takes strings, not numbers; it is left out",
                      given_.name, declared_->word);
    }
    if (may_be_numbers && !may_be_files && !strings_.empty()) {
        return refuse("'{}' has the type {} and takes numbers, not strings; it is left out",
                      given_.name, declared_->word);
    }
    return strings_.empty() ? convert_numbers() : convert_strings();
}

bool ParameterReader::convert_strings() {
    if (given_.is_texture && strings_.size() != 1) {
        return refuse("'{}' takes the name of one texture, not {}; it is left out", given_.name,
                      strings_.size());
    }
    if (declared_->encoding == ValueEncoding::flags) {
        convert_flags();
    } else if (declared_->encoding == ValueEncoding::spectrum) {
        convert_spectrum_files();
    } else {
        given_.values = std::move(strings_);
    }
    return true;
}

void ParameterReader::convert_flags() {
    std::vector<std::int32_t> flags;
    for (const std::string& text : strings_) {
        if (text != "true" && text != "false") {
            log_.warn(given_.where, "choice", "'{}' is true or false; {} is taken for false",
                      given_.name, in_quotes(text));
        }
        flags.push_back(text == "true" ? 1 : 0);
    }
    given_.values = std::move(flags);
}

void ParameterReader::convert_spectrum_files() {
    std::vector<float> rgb;
    for (const std::string& name : strings_) {
        const Color c = spectra_.color(name, given_.where);
        rgb.insert(rgb.end(), {c.x, c.y, c.z});
    }
    given_.values = std::move(rgb);
}

bool ParameterReader::convert_numbers() {
    if (declared_->type == ValueType::integer) {
        fit(integers_);
        given_.values = std::move(integers_);
        return true;
    }
    const auto multiple = static_cast<std::size_t>(declared_->numbers);
    if (const std::size_t surplus = numbers_.size() % multiple; surplus != 0) {
        log_.warn(given_.where, "count",
                  "'{}' takes {} numbers per value, found {}; left out at the end: {}", given_.name,
                  multiple, numbers_.size(), surplus);
        drop_surplus(numbers_, multiple);
    }
    if (declared_->encoding != ValueEncoding::plain) {
        numbers_ = to_rgb(*declared_, std::move(numbers_));
        const bool is_finite =
            std::ranges::all_of(numbers_, [](float x) { return std::isfinite(x); });
        if (!is_finite && given_.not_finite.line == 0) given_.not_finite = given_.where;
    }
    fit(numbers_);
    given_.values = std::move(numbers_);
    return true;
}

}  // namespace etalon::pbrt
