#include "app/common/options.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace etalon {

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::by_commas() {
    option_->delimiter(',');
    return *this;
}

Option& Option::one_value_each() {
    option_->allow_extra_args(false);
    return *this;
}

Option& Option::excludes(const std::string& other) {
    option_->excludes(other);
    return *this;
}

Option& Option::show_default() {
    option_->capture_default_str();
    return *this;
}

Option& Option::group(const std::string& heading) {
    option_->group(heading);
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& values) {
    option_->check(CLI::IsMember(values));
    return *this;
}

Option& Option::within(int least, int most) {
    option_->check(CLI::Range(least, most));
    return *this;
}

Option& Option::within(std::size_t least, std::size_t most) {
    option_->check(CLI::Range(least, most));
    return *this;
}

Option& Option::within(double least, double most) {
    option_->check(CLI::Range(least, most));
    return *this;
}

Option& Option::positive() {
    option_->check(CLI::PositiveNumber);
    return *this;
}

Option& Option::not_negative() {
    option_->check(CLI::NonNegativeNumber);
    return *this;
}

Option& Option::check(std::function<std::string(const std::string&)> find_fault) {
    option_->check(std::move(find_fault));
    return *this;
}

template <class T>
Option Options::add(const std::string& names, T& value, const std::string& help) {
    return Option(*app_.add_option(names, value, help));
}

template Option Options::add(const std::string&, int&, const std::string&);
template Option Options::add(const std::string&, unsigned&, const std::string&);
template Option Options::add(const std::string&, std::size_t&, const std::string&);
template Option Options::add(const std::string&, double&, const std::string&);
template Option Options::add(const std::string&, std::string&, const std::string&);
template Option Options::add(const std::string&, std::vector<int>&, const std::string&);
template Option Options::add(const std::string&, std::vector<std::string>&, const std::string&);

Option Options::add_flag(const std::string& names, bool& value, const std::string& help) {
    return Option(*app_.add_flag(names, value, help));
}

}  // namespace etalon
