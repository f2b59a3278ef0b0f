#include "bench/hard_cases/rows.h"

namespace etalon::hard {

void Rows::add(const std::string& id, const std::string& variant, const MakeSetting& make,
               Judge judge) {
    list_.push_back({id, variant, shape_, judge, make});
}

void Rows::add_in_float(const std::string& id, const std::string& variant, const MakeSetting& make,
                        Judge judge) {
    add(
        id, variant + ", float",
        [make] {
            Setting setting = make();
            setting.ray = [ray = std::move(setting.ray)](Random& random) {
                return in_float(ray(random));
            };
            return setting;
        },
        judge);
}

void Rows::add_both(const std::string& id, const std::string& variant, const MakeSetting& make,
                    Judge judge) {
    add(id, variant, make, judge);
    add_in_float(id, variant, make, judge);
}

std::string power_of_ten(int exponent) {
    return "1e" + std::to_string(exponent);
}

std::string power_of_two(int exponent) {
    return "2^" + std::to_string(exponent);
}

}  // namespace etalon::hard
